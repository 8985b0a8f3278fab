// SPDX-License-Identifier: GPL-3.0-or-later
// Generalized forces (26)-(30): virtual work, resultants, pressures on closed surfaces, torques in skew frames.
#include "physics/rigid/body.hpp"

#include <gtest/gtest.h>

#include "unit/physics/rigid/support.hpp"

namespace tether::fem {
namespace {

using namespace rigid;

Vector3d resultant(const RigidColumns& F) { return F.col(0); }
/// About the origin.
Vector3d moment(const RigidColumns& F, const RigidColumns& q) {
  Vector3d sum = Vector3d::Zero();
  for (int a = 0; a < 4; ++a) sum += q.col(a).cross(F.col(a));
  return sum;
}

/// A frame's columns after the body has moved and turned.
RigidColumns moved(const RigidFrame& frame, const Matrix3d& R) {
  RigidColumns q = R * frame.columns();
  q.col(0) += Vector3d(1, -2, 0.5);
  return q;
}

const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();

TEST(RigidLoads, forces_at_points_have_their_work_resultant_and_moment) {
  const RigidFrame frame = skew();
  const std::vector<double> at{0.3, 0.1, -0.2, -0.5, 0.4, 0.9}, force{1, -2, 3, 0.5, 0.7, -0.4};
  for (const RigidDirection direction : {RigidDirection::fixed, RigidDirection::turning}) {
    const RigidForces load = rigid_point_forces(frame, at, force, direction);
    const RigidColumns q = moved(frame, turn), F = rigid_generalized_forces(load, q), dq = any_numbers<RigidColumns>();
    Vector3d sum = Vector3d::Zero(), turning = Vector3d::Zero();
    double work = 0;
    for (std::size_t k = 0; k < 6; k += 3) {
      const Vector3d theta = frame.convective(Vector3d(at.data() + k));
      Vector3d f(force.data() + k);
      if (direction == RigidDirection::turning) f = turn * f;
      sum += f, turning += (q.col(0) + q.rightCols<3>() * theta).cross(f);
      work += f.dot(dq.col(0) + dq.rightCols<3>() * theta);
    }
    EXPECT_NEAR(F.cwiseProduct(dq).sum(), work, 1e-13);  // (26)
    EXPECT_LT((resultant(F) - sum).norm(), 1e-14);
    EXPECT_LT((moment(F, q) - turning).norm(), 1e-13);
  }
}

TEST(RigidLoads, weight_is_the_sum_over_the_mass_points) {
  const Vector3d g(0.3, -9.8, 1);
  const MassPoints points = gauss_points(Box());
  std::vector<double> forces;
  for (const double mass : points.masses) forces.insert(forces.end(), {mass * g[0], mass * g[1], mass * g[2]});
  const RigidForces sum = rigid_point_forces(skew(), points.positions, forces, RigidDirection::fixed);
  EXPECT_LT((rigid_gravity(inertia_of(Box(), skew()), g).fixed - sum.fixed).norm(), 1e-14);
}

/// Quadrature points of a box's six sides, exact for polynomials of the third degree, and outward area vectors.
struct Surface {
  std::vector<double> positions, areas;
  explicit Surface(const Box& box) {
    const double at = 0.5 / std::sqrt(3);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      for (int side = 0; side < 2; ++side) {
        for (int g = 0; g < 4; ++g) {
          Vector3d x = box.centre(), area = Vector3d::Zero();
          x[i] += (side - 0.5) * box.size()[i];
          x[j] += ((g & 1) ? at : -at) * box.size()[j], x[k] += ((g & 2) ? at : -at) * box.size()[k];
          area[i] = (side ? 0.25 : -0.25) * box.size()[j] * box.size()[k];
          positions.insert(positions.end(), {x[0], x[1], x[2]});
          areas.insert(areas.end(), {area[0], area[1], area[2]});
        }
      }
    }
  }
};

TEST(RigidLoads, even_pressure_on_a_closed_surface_does_nothing) {
  const Surface surface{Box()};
  const std::vector<double> pressures(24, 1e3);
  const RigidForces load = rigid_pressure(skew(), surface.positions, surface.areas, pressures);
  const RigidColumns q = moved(skew(), turn), F = rigid_generalized_forces(load, q);
  EXPECT_LT(resultant(F).norm(), 1e-11);
  EXPECT_LT(moment(F, q).norm(), 1e-11);
  EXPECT_GT(F.norm(), 100);  // it does press: only a deforming body would feel it
}

TEST(RigidLoads, pressure_of_a_fluid_at_rest_lifts_by_its_weight) {
  const Box box{{-0.4, 0.1, -0.7}, {0.6, 0.9, -0.2}, 1, {1, 1, 1}};
  const Surface surface(box);
  const double weight = 7;  // rho g
  std::vector<double> pressures;
  for (std::size_t k = 0; k < 24; ++k) pressures.push_back(-weight * surface.positions[3 * k + 2]);
  const RigidColumns q = skew().columns();
  const RigidColumns F =
      rigid_generalized_forces(rigid_pressure(skew(), surface.positions, surface.areas, pressures), q);
  const Vector3d lift(0, 0, weight * box.size().prod());
  EXPECT_LT((resultant(F) - lift).norm(), 1e-14);
  EXPECT_LT((moment(F, q) - box.centre().cross(lift)).norm(), 1e-14);  // Archimedes: through the centre of the volume
}

TEST(RigidLoads, torque_has_its_power_and_no_force_in_a_skew_frame) {
  const Vector3d m(2, -1, 3), omega(0.4, 1.5, -0.7);
  const RigidColumns q = moved(skew(), turn), F = rigid_generalized_forces(rigid_torque(m), q);
  RigidColumns v = RigidColumns::Zero();
  v.col(0) = Vector3d(5, 6, 7);
  for (int i = 1; i < 4; ++i) v.col(i) = omega.cross(q.col(i));
  EXPECT_NEAR(F.cwiseProduct(v).sum(), m.dot(omega), 1e-13);  // (29)
  EXPECT_LT((moment(F, q) - m).norm(), 1e-13);
  EXPECT_EQ(resultant(F).norm(), 0);
  // With d_i for d^i as printed in (30) the power would be another one.
  double printed = 0;
  for (int i = 1; i < 4; ++i) printed += 0.5 * m.cross(q.col(i)).dot(v.col(i));
  EXPECT_GT(std::abs(printed - m.dot(omega)), 0.1);
}

TEST(RigidLoads, loads_add_with_their_factors) {
  const std::vector<double> at{1, 2, 3}, force{4, 5, 6};
  RigidForces sum = rigid_torque({1, 0, 0});
  const RigidForces turning = rigid_point_forces(skew(), at, force, RigidDirection::turning);
  sum.add(turning, -2).add(rigid_torque({0, 1, 0}), 3).add(rigid_gravity(inertia_of(Box(), skew()), {0, 0, 1}));
  EXPECT_EQ(sum.torque, Vector3d(1, 3, 0));
  EXPECT_EQ(sum.turning, -2 * turning.turning);
  EXPECT_NEAR(sum.fixed(2, 0), Box().mass(), 1e-14);
}

}  // namespace
}  // namespace tether::fem
