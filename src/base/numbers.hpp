// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/words.hpp"

namespace tether {

/// An array's index of a number that counts cells, axes or nodes and is not negative.
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Returns whether c is a decimal digit, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns whether a quantity is positive and finite.
inline bool is_positive(double value) { return std::isfinite(value) && value > 0; }

/// What stands where a number is asked for and there is none.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// [+-]digits, the whole text; what does not fit is the largest or smallest long long. Else nothing.
std::optional<long long> parse_integer(std::string_view text);

/// A Fortran real, the whole text: [+-] (d+[.d*] | .d+) [(e|d|q)[+-]d+ | [+-]d+], or inf, infinity, nan, in any case.
/// So 1.d-4 and 1.5+3 (= 1500) are numbers. 1e400 gives infinity. Else nothing.
/// Source: Fortran 2018, 13.7.2.3.2, as gfortran's namelist reader takes it.
std::optional<double> parse_real(std::string_view text);

/// The unit system a deck says it is written in. Nothing is converted: it only labels outputs.
enum class Units { none, si, cgs };
template <>
inline constexpr std::array<Word<Units>, 3> words<Units>{
    {{Units::none, "none"}, {Units::si, "si"}, {Units::cgs, "cgs"}}};

/// What a quantity measures, for its unit attribute.
enum class Dimension {
  number,
  whole,  ///< a number that counts or names something
  time,
  length,
  area,
  volume,
  mass,
  velocity,
  acceleration,
  force,
  stress,
  density,
  viscosity,
  energy,
  specific_energy,
  momentum,
  angular_momentum,
  rate,
  torque,
  flux,  ///< area/time, of stream functions
  power,
  angle  ///< in degrees, whatever the system
};

/// The unit in UDUNITS spelling ("m s-1"), "1" for pure numbers and wherever the deck names no system; angles are in
/// "degree" even so. Time stays "s" in both systems (xarray turns "seconds" into timedelta, but leaves "s" a number).
std::string unit_text(Dimension dimension, Units units);

/// The word for it in guides, `-` for pure numbers.
const char* dimension_text(Dimension dimension);

}  // namespace tether
