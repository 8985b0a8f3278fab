// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/drag.hpp"

#include <gtest/gtest.h>

#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

/// Fluid that moves by a square at rest, of nodes each of this mass.
class FluidBesideASquare {
 public:
  explicit FluidBesideASquare(double mass)
      : grid_{2, {8, 8, 1}, {0, 0, 0}, {0.125, 0.125, 1}},
        mesh_(support::lattice(
            2, {4, 4, 1}, [](const support::Cell&) { return true; },
            [](const Vec<3>& x) {
              return Vec<3>{0.31 + 0.4 * x[0], 0.27 + 0.4 * x[1], 0};
            })),
        surface_(surface_of(mesh_)),
        beside_(surface_beside_faces(surface_, mesh_.x, grid_)),
        still_(mesh_.x.size(), 0.0),
        bodies_{surface_, beside_, std::vector<double>(mesh_.x.size(), 1 / mass), still_, still_, 3, still_},
        v_(grid_.face_count(0), 1.0),
        drag_(grid_, 0) {
    const NearSurface near(grid_, 0, beside_[0]);
    for (std::size_t f = 0; f < v_.size(); ++f) {
      for (std::size_t b = 0; b < 2; ++b) {
        for (const bool up : {false, true}) {
          if (const auto found = near.between(grid_.place_of_face(0, f), b, up))
            drag_.join(f, grid_.volume(), b, *found, false);
        }
      }
    }
  }

  void act(double nu, double h) { drag_.act(nu, h, bodies_, v_); }
  double momentum_of_fluid() const {
    double sum = 0;
    for (const double v : v_) sum += bodies_.density * grid_.volume() * v;
    return sum;
  }
  double impulse() const {
    double sum = 0;
    for (const double impulse : bodies_.impulse) sum += impulse;
    return sum;
  }
  double energy() const {
    double sum = 0;
    for (const double v : v_) sum += 0.5 * bodies_.density * grid_.volume() * v * v;
    for (std::size_t k = 0; k < bodies_.u.size(); ++k) sum += 0.5 * bodies_.u[k] * bodies_.u[k] / bodies_.mobility[k];
    return sum;
  }

 private:
  StaggeredGrid grid_;
  Mesh mesh_;
  SolidSurface surface_;
  SurfaceBesideFaces beside_;
  std::vector<double> still_;
  StickingBodies bodies_;
  std::vector<double> v_;
  Drag drag_;
};

TEST(Drag, GivesTheNodesWhatItTakesOfTheFluidAndNoEnergy) {
  for (const double mass : {1e-6, 1.0, 1e6}) {
    for (const double h : {1e-3, 1.0, 1e6}) {
      FluidBesideASquare scene(mass);
      const double momentum = scene.momentum_of_fluid();
      double energy = scene.energy();
      for (int step = 0; step < 3; ++step) {
        scene.act(0.1, h);
        EXPECT_NEAR(momentum - scene.momentum_of_fluid(), scene.impulse(), 1e-12 * momentum);
        EXPECT_LE(scene.energy(), energy * (1 + 1e-12)) << mass << " " << h;
        energy = scene.energy();
      }
      EXPECT_GT(scene.impulse(), 0);
    }
  }
}

/// A surface between two middles of faces is as far from each of them as it is drawn.
TEST(Drag, FindsTheSurfaceBesideAFace) {
  const StaggeredGrid grid{2, {8, 8, 1}, {0, 0, 0}, {0.125, 0.125, 1}};
  const Mesh mesh = support::lattice(
      2, {1, 1, 1}, [](const support::Cell&) { return true; },
      [](const Vec<3>& x) {
        return Vec<3>{0.3 + 0.5 * x[0], 0.27 + 0.5 * x[1], 0};
      });
  const SolidSurface surface = surface_of(mesh);
  const SurfaceBesideFaces beside = surface_beside_faces(surface, mesh.x, grid);
  const NearSurface along_x(grid, 0, beside[0]);
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
