// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/units.hpp"

#include <array>

namespace tether {
namespace {

struct Spelling {
  Dimension dimension;
  const char* si;
  const char* cgs;
};

constexpr std::array<Spelling, 20> spellings{{
    {Dimension::number, "1", "1"},
    {Dimension::time, "s", "s"},
    {Dimension::length, "m", "cm"},
    {Dimension::area, "m2", "cm2"},
    {Dimension::volume, "m3", "cm3"},
    {Dimension::mass, "kg", "g"},
    {Dimension::velocity, "m s-1", "cm s-1"},
    {Dimension::acceleration, "m s-2", "cm s-2"},
    {Dimension::force, "N", "dyn"},
    {Dimension::stress, "Pa", "dyn cm-2"},
    {Dimension::density, "kg m-3", "g cm-3"},
    {Dimension::viscosity, "Pa s", "P"},
    {Dimension::energy, "J", "erg"},
    {Dimension::specific_energy, "J kg-1", "erg g-1"},
    {Dimension::momentum, "kg m s-1", "g cm s-1"},
    {Dimension::angular_momentum, "kg m2 s-1", "g cm2 s-1"},
    {Dimension::rate, "s-1", "s-1"},
    {Dimension::torque, "N m", "dyn cm"},
    {Dimension::flux, "m2 s-1", "cm2 s-1"},
    {Dimension::power, "W", "erg s-1"},
}};

}  // namespace

std::string unit_text(Dimension dimension, Units units) {
  if (units == Units::none) return "1";
  for (const auto& spelling : spellings) {
    if (spelling.dimension == dimension) return units == Units::si ? spelling.si : spelling.cgs;
  }
  return "1";
}

}  // namespace tether
