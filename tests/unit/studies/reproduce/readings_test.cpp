// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/read_formula.hpp"

#include <cmath>
#include <numbers>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "plan/load.hpp"
#include "reference/riemann.hpp"
#include "unit/studies/reproduce/support.hpp"

namespace tether::published {
namespace {

/// Each quantity of the table off a run that was made up to show a known number.
class Readings : public test::TemporaryFolder {};

TEST_F(Readings, EnergyLostIsThatOfTheTotal) {
  const RunFiles run = MadeUpRun{{0, 1, 2}, {{"energy_total", {50, 60, 49}}}, {}, {}, {}}.write(folder);
  EXPECT_DOUBLE_EQ(readout("100*(first(energy_total) - last(energy_total))/first(energy_total)")(run), 2);
}

TEST_F(Readings, AQuantityIsFirstNearItsEnd) {
  const MadeUpQuantity v{"body_vx", {{1, 0.5, -0.69, -0.72, -0.7}}};
  const RunFiles run = MadeUpRun{{0, 1, 2, 3, 4}, {}, {v}, {}, {}}.write(folder);
  EXPECT_EQ(readout("settles(body_vx_1, 0.015)")(run), 2);
  EXPECT_EQ(readout("settles(body_vx_1, 0.001)")(run), 4);
  EXPECT_EQ(readout("settles(body_vx_1, 2)")(run), 0);
}

TEST_F(Readings, APeriodIsTwiceTheTimeBetweenPassages) {
  const MadeUpQuantity x{"body_x", {{2, 0, 2, 0, 2}}};  // through 1 at .5, 1.5, 2.5, 3.5
  const RunFiles run = MadeUpRun{{0, 1, 2, 3, 4}, {}, {x}, {}, {}}.write(folder);
  EXPECT_DOUBLE_EQ(readout("period(body_x_1, 1)")(run), 2);
  EXPECT_TRUE(std::isnan(readout("period(body_x_1, 3)")(run)));
}

TEST_F(Readings, ColumnsOfCellsHaveTheMeanOfTheirPoints) {
  MadeUpRun run{.summary = {{"dx", "0.5"}}};
  run.snapshots = {{0, {{"x", {0, 0, 0}}, {"y", {0, 0, 0}}, {"q", {0, 0, 0}}}},
                   {1, {{"x", {0.1, 1.2, 0.4}}, {"y", {0, 0, 0}}, {"q", {1, 5, 2}}}}};
  const RunFiles files = run.write(folder);
  EXPECT_EQ(readout("columns_mean(q, 0, 0.5, last)")(files), 1.5);
  EXPECT_EQ(readout("columns_mean(q, 1, 1.5, last)")(files), 5);
  EXPECT_EQ(readout("columns_mean(q, 0, 2, last)")(files), 3.25);
  EXPECT_TRUE(std::isnan(readout("columns_mean(q, 0.5, 1, last)")(files)));
}

TEST_F(Readings, TwoBars) {
  const MadeUpQuantity v{"body_vx", {{2, 1, 0.3}, {0, 1, 1.7}}};
  const RunFiles run = MadeUpRun{{0, 0.2, 0.5}, {{"energy_total", {100, 80, 89}}}, {v}, {}, {}}.write(folder);
  EXPECT_DOUBLE_EQ(read(run, "two-bar", "velocity of the left bar"), 0.3);
  EXPECT_DOUBLE_EQ(read(run, "two-bar", "velocity of the right bar"), 1.7);
  EXPECT_DOUBLE_EQ(read(run, "two-bar", "restitution"), 0.7);
  EXPECT_DOUBLE_EQ(read(run, "two-bar", "energy lost [%]"), 11);
}

TEST_F(Readings, BarsThatStickSwingAboutTheirMean) {
  const MadeUpQuantity v{"body_vx", {{2, 0.8, 1.0}, {0, 1.2, 1.0}}};
  const RunFiles run = MadeUpRun{{0, 0.4, 0.5}, {}, {v}, {}, {}}.write(folder);
  EXPECT_NEAR(read(run, "two-bar-stick", "restitution, of the means since the impact"), 0.1, 1e-12);
}

TEST_F(Readings, PendulumReturnsToAPartOfItsAngle) {
  MadeUpRun run{{}, {{"tracked_angle", {}}}, {}, {}, {}};
  const double decay = 0.1, omega = 2 * std::numbers::pi / 1.2;
  for (int k = 0; k < 175; ++k) {
    const double t = 0.01 * k;
    run.time.push_back(t);
    run.scene[0].second.push_back(-18.44 * std::exp(-decay * t) * std::cos(omega * t));
  }
  const RunFiles files = run.write(folder);
  EXPECT_NEAR(read(files, "pendulum-40", "amplitude after one swing over the first"), std::exp(-decay * 1.2), 1e-3);
  EXPECT_DOUBLE_EQ(read(files, "pendulum-40", "angle at the start [degrees]"), 18.44);
}

TEST_F(Readings, AStringsThicknessIsItsVolumeOverItsLength) {
  // The ends may have half a piece or a whole one: they do not count.
  const RunFiles run =
      MadeUpRun{
          .snapshots =
              {{0, {{"x", {0, 3, 6, 9}}, {"y", {0, 4, 8, 12}}, {"body", {1, 1, 1, 1}}, {"volume", {9, 0.5, 0.5, 9}}}}}}
          .write(folder);
  EXPECT_DOUBLE_EQ(read(run, "pendulum-40", "thickness"), 0.1);
}

/// Sod's exact solution on points in the middle of half cells.
MadeUpRun sod_tube(double shift) {
  const RiemannSolution exact = solve_riemann({{1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.5});
  MadeUpSnapshot end{0.143, {{"x", {}}, {"y", {}}, {"density", {}}, {"pressure", {}}}};
  for (int k = 0; k < 200; ++k) {
    const double x = (k + 0.5) / 200;
    const GasSample gas = sample(exact, x - shift, end.time);
    const double values[] = {x, 0.005, gas.density, gas.pressure};
    for (std::size_t f = 0; f < 4; ++f) end.fields[f].second.push_back(values[f]);
  }
  return {.snapshots = {end}, .summary = {{"dx", "0.01"}}};
}

/// Written next to the deck that it would have run.
RunFiles tube_run(const MadeUpRun& run, const std::filesystem::path& folder) {
  const RunFiles files = run.write(folder);
  const auto deck = std::filesystem::path(TETHER_SOURCE_DIR) / "decks/sod.in";
  write_file(folder / "deck.effective", load(deck.string(), {}).effective);
  return files;
}

TEST_F(Readings, TheShockOfAnExactTubeIsWhereItBelongs) {
  const RunFiles run = tube_run(sod_tube(0), folder);
  const PublishedQuantity speed = quantity_named("sod", "shock speed"), way = quantity_named("sod", "way of the shock");
  EXPECT_NEAR(speed.exact(run), 1.7522, 1e-4);
  EXPECT_NEAR(speed.reading(run), speed.exact(run), 0.005 / 0.143);  // half a cell
  EXPECT_NEAR(way.reading(run), way.exact(run), 0.005);
  const PublishedQuantity strength = quantity_named("sod", "shock strength p2/p1");
  EXPECT_NEAR(strength.exact(run), 3.0313, 1e-4);
  EXPECT_NEAR(strength.reading(run), strength.exact(run), 1e-9);
  EXPECT_NEAR(way.reading(tube_run(sod_tube(0.05), folder / "later")), way.exact(run) + 0.05, 0.005);
}

TEST_F(Readings, TwoTubesAreComparedCellByCell) {
  auto other = sod_tube(0);
  for (std::size_t p = 40; p < 42; ++p) other.snapshots[0].fields[2].second[p] += 0.004;  // one cell
  sod_tube(0).write(folder / "a");
  other.write(folder / "b");
  const auto difference = quantity_named("sod-continuity", "largest density difference from quadratic").reading;
  EXPECT_NEAR(difference(RunFiles(folder / "b", folder / "a")), 0.004, 1e-12);
  EXPECT_THROW(difference(RunFiles(folder / "b")), FileError);
}

/// A settled quarter: 90 membrane points on a circle, gas of bodies 1 and 2 inside, one point outside.
MadeUpSnapshot ring(double radius, double stress) {
  MadeUpSnapshot end{1, {{"x", {}}, {"y", {}}, {"body", {}}, {"sxx", {}}, {"syy", {}}}};
  const auto add = [&end](std::initializer_list<double> values) {
    std::size_t f = 0;
    for (const double value : values) end.fields[f++].second.push_back(value);
  };
  for (int k = 0; k < 90; ++k) {
    const double angle = (k + 0.5) * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    add({radius * c, radius * s, 3, stress * s * s, stress * c * c});
  }
  add({0.1, 0.1, 1, 0, 0}), add({0.5, 0.5, 2, 0, 0}), add({radius + 0.3, 0, 2, 0, 0});
  return end;
}

TEST_F(Readings, ARingOfGasAndMembrane) {
  MadeUpRun run{.scene = {{"mass", {0.584}}, {"energy_total", {100}}}, .summary = {{"dx", "0.2"}}};
  run.snapshots = {ring(1.4, 440)};
  const RunFiles files = run.write(folder);
  Numbers pressures;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) pressures.push_back(std::hypot(i, j) < 5.999 ? 30.8 + (i - j) : 0);  // within 1.2
  }
  write_nodes(folder / "grid", BackgroundGrid(9, 9, 0, 1.6, 0, 1.6), "pressure", {Numbers(81, 100), pressures});
  std::filesystem::copy_file(folder / "grid" / "mesh.nc", folder / "mesh.nc");
  const auto value = [&](const char* quantity) { return read(files, "membrane-expansion-4", quantity); };
  EXPECT_EQ(value("membrane points"), 90);
  EXPECT_EQ(value("total mass"), 0.584);
  EXPECT_NEAR(value("radius at 0 degrees"), 1.4, 1e-12);
  EXPECT_NEAR(value("radius at 90 degrees"), 1.4, 1e-12);
  EXPECT_NEAR(value("pressure"), 30.8, 1e-12);
  EXPECT_NEAR(value("hoop stress p r/t"), 30.8 * 1.4 / 0.1, 1e-9);
  EXPECT_NEAR(value("hoop stress of the points"), 440, 1e-9);
  EXPECT_NEAR(value("difference of the two stresses [%]"), 100 * (440 / 431.2 - 1), 1e-9);
  EXPECT_EQ(value("gas points that escaped"), 1);
}

TEST_F(Readings, AProbeSinksAndABagHasItsThickness) {
  MadeUpRun run{{0, 0.02, 0.06, 0.1}, {}, {}, {}, {}};
  run.bodies = {{"body_y", {{0, 0, 0, 0}, {0, 0, 0, 0}, {0.36, 0.3, 0.22, 0.25}, {0, 0, 0, 0}}},
                {"body_mass", {{1, 1, 1, 1}, {1, 1, 1, 1}, {6, 6, 6, 6}, {0.3672, 0.3672, 0.3672, 0.3672}}}};
  MadeUpSnapshot bag{0, {{"x", {}}, {"y", {}}, {"body", {}}, {"volume", {}}, {"pressure", {}}}};
  const int count = 400;
  for (int k = 0; k < count; ++k) {  // half of a sphere of radius .3, .5 mm thick
    const double angle = (k + 0.5) / count * std::numbers::pi / 2, x = 0.3 * std::cos(angle);
    const double piece = 0.3 * std::numbers::pi / 2 / count;
    const double values[] = {x, 0.3 * std::sin(angle), 4, 0.5e-3 * piece * 2 * std::numbers::pi * x, 0};
    for (std::size_t f = 0; f < 5; ++f) bag.fields[f].second.push_back(values[f]);
  }
  run.snapshots = {bag};
  const RunFiles files = run.write(folder);
  EXPECT_NEAR(read(files, "cyl-200", "largest displacement of the probe [mm]"), 140, 1e-9);
  EXPECT_NEAR(read(files, "cyl-200", "its time [ms]"), 60, 1e-9);
  EXPECT_NEAR(read(files, "cyl-200", "mass of the probe [kg]"), 6, 1e-12);
  EXPECT_NEAR(read(files, "cyl-200", "mass of the bag [g]"), 367.2, 1e-9);
  EXPECT_NEAR(read(files, "cyl-200", "thickness of the bag [mm]"), 0.5, 1e-4);
}

TEST_F(Readings, AMembraneHoldsOrGivesWay) {
  const auto circle = [](double time, double radius) {
    return MadeUpSnapshot{time, {{"x", {0.1, radius, 0}}, {"y", {0.1, 0, radius}}, {"body", {1, 2, 2}}}};
  };
  const RunFiles holds = MadeUpRun{.snapshots = {circle(0, 1), circle(1, 1.04)}}.write(folder / "holds");
  const RunFiles gives = MadeUpRun{.snapshots = {circle(0, 1), circle(1, 1.2)}}.write(folder / "gives");
  EXPECT_EQ(read(holds, "cylinder-cubic", "the membrane holds (1) or gives way (0)"), 1);
  EXPECT_EQ(read(gives, "cylinder-cubic", "the membrane holds (1) or gives way (0)"), 0);
  EXPECT_NEAR(read(gives, "cylinder-cubic", "mean radius at t = .05 over the first"), 1.2, 1e-12);
}

TEST_F(Readings, TheForceOfARowIsThatOfItsNodes) {
  Numbers before(42, 0), after(42, 0);
  before[38] = 30, before[39] = 36;  // y = 1.9
  after[38] = 31, after[39] = 36;
  write_nodes(folder, BackgroundGrid(2, 21, 0, 0.1, 0, 2), "force_y", {before, after});
  EXPECT_EQ(read(RunFiles(folder), "noise", "force at y = 1.9 before"), 66);
  EXPECT_EQ(read(RunFiles(folder), "noise", "force at y = 1.9 after"), 67);
  EXPECT_EQ(read(RunFiles(folder), "noise", "force at y = 1.8 before"), 0);
}

TEST_F(Readings, WhatTheRunDidNotWriteIsAFileError) {
  const RunFiles run = MadeUpRun{}.write(folder);
  EXPECT_THROW(run.summary("period"), FileError);
  EXPECT_THROW(run.history("body_vx", 3), FileError);
  EXPECT_THROW(run.nodes("mass", 0), FileError);
  EXPECT_THROW(run.outcome("largest_holding"), FileError);
  EXPECT_THROW(RunFiles(folder / "none").summary("steps"), FileError);
}

}  // namespace
}  // namespace tether::published
