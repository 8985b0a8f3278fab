// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cases/run_deck.hpp"
#include "reference/thick_ring.hpp"

// Pressures that follow the sides of elastic bodies: a quarter of a thick ring, and free bodies.

namespace tether::cases {
namespace {

constexpr double outer_radius = 2;  // the inner radius is 1

/// A quarter ring in plane strain by n x 2n elements, E = 1, pushed open from inside in `steps`.
DeckRun ring(const char* element, int n, const char* law, double nu, double pressure, int steps = 1) {
  const std::string text = fmt::format(
      "a quarter of a ring\n$in nx=2,ny=2,xleft=-5.,xright=5.,ybot=-5.,ytop=5.,wl=1,wr=1,wb=1,wt=1,tmax=1.,tstep={6},"
      "iout(33)=1,tiout(33)=1.,iout(39)=1,tiout(39)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=1.,2.,0.,0.,yvi(1,1)=0.,0.,2.,1.,"
      "densir(1)=1.,matr(1,1)=1.,{3} $\n$mesh element='{0}',cells(1,1)={1},{5},edge(2,1)='arc',edge(4,1)='arc' $\n$fem "
      "static=.true.,law(1)='{2}',fix_on(1)='1.bottom',fix(2,1)=0.,fix_on(2)='1.top',fix(1,2)=0.,load_on(1)='1.left',"
      "pressure(1)={4} $\n$points tracked_at(1,1)=1.,0.,tracked_at(1,2)=2.,0. $\n",
      element, n, law, nu, pressure, 2 * n, 1.0 / steps);
  return run_text("ring", text);
}

/// Lame's ring, by every element: displacement, the supports' forces, and stress at nodes.
struct RingErrors {
  double displacement, reaction, stress;
};

RingErrors errors_of(const char* element, int n) {
  constexpr double p = 1e-6, nu = 0.3, A = p / (outer_radius * outer_radius - 1);
  const DeckRun run = ring(element, n, "svk", nu, p);
  const double exact = (1 + nu) * A * ((1 - 2 * nu) + outer_radius * outer_radius);
  const std::string file = run.folder + "/mesh.nc";
  const auto x = read_variable(file, "node_x"), y = read_variable(file, "node_y");
  const auto sxx = read_variable(file, "sxx"), syy = read_variable(file, "syy"), sxy = read_variable(file, "sxy");
  double square = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t last = sxx.size() - x.size() + k;
    const double r2 = x[k] * x[k] + y[k] * y[k];
    const double radial = (sxx[last] * x[k] * x[k] + syy[last] * y[k] * y[k] + 2 * sxy[last] * x[k] * y[k]) / r2;
    square += std::pow((radial - A * (1 - outer_radius * outer_radius / r2)) / p, 2) / static_cast<double>(x.size());
  }
  return {std::abs(run.last("point_x_1") - 1 - exact) / exact, std::abs(run.last("support_force_y_1") / p + 1),
          std::sqrt(square)};
}

/// Both supports hold the pressure over the hole's radius. The stress at nodes is of a higher order than that of the
/// elements, 1 and 2: as far as the boundary lets it be.
TEST(Pressure, OpensARingAsLame) {
  struct Case {
    const char* element;
    double displacement, order, stress, stress_order;
  };
  for (const Case& of : {Case{"q1", 1e-2, 1.9, 0.04, 1.9}, Case{"p1", 4e-2, 1.6, 0.08, 1.4},
                         Case{"q2", 2e-4, 3.5, 0.004, 2.3}, Case{"p2", 4e-4, 2.5, 0.006, 2.1}}) {
    SCOPED_TRACE(of.element);
    const RingErrors coarse = errors_of(of.element, 4), fine = errors_of(of.element, 8);
    EXPECT_LT(fine.displacement, of.displacement);
    EXPECT_GT(std::log2(coarse.displacement / fine.displacement), of.order);
    EXPECT_LT(fine.stress, of.stress);
    EXPECT_GT(std::log2(coarse.stress / fine.stress), of.stress_order);
    EXPECT_LT(fine.reaction, 1e-5);
  }
}

/// A soft ring blown up by 40 %: by the radial solution of the same law, which hardly or not at all changes its volume.
TEST(Pressure, BlowsARingUpAsTheRadialSolution) {
  for (const double nu : {0.3, 0.49, 0.4999}) {
    const NeoHookean law = NeoHookean::of({.E = 1, .nu = nu});
    const BlownRing exact = blown_ring({1, outer_radius, law}, 1.4);
    for (const auto& [element, within] : {std::pair("q1", 4e-2), {"q2", 1e-3}, {"p2", 4e-3}}) {
      SCOPED_TRACE(fmt::format("{} {}", element, nu));
      const DeckRun run = ring(element, 4, "neo-hookean", nu, exact.pressure, 5);
      EXPECT_NEAR(run.last("point_x_1") - 1, exact.inner - 1, within * 0.4);
      EXPECT_NEAR(run.last("point_x_2") - outer_radius, exact.outer - outer_radius, within * 0.4);
    }
  }
}

/// A pressure that one step of Newton's method cannot take: the run settles by parts of it.
TEST(Pressure, SettlesByParts) {
  const DeckRun run = run_text(
      "settles",
      "a soft beam under pressure\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,wl=1,wr=1,wb=1,wt=1,tmax=.02,"
      "tstep=.01,iout(33)=1,tiout(33)=.01 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,4.,4.,0.,yvi(1,1)=0.,0.,.5,.5,densir(1)=1.,"
      "matr(1,1)=1000.,.3 $\n$mesh cells(1,1)=8,2 $\n$fem law(1)='neo-hookean',settle=.true.,fix_on(1)='1.left',"
      "fix(1:2,1)=0.,0.,load_on(1)='1.top',pressure(1)=4. $\n$points tracked_at(1,1)=4.,.25 $\n");
  EXPECT_LT(run.first("point_y_1"), -1);
  EXPECT_NEAR(run.last("point_y_1"), run.first("point_y_1"), 1e-8);
  EXPECT_LT(run.last("energy_kinetic"), 1e-12);
}

/// A block that tumbles under a pressure all around: the pressure's work is that of the block's volume, by any step.
TEST(Pressure, AllAroundATumblingBlockKeepsItsEnergy) {
  std::string rest;
  int k = 20;
  for (const char* side : {"1.bottom", "1.left", "1.back", "1.front", "1.right", "1.top"})
    rest += fmt::format("load_on({0})='{1}',pressure({0})=3.,", k++, side);
  for (const char* element : {"q1", "p1", "q2", "p2"}) {
    SCOPED_TRACE(element);
    const DeckRun run = run_text(
        "tumbling", fmt::format("a block that tumbles\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,wl=1,wr=1,"
                                "wb=1,wt=1,tmax=4.,tstep=.1,iout(33)=1,tiout(33)=.1 $\n$reg nreg=1,nvi=4,"
                                "xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=2.,matr(1,1)=50.,.3 $\n"
                                "$mesh element='{}',cells(1,1)=2,2,2,z(1,1)=0.,1. $\n$fem law(1)='neo-hookean',"
                                "spin(1:3,1)=1.,2.,3.,{} $\n",
                                element, rest));
    double most = 0, size = 0;
    const auto total = run.history.column("energy_total"), loads = run.history.column("energy_loads");
    for (std::size_t n = 0; n < total.size(); ++n) {
      most = std::max(most, std::abs(total[n] - total[0] - loads[n]));
      size = std::max(size, std::abs(loads[n]));
    }
    EXPECT_GT(size, 0.1);
    EXPECT_LT(most, 1e-9 * total[0]);
    EXPECT_NEAR(run.last("momentum_x"), run.first("momentum_x"), 1e-10);
    EXPECT_LT(run.summary.at("energy_drift"), 1e-9);
  }
}

/// What a rigid body feels of it, elastic ones and those of the coupled path feel, too: the force of a pressure on one
/// side turns with the body, and turns it as a rigid one.
TEST(Pressure, TurnsWithARigidBody) {
  const auto block = [](const char* more) {
    return run_text("turning", fmt::format("a block that a pressure turns\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,"
                                           "ytop=9.,wl=1,wr=1,wb=1,wt=1,tmax=1.,tstep=.01,iout(33)=1,tiout(33)=.1 $\n"
                                           "$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=1.,"
                                           "matr(1,1)=1.e5,.3 $\n$mesh element='q1',cells(1,1)=2,2,1,z(1,1)=0.,1. $\n"
                                           "$fem spin(3,1)=0.,load_on(1)='1.left',pressure(1)=.5 $\n{}",
                                           more));
  };
  const DeckRun rigid = block("$rigid omega=0.,0.,2. $\n");
  // The force is .5 along the body's first axis, which turns by 2 t: x = .25/2 sin^2(t) 2 ..., integrated twice.
  EXPECT_NEAR(rigid.last("body_x_1") - 0.5, 0.5 / 4 * (1 - std::cos(2.0)), 1e-4);
  EXPECT_NEAR(rigid.last("body_y_1") - 0.5, 0.5 / 4 * (2.0 - std::sin(2.0)), 1e-4);
}

}  // namespace
}  // namespace tether::cases
