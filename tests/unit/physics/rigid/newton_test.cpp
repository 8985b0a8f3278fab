// SPDX-License-Identifier: GPL-3.0-or-later
// The two systems of a step: tangents against differences, quadratic convergence, and what does not converge.
#include <gtest/gtest.h>

#include <cmath>

#include "physics/rigid/constrained.hpp"
#include "physics/rigid/reduced.hpp"
#include "unit/physics/rigid/support.hpp"

namespace tether::fem {
namespace {

using namespace rigid;

/// All kinds of load at once, large enough to show in the tangent.
RigidForces all_loads(const RigidBody& body) {
  const std::vector<double> at{0.3, 0.1, -0.2, -0.5, 0.4, 0.9}, force{10, -20, 30, 5, 7, -4};
  RigidForces loads = rigid_gravity(body.inertia, {1, -9, 2});
  loads.add(rigid_point_forces(body.frame, at, force, RigidDirection::turning));
  loads.add(rigid_point_forces(body.frame, at, force, RigidDirection::fixed), -0.7);
  return loads.add(rigid_torque({3, -8, 5}));
}

RigidState any_start(const RigidBody& body) {
  const Vector3d omega(1.5, -2, 0.8);
  RigidState state = body.pin ? rigid_start(body, omega) : rigid_start(body, {0.5, 0.3, -0.2}, omega);
  const RigidState turned = state;
  const Matrix3d R = Eigen::AngleAxisd(0.4, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
  state.q = R * turned.q, state.v = R * turned.v;
  return state;
}

template <class System>
class RigidTangent : public testing::Test {};

using Systems = testing::Types<RigidConstrained<0>, RigidConstrained<3>, RigidReduced<false>, RigidReduced<true>>;
TYPED_TEST_SUITE(RigidTangent, Systems);

template <class System>
constexpr bool holds_a_point = System::size == 21 || System::size == 3;

TYPED_TEST(RigidTangent, is_the_derivative_of_the_residual) {
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    const RigidBody body = holds_a_point<TypeParam> ? body_of(Box(), frame, {0.4, 0.2, -0.3}) : body_of(Box(), frame);
    const RigidMiddle middle(body, all_loads(body), any_start(body), 0.6);
    const TypeParam system(middle);
    using Vector = typename TypeParam::Vector;
    const Vector x = 0.3 * any_numbers<Vector>();
    const auto J = system.tangent(x);
    for (int k = 0; k < TypeParam::size; ++k) {
      // Central differences of two steps, extrapolated: of fourth order.
      Vector difference[2];
      for (int half = 0; half < 2; ++half) {
        const double step = 1e-3 / (half + 1);
        Vector up = x, down = x, above, below;
        up[k] += step, down[k] -= step;
        system.residual(up, above), system.residual(down, below);
        difference[half] = (above - below) / (2 * step);
      }
      const Vector column = (4 * difference[1] - difference[0]) / 3;
      EXPECT_LT((J.col(k) - column).norm(), 1e-10 * J.norm()) << "unknown " << k;
    }
    // What the step subtracts is the solution with this tangent.
    const Vector r = any_numbers<Vector>();
    EXPECT_LT((J * system.correction(x, r) - r).norm(), 1e-11 * r.norm() * J.norm());
  }
}

TYPED_TEST(RigidTangent, makes_newton_quadratic) {
  const RigidBody body = holds_a_point<TypeParam> ? body_of(Box(), skew(), {0.4, 0.2, -0.3}) : body_of(Box(), skew());
  const RigidMiddle middle(body, all_loads(body), any_start(body), 0.05);
  const TypeParam system(middle);
  typename TypeParam::Vector x = system.start(), r, exact = x;
  for (int k = 0; k < 20; ++k) system.residual(exact, r), exact -= system.correction(exact, r);
  std::vector<double> errors;
  for (int k = 0; k < 8; ++k) {
    errors.push_back((x - exact).norm() / exact.norm());
    system.residual(x, r), x -= system.correction(x, r);
  }
  // Each error is at most a constant times the square of the one before it, down to rounding.
  int squared = 0;
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) {
    if (errors[k] > 0.1 || errors[k + 1] < 1e-13) continue;
    EXPECT_LT(errors[k + 1], 20 * errors[k] * errors[k]) << k;
    ++squared;
  }
  EXPECT_GE(squared, 1);
  EXPECT_LT(errors.back(), 1e-14);
}

TEST(RigidNewton, ends_at_rounding_and_tells_its_residuals) {
  const RigidBody body = body_of(Box(), skew());
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    RigidState state = any_start(body);
    const RigidReport report = step(body, all_loads(body), 0.05, state, {});
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.residual(), 1e-15);
    EXPECT_GT(report.residuals[0], 1e-3);
    EXPECT_LE(report.iterations, 6);
  }
}

TEST(RigidNewton, without_convergence_leaves_the_state_and_says_so) {
  const RigidBody body = body_of(Box(), skew());
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    RigidState state = any_start(body);
    const RigidState before = state;
    const RigidReport report = step(body, all_loads(body), 0.2, state, {1e-12, 1});
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, 1);
    EXPECT_GT(report.residual(), 1e-12);
    EXPECT_EQ(state.q, before.q);
    EXPECT_EQ(state.v, before.v);
  }
}

TEST(RigidNewton, what_is_not_a_number_does_not_converge) {
  // From rest as well, where all other terms of the balance are zero.
  const RigidBody body = body_of(Box(), skew());
  const RigidForces bad = rigid_torque({0, std::nan(""), 0});
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    for (const RigidState& first : {any_start(body), rigid_start(body, Vector3d::Zero(), Vector3d::Zero())}) {
      RigidState state = first;
      EXPECT_FALSE(step(body, bad, 0.2, state, {}).converged);
      EXPECT_EQ(state.q, first.q);
    }
  }
}

TEST(RigidNewton, a_body_at_rest_stays_there) {
  const RigidBody body = body_of(Box(), skew());
  for (const Step step : {rigid_constrained_step, rigid_reduced_step}) {
    RigidState state = rigid_start(body, Vector3d::Zero(), Vector3d::Zero());
    EXPECT_TRUE(step(body, {}, 0.1, state, {}).converged);
    EXPECT_EQ(state.q, body.frame.columns());
    EXPECT_EQ(state.v.norm(), 0);
  }
}

// No number of a step is of variable size: nothing can be allocated for it.
template <class System>
constexpr bool fixed_sizes = System::Vector::SizeAtCompileTime > 0 && System::Matrix::SizeAtCompileTime > 0;
static_assert(fixed_sizes<RigidReduced<false>> && fixed_sizes<RigidReduced<true>>);

}  // namespace
}  // namespace tether::fem
