// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/elements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tether {
namespace {

int extent(const Variable& variable, std::size_t direction) { return direction == 0 ? variable.n1 : variable.n2; }

bool rank_is_right(const Variable& variable, const Item& item, Remarks& remarks) {
  const auto given = item.sections.size();
  if (given == static_cast<std::size_t>(variable.rank)) return true;
  const auto& place = item.sections.front();
  const std::string message = variable.rank == 0 ? fmt::format("{} is no array and takes no subscript", variable.name)
                                                 : fmt::format("{} takes {} subscript{}, not {}", variable.name,
                                                               variable.rank, variable.rank == 1 ? "" : "s", given);
  const std::string hint = variable.rank == 0 ? fmt::format("Write {} = value.", variable.name)
                           : variable.rank == 1
                               ? fmt::format("Its shape is {}({}).", variable.name, variable.n1)
                               : fmt::format("Its shape is {}({},{}).", variable.name, variable.n1, variable.n2);
  remarks.error(place.line, place.column, message, hint);
  return false;
}

bool in_bounds(const Variable& variable, const Bound& bound, std::size_t direction, Remarks& remarks) {
  const int n = extent(variable, direction);
  if (bound.value >= 1 && bound.value <= n) return true;
  remarks.error(bound.line, bound.column, fmt::format("subscript {} of {} is out of range", bound.value, variable.name),
                fmt::format("Subscript {} of {} goes from 1 to {}.", direction + 1, variable.name, n));
  return false;
}

/// Sets one direction of `elements` to a section first:last:step.
bool set_section(const Variable& variable, const Section& section, std::size_t direction, Elements& elements,
                 Remarks& remarks) {
  const Bound lower = section.first.value_or(Bound{1});
  const Bound upper = section.range ? section.last.value_or(Bound{extent(variable, direction)}) : lower;
  if (!in_bounds(variable, lower, direction, remarks) || !in_bounds(variable, upper, direction, remarks)) return false;
  const long long first = lower.value, last = upper.value, step = section.step.value_or(Bound{1}).value;
  if (step == 0 || (last - first) / std::clamp(step, -1LL, 1LL) < 0) {
    remarks.error(section.line, section.column,
                  fmt::format("the section {}:{}:{} of {} has no elements", first, last, step, variable.name),
                  "A section is first:last:step; the step must lead from the first to the last.");
    return false;
  }
  elements.first[direction] = first;
  elements.step[direction] = step;
  elements.counts[direction] = (last - first) / step + 1;
  return true;
}

Elements whole(const Variable& variable) { return {.counts = {variable.n1, variable.n2}}; }

}  // namespace

Subscript Elements::at(long long k) const {
  const long long linear = k + skipped;
  const long long i = linear % counts[0], j = linear / counts[0];
  return {static_cast<int>(first[0] + i * step[0]), static_cast<int>(first[1] + j * step[1])};
}

std::string element_name(const Variable& variable, Subscript at) {
  if (variable.rank == 0) return std::string(variable.name);
  if (variable.rank == 1) return fmt::format("{}({})", variable.name, at[0]);
  return fmt::format("{}({},{})", variable.name, at[0], at[1]);
}

std::optional<Elements> resolve_elements(const Variable& variable, const Item& item, Remarks& remarks) {
  if (!item.subscripted) return whole(variable);
  if (!rank_is_right(variable, item, remarks)) return std::nullopt;
  Elements elements;
  bool ranged = false;
  for (std::size_t direction = 0; direction < item.sections.size(); ++direction) {
    const auto& section = item.sections[direction];
    if (!set_section(variable, section, direction, elements, remarks)) return std::nullopt;
    ranged = ranged || section.range;
  }
  if (ranged) return elements;
  Elements onward = whole(variable);
  onward.skipped = elements.first[0] - 1 + (elements.first[1] - 1) * variable.n1;
  return onward;
}

}  // namespace tether
