// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "unit/physics/flow/support.hpp"

// Flows whose solution is known, their errors and their orders.

namespace tether::fem {
namespace {

using std::numbers::pi;

/// Poiseuille's flow through 2 x 1, largest velocity 1/4 mu.
Flow channel(FlowElement element, int n) {
  const RectangleSide wall{}, open{Boundary::open, {}}, inflow{Boundary::inflow, flow_vector("y*(1-y)", "0")};
  Flow flow = rectangle_flow(element, 2 * n, n, 2, 1, {wall, open, wall, inflow});
  flow.integrator = FlowIntegrator::steady, flow.viscosity = 0.1;
  return flow;
}

double poiseuille_error(FlowElement element, int n) {
  const Flow flow = channel(element, n);
  RunningFlow run(flow);
  EXPECT_TRUE(run.run(1, 1));
  return run.velocity_error([](double, double y) { return std::array{y * (1 - y), 0.0}; });
}

TEST(FlowExact, PoiseuilleIsExactInQ2Q1) { EXPECT_LT(poiseuille_error(FlowElement::q2q1, 4), 1e-9); }

TEST(FlowExact, PoiseuilleIsOfOrder2InQ1Q1) {
  const double coarse = poiseuille_error(FlowElement::q1q1, 16), fine = poiseuille_error(FlowElement::q1q1, 32);
  EXPECT_LT(fine, 0.005 * 0.25);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2) << coarse << " " << fine;
}

/// A made-up steady flow that no element has: u = sin x cos y + 1, v = -cos x sin y, p = sin(x) sin(2 y), mu = .1, with
/// its body force. Errors of velocity and pressure.
std::array<double, 2> steady_errors(FlowElement element, int n) {
  const RectangleSide given{Boundary::inflow, flow_vector("sin(x)*cos(y)+1", "-cos(x)*sin(y)")};
  Flow flow = rectangle_flow(element, n, n, 1, 1.5, {given, given, given, given});
  flow.integrator = FlowIntegrator::steady, flow.viscosity = 0.1;
  // (v . grad) v = (sin x cos x + cos x cos y, sin y cos y + sin x sin y); -mu Laplace v = 2 mu (v - (1, 0))
  flow.acceleration = flow_vector("sin(x)*cos(x)+cos(x)*cos(y) + .2*sin(x)*cos(y) + cos(x)*sin(2*y)",
                                  "sin(y)*cos(y)+sin(x)*sin(y) - .2*cos(x)*sin(y) + 2*sin(x)*cos(2*y)");
  RunningFlow run(flow);
  EXPECT_TRUE(run.run(1, 1));
  return {run.velocity_error([](double x, double y) {
            return std::array{std::sin(x) * std::cos(y) + 1, -std::cos(x) * std::sin(y)};
          }),
          run.pressure_error([](double x, double y) { return std::sin(x) * std::sin(2 * y); })};
}

TEST(FlowExact, SteadyOrdersOfQ2Q1) {
  const auto coarse = steady_errors(FlowElement::q2q1, 8), fine = steady_errors(FlowElement::q2q1, 16);
  EXPECT_LT(fine[0], 1e-5);
  EXPECT_GT(std::log2(coarse[0] / fine[0]), 2.8) << coarse[0] << " " << fine[0];
  EXPECT_GT(std::log2(coarse[1] / fine[1]), 1.8) << coarse[1] << " " << fine[1];
}

TEST(FlowExact, SteadyOrdersOfQ1Q1) {
  const auto coarse = steady_errors(FlowElement::q1q1, 32), fine = steady_errors(FlowElement::q1q1, 64);
  EXPECT_LT(fine[0], 5e-5);
  EXPECT_GT(std::log2(coarse[0] / fine[0]), 1.8) << coarse[0] << " " << fine[0];
  EXPECT_GT(std::log2(coarse[1] / fine[1]), 0.95) << coarse[1] << " " << fine[1];
}

/// v = (y^2, x^2) cos 2 t, p = (x + y) sin 3 t, which Q2Q1 has but for the time; mu = 1. Errors of the velocity at the
/// end t = 1 and of the pressure at the middle of the last step (of backward Euler at its end).
std::array<double, 2> errors_in_time(FlowIntegrator integrator, double dt) {
  const RectangleSide given{Boundary::inflow, flow_vector("y*y*cos(2*t)", "x*x*cos(2*t)")};
  Flow flow = rectangle_flow(FlowElement::q2q1, 2, 2, 1, 1, {given, given, given, given});
  flow.integrator = integrator;
  flow.start = given.velocity;
  flow.acceleration = flow_vector("-2*y*y*sin(2*t) + 2*x*x*y*cos(2*t)^2 - 2*cos(2*t) + sin(3*t)",
                                  "-2*x*x*sin(2*t) + 2*x*y*y*cos(2*t)^2 - 2*cos(2*t) + sin(3*t)");
  RunningFlow run(flow);
  EXPECT_TRUE(run.run(1, dt));
  const double at = integrator == FlowIntegrator::midpoint ? 1 - dt / 2 : 1;
  return {run.velocity_error([](double x, double y) {
            return std::array{y * y * std::cos(2.0), x * x * std::cos(2.0)};
          }),
          run.pressure_error([at](double x, double y) { return (x + y) * std::sin(3 * at); })};
}

TEST(FlowExact, OrdersInTime) {
  for (const auto& [integrator, order] :
       {std::pair(FlowIntegrator::midpoint, 2.0), std::pair(FlowIntegrator::euler, 1.0)}) {
    const auto coarse = errors_in_time(integrator, 0.025), fine = errors_in_time(integrator, 0.0125);
    EXPECT_NEAR(std::log2(coarse[0] / fine[0]), order, 0.1) << coarse[0] << " " << fine[0];
    EXPECT_NEAR(std::log2(coarse[1] / fine[1]), order, 0.1) << coarse[1] << " " << fine[1];
  }
}

/// Taylor and Green's decaying vortices in a periodic box of 2 pi at t = .5, mu = .1.
double vortex_error(FlowElement element, int n, double dt) {
  const RectangleSide around{Boundary::periodic, {}};
  Flow flow = rectangle_flow(element, n, n, 2 * pi, 2 * pi, {around, around, around, around});
  flow.viscosity = 0.1, flow.tolerance = 1e-10;
  flow.start = flow_vector("sin(x)*cos(y)", "-cos(x)*sin(y)");
  const int line = element == FlowElement::q1q1 ? n : 2 * n;  // nodes of a line less one
  for (int j = 0; j <= line; ++j) {
    for (int i = 0; i <= line; ++i)
      flow.twin[static_cast<std::size_t>(j * (line + 1) + i)] = (j % line) * (line + 1) + i % line;
  }
  RunningFlow run(flow);
  EXPECT_TRUE(run.run(0.5, dt));
  const double decay = std::exp(-2 * 0.1 * 0.5);
  return run.velocity_error([&](double x, double y) {
    return std::array{decay * std::sin(x) * std::cos(y), -decay * std::cos(x) * std::sin(y)};
  });
}

TEST(FlowExact, VorticesDecayByTheirOrders) {
  const double q1[] = {vortex_error(FlowElement::q1q1, 16, 0.05), vortex_error(FlowElement::q1q1, 32, 0.025)};
  EXPECT_GT(std::log2(q1[0] / q1[1]), 1.9) << q1[0] << " " << q1[1];
  const double q2[] = {vortex_error(FlowElement::q2q1, 8, 0.01), vortex_error(FlowElement::q2q1, 16, 0.01)};
  EXPECT_GT(std::log2(q2[0] / q2[1]), 2.8) << q2[0] << " " << q2[1];
}

/// What the start does to velocities that are incompressible is nothing, however long the steps to come.
TEST(FlowExact, TheStartLeavesAShearAsItIs) {
  const RectangleSide wall{}, around{Boundary::periodic, {}};
  Flow flow = rectangle_flow(FlowElement::q2q1, 4, 4, 1, 1, {wall, around, wall, around});
  flow.start = flow_vector("sin(pi*y)", "0");
  for (std::size_t n = 8; n < flow.twin.size(); n += 9) flow.twin[n] = static_cast<int>(n) - 8;
  RunningFlow run(flow);
  ASSERT_TRUE(run.step.start(run.state, 1e5).converged);
  EXPECT_LT(run.velocity_error([](double, double y) { return std::array{std::sin(pi * y), 0.0}; }), 1e-6);
}

}  // namespace
}  // namespace tether::fem
