// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

// Elastic bodies immersed in a flow.

namespace tether::cases {
namespace {

double largest_part(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value / values.front() - 1));
  return largest;
}

struct RingAtRest {
  double inside = 0, outside = 0, fastest = 0;
};

/// Pressures less their mean over the box, and the largest velocity that is left.
RingAtRest ring(int cells, int along, int across) {
  std::vector<std::string> deck{"mesh.cells(1,1)=" + std::to_string(cells), "mesh.cells(2,1)=" + std::to_string(cells)};
  for (const char* region : {"2", "3", "4", "5"}) {
    deck.push_back(std::string("mesh.cells(1,") + region + ")=" + std::to_string(across));
    deck.push_back(std::string("mesh.cells(2,") + region + ")=" + std::to_string(along));
  }
  const DeckRun run = run_deck("immersed-ring", deck);
  const auto x = read_variable(run.folder + "/mesh.nc", "node_x"), y = read_variable(run.folder + "/mesh.nc", "node_y");
  const auto last = [&](const char* name) {
    const auto all = read_variable(run.folder + "/mesh.nc", name);
    return std::vector<double>(all.end() - static_cast<std::ptrdiff_t>(x.size()), all.end());
  };
  const auto p = last("p"), vx = last("vx"), vy = last("vy");
  RingAtRest rest;
  double mean = 0, weight = 0, in = 0, out = 0, ins = 0, outs = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double r = std::hypot(x[n] - 0.5, y[n] - 0.5);
    const auto edge = [](double s) { return s < 1e-9 || s > 1 - 1e-9 ? 0.5 : 1.0; };
    const double w = edge(x[n]) * edge(y[n]);
    mean += w * p[n], weight += w;
    if (r < 0.2) in += p[n], ++ins;
    if (r > 0.38) out += p[n], ++outs;
    rest.fastest = std::max(rest.fastest, std::hypot(vx[n], vy[n]));
  }
  rest.inside = in / ins - mean / weight, rest.outside = out / outs - mean / weight;
  return rest;
}

/// sigma_rr(R) - sigma_rr(r) = mu ln(R/r) for the fibre's stress mu: .22314 from .25 to .3125, less its mean.
TEST(Immersed, RingPressesOnTheFluidInside) {
  const RingAtRest coarse = at_full_length() ? ring(32, 25, 4) : ring(16, 13, 2),
                   fine = at_full_length() ? ring(64, 50, 8) : ring(32, 25, 4);
  EXPECT_NEAR(fine.inside / 0.1679, 1, 0.03);
  EXPECT_NEAR(fine.outside / -0.0552, 1, 0.03);
  EXPECT_NEAR(coarse.inside / 0.1679, 1, 0.03);
  EXPECT_LT(fine.fastest, 0.6 * coarse.fastest) << coarse.fastest;
}

/// Coarser than the deck, over its first quarter, or sixteenth; the densities at one step.
TEST(Immersed, DiskKeepsItsAreaWhateverItsDensity) {
  for (const char* density : {"1.", ".5", "10."}) {
    std::vector<std::string> deck{at_full_length() ? "in.tmax=2." : "in.tmax=.5", "mesh.cells(1,1)=32",
                                  "mesh.cells(2,1)=32"};
    for (const char* region : {"2", "3", "4", "5", "6"})
      deck.push_back(std::string("reg.densir(") + region + ")=" + density);
    const DeckRun run = run_deck("disk", deck);
    std::vector<double> area(run.history.records.size(), 0.0);
    for (const char* region : {"1", "2", "3", "4", "5"}) {
      const auto part = run.history.column(std::string("body_volume_") + region);
      for (std::size_t k = 0; k < area.size(); ++k) area[k] += part[k];
    }
    EXPECT_LT(largest_part(area), at_full_length() ? 0.01 : 1.2e-4) << density;
    EXPECT_LT(run.summary.at("energy_drift"), at_full_length() ? 0.02 : 1e-6) << density;
  }
}

/// A light body of few elements would take more mass from the fluid than its nodes have: the run tells so.
TEST(Immersed, LightBodiesOfCoarseElementsAreTold) {
  const auto run = [](const std::string& along, const std::string& across) {
    std::vector<std::string> deck{"in.tmax=.002",
                                  "in.tstep=.0005",
                                  "in.gravc=-1.",
                                  "flow.element='q2q1'",
                                  "mesh.cells(1:2,1)=16,16",
                                  "flow.boundary_u(1)='0'",
                                  "mesh.cells(1:2,2)=" + along + "," + along};
    for (const char* region : {"2", "3", "4", "5", "6"}) {
      deck.push_back(std::string("reg.densir(") + region + ")=.1");
      if (*region > '2') deck.push_back(std::string("mesh.cells(1:2,") + region + ")=" + across + "," + along);
    }
    return run_deck("disk", deck);
  };
  EXPECT_NO_THROW(run("16", "8"));
  try {
    run("2", "1");
    FAIL() << "a body of 12 elements";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("kinetic energy is negative"), std::string::npos) << error.what();
  }
}

/// The areas are those of bodies whose volume the fluid holds: by their own law, of nu = 0.4, they change by 1.2 %.
TEST(Immersed, FlapsMirrorEachOtherAndKeepTheirAreas) {
  const DeckRun run = run_deck("two-flaps", {"in.tmax=.3", "in.iout(13)=1", "in.tiout(13)=.3", "flow.element='q1q1'",
                                             "flow.volume(2:3)='fluid','fluid'", "flow.tracers(1)=160",
                                             "flow.tracers(2)=32", "flow.tracer_box(1)=0.", "flow.tracer_box(2)=4.",
                                             "flow.tracer_box(3)=0.", "flow.tracer_box(4)=1.61"});
  const auto x = run.history.column("point_x_1"), y = run.history.column("point_y_1");
  const auto lower_x = run.history.column("point_x_2"), lower_y = run.history.column("point_y_2");
  const double range = *std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end());
  EXPECT_GT(range, 0.4);
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_NEAR(x[k], lower_x[k], 1e-3 * range);
    EXPECT_NEAR(y[k], 1.61 - lower_y[k], 1e-3 * range);
  }
  EXPECT_LT(largest_part(run.history.column("body_volume_1")), 0.005);
  EXPECT_LT(largest_part(run.history.column("body_volume_2")), 0.005);
  EXPECT_LT(run.summary.at("energy_drift"), 0.02);
  for (const double inside : run.history.column("tracers_in_solids")) EXPECT_EQ(inside, 0);
  EXPECT_GT(read_variable(run.folder + "/particles.nc", "x").size(), 2u * 4000u);
}

/// The flaps in cm, g and s, and in m, kg and s: the same motion but for rounding.
TEST(Immersed, FlapsDoNotDependOnUnits) {
  const auto run = [](const std::string& deck) {
    return run_deck(deck, {"flow.element='q1q1'", "mesh.cells(1:2,1)=24,6", "mesh.cells(1:2,2)=1,4",
                           "mesh.cells(1:2,3)=1,4", "in.tmax=.2"});
  };
  const DeckRun cgs = run("two-flaps"), si = run("two-flaps-si");
  EXPECT_GT(cgs.last("point_x_1") - cgs.first("point_x_1"), .1);
  for (const char* column : {"point_x_1", "point_y_1", "point_x_2", "point_y_2"}) {
    const auto here = cgs.history.column(column), there = si.history.column(column);
    ASSERT_EQ(here.size(), 41u);
    ASSERT_EQ(there.size(), 41u);
    for (std::size_t k = 0; k < 41; ++k) EXPECT_NEAR(here[k], 100 * there[k], 1e-10) << column << " " << k;
  }
  EXPECT_NEAR(cgs.last("energy_total") / si.last("energy_total"), 1e5, 1e-3);  // of a cm and of a m of depth
}

/// Of 1,600 tracers over the box those on the disk of area .04 pi are left away, whatever its elements; none goes in.
TEST(Immersed, TracersStartOutsideOfSolids) {
  for (const char* element : {"'q1'", "'q2'", "'p1'"}) {
    const DeckRun run = run_deck(
        "disk", {std::string("mesh.element=") + element, "in.tmax=.1", "mesh.cells(1,1)=8", "mesh.cells(2,1)=8",
                 "flow.tracers(1)=40", "flow.tracers(2)=40", "in.iout(13)=1", "in.tiout(13)=.1"});
    const auto x = read_variable(run.folder + "/particles.nc", "x");
    EXPECT_NEAR(static_cast<double>(x.size()) / 2, 1600 * (1 - 0.04 * 3.14159), 12) << element;
    EXPECT_EQ(run.first("tracers_in_solids"), 0) << element;
  }
}

}  // namespace
}  // namespace tether::cases
