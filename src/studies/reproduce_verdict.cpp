// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// How far a value is off: in per cent, or, where that has no meaning or is not asked for, in its own unit.
struct Deviation {
  double size = 0;
  bool relative = true;

  Deviation(double value, const Target& target, bool as_part)
      : size(value - target.value), relative(as_part && target.value != 0) {
    if (relative) size /= std::abs(target.value);
  }
  std::string text() const { return text_of(std::abs(size)); }
  std::string signed_text() const { return fmt::format("{}{}", size < 0 ? "-" : "+", text()); }
  std::string text_of(double number) const {
    if (!relative) return fmt::format("{:.2g}", number);
    return number < 1 ? fmt::format("{:.2g} %", 100 * number) : fmt::format("{:.0f} %", 100 * number);
  }
};

std::string name_of(const Quantity& quantity, const Target& target) {
  return quantity.published.size() > 1 && !quantity.exact ? fmt::format(" with {}", target.name) : "";
}

/// What is not judged is told with how far it is off.
std::string reported(const Quantity& quantity, double value) {
  const auto target = target_of(quantity, value);
  if (!target || quantity.upper_bound || quantity.published.size() > 1) return "reported";
  return fmt::format("reported, {}", Deviation(value, *target, true).signed_text());
}

Verdict verdict_on_bound(double bound, double value) {
  if (value < bound) return {fmt::format("agrees, below {}", bound), false};
  return {fmt::format("differs, not below {}", bound), true};
}

Verdict judged(const Quantity& quantity, double value, const Tolerance& tolerance) {
  if (quantity.upper_bound) return verdict_on_bound(*quantity.upper_bound, value);
  const auto target = target_of(quantity, value);
  if (!target) return {"reported", false};
  const Deviation off(value, *target, tolerance.relative);
  const bool agrees = std::abs(off.size) <= tolerance.size;
  const std::string with = name_of(quantity, *target), allowed = off.text_of(tolerance.size);
  if (agrees) return {fmt::format("agrees{} within {}", with, allowed), false};
  return {fmt::format("differs by {} ({} allowed)", off.text(), allowed), true};
}

}  // namespace

double Measured::median() const {
  if (values.empty() || 2 * values.size() <= runs) return none;
  auto sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double Measured::spread() const {
  if (values.size() < 2) return none;
  double squares = 0;
  for (const double value : values) squares += (value - mean(values)) * (value - mean(values));
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Measured measure(const Quantity& quantity, const MethodResult& result) {
  Measured measured{{}, result.runs, result.failure};
  for (const RunFiles& files : result.files) {
    double value = none;
    try {
      value = quantity.reading(files);
    } catch (const FileError& error) {
      if (measured.failure.empty()) measured.failure = error.what();
    }
    if (!std::isnan(value)) measured.values.push_back(value);
  }
  if (measured.values.size() < measured.runs && measured.failure.empty()) measured.failure = "the run does not show it";
  return measured;
}

std::optional<Target> target_of(const Quantity& quantity, double value) {
  if (quantity.exact) return Target{quantity.exact(), "exact"};
  if (quantity.published.empty()) return std::nullopt;
  const auto nearer = [value](const Printed& a, const Printed& b) {
    return std::abs(a.value - value) < std::abs(b.value - value);
  };
  const auto nearest = std::min_element(quantity.published.begin(), quantity.published.end(), nearer);
  return Target{nearest->value, nearest->place};
}

Verdict verdict_on(const Quantity& quantity, const Measured& measured, const std::optional<Tolerance>& tolerance) {
  const double value = measured.median();
  if (std::isnan(value)) return {"no value: " + measured.failure, tolerance.has_value()};
  if (!tolerance) return {reported(quantity, value), false};
  return judged(quantity, value, *tolerance);
}

}  // namespace tether::published
