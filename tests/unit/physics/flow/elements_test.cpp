// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "physics/flow/make_elements.hpp"
#include "physics/flow/unknowns.hpp"
#include "unit/alone.hpp"
#include "unit/physics/flow/support.hpp"

// The elements of a flow: derivatives against differences, forces in balance.

namespace tether::fem {
namespace {

Flow open_channel(FlowElement element, bool steady) {
  const RectangleSide wall{}, open{Boundary::open, {}}, slip{Boundary::slip, {}};
  const RectangleSide inflow{Boundary::inflow, flow_vector("1+y", ".1")};
  Flow flow = rectangle_flow(element, 3, 2, 1.5, 1, {wall, open, slip, inflow});
  flow.integrator = steady ? FlowIntegrator::steady : FlowIntegrator::midpoint;
  flow.viscosity = 0.3, flow.density = 2;
  return flow;
}

struct Numbers {
  std::vector<double> v0, v1, p, b;
};

/// Some flow without any symmetry.
Numbers some_numbers(const Flow& flow, const FlowElements& elements) {
  Numbers numbers{std::vector<double>(2 * flow.twin.size()), std::vector<double>(2 * flow.twin.size()),
                  std::vector<double>(flow.twin.size()), elements.accelerations(-1, 0)};
  for (std::size_t k = 0; k < numbers.v0.size(); ++k)
    numbers.v0[k] = std::sin(3.0 * static_cast<double>(k)), numbers.v1[k] = std::cos(2.0 * static_cast<double>(k));
  for (std::size_t k = 0; k < numbers.p.size(); ++k) numbers.p[k] = std::sin(5.0 * static_cast<double>(k));
  return numbers;
}

/// Of all unknowns, in their order.
std::vector<double> residual(const FlowUnknowns& unknowns, const FlowElements& elements, const FlowMoment& m) {
  std::vector<double> f(m.v1.size(), 0.0), g(m.p.size(), 0.0), r(unknowns.count());
  elements.add_residual(m, f, g);
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (unknowns.velocity[k] >= 0) r[static_cast<std::size_t>(unknowns.velocity[k])] = f[k];
  }
  for (std::size_t k = 0; k < g.size(); ++k) {
    if (unknowns.pressure[k] >= 0) r[static_cast<std::size_t>(unknowns.pressure[k])] = g[k];
  }
  return r;
}

/// The largest difference between the tangent and the residual's central differences, over the largest number.
double tangent_error(FlowElement element, bool steady, double stabilisation = 1) {
  Flow flow = open_channel(element, steady);
  flow.stabilisation = stabilisation;
  const FlowUnknowns unknowns(flow);
  const auto elements = make_flow_elements(unknowns, alone());
  Numbers at = some_numbers(flow, *elements);
  const FlowMoment m{
      at.v0, at.v1, at.p, steady ? 1 : 0.5, steady ? 0 : 4.0, flow.viscosity, at.b, Linearisation::newton};
  const ClusterPattern pattern(unknowns.first, clusters_of(flow));
  SparseMatrix K = pattern.matrix();
  elements->add_tangent(m, pattern, K);
  double worst = 0, largest = 0;
  const auto check = [&](double& number, int unknown) {
    if (unknown < 0) return;
    const double there = number, h = 1e-6;
    number = there + h;
    const auto up = residual(unknowns, *elements, m);
    number = there - h;
    const auto down = residual(unknowns, *elements, m);
    number = there;
    std::vector<double> unit(unknowns.count(), 0.0), column(unknowns.count());
    unit[static_cast<std::size_t>(unknown)] = 1;
    K.multiply(unit, column);
    for (std::size_t k = 0; k < column.size(); ++k) {
      worst = std::max(worst, std::abs(column[k] - (up[k] - down[k]) / (2 * h)));
      largest = std::max(largest, std::abs(column[k]));
    }
  };
  for (std::size_t k = 0; k < at.v1.size(); ++k) check(at.v1[k], unknowns.velocity[k]);
  for (std::size_t k = 0; k < at.p.size(); ++k) check(at.p[k], unknowns.pressure[k]);
  return worst / largest;
}

TEST(FlowElements, TangentIsTheResidualsDerivative) {
  EXPECT_LT(tangent_error(FlowElement::q1q1, false), 1e-8);
  EXPECT_LT(tangent_error(FlowElement::q1q1, true), 1e-8);
  EXPECT_LT(tangent_error(FlowElement::q2q1, false), 1e-8);
  EXPECT_LT(tangent_error(FlowElement::q2q1, true), 1e-8);
  for (const double factor : {0.0, 0.3, 2.0}) {
    EXPECT_LT(tangent_error(FlowElement::q1q1, false, factor), 1e-8) << factor;
    EXPECT_LT(tangent_error(FlowElement::q1q1, true, factor), 1e-8) << factor;
  }
}

/// A fluid at rest in gravity presses on its walls by its weight, and the walls carry it.
TEST(FlowElements, WallsCarryAFluidAtRest) {
  for (const FlowElement element : {FlowElement::q1q1, FlowElement::q2q1}) {
    Flow flow = rectangle_flow(element, 4, 3, 2, 1, {});
    flow.density = 3;
    RunningFlow run(flow, -10);
    ASSERT_TRUE(run.run(0.1, 0.1));
    double fx = 0, fy = 0, fastest = 0;
    for (std::size_t n = 0; n < flow.twin.size(); ++n) {
      fx += run.state.force[2 * n], fy += run.state.force[2 * n + 1];
      fastest = std::max({fastest, std::abs(run.state.v[2 * n]), std::abs(run.state.v[2 * n + 1])});
    }
    EXPECT_NEAR(fx, 0, 1e-9);
    EXPECT_NEAR(fy, 3 * 2 * 10, 1e-9);
    EXPECT_LT(fastest, 1e-10);
  }
}

}  // namespace
}  // namespace tether::fem
