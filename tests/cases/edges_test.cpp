// SPDX-License-Identifier: GPL-3.0-or-later
// Gas that comes in and goes out through the edges of the grid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace tether::cases
