// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/numbers.hpp"
#include "studies/map/map.hpp"
#include "studies/run_table.hpp"

namespace tether::map {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

double number_of(const Cell& cell) { return std::holds_alternative<double>(cell) ? std::get<double>(cell) : no_number; }

void add_bisections(StudyTable& table, const std::string& vary, const Outcome& outcome) {
  Numbers low, high, theory;
  Texts verdict;
  for (std::size_t k = 0; k < outcome.bisections.size(); ++k) {
    const Bisection& bisection = outcome.bisections[k];
    low.push_back(bisection.holds()), high.push_back(bisection.fails());
    theory.push_back(bisected_theory(outcome, k)), verdict.push_back(bisection.verdict());
  }
  table.columns.push_back({"largest_holding", "largest " + vary + " that holds", "", low});
  table.columns.push_back({"smallest_failing", "smallest " + vary + " that does not", "", high});
  table.columns.push_back({"theory", "where theory has the border", "", theory});
  table.columns.push_back({"verdict", "how the bisection ended", "", verdict});
}

void add_verdicts(StudyTable& table, const Map& map, const Outcome& outcome) {
  Numbers holds, decided, own, theory(outcome.decided_by.size(), no_number);
  Texts verdict;
  for (std::size_t k = 0; k < outcome.decided_by.size(); ++k) {
    const auto by = outcome.decided_by[k];
    verdict.push_back(by ? outcome.verdicts[*by] : "tells nothing");
    holds.push_back(by ? (verdict.back() == "holds" ? 1 : 0) : no_number);
    decided.push_back(by ? static_cast<double>(*by + 1) : no_number);
    own.push_back(by && outcome.runs[*by].variant.combination == k ? 1 : 0);
  }
  for (const Crossing& crossing : border_of(map, outcome).crossings) theory[crossing.square] = crossing.theory;
  table.columns.push_back({"verdict", "holds, or what is wrong with the run that decided the square", "", verdict});
  table.columns.push_back({"holds", "1 where it does", "1", holds});
  table.columns.push_back(
      {"decided_by", "row of table.nc that decided it, its own run or the nearest on its side", "1", decided});
  table.columns.push_back({"own_run", "1 where it was run itself", "1", own});
  table.columns.push_back({"theory", "where theory has the border between this square and the next one", "", theory});
}

}  // namespace

std::string verdict_of(const Criterion& criterion, const FinishedRun& run) {
  const auto meets = run.meets(criterion);
  if (!meets) return "tells nothing";
  if (*meets) return "holds";
  if (run.failed()) return std::string(word_of(run.record.ending.failure.value_or(Failure::diverges)));
  return run.value(criterion.key) > criterion.at_most ? "grows" : "falls short";
}

double bisected_theory(const Outcome& outcome, std::size_t square) {
  for (std::size_t k = 0; k < outcome.runs.size(); ++k) {
    const Variant& variant = outcome.runs[k].variant;
    if (variant.combination == square && variant.varied == outcome.bisections[square].holds()) return outcome.theory[k];
  }
  return no_number;
}

std::vector<std::size_t> border_axes(const Study& study) {
  std::vector<std::size_t> axes = leading_axes(study);
  std::erase_if(axes, [&](std::size_t a) {
    return study.axes[a].cells.size() < 2 || !std::holds_alternative<double>(study.axes[a].cells.front());
  });
  std::reverse(axes.begin(), axes.end());
  return axes;
}

namespace {

/// Says where a border is read: the deck, and the value of the other axis.
std::array<std::size_t, 2> line_of(const Combination& at, std::size_t axis, const std::vector<std::size_t>& leading) {
  for (const std::size_t other : leading) {
    if (other != axis) return {at.deck, at.values[other]};
  }
  return {at.deck, 0};
}

/// Theory is read off the run on the side that holds, or the one that decided it.
std::vector<Crossing> crossings_along(std::size_t axis, const Map& map, const Outcome& outcome) {
  const auto all = combinations(map.study);
  const auto leading = leading_axes(map.study);
  const std::size_t next = axis == leading.front() ? 1 : map.study.axes[leading.front()].cells.size();
  const auto& cells = map.study.axes[axis].cells;
  std::vector<Crossing> crossings;
  for (std::size_t k = 0; k + next < all.size(); ++k) {
    const auto &here = outcome.decided_by[k], &there = outcome.decided_by[k + next];
    if (all[k].values[axis] + 1 != all[k + next].values[axis] || !here || !there) continue;
    const bool below = outcome.verdicts[*here] == "holds", above = outcome.verdicts[*there] == "holds";
    if (below == above) continue;
    const double first = number_of(cells[all[k].values[axis]]), second = number_of(cells[all[k + next].values[axis]]);
    crossings.push_back({k, std::min(first, second), std::max(first, second), below == (first < second),
                         outcome.theory[below ? *here : *there]});
  }
  std::stable_sort(crossings.begin(), crossings.end(), [&](const Crossing& a, const Crossing& b) {
    return line_of(all[a.square], axis, leading) < line_of(all[b.square], axis, leading);
  });
  return crossings;
}

}  // namespace

Border border_of(const Map& map, const Outcome& outcome) {
  Border border;
  for (const std::size_t axis : border_axes(map.study)) {
    border = {axis, crossings_along(axis, map, outcome)};
    if (!border.crossings.empty()) break;
  }
  return border;
}

StudyTable squares_table(const Map& map, const Outcome& outcome) {
  const auto all = combinations(map.study);
  Numbers number(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) number[k] = static_cast<double>(k + 1);
  StudyTable table{"square", {{"square", "number of the square", "1", number}}};
  add_inputs(table, map.study, all);
  if (map.study.bisects())
    add_bisections(table, map.study.vary.variable, outcome);
  else
    add_verdicts(table, map, outcome);
  return table;
}

}  // namespace tether::map
