// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/units.hpp"

#include <algorithm>
#include <array>

namespace tether {
namespace {

struct Spelling {
  Dimension dimension;
  const char* word;
  const char* si;
  const char* cgs;
};

constexpr std::array<Spelling, 21> spellings{{
    {Dimension::number, "-", "1", "1"},
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
