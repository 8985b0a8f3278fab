// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of the mass (24, 25) in any frame, and what cannot be a rigid body.
#include "physics/rigid/body.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/diagnostics.hpp"
#include "unit/physics/rigid/support.hpp"

namespace tether::fem {
namespace {

using namespace rigid;

/// Exact moments of a box: theta = D^-1 (X - point) is linear, so that M_phi, e_i, E_ij follow from those of X.
Eigen::Matrix4d exact_moments(const Box& box, const RigidFrame& frame) {
  const Matrix3d per = frame.directors.inverse();
  const Vector3d mean = per * (box.centre() - frame.point);
  const Matrix3d spread = box.mass() / 12 * Matrix3d(box.size().cwiseAbs2().asDiagonal());
  Eigen::Matrix4d m;
  m << box.mass(), box.mass() * mean.transpose(), box.mass() * mean,
      per * spread * per.transpose() + box.mass() * mean * mean.transpose();
  return m;
}

TEST(RigidBody, moments_of_a_box_are_exact_in_any_frame) {
  const Box box{{-0.2, 0.1, 0.3}, {0.9, 0.5, 1.7}, 3, {3, 1, 2}};
  RigidFrame left = skew();
  left.directors.col(1) *= -1;  // directors of the other hand
  for (const RigidFrame& frame : {orthonormal(), orthonormal(box.centre()), skew(), left}) {
    const Eigen::Matrix4d exact = exact_moments(box, frame);
    EXPECT_LT((inertia_of(box, frame).moments - exact).norm(), 1e-14 * exact.norm());
  }
  // At the centre of mass e vanishes, and E is diagonal along the principal axes.
  const RigidInertia central = inertia_of(box, orthonormal(box.centre()));
  EXPECT_LT(central.first().norm(), 1e-15);
  EXPECT_LT(
      (rigid_inertia_tensor(central.second(), Matrix3d::Identity()) - Matrix3d(box.principal().asDiagonal())).norm(),
      1e-14);
}

TEST(RigidBody, consistent_mass_gives_the_moments_of_its_quadrature_points) {
  // One trilinear brick: M_AB = sum over the Gauss points of rho w N_A N_B.
  const Box box{{0.1, 0.2, -0.4}, {1.3, 0.9, 0.5}, 1.7, {1, 1, 1}};
  const MassPoints points = gauss_points(box);
  std::vector<double> nodes, value(64);
  std::vector<std::size_t> row(64), column(64);
  for (int A = 0; A < 8; ++A) {
    for (int i = 0; i < 3; ++i) nodes.push_back((A >> i & 1) ? box.high[i] : box.low[i]);
  }
  const auto N = [&](std::size_t A, const Vector3d& x) {
    double product = 1;
    for (int i = 0; i < 3; ++i) {
      const double xi = (x[i] - box.low[i]) / box.size()[i];
      product *= (A >> i & 1) ? xi : 1 - xi;
    }
    return product;
  };
  for (std::size_t A = 0; A < 8; ++A) {
    for (std::size_t B = 0; B < 8; ++B) {
      row[8 * A + B] = A, column[8 * A + B] = B;
      for (std::size_t g = 0; g < points.masses.size(); ++g) {
        const Vector3d x(points.positions.data() + 3 * g);
        value[8 * A + B] += points.masses[g] * N(A, x) * N(B, x);
      }
    }
  }
  const Eigen::Matrix4d exact = exact_moments(box, skew());
  EXPECT_LT((rigid_inertia(skew(), nodes, {row, column, value}).moments - exact).norm(), 1e-14 * exact.norm());
}

TEST(RigidBody, mass_matrix_gives_the_kinetic_energy_of_the_points) {
  const Box box;
  const MassPoints points = gauss_points(box);
  const RigidInertia inertia = inertia_of(box, skew());
  const RigidColumns v = any_numbers<RigidColumns>();  // any motion of the frame, not a rigid one only
  double sum = 0;
  for (std::size_t k = 0; k < points.masses.size(); ++k) {
    const Vector3d theta = skew().convective(Vector3d(points.positions.data() + 3 * k));
    sum += 0.5 * points.masses[k] * (v.col(0) + v.rightCols<3>() * theta).squaredNorm();
  }
  const Eigen::Matrix<double, 12, 1> flat = v.reshaped();
  EXPECT_NEAR(0.5 * flat.dot(inertia.matrix() * flat), sum, 1e-14 * sum);
  EXPECT_NEAR(rigid_kinetic_energy(inertia, {{}, v}), sum, 1e-14 * sum);
}

TEST(RigidBody, energy_and_momenta_of_a_turning_box) {
  const Box box{{0.2, -0.3, 0.1}, {1.0, 0.4, 0.4}, 2, {2, 1, 1}};
  const Vector3d velocity(0.4, -0.7, 0.2), omega(1, -2, 0.5), p = box.mass() * velocity;
  const Vector3d spin = box.principal().cwiseProduct(omega);
  const double energy = 0.5 * (p.dot(velocity) + spin.dot(omega));
  for (const RigidFrame& frame : {orthonormal(), skew()}) {
    const RigidBody body = body_of(box, frame);
    const RigidState state = start(body, velocity, omega);
    EXPECT_NEAR(rigid_kinetic_energy(body.inertia, state), energy, 1e-14);
    EXPECT_LT((rigid_linear_momentum(body.inertia, state) - p).norm(), 1e-14);
    EXPECT_LT((rigid_angular_momentum(body.inertia, state) - box.centre().cross(p) - spin).norm(), 1e-14);
    EXPECT_LT((rigid_angular_velocity(body, state) - omega).norm(), 1e-13);
    EXPECT_NEAR(rigid_torque_power({3, 1, -2}, state), Vector3d(3, 1, -2).dot(omega), 1e-13);
    EXPECT_NEAR(rigid_potential_energy(body.inertia, state, {0, 0, -9}), 9 * box.mass() * box.centre()[2], 1e-14);
  }
}

/// The text of the InputError, or empty.
std::string refusal(const RigidFrame& frame, std::vector<double> positions, std::vector<double> masses) {
  try {
    rigid_body(frame, rigid_inertia(frame, positions, masses));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(RigidBody, refuses_what_is_none) {
  const std::vector<double> corner{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, four{1, 1, 1, 1};
  RigidFrame flat = skew(), none = skew();
  flat.directors.col(2) = 2 * flat.directors.col(0) - flat.directors.col(1);
  none.directors.col(1).setZero();
  EXPECT_EQ(refusal(skew(), corner, four), "");
  EXPECT_NE(refusal(flat, corner, four).find("lie in one plane"), std::string::npos);
  EXPECT_NE(refusal(none, corner, four).find("director d2 has length 0"), std::string::npos);
  EXPECT_NE(refusal(skew(), {}, {}).find("total mass is 0"), std::string::npos);
  EXPECT_NE(refusal(skew(), corner, {1, 1, -3, 0}).find("total mass is -1"), std::string::npos);
  EXPECT_NE(refusal(skew(), corner, {1, 1, std::numeric_limits<double>::quiet_NaN(), 0}).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(refusal(skew(), {1, 1, 1, 2, 3, 4, 1.5, 2, 2.5}, {1, 2, 1}).find("one line"), std::string::npos);
  EXPECT_NE(refusal(skew(), {1, 1, 1}, {1}).find("one line or in one point"), std::string::npos);
  EXPECT_EQ(refusal(skew(), {0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 1, 1}), "");  // a plane body has its inertia
}

TEST(RigidBody, refuses_a_frame_that_its_inertia_was_not_made_in) {
  RigidFrame flat = skew();
  flat.directors.col(2) = flat.directors.col(0);
  const RigidInertia inertia = inertia_of(Box(), skew());
  EXPECT_THROW(rigid_body(flat, inertia), InputError);
  EXPECT_THROW(rigid_body(skew(), inertia, Vector3d::Constant(std::numeric_limits<double>::infinity())), InputError);
}

}  // namespace
}  // namespace tether::fem
