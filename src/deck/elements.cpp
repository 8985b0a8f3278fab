// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/elements.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "deck/opener.hpp"
#include "deck/spelling.hpp"
#include "deck/table.hpp"

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

namespace {

using Data = decltype(DeckValue::data);

/// One value on its way into one element.
class Conversion {
 public:
  Conversion(const Variable& variable, Subscript at, const ItemValue& value, Remarks& remarks)
      : variable_(variable), name_(element_name(variable, at)), value_(value), remarks_(remarks) {}

  std::optional<Data> run();

 private:
  std::nullopt_t fail(std::string message, std::string hint = {}) {
    remarks_.error(value_.line, value_.column, std::move(message), std::move(hint));
    return std::nullopt;
  }
  std::nullopt_t wrong_type();
  std::string text_hint() const;
  std::optional<Data> integer();
  std::optional<Data> whole_real();
  std::optional<Data> real();
  std::optional<double> real_without_last_dot();
  std::optional<Data> logical();
  std::optional<Data> text();
  bool allowed(double number);

  const Variable& variable_;
  std::string name_;
  const ItemValue& value_;
  Remarks& remarks_;
};

std::optional<Data> Conversion::run() {
  const bool is_text = variable_.type == ValueType::text;
  if (is_text != (value_.kind == ItemValue::Kind::quoted)) return wrong_type();
  switch (variable_.type) {
    case ValueType::integer:
      return integer();
    case ValueType::real:
      return real();
    case ValueType::logical:
      return logical();
    default:
      return text();
  }
}

std::nullopt_t Conversion::wrong_type() {
  const auto type = variable_.type;
  if (find_variable(variable_.group, lower(value_.text)) != nullptr) {
    return fail(fmt::format("'=' is missing after {}", in_quotes(value_.text)), "An item is: name = value.");
  }
  const std::string hint = type == ValueType::text      ? text_hint()
                           : type == ValueType::real    ? "Numbers are written as 1.5, 1.5e-3 or 1.5d-3."
                           : type == ValueType::integer ? "Integers are digits with or without a sign."
                                                        : "";
  return fail(fmt::format("{} must be {}, not {}", name_, type_text(type), in_quotes(value_.text)), hint);
}

/// Says what a word without quotes was to be: itself in quotes, where that is a choice.
std::string Conversion::text_hint() const {
  const auto choices = split_choices(variable_);
  const bool any = choices.empty() || std::find(choices.begin(), choices.end(), lower(value_.text)) != choices.end();
  if (any) return fmt::format("Write {}.", in_quotes(value_.text));
  const auto near = nearest_name(lower(value_.text), choices);
  return fmt::format("Allowed, in quotes: {}.{}", range_text(variable_),
                     near.empty() ? "" : fmt::format(" Did you mean '{}'?", near));
}

std::optional<Data> Conversion::integer() {
  const auto number = parse_integer(value_.text);
  if (!number) return whole_real();
  if (*number > 2147483647LL || *number < -2147483648LL) {
    return fail(fmt::format("{} overflows: {}", name_, in_quotes(value_.text)),
                "Integers go from -2147483648 to 2147483647.");
  }
  if (!allowed(static_cast<double>(*number))) return std::nullopt;
  return *number;
}

/// 3.0 for an integer: taken, with a warning.
std::optional<Data> Conversion::whole_real() {
  const auto number = parse_real(value_.text);
  if (!number) return wrong_type();
  if (*number != std::floor(*number) || std::abs(*number) > bounds::largest_integer) return wrong_type();
  if (!allowed(*number)) return std::nullopt;
  const auto whole = static_cast<long long>(*number);
  remarks_.remark(value_.line, value_.column,
                  fmt::format("{} is an integer; {} is taken for {}", name_, in_quotes(value_.text), whole));
  return whole;
}

std::optional<Data> Conversion::real() {
  auto number = parse_real(value_.text);
  if (!number) number = real_without_last_dot();
  if (!number) return wrong_type();
  if (!std::isfinite(*number)) {
    return fail(fmt::format("{} must be a finite number, not {}", name_, in_quotes(value_.text)),
                "The largest number is about 1.8e308.");
  }
  if (!allowed(*number)) return std::nullopt;
  return *number;
}

/// 2.00. of Box 9.
std::optional<double> Conversion::real_without_last_dot() {
  const auto shorter = std::string_view(value_.text).substr(0, value_.text.size() - 1);
  if (!value_.text.ends_with('.') || shorter.find('.') == std::string_view::npos) return std::nullopt;
  const auto number = parse_real(shorter);
  if (number) {
    remarks_.remark(value_.line, value_.column,
                    fmt::format("the last '.' of {} is dropped: {} = {}", in_quotes(value_.text), name_, shorter));
  }
  return number;
}

/// [.](t|f)[letters][.]
std::optional<Data> Conversion::logical() {
  std::string word = lower(value_.text);
  if (word.starts_with('.')) word.erase(0, 1);
  if (word.ends_with('.')) word.pop_back();
  const bool letters = std::all_of(word.begin(), word.end(), is_letter);
  if (word.empty() || !letters || (word[0] != 't' && word[0] != 'f')) return wrong_type();
  return word[0] == 't';
}

std::optional<Data> Conversion::text() {
  const bool none = value_.text.empty() && variable_.fallback == "''";
  if (variable_.choices.empty() || none) return value_.text;
  const auto word = lower(value_.text);
  const auto choices = split_choices(variable_);
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return word;
  const auto near = nearest_name(word, choices);
  return fail(fmt::format("{} = {} is none of its choices", name_, in_quotes(value_.text)),
              fmt::format("Allowed: {}.{}", range_text(variable_),
                          near.empty() ? "" : fmt::format(" Did you mean '{}'?", near)));
}

bool Conversion::allowed(double number) {
  const auto choices = split_choices(variable_);
  const bool chosen = choices.empty() || std::any_of(choices.begin(), choices.end(), [&](const std::string& choice) {
                        return parse_real(choice) == number;
                      });
  if (chosen && number >= variable_.low && number <= variable_.high) return true;
  fail(fmt::format("{} = {} is out of range", name_, number), fmt::format("Allowed: {}.", range_text(variable_)));
  return false;
}

}  // namespace

std::optional<DeckValue> convert(const Variable& variable, Subscript at, const ItemValue& value, Remarks& remarks) {
  auto data = Conversion(variable, at, value, remarks).run();
  if (!data) return std::nullopt;
  return DeckValue{std::move(*data), remarks.place(value.line, value.column)};
}

}  // namespace tether
