// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace tether {
namespace {

struct Row {
  Dimension dimension;
  const char *si, *cgs;
};

/// Every dimension, in UDUNITS spelling.
constexpr std::array<Row, 20> rows{{
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

TEST(UnitText, OfEveryDimensionInBothSystems) {
  for (const Row& row : rows) {
    EXPECT_EQ(unit_text(row.dimension, Units::si), row.si);
    EXPECT_EQ(unit_text(row.dimension, Units::cgs), row.cgs);
  }
}

TEST(UnitText, OfAnglesIsDegreesWithoutASystemToo) {
  for (const Units units : {Units::none, Units::si, Units::cgs})
    EXPECT_EQ(unit_text(Dimension::angle, units), "degree");
}

TEST(UnitText, IsOneWhereTheDeckNamesNoSystem) {
  for (const Row& row : rows) EXPECT_EQ(unit_text(row.dimension, Units::none), "1");
}

TEST(DimensionText, IsAWordForEachAndADashForNumbers) {
  EXPECT_STREQ(dimension_text(Dimension::number), "-");
  EXPECT_STREQ(dimension_text(Dimension::specific_energy), "energy/mass");
  for (const Row& row : rows) EXPECT_STRNE(dimension_text(row.dimension), "");
}

}  // namespace
}  // namespace tether
