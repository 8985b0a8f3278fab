// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/energy_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace tether {
namespace {

/// kinetic, strain, internal, potential; the total is their sum.
struct Energies {
  double kinetic = 0, strain = 0, internal = 0, potential = 0;
};

History history_of(const std::vector<Energies>& records) {
  History history;
  for (const char* name :
       {"time", "energy_kinetic", "energy_strain", "energy_internal", "energy_potential", "energy_total"}) {
    history.layout.quantities.push_back({name, Dimension::energy, ""});
  }
  for (std::size_t k = 0; k < records.size(); ++k) {
    const auto& [a, b, c, d] = records[k];
    history.records.push_back({static_cast<double>(k), a, b, c, d, a + b + c + d});
  }
  return history;
}

TEST(EnergyDrift, IsZeroWhereEveryLossIsAGain) {
  EXPECT_EQ(energy_drift(history_of({{0, 0, 8, -10}, {2, 1, 8, -13}, {0, 4, 8, -14}})), 0);
}

/// The total changes by .5 at most, the potential energy by 4.
TEST(EnergyDrift, IsTheLargestChangeOverTheLargestExchange) {
  EXPECT_EQ(energy_drift(history_of({{0, 0, 8, -10}, {3, 0, 8, -13.5}, {0, 3.5, 8, -14}})), 0.125);
  EXPECT_EQ(energy_drift(history_of({{0, 0, 8, -10}, {0, 3.75, 8, -14}, {0, 0, 8, -10}})),
            0.0625);  // a loss, made good
}

TEST(EnergyDrift, AnyKindCanBeTheLargestExchange) {
  EXPECT_EQ(energy_drift(history_of({{4, 0, 0, 0}, {2, 1, 0, 0}})), 0.5);
  EXPECT_EQ(energy_drift(history_of({{0, 5, 0, 0}, {0, 1, 2, 0}})), 0.5);
  EXPECT_EQ(energy_drift(history_of({{0, 0, 100, 0}, {0, 0, 92, 0}})), 1);
}

/// Only differences count: a potential energy far from 0 makes no drift small.
TEST(EnergyDrift, DoesNotDependOnWhereAnEnergyIsZero) {
  EXPECT_EQ(energy_drift(history_of({{4, 0, 0, 1024}, {2, 1, 0, 1024}})), 0.5);
}

TEST(EnergyDrift, IsZeroWhereNothingWasExchanged) {
  EXPECT_EQ(energy_drift(history_of({{1, 2, 3, 4}, {1, 2, 3, 4}})), 0);
  EXPECT_EQ(energy_drift(history_of({{1, 2, 3, 4}})), 0);
}

/// Of a free rigid body all changes are rounding.
TEST(EnergyDrift, IsOverTheEnergyItselfWhereOnlyRoundingWasExchanged) {
  const double small = 1.0 / (1LL << 42);
  EXPECT_EQ(energy_drift(history_of({{8, 0, 0, 0}, {8 + small, 0, 0, 0}})), small / (8 + small));
  EXPECT_EQ(energy_rise(history_of({{8, 0, 0, 0}, {8 + small, 0, 0, 0}})), small / (8 + small));
  EXPECT_EQ(energy_drift(history_of({{8, 0, 0, 0}, {8 + 128 * small, 0, 0, 0}})), 1);
}

/// A column of what came in, went out or was lost: the balance has it, whatever its name.
History with_column(History history, Book book, const std::vector<double>& values) {
  const std::string name = "energy_booked_" + std::to_string(history.layout.quantities.size());
  history.layout.quantities.push_back({name, Dimension::energy, "", Per::scene, book});
  for (std::size_t k = 0; k < values.size(); ++k) history.records[k].push_back(values[k]);
  return history;
}

TEST(EnergyDrift, CountsWhatIsBooked) {
  const History grows = history_of({{0, 0, 0, 0}, {2, 0, 0, 0}, {8, 0, 0, 0}}),
                falls = history_of({{8, 0, 0, 0}, {6, 0, 0, 0}, {0, 0, 0, 0}});
  EXPECT_EQ(energy_drift(with_column(grows, Book::gained, {0, 2, 8})), 0);
  EXPECT_EQ(energy_drift(with_column(grows, Book::none, {0, 2, 8})), 1);
  EXPECT_EQ(energy_drift(with_column(falls, Book::given, {1, 3, 9})), 0);  // changes count
  EXPECT_EQ(energy_drift(with_column(falls, Book::lost, {0, 2, 6})), 0.25);
}

TEST(EnergyDrift, IsOverWhatWasBookedWhereThatIsLargest) {
  EXPECT_EQ(energy_drift(with_column(history_of({{1, 0, 0, 0}, {2, 0, 0, 0}}), Book::given, {0, 4})), 1.25);
}

// Columns of what the method lost may be large and cancel: their sum counts.
TEST(EnergyLost, LargeColumnsThatCancelAreNoExchange) {
  const History falls = history_of({{8, 0, 0, 0}, {6, 0, 0, 0}, {4, 0, 0, 0}});
  const History booked = with_column(with_column(falls, Book::lost, {0, 51, 102}), Book::lost, {0, -50, -100});
  EXPECT_EQ(energy_lost(booked), 0.5);
  EXPECT_EQ(energy_drift(booked), 0.5);
}

// A method that gains energy shows it, although it books it.
TEST(EnergyRise, CountsWhatTheMethodGained) {
  const History grows = history_of({{4, 0, 0, 0}, {5, 0, 0, 0}, {8, 0, 0, 0}});
  EXPECT_EQ(energy_rise(with_column(grows, Book::lost, {0, -1, -4})), 1);
  EXPECT_EQ(energy_rise(with_column(grows, Book::gained, {0, 1, 4})), 0);
}

/// What settles in a fluid that stands under pressure is small against the pressure times the volume.
TEST(EnergyRise, IsNoneOfWhatSettlesUnderPressure) {
  History history = history_of({{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}});
  EXPECT_EQ(energy_rise(history), 1);
  history.layout.quantities.push_back({"energy_pressure", Dimension::energy, ""});
  for (Record& record : history.records) record.push_back(-1e5);
  EXPECT_EQ(energy_rise(history), 0.01);
  EXPECT_EQ(energy_drift(history), 1);
}

TEST(EnergyLost, IsWhatTheMethodLostByTheEnd) {
  const History falls = history_of({{8, 0, 0, 0}, {6, 0, 0, 0}, {0, 0, 0, 0}});
  EXPECT_EQ(energy_lost(with_column(falls, Book::lost, {0, 5, 4})), 0.5);
  EXPECT_EQ(energy_lost(with_column(falls, Book::given, {0, 5, 4})), 0);
  EXPECT_EQ(energy_lost(falls), 0);
}

TEST(EnergyDrift, NeedsItsColumns) { EXPECT_THROW(energy_drift(History{}), std::out_of_range); }

TEST(EnergyRise, CountsGainsAlone) {
  EXPECT_EQ(energy_rise(history_of({{0, 0, 8, -10}, {4, 0, 8, -12}, {0, 0, 8, -14}})), 0.5);
  EXPECT_EQ(energy_rise(history_of({{4, 0, 0, 0}, {2, 1, 0, 0}})), 0);
  EXPECT_EQ(energy_rise(history_of({{1, 2, 3, 4}})), 0);
}

TEST(EnergyGrowth, IsTheLargestSizeOverTheStart) {
  EXPECT_EQ(energy_growth(history_of({{2, 0, 0, 0}, {1, 4, 0, 0}, {2, 1, 0, 0}})), 2.5);
  EXPECT_EQ(energy_growth(history_of({{0, 0, 0, -2}, {0, 1, 0, -9}})), 4);  // a size has no sign
  EXPECT_EQ(energy_growth(history_of({{2, 0, 0, 0}, {1, 0, 0, 0}})), 1);
}

TEST(EnergyGrowth, IsNoNumberWithoutEnergyAtTheStart) {
  EXPECT_TRUE(std::isnan(energy_growth(history_of({{2, 0, 0, -2}, {4, 0, 0, 0}}))));
}

/// At rest but for rounding, then 3 came from outside; a run that grows by itself has a growth, however large it is.
TEST(EnergyGrowth, IsNoNumberOfWhatCameFromOutside) {
  const History moved = history_of({{1e-28, 0, 0, 0}, {1, 0, 0, 0}});
  EXPECT_TRUE(std::isnan(energy_growth(with_column(moved, Book::gained, {0, 3}))));
  EXPECT_GT(energy_growth(with_column(moved, Book::given, {0, 3})), 1e27);
}

History masses(const std::vector<double>& values) {
  History history;
  history.layout.quantities = {{"time", Dimension::time, ""}, {"mass", Dimension::mass, ""}};
  for (const double value : values) history.records.push_back({0, value});
  return history;
}

TEST(MassDrift, IsTheLargestChangeOverTheStart) {
  EXPECT_EQ(mass_drift(masses({4, 4, 4})), 0);
  EXPECT_EQ(mass_drift(masses({4, 5, 4, 2, 4})), 0.5);
  EXPECT_EQ(mass_drift(masses({4, 4.5})), 0.125);
}

}  // namespace
}  // namespace tether
