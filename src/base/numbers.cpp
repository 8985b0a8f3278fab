// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>

#include "base/text.hpp"

namespace tether {
namespace {

bool is_sign(char c) { return c == '+' || c == '-'; }

/// Moves `at` over the digits there; returns how many there were.
std::size_t skip_digits(std::string_view text, std::size_t& at) {
  const auto start = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  return at - start;
}

/// The mantissa d+[.d*] | .d+ from `at` on.
bool skip_mantissa(std::string_view text, std::size_t& at) {
  auto digits = skip_digits(text, at);
  if (at < text.size() && text[at] == '.') digits += skip_digits(text, ++at);
  return digits > 0;
}

/// The digits of the exponent with their sign; empty if `text` is no exponent.
std::string_view exponent_of(std::string_view text) {
  if (std::string_view("eEdDqQ").find(text[0]) != std::string_view::npos) text.remove_prefix(1);
  std::size_t at = !text.empty() && is_sign(text[0]) ? 1 : 0;
  const auto digits = skip_digits(text, at);
  return digits > 0 && at == text.size() ? text : std::string_view{};
}

std::optional<double> named_number(std::string_view text, bool negative) {
  const auto name = lower(text);
  const double sign = negative ? -1 : 1;
  if (name == "inf" || name == "infinity") return sign * std::numeric_limits<double>::infinity();
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

}  // namespace

std::optional<long long> parse_integer(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  std::size_t at = negative ? 1 : 0;
  if (skip_digits(text, at) == 0 || at != text.size()) return std::nullopt;
  long long value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{}) return value;
  return negative ? std::numeric_limits<long long>::min() : std::numeric_limits<long long>::max();
}

std::optional<double> parse_real(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && is_sign(text[0])) text.remove_prefix(1);
  std::size_t at = 0;
  if (!skip_mantissa(text, at)) return named_number(text, negative);
  std::string c_spelling(text.substr(0, at));
  if (at < text.size()) {
    const auto exponent = exponent_of(text.substr(at));
    if (exponent.empty()) return std::nullopt;
    c_spelling.append("e").append(exponent);
  }
  // strtod, not from_chars: it distinguishes overflow (infinity) from underflow (0 or the nearest subnormal).
  const double size = std::strtod(c_spelling.c_str(), nullptr);
  return negative ? -size : size;
}

namespace {

struct Spelling {
  Dimension dimension;
  const char* word;
  const char* si;
  const char* cgs;
};

constexpr std::array<Spelling, 22> spellings{{
    {Dimension::number, "-", "1", "1"},
    {Dimension::whole, "-", "1", "1"},
    {Dimension::time, "time", "s", "s"},
    {Dimension::length, "length", "m", "cm"},
    {Dimension::area, "area", "m2", "cm2"},
    {Dimension::volume, "volume", "m3", "cm3"},
    {Dimension::mass, "mass", "kg", "g"},
    {Dimension::velocity, "velocity", "m s-1", "cm s-1"},
    {Dimension::acceleration, "acceleration", "m s-2", "cm s-2"},
    {Dimension::force, "force", "N", "dyn"},
    {Dimension::stress, "stress", "Pa", "dyn cm-2"},
    {Dimension::density, "density", "kg m-3", "g cm-3"},
    {Dimension::viscosity, "viscosity", "Pa s", "P"},
    {Dimension::energy, "energy", "J", "erg"},
    {Dimension::specific_energy, "energy/mass", "J kg-1", "erg g-1"},
    {Dimension::momentum, "momentum", "kg m s-1", "g cm s-1"},
    {Dimension::angular_momentum, "angular momentum", "kg m2 s-1", "g cm2 s-1"},
    {Dimension::rate, "1/time", "s-1", "s-1"},
    {Dimension::torque, "torque", "N m", "dyn cm"},
    {Dimension::flux, "area/time", "m2 s-1", "cm2 s-1"},
    {Dimension::power, "power", "W", "erg s-1"},
    {Dimension::angle, "degrees", "degree", "degree"},
}};

static_assert(spellings.size() == static_cast<std::size_t>(Dimension::angle) + 1, "a row for every dimension");

const Spelling& spelling_of(Dimension dimension) {
  return *std::ranges::find(spellings, dimension, &Spelling::dimension);
}

}  // namespace

std::string unit_text(Dimension dimension, Units units) {
  if (units == Units::none && dimension != Dimension::angle) return "1";
  const Spelling& spelling = spelling_of(dimension);
  return units == Units::si ? spelling.si : spelling.cgs;
}

const char* dimension_text(Dimension dimension) { return spelling_of(dimension).word; }

}  // namespace tether
