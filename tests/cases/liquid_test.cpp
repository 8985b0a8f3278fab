// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/liquid_support.hpp"
#include "cases/run_deck.hpp"

// Liquids with a surface, against exact solutions and against themselves on finer grids. Density and gravity are 1.

namespace tether::cases {
namespace {

using std::numbers::pi;

TEST(Liquid, StandingWaves) {
  const int periods = at_full_length() ? 10 : 5;
  const Wave coarse = wave(32, 0.01, 2, periods), small = wave(64, 0.01, 2, periods),
             large = wave(64, 0.05, 2, periods);
  EXPECT_LT(std::abs(small.frequency), 0.005);
  EXPECT_LT(std::abs(large.frequency), 0.005);
  EXPECT_GT(std::log2(std::abs(coarse.frequency / small.frequency)), 1.3);  // of order 2 and more
  EXPECT_LT(small.damping, 0.005);
  EXPECT_LT(large.damping, 0.015);
  EXPECT_GT(std::min(small.damping, large.damping), -0.002);
}

TEST(Liquid, StandingWavesInSpace) {
  const Wave coarse = wave(32, 0.05, 3, 5);
  EXPECT_LT(std::abs(coarse.frequency), 0.025);
  EXPECT_GT(coarse.damping, -0.002);
}

double front(const DeckRun& run, double time) {
  const auto t = run.history.column("time"), p = run.history.column("liquid_x");
  const auto after = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  const double part = (time - t[after - 1]) / (t[after] - t[after - 1]);
  return (1 - part) * p[after - 1] + part * p[after];
}

/// A column half as wide as it is high falls; T = t sqrt(2 g / a) with its width a.
TEST(Liquid, ColumnsCollapseAlikeOnFinerGrids) {
  std::vector<double> middle;
  for (const int cells : {32, 64}) {
    const double cell = 1.0 / cells;
    const DeckRun run =
        run_text("dam", box(2 * cells + cells / 2, cells + cells / 4, cell, 0.25 * std::sqrt(cell), 1.5) +
                            liquid("liquid_box(1,1)=0.,.5,0.,1."));
    const auto energy = run.history.column("energy_total");
    EXPECT_LT(*std::max_element(energy.begin(), energy.end()), energy.front() * (1 + 1e-3));
    EXPECT_NEAR(run.last("fluid_volume"), 0.5, 0.005);  // T = 3
    EXPECT_NEAR(run.last("liquid_volume"), 0.5, 1e-12);
    middle.push_back(front(run, 1.4));
  }
  EXPECT_NEAR(middle[0], middle[1], 0.01);
}

TEST(Liquid, DropsSmallerThanACellFall) {
  const double h = 0.01;
  const DeckRun run =
      run_text("drop", box(32, 32, 1.0 / 32, h, 0.8) + liquid("liquid_ellipse(1,1)=.501,.515,.901,.915"));
  const auto y = run.history.column("liquid_y"), x = run.history.column("liquid_x");
  for (std::size_t n = 0; n < y.size(); ++n)
    EXPECT_NEAR(y[n] - y[0], -0.5 * h * h * static_cast<double>(n * (n + 1)), 1e-12) << n;
  EXPECT_NEAR(x.back(), x.front(), 1e-12);
}

/// A film slides down a slope of 30 degrees that holds it by nothing.
TEST(Liquid, FilmsSlideFreely) {
  const double c = std::cos(pi / 6), s = 0.5, cell = 1.0 / 64, h = 0.25 * std::sqrt(cell);
  for (const int thick : {2, 4}) {
    std::string corners;
    for (const auto& [a, b] : {std::pair(0.475, -0.03), {0.875, -0.03}, {0.875, thick * cell}, {0.475, thick * cell}})
      corners += fmt::format("{:.17g},{:.17g},", a * c - b * s, 0.15 + a * s + b * c);
    const DeckRun run = run_text(
        "film", box(64, 64, cell, h, 0.6) +
                    liquid("liquid_polygon(1,1)=" + corners + fmt::format("obstacle_plane(1,1)=0.,.15,{},{}", -s, c)));
    const double speed = -run.last("liquid_vx") * c - run.last("liquid_vy") * s, t = run.history.column("time").back();
    EXPECT_NEAR(speed / (s * t), 1, 0.06) << thick;
    EXPECT_NEAR(run.last("fluid_volume") / (thick * cell * 0.4), 1, 0.1) << thick;
  }
}

/// A block of half the density floats with half of it under water.
TEST(Liquid, BlocksFloat) {
  for (const int cells : {32, 48}) {
    const double cell = 1.0 / cells;
    const DeckRun run = run_text(
        "float",
        box(cells, cells, cell, 0.125 * std::sqrt(cell), 4) +
            "$reg nreg=1, nvi=4, densir(1)=.5, xvi(1,1)=.35,.65,.65,.35, yvi(1,1)=.4,.4,.6,.6, matr(1,1)=1e4,.3 $\n"
            "$mesh cells(1,1)=6,4 $\n" +
            liquid("liquid_below(1)='.5'"));
    EXPECT_NEAR(run.last("body_y_1") - run.first("body_y_1"), 0, 0.01 * 0.1);
    EXPECT_NEAR(run.last("body_x_1") - run.first("body_x_1"), 0, 1e-3);
    EXPECT_LT(run.summary.at("interface_mismatch"), 1e-9);
    EXPECT_EQ(run.first("liquid_particles"), run.last("liquid_particles"));
  }
}

/// A light block rises from below, goes through the surface and bobs; nothing gives it energy.
TEST(Liquid, BlocksRise) {
  const DeckRun run = run_text(
      "rise",
      box(32, 32, 1.0 / 32, 0.02, 10) +
          "$reg nreg=1, nvi=4, densir(1)=.3, xvi(1,1)=.413,.613,.613,.413, yvi(1,1)=.15,.15,.3,.3, matr(1,1)=1e4,.3 $\n"
          "$mesh cells(1,1)=6,4 $\n" +
          liquid("liquid_below(1)='.5'"));
  const auto energy = run.history.column("energy_total"), y = run.history.column("body_y_1");
  EXPECT_LT(*std::max_element(energy.begin(), energy.end()), energy.front() * (1 + 1e-3));
  EXPECT_LT(run.summary.at("interface_mismatch"), 1e-9);
  const double level = 0.47 + 0.009, draft = 0.3 * 0.15;
  double mean = 0;
  const std::size_t settled = y.size() * 6 / 10;
  for (std::size_t i = settled; i < y.size(); ++i) mean += y[i] / static_cast<double>(y.size() - settled);
  EXPECT_NEAR(mean, level - draft + 0.075, 0.01);
}

/// A bubble shut in by water stays as large, where air is sealed, and vanishes where it is nothing.
TEST(Liquid, SealedAirStays) {
  const std::string bubble =
      "liquid_polygon(1,1)=0.,0.,1.,0.,1.,.7,.5,.7,.5,.4,.6,.3,.5,.2,.4,.3,.4999,.4,.4999,.7,0.,.7";
  const auto run = [&](const std::string& more) {
    return run_text("bubble", box(32, 32, 1.0 / 32, 0.01, 0.5) + liquid(bubble + more));
  };
  const DeckRun sealed = run(",air='sealed'"), gone = run("");
  EXPECT_GT(sealed.last("surface_area"), 1.4);
  EXPECT_LT(gone.last("surface_area"), 1.1);
  EXPECT_NEAR(sealed.last("fluid_volume"), sealed.first("fluid_volume"), 0.003);
}

/// The facets of surface.nc are the surface: as long in all as the column says, and where the liquid ends.
TEST(Liquid, SurfaceFiles) {
  const DeckRun run = run_text("surface", box(32, 32, 1.0 / 32, 0.01, 0.2) + "$in iout(39)=1, tiout(39)=.1 $\n" +
                                              liquid("liquid_below(1)='.5+.05*cos(2*pi*x)'"));
  const auto x = read_variable(run.folder + "/surface.nc", "x"), y = read_variable(run.folder + "/surface.nc", "y");
  double length = 0;
  const std::size_t corners = x.size() / 3;  // of each of three records, the longest
  for (std::size_t k = 0; k + 1 < corners && std::isfinite(x[k]); k += 2) {
    length += std::hypot(x[k + 1] - x[k], y[k + 1] - y[k]);
    EXPECT_NEAR(y[k], 0.5 + 0.05 * std::cos(2 * pi * x[k]), 0.2 / 32);
  }
  EXPECT_NEAR(length, run.first("surface_area"), 1e-9);
  EXPECT_GT(length, 1.02);
}

/// What a jet brings is its own, whatever the grid, and what leaves by a hole is gone.
TEST(Liquid, JetsPourAndHolesDrain) {
  const DeckRun run = run_text(
      "pour", box(32, 32, 1.0 / 32, 0.01, 3) +
                  liquid("jet_on(1)='top', jet(1,1)=.41,.503, jet_speed(1)=1., open_on(1)='right', open(1,1)=.05,.12"));
  EXPECT_NEAR(run.last("liquid_in"), 0.093 * 3, 0.093 / 96);  // to a layer of particles
  EXPECT_NEAR(run.last("liquid_volume"), run.last("liquid_in") - run.last("liquid_out"), 1e-12);
  EXPECT_GT(run.last("liquid_out"), 0.02);
}

/// A jet without gravity goes on as it came in, whatever the step.
TEST(Liquid, JetsGoStraightOn) {
  for (const double step : {0.004, 0.001}) {
    const DeckRun run = run_text("straight", box(40, 40, 1.0 / 40, step, 0.4) + "$in gravc=0. $\n" +
                                                 liquid("jet_on(1)='left', jet(1,1)=.43,.55, jet_speed(1)=2."));
    EXPECT_NEAR(run.last("liquid_vx"), 2, 1e-12);
    EXPECT_NEAR(run.last("liquid_vy"), 0, 1e-12);
    EXPECT_NEAR(run.last("energy_kinetic"), 0.5 * 4 * run.last("liquid_volume"), 1e-12);
    EXPECT_NEAR(run.last("liquid_volume"), 0.12 * 2 * 0.4, 0.12 / 120);
  }
}

/// A lid sinks into a bowl that is full: what is pressed out runs over, and none of it is lost or in the bodies.
TEST(Liquid, BodiesThatCloseLoseNone) {
  const DeckRun run = run_text(
      "lid",
      box(40, 40, 1.0 / 40, at_full_length() ? 0.01 : 0.02, 3) +
          "$reg nreg=2, nvi=4,4, densir(1)=2.,4., xvi(1,1)=.2,.8,.8,.2, yvi(1,1)=.0,.0,.1,.1, "
          "xvi(1,2)=.31,.69,.69,.31, yvi(1,2)=.4,.4,.5,.5, matr(1,1)=1e3,.3, matr(1,2)=1e3,.3 $\n"
          "$mesh cells(1,1)=12,2, cells(1,2)=8,2, side(1,1)='foot' $\n$fem fix_on(1)='foot', fix(1:2,1)=0.,0. $\n"
          "$contact $\n" +
          liquid("liquid_box(1,1)=.3,.7,.1,.3"));
  EXPECT_EQ(run.first("liquid_particles"), run.last("liquid_particles"));
  EXPECT_NEAR(run.last("liquid_volume"), 0.08, 1e-6);
  EXPECT_LT(run.last("body_y_2"), 0.25);  // it has come down
  EXPECT_EQ(run.summary.at("nodes_inside"), 0);
}

}  // namespace
}  // namespace tether::cases
