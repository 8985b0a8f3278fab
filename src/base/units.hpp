// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/words.hpp"

namespace tether {

/// The unit system a deck says it is written in. Nothing is converted: it only labels outputs.
enum class Units { none, si, cgs };
template <>
inline constexpr std::array<Word<Units>, 3> words<Units>{
    {{Units::none, "none"}, {Units::si, "si"}, {Units::cgs, "cgs"}}};

/// What a quantity measures, for its unit attribute.
enum class Dimension {
  number,
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
