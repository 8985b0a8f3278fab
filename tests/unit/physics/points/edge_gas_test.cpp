// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/strips.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether::mpm {
namespace {

constexpr double gamma_of_air = 1.4;

Edge inflow() {
  Edge edge;
  edge.kind = EdgeKind::inflow, edge.has_outside = true;
  return edge;
}

void expect_same(const EdgeGas& a, const EdgeGas& b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.density, b.density, tolerance);
  EXPECT_NEAR(a.across, b.across, tolerance);
  EXPECT_NEAR(a.along, b.along, tolerance);
  EXPECT_NEAR(a.pressure, b.pressure, tolerance);
}

TEST(EdgeGas, OneStateOnBothSidesIsTheStateOnTheEdge) {
  const EdgeGas gas{1, 0.5, 0.25, 1};
  expect_same(gas_on_edge(inflow(), gas, gas, gamma_of_air), gas);
}

TEST(EdgeGas, ASupersonicInflowHearsNothingFromTheInside) {
  const EdgeGas outside{1, 3, 0.5, 1}, inside{0.8, 2.5, -1, 1.2};
  expect_same(gas_on_edge(inflow(), outside, inside, gamma_of_air), outside);
}

TEST(EdgeGas, ASupersonicOutflowHearsNothingFromOutside) {
  Edge edge = inflow();
  edge.kind = EdgeKind::outflow;
  const EdgeGas outside{1, -3, 0.5, 1}, inside{0.8, -3, -1, 1.2};
  expect_same(gas_on_edge(edge, outside, inside, gamma_of_air), inside);
}

TEST(EdgeGas, AnOutflowWithNothingOutsideHasTheGasInside) {
  Edge edge;
  edge.kind = EdgeKind::outflow;
  const EdgeGas inside{0.8, -0.1, -1, 1.2};
  expect_same(gas_on_edge(edge, {}, inside, gamma_of_air), inside);
}

// The wave that runs out has p - rho c u, and leaves without an echo: on the edge is what it carries, to second order.
TEST(EdgeGas, AWeakWaveRunsOutThroughASubsonicInflow) {
  const EdgeGas outside{1, 0.3, 0.5, 1};
  const double c = std::sqrt(gamma_of_air), dp = 1e-4;
  const EdgeGas wave{1 + dp / (c * c), 0.3 - dp / c, 0.1, 1 + dp};
  const EdgeGas edge = gas_on_edge(inflow(), outside, wave, gamma_of_air);
  EXPECT_NEAR(edge.pressure, wave.pressure, 1e-8);
  EXPECT_NEAR(edge.across, wave.across, 1e-8);
  EXPECT_NEAR(edge.density, wave.density, 1e-8);  // the entropy is that of outside, and so is the velocity along it
  EXPECT_EQ(edge.along, outside.along);
}

TEST(EdgeGas, WhereAVacuumOpensTheInflowIsAsGiven) {
  const EdgeGas outside{1, 0, 0, 1}, inside{1, 20, 0, 1};
  expect_same(gas_on_edge(inflow(), outside, inside, gamma_of_air), outside);
  expect_same(gas_on_edge(inflow(), outside, {}, gamma_of_air), outside);
}

}  // namespace
}  // namespace tether::mpm
