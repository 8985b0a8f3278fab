// SPDX-License-Identifier: GPL-3.0-or-later
// Friction between a fluid and bodies that it sticks to.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "physics/box/friction/viscosity.hpp"
#include "unit/physics/box/bodies_support.hpp"
#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

/// Fluid of density 3 about a square, or about a disc, in a box with walls.
class FluidAboutABody {
 public:
  template <class Map>
  FluidAboutABody(int n, double mass, const Map& map)
      : grid_(support::unit_box(2, n)),
        mesh_(support::lattice(
            2, {n / 2, n / 2, 1}, [](const support::Cell&) { return true; }, map)),
        surface_(surface_of(mesh_)),
        near_(surface_near_faces(surface_, mesh_.x, grid_)),
        domain_(support::box(grid_)),
        mobility_(mesh_.x.size(), mass > 0 ? 1 / mass : 0) {
    const Crossings crossings = find_crossings(surface_, mesh_.x, grid_);
    for (std::size_t c = 0; c < crossings.inside.size(); ++c) {
      if (crossings.inside[c] != 0) support::fill_cell(domain_, grid_.place_of_cell(c));
    }
    u.assign(mesh_.x.size(), 0.0);
    v = face_values(grid_);
  }

  Rubbed rub(double nu, double h) {
    const SolidsNearFaces solids{surface_, near_, u.size(), true};
    const RubbingFluid fluid{domain_, density, density * nu, all_liquid, Beyond::nothing, &solids};
    Rubbed rubbed = Friction(fluid, mobility_, h).act(alone(), u, {}, 1e-13, {}, v);
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += mobility_[k] * rubbed.impulse[k];
    return rubbed;
  }
  double momentum(int axis) const {
    double sum = 0;
    for (std::size_t f = 0; f < v[at(axis)].size(); ++f) sum += mass(axis, f) * v[at(axis)][f];
    return sum;
  }
  double energy() const {
    double sum = 0;
    for (int axis = 0; axis < 2; ++axis) {
      for (std::size_t f = 0; f < v[at(axis)].size(); ++f) sum += 0.5 * mass(axis, f) * std::pow(v[at(axis)][f], 2);
    }
    for (std::size_t k = 0; k < u.size(); ++k) sum += 0.5 * u[k] * u[k] / mobility_[k];
    return sum;
  }
  const Mesh& mesh() const { return mesh_; }
  const FlowDomain& domain() const { return domain_; }

  static constexpr double density = 3;
  std::vector<double> u;
  FaceValues v;

 private:
  double mass(int axis, std::size_t f) const {
    return domain_.face[at(axis)][f] == FaceKind::open ? density * domain_.volume[at(axis)][f] : 0;
  }

  StaggeredGrid grid_;
  Mesh mesh_;
  SolidSurface surface_;
  SurfaceNearFaces near_;
  FlowDomain domain_;
  std::vector<double> mobility_;
};

Vec<3> square(const Vec<3>& x) { return {0.31 + 0.4 * x[0], 0.27 + 0.4 * x[1], 0}; }

/// A disc of radius .2 in the middle of the box.
Vec<3> disc_in_the_middle(const Vec<3>& x) {
  const double a = 2 * x[0] - 1, b = 2 * x[1] - 1;
  return {0.5 + 0.2 * a * std::sqrt(1 - b * b / 2), 0.5 + 0.2 * b * std::sqrt(1 - a * a / 2), 0};
}

TEST(RubbedBody, GetsTheMomentumThatTheFluidLosesAndNoEnergy) {
  for (const double mass : {1e-6, 1.0, 1e6}) {
    for (const double h : {1e-3, 1.0, 1e6}) {
      FluidAboutABody scene(8, mass, square);
      for (std::size_t f = 0; f < scene.v[0].size(); ++f)
        scene.v[0][f] = scene.domain().face[0][f] == FaceKind::open ? 1 : 0;
      for (int step = 0; step < 3; ++step) {
        const double energy = scene.energy(), momentum = scene.momentum(0);
        const Rubbed rubbed = scene.rub(1e-9, h);  // walls take next to nothing in so short a time
        double impulse = 0;
        for (const double part : rubbed.impulse) impulse += part;
        EXPECT_NEAR(momentum - scene.momentum(0), impulse, (h <= 1 ? 1e-7 : 1) * momentum);
        if (step == 0) {
          EXPECT_GT(impulse, 0);
        }
        EXPECT_LE(scene.energy(), energy * (1 + 1e-12)) << mass << " " << h;
        EXPECT_GT(rubbed.taken, 0);
      }
    }
  }
}

/// What is held gets it, too.
TEST(RubbedBody, WhoseNodesAreHeldIsPushed) {
  FluidAboutABody scene(8, 0, square);
  for (std::size_t f = 0; f < scene.v[0].size(); ++f)
    scene.v[0][f] = scene.domain().face[0][f] == FaceKind::open ? 1 : 0;
  const double momentum = scene.momentum(0);
  const Rubbed rubbed = scene.rub(1e-9, 1);
  double impulse = 0;
  for (const double part : rubbed.impulse) impulse += part;
  EXPECT_GT(impulse, 0);
  EXPECT_NEAR(momentum - scene.momentum(0), impulse, 1e-7 * momentum);
  for (const double u : scene.u) EXPECT_EQ(u, 0);
}

/// What turns as one has no rate of strain, and keeps turning.
TEST(RubbedBody, TurnsWithTheFluid) {
  FluidAboutABody scene(16, 1, disc_in_the_middle);
  const auto turn = [](const std::array<double, 3>& x) { return std::array{0.5 - x[1], x[0] - 0.5, 0.0}; };
  scene.v = support::faces_of(scene.domain().grid, turn);
  for (std::size_t k = 0; k + 1 < scene.u.size(); k += 2) {
    const auto u = turn({scene.mesh().x[k], scene.mesh().x[k + 1], 0});
    scene.u[k] = u[0], scene.u[k + 1] = u[1];
  }
  const std::vector<double> before = scene.u;
  const Rubbed rubbed = scene.rub(1e-3, 1e-3);
  double largest = 0;
  for (const double impulse : rubbed.impulse) largest = std::max(largest, std::abs(impulse));
  EXPECT_LT(largest, 1e-12);
}

/// A disc of radius .2 that turns at a rate of 1 in a ring of radius .4 at rest, both heavy: the torque over
/// 4 pi mu a^2 b^2 / (b^2 - a^2), and the largest error of the velocity between them, which is of a vortex and a
/// turning, after a step so long that it ends in the flow that stays.
struct Torque {
  double part = 0, velocity_error = 0;
};
Torque torque(int n) {
  const double a = 0.2, b = 0.4, heavy = 1e7, h = 1e3, nu = 1;
  const auto around = [](const Vec<3>& x, double inner, double outer) {  // y goes round, x from inside to outside
    const double r = inner + (outer - inner) * x[0], angle = 2 * std::numbers::pi * x[1];
    return Vec<3>{0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle), 0};
  };
  const StaggeredGrid grid = support::unit_box(2, n);
  Mesh mesh = support::lattice(
      2, {2, 256, 1}, [](const support::Cell&) { return true; }, [&](const Vec<3>& x) { return around(x, 0.05, a); });
  const std::size_t turning = mesh.x.size(), count = turning / 2;
  const Mesh ring = support::lattice(
      2, {2, 256, 1}, [](const support::Cell&) { return true; }, [&](const Vec<3>& x) { return around(x, b, 0.49); });
  mesh.x.insert(mesh.x.end(), ring.x.begin(), ring.x.end());
  for (const int node : ring.nodes) mesh.nodes.push_back(node + static_cast<int>(count));
  mesh.region.insert(mesh.region.end(), ring.region.begin(), ring.region.end());
  const SolidSurface surface = surface_of(mesh);
  const SurfaceNearFaces near = surface_near_faces(surface, mesh.x, grid);
  FlowDomain domain = support::box(grid);
  const Crossings crossings = find_crossings(surface, mesh.x, grid);
  for (std::size_t c = 0; c < crossings.inside.size(); ++c) {
    if (crossings.inside[c] != 0) support::fill_cell(domain, grid.place_of_cell(c));
  }
  std::vector<double> u(mesh.x.size(), 0.0);
  for (std::size_t k = 0; k < turning; k += 2) u[k] = 0.5 - mesh.x[k + 1], u[k + 1] = mesh.x[k] - 0.5;
  const SolidsNearFaces solids{surface, near, u.size(), true};
  const RubbingFluid fluid{domain, 1, nu, all_liquid, Beyond::nothing, &solids};
  FaceValues v = face_values(grid);
  const std::vector<double> mobility(u.size(), 1 / heavy);
  const Rubbed rubbed = Friction(fluid, mobility, h).act(alone(), u, {}, 1e-13, {}, v);
  Torque result;
  for (std::size_t k = 0; k < turning; k += 2)
    result.part -= ((mesh.x[k] - 0.5) * rubbed.impulse[k + 1] - (mesh.x[k + 1] - 0.5) * rubbed.impulse[k]) / h;
  result.part /= 4 * std::numbers::pi * nu * a * a * b * b / (b * b - a * a);
  const auto exact = [&](const std::array<double, 3>& x) {
    const double r = std::hypot(x[0] - 0.5, x[1] - 0.5), rate = a * a / (b * b - a * a) * (b * b / (r * r) - 1);
    return std::array{rate * (0.5 - x[1]), rate * (x[0] - 0.5), 0.0};
  };
  const FaceValues flow = support::faces_of(grid, exact);
  for (int axis = 0; axis < 2; ++axis) {
    for (std::size_t f = 0; f < v[at(axis)].size(); ++f) {
      const auto x = support::middle_of_face(grid, axis, f);
      const double r = std::hypot(x[0] - 0.5, x[1] - 0.5);
      if (domain.face[at(axis)][f] == FaceKind::open && r > a && r < b)
        result.velocity_error = std::max(result.velocity_error, std::abs(v[at(axis)][f] - flow[at(axis)][f]) / a);
    }
  }
  return result;
}

TEST(RubbedBody, HasTheTorqueOfItsTurning) {
  const Torque coarse = torque(32), fine = torque(128);
  EXPECT_NEAR(coarse.part, 1, 0.03);
  EXPECT_NEAR(fine.part, 1, 0.01);
  EXPECT_LT(coarse.velocity_error, 0.035);
  EXPECT_LT(fine.velocity_error, 0.015);
}

/// A surface between two middles of faces is as far from each of them as it is drawn.
TEST(NearSurface, FindsTheSurfaceBesideAFace) {
  const StaggeredGrid grid = support::unit_box(2, 8);
  const Mesh mesh = support::lattice(
      2, {1, 1, 1}, [](const support::Cell&) { return true; },
      [](const Vec<3>& x) {
        return Vec<3>{0.3 + 0.5 * x[0], 0.27 + 0.5 * x[1], 0};
      });
  const SolidSurface surface = surface_of(mesh);
  const SurfaceNearFaces near = surface_near_faces(surface, mesh.x, grid);
  const NearSurface along_x(grid, 0, near[0]);
  const auto below = along_x.between({4, 1, 0}, 1, true);  // at (.5, .1875), the bottom is at .27
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->cells, (0.27 - 0.1875) / 0.125, 1e-12);
  const auto left = along_x.between({2, 4, 0}, 0, true);  // at (.25, .5625), the left side is at .3
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->cells, (0.3 - 0.25) / 0.125, 1e-12);
  EXPECT_FALSE(along_x.between({1, 1, 0}, 0, true));
}

}  // namespace
}  // namespace tether::coupled
