// SPDX-License-Identifier: GPL-3.0-or-later
// Gas that comes in and goes out through the edges of the grid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "cases/run_deck.hpp"

namespace tether::cases {
namespace {

/// The tube of decks/open-tube.in on n square cells.
DeckRun tube(int n, const std::vector<std::string>& more = {}) {
  const std::string h = fmt::format("{}", 1.0 / n);
  std::vector<std::string> set{fmt::format("in.nx={}", n + 1),
                               "in.ytop=" + h,
                               "reg.yvi(3,1)=" + h,
                               "reg.yvi(4,1)=" + h,
                               "reg.yvi(3,2)=" + h,
                               "reg.yvi(4,2)=" + h,
                               fmt::format("in.tstep={}", 0.1 / n)};
  set.insert(set.end(), more.begin(), more.end());
  return run_deck("open-tube", set);
}

void expect_booked(const DeckRun& run) {
  const auto mass = run.history.column("mass"), in = run.history.column("edge_mass_in"),
             out = run.history.column("edge_mass_out");
  for (std::size_t k = 0; k < mass.size(); ++k)
    ASSERT_NEAR(mass[k] - mass[0] - in[k] + out[k], 0, 1e-12 * mass[0]) << "record " << k;
}

TEST(OpenTube, FollowsTheExactSolutionAtFirstOrder) {
  const DeckRun coarse = tube(100), middle = tube(200), fine = tube(400);
  for (const char* error : {"error_density", "error_velocity", "error_pressure"}) {
    const double first = coarse.summary.at(error), second = middle.summary.at(error), third = fine.summary.at(error);
    RecordProperty(error, fmt::format("{} {} {}", first, second, third));
    EXPECT_GE(std::log2(first / third) / 2, 0.85) << error << " " << first << " " << second << " " << third;
  }
  for (const DeckRun* run : {&coarse, &middle, &fine}) {
    expect_booked(*run);
    EXPECT_LE(run->summary.at("mass_drift"), 1e-12);
    EXPECT_GT(run->last("edge_mass_in"), 0);
    EXPECT_EQ(run->summary.at("compared_from"), 0);  // open edges send nothing into the tube
    EXPECT_EQ(run->summary.at("compared_to"), 1);
  }
}

/// A box of gas that moves at (u, v), 10 x 6 cells, all edges as given.
std::string stream(double u, double v, const std::string& edges, const std::string& method) {
  return fmt::format(
      "a stream\n$in\nnx=11, ny=7, igen=1, xleft=0., xright=1., ybot=0., ytop=.6, tmax=2., tstep=5.d-3\n$\n"
      "$fluid\ngm1=.4, siep(1)=2.5\n$\n$reg\nnreg=1, nvi=4, xvi(1,1)=0.,1.,1.,0., yvi(1,1)=0.,0.,.6,.6,\n"
      "rex=100., rey=100., nprg=9, densir=1., ipath(1,1)=3,3,3,9, vrx={0}, vry={1}\n$\n"
      "$mpm method='{3}', edge={2}, edge_density=4*1., edge_energy=4*2.5, edge_u=4*{0}, edge_v=4*{1}\n$\n",
      u, v, edges, method);
}

/// Largest departure of the last points' velocity, density and pressure from the stream's, over their sizes.
double unevenness(const DeckRun& run, double u, double v) {
  double largest = 0;
  const auto look = [&](const char* name, double right, double size) {
    const auto values = read_variable(run.folder + "/particles.nc", name);
    const std::size_t records = read_variable(run.folder + "/particles.nc", "time").size();
    const std::size_t points = values.size() / records;
    for (std::size_t p = values.size() - points; p < values.size(); ++p) {
      if (!std::isnan(values[p])) largest = std::max(largest, std::abs(values[p] - right) / size);
    }
  };
  const double c = std::sqrt(1.4);
  look("vx", u, c), look("vy", v, c), look("density", 1, 1), look("pressure", 1, 1);
  return largest;
}

TEST(OpenStream, StaysUniformAtMachAFifthAndTwo) {
  const double c = std::sqrt(1.4);
  for (const double mach : {0.2, 2.0}) {
    const double speed = mach * c;
    const DeckRun along_x = run_text("x", stream(speed, 0, "'inflow','outflow'", "robust"));
    EXPECT_LE(unevenness(along_x, speed, 0), 1e-3) << mach;
    const DeckRun against_x = run_text("back", stream(-speed, 0, "'outflow','inflow'", "robust"));
    EXPECT_LE(unevenness(against_x, -speed, 0), 1e-3) << mach;
    const DeckRun along_y = run_text("y", stream(0, speed, "2*'wall','inflow','outflow'", "robust"));
    EXPECT_LE(unevenness(along_y, 0, speed), 1e-3) << mach;
    for (const DeckRun* run : {&along_x, &against_x, &along_y}) {
      expect_booked(*run);
      EXPECT_NEAR(run->last("edge_mass_in"), speed * 2 * (run == &along_y ? 1 : 0.6), 0.06) << mach;
    }
  }
}

/// A shut tube of 20 cells with gas at rest, or as given, whose right edge is open to gas of density 1 and pressure 1.
DeckRun open_to_a_room(const std::string& energy, const std::vector<std::string>& more = {}) {
  const std::string deck =
      "a tube open to a room\n$in\nnx=21, ny=2, igen=1, xleft=0., xright=1., ybot=0., ytop=.05, tmax=4., "
      "tstep=5.d-3\n$\n"
      "$fluid\ngm1=.4, siep(1)=" +
      energy +
      "\n$\n$reg\nnreg=1, nvi=4, xvi(1,1)=0.,1.,1.,0., yvi(1,1)=0.,0.,.05,.05,\n"
      "rex=100., rey=100., nprg=9, densir=1., ipath(1,1)=3,3,3,9\n$\n"
      "$mpm method='robust', edge(2)='outflow', edge_density(2)=1., edge_energy(2)=2.5\n$\n"
      "$points tracked_at(1,1)=.99,.025\n$\n";
  return run_text("room", deck, more);
}

/// A tube of 20 cells by the thesis' method, whose gas all but rests. [velocity]
DeckRun all_but_at_rest(const std::string& mpm) {
  constexpr double speed = 1e-9;
  return run_text("rest", fmt::format("gas at rest in a tube\n$in\nnx=21, ny=2, igen=1, xleft=0., xright=1., ybot=0., "
                                      "ytop=.05, tmax=8., tstep=2.d-3\n$\n$fluid\ngm1=.4, siep(1)=2.5\n$\n"
                                      "$reg\nnreg=1, nvi=4, xvi(1,1)=0.,1.,1.,0., yvi(1,1)=0.,0.,.05,.05,\n"
                                      "rex=100., rey=100., nprg=9, densir=1., ipath(1,1)=3,3,3,9, vrx={}\n$\n"
                                      "$mpm method='thesis', {}\n$\n",
                                      speed, mpm));
}

TEST(OpenEdge, GasAtRestByTheThesisMethodStaysAtRest) {
  const std::string outside = ", edge_density=2*1., edge_energy=2*2.5";
  for (const std::string& mpm :
       {std::string("edge='wall','outflow'"), std::string("edge='outflow','outflow'"),
        "edge='wall','outflow'" + outside, "edge='inflow','outflow', edge_u=2*0." + outside,
        std::string("edge='wall','outflow', density='continuity'"),
        std::string("edge='wall','outflow', density='grid'"), std::string("edge='wall','outflow', order='usf'"),
        std::string("edge='wall','outflow', transfer='apic'"), std::string("edge='wall','outflow', kernel='bspline'"),
        std::string("edge='wall','outflow', kernel='bspline', density='grid'")}) {
    const DeckRun run = all_but_at_rest(mpm);
    EXPECT_LE(unevenness(run, 0, 0), 1e-7) << mpm;  // the wall it parts from thins it by 1e-9 a unit of time
    EXPECT_EQ(run.last("edge_mass_out"), 0) << mpm;
    expect_booked(run);
  }
}

std::string messages(const DeckRun& run) { return read_file(run.folder + "/messages.txt"); }

double total_with_what_passed(const History& history, std::size_t k) {
  return history.column("energy_total")[k] - history.column("edge_energy_in")[k] + history.column("edge_energy_out")[k];
}

TEST(OpenEdge, GasThatTurnsRoundIsToldAndHasTheStateOutside) {
  const DeckRun run = open_to_a_room("1.");  // the room's pressure is 2.5 times the gas's
  EXPECT_NE(messages(run).find("gas comes in at the right edge, an outflow, with the state given for outside"),
            std::string::npos);
  EXPECT_GT(run.last("edge_mass_in"), 0.01);
  EXPECT_EQ(run.last("edge_mass_back"), run.last("edge_mass_in"));
  expect_booked(run);
  EXPECT_LE(run.summary.at("energy_drift"), 1e-12);
  const auto pressure = read_variable(run.folder + "/particles.nc", "pressure");
  EXPECT_NEAR(pressure.back(), 1, 0.05);  // it has come to the room's
}

TEST(OpenEdge, GasUnderPressureLeavesAndRingsAboutTheRooms) {
  const DeckRun run = open_to_a_room("5.", {"in.tmax=20."});
  EXPECT_GT(run.last("edge_mass_out"), 0.01);
  expect_booked(run);
  EXPECT_LE(run.summary.at("energy_drift"), 1e-12);
  const auto energy = run.history.column("energy_internal");
  const auto half = static_cast<std::ptrdiff_t>(energy.size() / 2);
  const double mean = std::accumulate(energy.begin() + half, energy.end(), 0.0) /
                      static_cast<double>(energy.size() - energy.size() / 2);
  EXPECT_NEAR(mean * 0.4 / 0.05, 1, 0.05);  // the pressure, which rings as in a pipe with an open end
}

TEST(OpenEdge, ATrackedPointThatLeavesIsToldAndIsNoNumber) {
  const DeckRun run = open_to_a_room("5.", {"in.tmax=0.5"});
  EXPECT_NE(messages(run).find("leaves by the right edge"), std::string::npos);
  EXPECT_FALSE(std::isnan(run.first("point_x_1")));
  EXPECT_TRUE(std::isnan(run.last("point_x_1")));
}

TEST(OpenEdge, NumbersOfPointsAreTheirOwnAndParticlesAreThoseWithin) {
  const DeckRun run = tube(50);
  const auto id = read_variable(run.folder + "/particles.nc", "id"),
             mass = read_variable(run.folder + "/particles.nc", "mass");
  const std::size_t records = read_variable(run.folder + "/particles.nc", "time").size(), points = id.size() / records;
  std::set<double> seen;
  double sum = 0;
  for (std::size_t p = id.size() - points; p < id.size(); ++p) {
    if (std::isnan(id[p])) continue;
    EXPECT_TRUE(seen.insert(id[p]).second) << id[p];
    sum += mass[p];
  }
  EXPECT_NEAR(sum, run.last("mass"), 1e-14);
}

TEST(OpenEdge, PointsStayAsManyHoweverLongTheStream) {
  const double speed = 2 * std::sqrt(1.4);
  const DeckRun run = run_text("long", stream(speed, 0, "'inflow','outflow'", "robust"), {"in.tmax=8."});
  EXPECT_GT(run.last("edge_mass_in"), 15 * run.first("mass"));
  EXPECT_LE(run.summary.at("points"), 540 + 2 * 6 * 54 + 2 * 18);
}

TEST(OpenEdge, TwoGasesLeaveOneAfterTheOther) {
  const DeckRun run = run_text(
      "two",
      "two gases\n$in\nnx=21, ny=2, igen=1, xleft=0., xright=1., ybot=0., ytop=.05, tmax=3., tstep=5.d-3\n$\n"
      "$fluid\ngm1=.4, siep=2.5,.625\n$\n$reg\nnreg=2, nvi=4,4, xvi(1,1)=0.,.5,.5,0., yvi(1,1)=0.,0.,.05,.05,\n"
      "xvi(1,2)=.5,1.,1.,.5, yvi(1,2)=0.,0.,.05,.05, rex=2*100., rey=2*100., nprg=2*9, densir=1.,4.,\n"
      "ipath(1,1)=3,3,3,9, ipath(1,2)=3,3,3,9, vrx=.5,.5\n$\n"
      "$mpm method='robust', edge='inflow','outflow', edge_density(1)=1., edge_energy(1)=2.5, edge_u(1)=.5\n$\n");
  expect_booked(run);
  EXPECT_EQ(run.last("body_mass_2"), 0);
  EXPECT_NEAR(run.last("body_mass_1"), 0.05, 0.001);
  EXPECT_LE(run.summary.at("energy_drift"), 1e-12);
}

TEST(OpenEdge, MomentumIsBookedWithThePressureOnTheEdge) {
  const DeckRun run = tube(100);
  const auto px = run.history.column("momentum_x"), passed = run.history.column("edge_momentum_x");
  for (std::size_t k = 0; k < px.size(); ++k) ASSERT_NEAR(px[k] - passed[k], px[0], 1e-14);
  EXPECT_NEAR(total_with_what_passed(run.history, px.size() - 1), total_with_what_passed(run.history, 0), 1e-14);
  const double entering = 0.2 * 0.01 * (1 + 0.75 * 0.75), leaving = 0.2 * 0.01 * 0.1;  // (p + rho u^2) t A
  EXPECT_NEAR(passed.back(), entering - leaving, 0.02 * entering);
}

/// A block of an elastic solid that moves to the right edge, through gas.
TEST(OpenEdge, ASolidThatComesToTheEdgeEndsTheRun) {
  const std::string deck =
      "a block\n$in\nnx=21, ny=11, igen=1, xleft=0., xright=2., ybot=0., ytop=1., tmax=1., tstep=5.d-3\n$\n"
      "$fluid\ngm1=.4, siep=.025\n$\n$reg\nnreg=2, nvi=4,4, xvi(1,1)=0.,1.,1.,0., yvi(1,1)=0.,0.,1.,1.,\n"
      "xvi(1,2)=1.,1.5,1.5,1., yvi(1,2)=.3,.3,.7,.7, rex=2*100., rey=2*100., nprg=4,4, densir=.01,5.,\n"
      "ipath(1,1)=3,3,3,7, ipath(1,2)=3,3,3,0, matr(1,2)=10.,.3, vrx=2.,2.\n$\n"
      "$mpm method='robust', edge='inflow','outflow', edge_density(1)=.01, edge_energy(1)=.025, edge_u(1)=2.\n$\n";
  try {
    run_text("block", deck);
    FAIL() << "the block has left";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("is beyond an open edge, through which only gas passes"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace tether::cases
