// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases/contact_support.hpp"
#include "cases/run_deck.hpp"

// Bodies that stop each other, against exact solutions: a pressure that passes from mesh to mesh, Hertz' cylinder, bars
// end on.

namespace tether::cases {
namespace {

/// Nodal numbers of a run's end.
struct NodesAtEnd {
  std::vector<double> x, y, syy;
  explicit NodesAtEnd(const DeckRun& run) {
    const std::string file = run.folder + "/mesh.nc";
    x = read_variable(file, "node_x"), y = read_variable(file, "node_y"), syy = read_variable(file, "syy");
    syy.erase(syy.begin(), syy.end() - static_cast<std::ptrdiff_t>(x.size()));
  }
};

/// Two blocks of E = 1 whose meshes do not match, the upper one a little above the lower one and pressed on it.
struct Patch {
  const char* element;
  int below, above;
  bool in_space = false;
  const char* more = "";  ///< of $contact
  static constexpr double pressure = 1e-3;

  double bottom_of_upper() const { return 1 + 0.95 * 0.1 / above; }
  DeckRun run() const {
    const double y = bottom_of_upper();
    const std::string z = in_space ? "z(1,1)=0.,1.,z(1,2)=0.,1.," : "";
    const std::string back = in_space ? "fix_on(4)='1.back',fix(3,4)=0.,fix_on(5)='2.back',fix(3,5)=0.," : "";
    return run_text(
        "patch",
        frame(1, 1) +
            fmt::format(
                "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,xvi(1,2)=0.,1.,1.,0.,yvi(1,2)={0},{0},"
                "{1},{1},densir=2*1.,matr(1,1)=1.,.3,matr(1,2)=1.,.3 $\n$mesh element='{2}',{3}cells(1,1)={4},{4},{4},"
                "cells(1,2)={5},{5},{5} $\n$fem static=.true.,law(1)='linear',law(2)='linear',fix_on(1)='1.bottom',"
                "fix(2,1)=0.,fix_on(2)='1.left',fix(1,2)=0.,fix_on(3)='2.left',fix(1,3)=0.,{6}load_on(1)='2.top',"
                "load(2,1)={7} $\n$contact {8} $\n",
                y, y + 1, element, z, below, above, back, -pressure, more));
  }
};

/// The largest error of the pressure at the nodes that touch, over it.
double pressure_off(const Patch& patch) {
  const DeckRun run = patch.run();
  EXPECT_NEAR(run.last("contact_force") / Patch::pressure, 1, 1e-6);
  const NodesAtEnd nodes(run);
  double most = 0;
  for (std::size_t k = 0; k < nodes.y.size(); ++k) {
    if (std::min(std::abs(nodes.y[k] - 1), std::abs(nodes.y[k] - patch.bottom_of_upper())) < 1e-9)
      most = std::max(most, std::abs(nodes.syy[k] / Patch::pressure + 1));
  }
  return most;
}

/// A block pressed on a plane, whose points of quadrature alone make the pressure: nothing is off.
DeckRun block_on_plane(const char* element, bool in_space) {
  return run_text(
      "on_plane",
      frame(1, 1) +
          fmt::format("$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=.03,.03,1.03,1.03,densir=1.,matr(1,1)=1.,.3 $\n"
                      "$mesh element='{}',cells(1,1)=3,3,3{} $\n$fem static=.true.,law(1)='linear',fix_on(1)='1.left',"
                      "fix(1,1)=0.,load_on(1)='1.top',load(2,1)=-1e-3{} $\n$contact plane(1,1)={} $\n",
                      element, in_space ? ",z(1,1)=0.,1." : "", in_space ? ",fix_on(2)='1.back',fix(3,2)=0." : "",
                      in_space ? "0.,0.,0.,0.,1.,0." : "0.,0.,0.,1."));
}

TEST(Contact, PassesAPressureToAPlaneToAllDigits) {
  for (const char* element : {"q1", "q2", "p1", "p2"}) {
    for (const bool in_space : {false, true}) {
      SCOPED_TRACE(fmt::format("{} {}", element, in_space));
      for (const double syy : NodesAtEnd(block_on_plane(element, in_space)).syy) EXPECT_NEAR(syy / -1e-3, 1, 1e-9);
    }
  }
}

TEST(Contact, PassesAPressureFromMeshToMesh) {
  for (const auto& [element, within] : {std::pair("q1", 0.003), {"q2", 0.004}, {"p1", 0.003}, {"p2", 0.005}}) {
    SCOPED_TRACE(element);
    EXPECT_LT(pressure_off({element, 8, 11}), within);
  }
  for (const auto& [element, within] : {std::pair("q1", 0.01), {"q2", 0.02}, {"p1", 0.01}, {"p2", 0.01}}) {
    SCOPED_TRACE(element);
    EXPECT_LT(pressure_off({element, 4, 5, true}), within);
  }
}

/// Sides that are cut into parts with points of their own pass it ever more evenly.
TEST(Contact, PassesAPressureMoreEvenlyByMoreParts) {
  for (const char* element : {"q1", "q2", "p1", "p2"}) {
    SCOPED_TRACE(element);
    const double one = pressure_off({element, 16, 21}), four = pressure_off({element, 16, 21, false, "parts=4"});
    EXPECT_LT(four, 0.25 * one);
    EXPECT_LT(four, 0.001);
  }
  EXPECT_LT(pressure_off({"q1", 4, 5, true, "parts=2"}), 0.005);
}

/// A softer and a stiffer barrier, and friction, which has nothing to hold where both blocks widen alike.
TEST(Contact, PassesAPressureWithAnyStiffness) {
  for (const char* more : {"stiffness=.01", "stiffness=10.", "friction=.5"}) {
    SCOPED_TRACE(more);
    EXPECT_LT(pressure_off({"q2", 8, 11, false, more}), 0.02);
  }
}

/// Half a cylinder of radius 1 and E = 1 that is pushed on a block, by `cells` in about the half width of what touches.
DeckRun cylinder_on_block(const char* element, int cells) {
  constexpr double half_width = 0.05, angle = std::numbers::pi / 3;
  const double h = half_width / cells, ratio = 1 + 1.0 / cells, gap = 0.075 * h, side = std::sin(angle);
  const auto count = [&](double length, double first) {
    return static_cast<int>(std::lround(std::log(1 + length * (ratio - 1) / first) / std::log(ratio)));
  };
  const auto last_over_first = [&](int n) { return std::pow(ratio, n - 1); };
  const int around = count(angle, h), up = count(1, h), along = count(1, 0.75 * h);
  return run_text(
      "cylinder",
      frame(1, 0.5) +
          fmt::format(
              "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,{0:.15g},{0:.15g},0.,yvi(1,1)={1:.15g},{2:.15g},1.,1.,"
              "xvi(1,2)=0.,1.,1.,0.,yvi(1,2)=-1.,-1.,0.,0.,densir=2*1.,matr(1,1)=1.,.3,matr(1,2)=1.,.3 $\n"
              "$mesh element='{3}',cells(1,1)={4},{5},cells(1,2)={6},{6},grading(1,1)={7},{8},grading(1,2)={9},{10},"
              "edge(1,1)='arc',edge_xc(1,1)=0.,edge_yc(1,1)={11:.15g} $\n$fem static=.true.,law(1)='linear',"
              "law(2)='linear',fix_on(1)='1.left',fix(1,1)=0.,fix_on(2)='2.left',fix(1,2)=0.,fix_on(3)='2.bottom',"
              "fix(2,3)=0.,fix_on(4)='1.top',fix(2,4)=-.0045 $\n$contact $\n",
              side, 0.9 * gap, 0.9 * gap + 1 - std::cos(angle), element, around, up, along, last_over_first(around),
              last_over_first(up), last_over_first(along), 1 / last_over_first(along), 1 + 0.9 * gap));
}

/// Errors of the cylinder's largest pressure and half width, the latter by p^2 = p0^2 (1 - x^2/a^2), over Hertz' ones.
struct HertzErrors {
  double pressure, half_width;
};

HertzErrors hertz_errors(const char* element, int cells) {
  const DeckRun run = cylinder_on_block(element, cells);
  const double modulus = 0.5 / (1 - 0.3 * 0.3), force = 2 * run.last("contact_force");
  const double a = std::sqrt(4 * force / (std::numbers::pi * modulus)), p0 = 2 * force / (std::numbers::pi * a);
  const NodesAtEnd nodes(run);
  double n = 0, x2 = 0, x4 = 0, p2 = 0, x2p2 = 0, largest = 0;
  for (std::size_t k = 0; k < nodes.x.size(); ++k) {
    const double x = nodes.x[k] * nodes.x[k], p = nodes.syy[k] * nodes.syy[k];
    if (std::abs(nodes.y[k]) > 1e-12 || nodes.x[k] > 1.3 * a || nodes.syy[k] > -0.35 * p0) continue;
    n += 1, x2 += x, x4 += x * x, p2 += p, x2p2 += x * p, largest = std::max(largest, -nodes.syy[k]);
  }
  const double slope = (n * x2p2 - x2 * p2) / (n * x4 - x2 * x2), start = (p2 - slope * x2) / n;
  return {largest / p0 - 1, std::sqrt(-start / slope) / a - 1};
}

TEST(Contact, PressesACylinderAsHertz) {
  const HertzErrors fine = hertz_errors("q2", 8);
  EXPECT_LT(std::abs(fine.pressure), 0.02);
  EXPECT_LT(std::abs(fine.half_width), 0.03);
}

TEST(Contact, ComesNearHertzWithFinerElements) {
  const HertzErrors coarse = hertz_errors("q1", 3), fine = hertz_errors("q1", 6), finer = hertz_errors("q1", 12);
  EXPECT_LT(std::abs(finer.pressure), 0.02);
  EXPECT_GT(std::log2(std::abs(coarse.pressure / fine.pressure)), 1);
  EXPECT_LT(std::abs(finer.pressure), std::abs(fine.pressure));
}

/// Bars of one length: the first one's velocity goes over to the second, and nothing is left swinging.
TEST(Contact, ExchangesTheVelocitiesOfBars) {
  const DeckRun run = run_text(
      "bars", frame(0.03, 1e-4) +
                  "$reg nreg=2,nvi=4,4,xvi(1,1)=1.,2.25,2.25,1.,yvi(1,1)=.25,.25,4.75,4.75,xvi(1,2)=2.28,3.53,3.53,"
                  "2.28,yvi(1,2)=.25,.25,4.75,4.75,densir=2*1.,matr(1,1)=1.e5,0.,matr(1,2)=1.e5,0.,vrx(1)=2. $\n"
                  "$mesh element='q2',cells(1,1)=5,1,cells(1,2)=5,1 $\n$fem $\n$contact $\n");
  EXPECT_NEAR(run.last("body_vx_1"), 0, 0.02);
  EXPECT_NEAR(run.last("body_vx_2"), 2, 0.02);
  EXPECT_LT(energy_off(run), 1e-9);
  EXPECT_NEAR(run.last("momentum_x") / run.first("momentum_x"), 1, 1e-10);
  EXPECT_NEAR(run.last("momentum_y") / run.first("momentum_x"), 0, 1e-10);
  EXPECT_NEAR(run.last("angular_momentum_z") / run.first("angular_momentum_z"), 1, 1e-10);
}

/// A cantilever that meets nothing bends as it does without contact, and supported blocks that go to meet each other
/// carry nothing until they do.
TEST(Contact, LeavesEquilibriaAloneThatMeetNothing) {
  const std::string bar =
      "$reg nreg=1,nvi=4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=.55,.55,.65,.65,densir(1)=1000.,matr(1,1)=1e6,.3 $\n"
      "$mesh element='q2',cells(1,1)=9,1 $\n$fem static=.true.,law(1)='neo-hookean',fix_on(1)='1.left',"
      "fix(1:2,1)=0.,0.,load_on(1)='1.top',load(2,1)=-200. $\n";
  const DeckRun free = run_text("free", frame(1, 0.1) + bar),
                alone = run_text("alone", frame(1, 0.1) + bar + "$contact $\n");
  EXPECT_LT(free.last("body_y_1"), 0.5);
  EXPECT_NEAR(alone.last("body_y_1"), free.last("body_y_1"), 1e-9);
  const DeckRun dies = run_text(
      "dies", frame(1, 0.1) +
                  "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=.55,.55,1.05,1.05,xvi(1,2)=-.2,1.25,1.25,-.2,"
                  "yvi(1,2)=0.,0.,.5,.5,densir=2*1000.,matr(1,1)=1e5,.3,matr(1,2)=4e5,.3 $\n"
                  "$mesh cells(1,1)=3,2,cells(1,2)=5,3 $\n$fem static=.true.,law=2*'neo-hookean',"
                  "fix_on(1)='2.bottom','1.top',fix(1:2,1)=0.,0.,fix(1:2,2)=0.,-.1 $\n$contact $\n");
  const auto force = dies.history.column("contact_force");
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(force[k], 0) << k;
  EXPECT_GT(force.back(), 1000);
  EXPECT_LT(dies.summary.at("equilibrium_residual"), 1e-9);
}

}  // namespace
}  // namespace tether::cases
