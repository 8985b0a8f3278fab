// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "deck/variable_groups.hpp"

namespace tether {
namespace {

std::string listed(const std::vector<std::string>& choices) {
  std::string text = choices.front();
  for (std::size_t k = 1; k < choices.size(); ++k) {
    text += (k + 1 == choices.size() ? " or " : ", ") + choices[k];
  }
  return text;
}

std::string bound_text(double bound) {
  return bound == std::floor(bound) ? fmt::format("{:.0f}", bound) : fmt::format("{}", bound);
}

/// The shortest decimal that reads back the same, with a '.' or an exponent.
std::string real_text(double value) {
  auto text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quote_text(const std::string& value) {
  std::string text = "'";
  for (const char c : value) {
    text += c;
    if (c == '\'') text += c;
  }
  return text + "'";
}

struct ValueText {
  std::string operator()(long long value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return real_text(value); }
  std::string operator()(bool value) const { return value ? ".true." : ".false."; }
  std::string operator()(const std::string& value) const { return quote_text(value); }
};

}  // namespace

std::optional<DeckValue> default_value(const Variable& variable) {
  const auto fallback = variable.fallback;
  if (fallback.empty()) return std::nullopt;
  switch (variable.type) {
    case ValueType::integer:
      return DeckValue{parse_integer(fallback).value(), {}};
    case ValueType::real:
      return DeckValue{parse_real(fallback).value(), {}};
    case ValueType::logical:
      return DeckValue{fallback == ".true.", {}};
    default:
      return DeckValue{std::string(fallback.substr(1, fallback.size() - 2)), {}};
  }
}

std::string type_text(ValueType type) {
  switch (type) {
    case ValueType::integer:
      return "an integer";
    case ValueType::real:
      return "a number";
    case ValueType::logical:
      return ".true. or .false.";
    default:
      return "a text in quotes";
  }
}

std::vector<std::string> split_choices(const Variable& variable) {
  std::vector<std::string> choices;
  auto rest = variable.choices;
  while (!rest.empty()) {
    const auto bar = std::min(rest.find('|'), rest.size());
    choices.emplace_back(rest.substr(0, bar));
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return choices;
}

std::string range_text(const Variable& variable) {
  if (!variable.choices.empty()) return listed(split_choices(variable));
  if (variable.type == ValueType::logical || variable.type == ValueType::text) return "";
  const bool integer = variable.type == ValueType::integer;
  const bool no_lowest = integer ? variable.low <= bounds::smallest_integer : std::isinf(variable.low);
  const bool no_highest = integer ? variable.high >= bounds::largest_integer : std::isinf(variable.high);
  if (no_lowest && no_highest) return "";
  if (variable.low == bounds::above_zero) return "> 0";
  if (no_highest) return ">= " + bound_text(variable.low);
  return fmt::format("{} to {}", bound_text(variable.low), bound_text(variable.high));
}

std::string shape_text(const Variable& variable) {
  if (variable.rank == 0) return std::string(variable.name);
  if (variable.rank == 1) return fmt::format("{}({})", variable.name, variable.n1);
  return fmt::format("{}({},{})", variable.name, variable.n1, variable.n2);
}

std::string value_text(const DeckValue& value) { return std::visit(ValueText{}, value.data); }

}  // namespace tether
