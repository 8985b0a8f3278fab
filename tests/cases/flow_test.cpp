// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

// Incompressible flow by finite elements against published numbers.

namespace tether::cases {
namespace {

/// Least value of a parabola through three neighbours of the least of values over places, which ascend.
double least_between(const std::vector<std::pair<double, double>>& values) {
  std::size_t k = 1;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) k = values[i].second < values[k].second ? i : k;
  const auto [xa, a] = values[k - 1];
  const auto [xb, b] = values[k];
  const auto [xc, c] = values[k + 1];
  const double slope = (b - a) / (xb - xa), curve = ((c - b) / (xc - xb) - slope) / (xc - xa);
  const double at = 0.5 * (xa + xb) - slope / (2 * curve);
  return a + slope * (at - xa) + curve * (at - xa) * (at - xb);
}

/// Least of a field on the line x (or y) = .5 of the unit box at the end.
double least_on_middle_line(const DeckRun& run, const std::string& field, const std::string& across) {
  const auto at = read_variable(run.folder + "/mesh.nc", "node_" + across);
  const auto along = read_variable(run.folder + "/mesh.nc", across == "x" ? "node_y" : "node_x");
  const auto all = read_variable(run.folder + "/mesh.nc", field);
  std::vector<std::pair<double, double>> line;
  for (std::size_t n = 0; n < at.size(); ++n) {
    if (std::abs(at[n] - 0.5) < 1e-9) line.emplace_back(along[n], all[all.size() - at.size() + n]);
  }
  std::sort(line.begin(), line.end());
  return least_between(line);
}

/// O. Botella and R. Peyret, Comput. Fluids 27 (1998) 421-433; the least v tells the sign of the convective term.
void expect_cavity(const DeckRun& run, double u, double v) {
  EXPECT_NEAR(least_on_middle_line(run, "vx", "x") / u, 1, 0.005);
  EXPECT_NEAR(least_on_middle_line(run, "vy", "y") / v, 1, 0.005);
}

/// Expects one value of the stream function at the end at all nodes of this kind; returns it.
double expect_one_stream(const DeckRun& run, const std::function<bool(double, double)>& is_of_it) {
  const std::string file = run.folder + "/mesh.nc";
  const auto x = read_variable(file, "node_x"), y = read_variable(file, "node_y"), all = read_variable(file, "stream");
  double low = INFINITY, high = -INFINITY;
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (!is_of_it(x[n], y[n])) continue;
    const double stream = all[all.size() - x.size() + n];
    low = std::min(low, stream), high = std::max(high, stream);
  }
  EXPECT_EQ(low, high);
  return low;
}

std::vector<std::string> cavity(const char* element, int cells, const char* viscosity, const char* step) {
  const std::string n = std::to_string(cells);
  return {std::string("flow.element=") + element, "mesh.cells(1,1)=" + n, "mesh.cells(2,1)=" + n,
          std::string("reg.matr(1,1)=") + viscosity, std::string("in.tstep=") + step};
}

TEST(Flow, CavityOfReynolds100) {
  expect_cavity(run_deck("cavity"), -0.21404, -0.25380);
  expect_cavity(run_deck("cavity", cavity("'q2q1'", 32, ".01", "1.")), -0.21404, -0.25380);
}

TEST(Flow, CavityOfReynolds1000) {
  if (at_full_length()) expect_cavity(run_deck("cavity", cavity("'q1q1'", 128, ".001", ".2")), -0.38857, -0.52708);
  const int cells = at_full_length() ? 64 : 40;
  expect_cavity(run_deck("cavity", cavity("'q2q1'", cells, ".001", ".2")), -0.38857, -0.52708);
}

/// Cells finer at the walls, in the middle three times as long: a third of the errors of equal ones, or less.
TEST(Flow, CavityOfReynolds1000OnCellsFinerAtTheWalls) {
  const auto errors = [](const std::vector<std::string>& deck) {
    const DeckRun run = run_deck("cavity", deck);
    return std::array{std::abs(least_on_middle_line(run, "vx", "x") / -0.38857 - 1),
                      std::abs(least_on_middle_line(run, "vy", "y") / -0.52708 - 1), run.summary.at("unknowns")};
  };
  auto deck = cavity("'q2q1'", 16, ".001", ".2");
  const auto equal = errors(deck);
  deck.insert(deck.end(), {"mesh.grading_middle(1,1)=3.", "mesh.grading_middle(2,1)=3."});
  const auto graded = errors(deck);
  EXPECT_EQ(graded[2], equal[2]);
  EXPECT_LT(graded[0], equal[0] / 3);
  EXPECT_LT(graded[1], equal[1] / 3);
}

/// Nothing flows through walls and the lid: the stream function has one value there, also where the lid meets the walls
/// and on elements of no order.
TEST(Flow, StreamFunctionIsOneAlongWalls) {
  const DeckRun lid = run_deck("cavity", {"mesh.cells(1:2,1)=6,5", "in.iout(39)=1", "in.tiout(39)=1."});
  expect_one_stream(lid, [](double x, double y) { return x == 0 || x == 1 || y == 0 || y == 1; });
  const DeckRun channel = run_deck("cylinder-file", {"in.iout(39)=1", "in.tiout(39)=1."});
  const double bottom = expect_one_stream(channel, [](double, double y) { return y == 0; });
  const double top = expect_one_stream(channel, [](double, double y) { return y == 0.41; });
  EXPECT_NEAR(top - bottom, 0.2 * 0.41, 2e-5);
  expect_one_stream(channel, [](double x, double y) { return std::abs(std::hypot(x - 0.2, y - 0.2) - 0.05) < 1e-6; });
}

TEST(Flow, PicardFindsTheSameFlow) {
  const DeckRun newton = run_deck("cavity", cavity("'q2q1'", 8, ".01", "1."));
  auto other = cavity("'q2q1'", 8, ".01", "1.");
  other.insert(other.end(), {"flow.linearisation='picard'", "flow.tolerance=1e-8"});
  const DeckRun picard = run_deck("cavity", other);
  EXPECT_GT(picard.summary.at("newton_iterations"), newton.summary.at("newton_iterations"));
  EXPECT_NEAR(picard.last("stream_min") / newton.last("stream_min"), 1, 1e-5);
}

/// Under a lid that moves along walls that are periodic, with u = y at the end and at the start: tracers go by t y.
TEST(Flow, TracersGoWithTheFluid) {
  const DeckRun run = run_deck(
      "cavity", {"mesh.cells(1:2,1)=4,4", "in.xright=1.", "flow.steady=.false.", "in.tmax=.4", "in.tstep=.1",
                 "in.iout(32)=1", "in.tiout(32)=.4", "flow.boundary_on(2)='1.left'", "flow.boundary(2)='periodic'",
                 "flow.boundary_with(2)='1.right'", "flow.u0='y'", "flow.tracers(1)=3", "flow.tracers(2)=5"});
  for (const std::string& warning : run.warnings) EXPECT_EQ(warning.find("writes nothing"), std::string::npos);
  const auto x = read_variable(run.folder + "/particles.nc", "x"), y = read_variable(run.folder + "/particles.nc", "y");
  ASSERT_EQ(x.size(), 30u);
  ASSERT_EQ(y.size(), 30u);
  for (std::size_t n = 0; n < 15; ++n) {
    const double at = (static_cast<double>(n / 3) + .5) / 5;
    EXPECT_NEAR(y[n], at, 1e-12);
    EXPECT_NEAR(y[15 + n], at, 1e-9);
    if (n % 3 == 2) continue;  // it goes out at the end of the mesh
    EXPECT_NEAR(x[15 + n], x[n] + .4 * at, 1e-6) << n;
  }
}

/// Where no steady flow is found the run stops and tells how far it came.
TEST(Flow, TellsTheLastReynoldsNumberThatConverged) {
  auto deck = cavity("'q2q1'", 8, "1e-7", ".5");
  deck.insert(deck.end(), {"in.tmax=1.", "in.tiout(33)=.5"});
  try {
    run_deck("cavity", deck);
    FAIL() << "a cavity of 8 x 8 elements at Re = 1e7";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("the last one that converged has"), std::string::npos) << error.what();
  }
}

/// M. Schaefer and S. Turek, in Flow Simulation with High-Performance Computers II, Notes Numer. Fluid Mech. 52 (1996)
/// 547-566: 2D-1.
TEST(Flow, CylinderInAChannel) {
  const DeckRun run = run_deck("cylinder");
  EXPECT_NEAR(run.last("drag_1") / 5.57954, 1, 0.003);
  EXPECT_NEAR(run.last("lift_1") / 0.010619, 1, 0.05);
  EXPECT_NEAR(run.last("pressure_difference_1") / 0.117520, 1, 0.005);
}

/// Relative errors of drag, lift and pressure difference against those of spectral methods, by G. Nabh (On High Order
/// Methods for the Stationary Incompressible Navier-Stokes Equations, Heidelberg 1998).
std::array<double, 3> cylinder_errors(const std::string& element, const std::string& cells) {
  const DeckRun run = run_deck("cylinder", {"flow.element='" + element + "'", "mesh.cells(1:2,1:5)=" + cells});
  return {std::abs(run.last("drag_1") / 5.57953523384 - 1), std::abs(run.last("lift_1") / .010618948146 - 1),
          std::abs(run.last("pressure_difference_1") / .11752016697 - 1)};
}

TEST(Flow, CylinderOnFinerMeshes) {
  const auto coarse = cylinder_errors("q2q1", "8*6,12,6"), fine = cylinder_errors("q2q1", "8*12,24,12");
  EXPECT_LT(fine[0], 2e-4);
  EXPECT_LT(fine[1], 4e-3);
  EXPECT_LT(fine[2], 3e-3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(coarse[k] / fine[k], 3) << k;
  const auto linear = cylinder_errors("q1q1", "8*24,48,24");
  EXPECT_LT(linear[0], 2e-3);
  EXPECT_LT(linear[1], .02);
  EXPECT_LT(linear[2], .01);
}

}  // namespace
}  // namespace tether::cases
