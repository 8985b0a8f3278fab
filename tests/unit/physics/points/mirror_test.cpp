// SPDX-License-Identifier: GPL-3.0-or-later
// A quarter of a symmetric scene between slip walls moves as the whole one does.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

/// A corner of the whole scene: the signs of x and y there.
struct Corner {
  double x, y;
};

class Mirror : public testing::TestWithParam<Corner> {
 protected:
  static constexpr int cells = 8;  // of a quarter's side, .25 wide and .2 high
  static constexpr double width = 2, height = 1.6;

  static Scene whole(double dt) {
    return scene_on(BackgroundGrid(2 * cells + 1, 2 * cells + 1, -width, width, -height, height),
                    all_walls(Wall::free_slip), dt, robust_set());
  }
  static Scene quarter(double dt) {
    const Corner c = GetParam();
    return scene_on(BackgroundGrid(cells + 1, cells + 1, c.x < 0 ? -width : 0, c.x < 0 ? 0 : width,
                                   c.y < 0 ? -height : 0, c.y < 0 ? 0 : height),
                    all_walls(Wall::free_slip), dt, robust_set());
  }
  static void turn(std::vector<PointAt>& points, double x, double y) {
    for (PointAt& at : points) at.x *= x, at.y *= y;
  }
  /// The points, which lie where x and y are positive, as a body of the quarter and, in all corners, of the whole: the
  /// quarter's own come first in either. A chain goes on from corner to corner.
  void add(const Material& material, const std::vector<PointAt>& points, double density, double energy = 0,
           bool chain = false) {
    const Corner c = GetParam();
    auto own = points;
    turn(own, c.x, c.y);
    auto all = own;
    for (const Corner other : {Corner{-c.x, c.y}, Corner{-c.x, -c.y}, Corner{c.x, -c.y}}) {
      auto image = points;
      turn(image, other.x, other.y);
      if (chain && other.x * other.y * c.x * c.y < 0) std::reverse(image.begin(), image.end());
      all.insert(all.end(), image.begin(), image.end());
    }
    // A chain that runs from the x axis to the y axis comes back to where it began.
    add_body(quarter_, material, own, density, energy);
    add_body(whole_, material, all, density, energy, chain);
  }
  /// An even, symmetric motion of both.
  void stir(double scale) {
    for (Scene* scene : {&quarter_, &whole_}) {
      set_velocities(*scene, [=](double x, double y) {
        return Vec<2>{scale * std::sin(x) * (1 - 0.4 * y * y), scale * (x * x - 0.8) * std::sin(2 * y)};
      });
    }
  }
  /// Largest difference of a field between the quarter and its points in the whole, against the largest value.
  static double difference(const Running& quarter, const Running& whole, const char* name) {
    const auto a = quarter.field(name), b = whole.field(name);
    double worst = 0, most = 1e-300;
    for (std::size_t k = 0; k < quarter.scene().bodies.size(); ++k) {
      const Body &of = quarter.scene().bodies[k], &in = whole.scene().bodies[k];
      for (std::size_t p = 0; p < of.count; ++p) {
        worst = std::max(worst, std::abs(a[of.first + p] - b[in.first + p]));
        most = std::max(most, std::abs(a[of.first + p]));
      }
    }
    return worst / most;
  }
  void expect_same(int steps, std::initializer_list<const char*> fields) {
    Running part(quarter_), all(whole_);
    part.steps(steps), all.steps(steps);
    for (const char* name : fields) EXPECT_LT(difference(part, all, name), 1e-12) << name;
    for (const char* name : {"energy_kinetic", "energy_strain", "energy_internal", "mass"})
      EXPECT_NEAR(4 * part.value(name), all.value(name), 1e-12 * (1 + all.value("energy_total"))) << name;
  }

  Scene quarter_ = quarter(0.01), whole_ = whole(0.01);
};

INSTANTIATE_TEST_SUITE_P(Corners, Mirror, testing::Values(Corner{1, 1}, Corner{-1, 1}, Corner{1, -1}, Corner{-1, -1}));

bool in_disc(double x, double y) { return x * x + y * y < 0.9; }

TEST_P(Mirror, GasBlob) {
  add(robust_gas(0.01), lattice(0.1, 0, 2, 0, 2, in_disc), 1.3, 2);
  stir(0.3);
  expect_same(80, {"x", "y", "vx", "vy", "density", "specific_energy", "sxy"});
}

TEST_P(Mirror, ElasticBlock) {
  add(plane_strain(3, 0.3), lattice(0.1, 0, 0.8, 0, 1), 1.3);
  stir(0.1);
  expect_same(80, {"x", "y", "vx", "vy", "sxx", "syy", "sxy"});
}

/// An ellipse around gas: its ends have their images behind the walls.
TEST_P(Mirror, MembraneAcrossTheWallsAroundGas) {
  add(robust_gas(0.01), lattice(0.1, 0, 2, 0, 2, in_disc), 1.3, 2);
  add(Membrane{50, 0.3, true, Membrane::Kind::plane_stress}, arc(0, 0, 1.1, 0.9, 0, 0.5, 14, 0.03), 2, 0, true);
  for (Scene* scene : {&quarter_, &whole_}) scene->ambient = 0.2;
  stir(0.2);
  expect_same(80, {"x", "y", "vx", "vy", "density", "specific_energy", "strain", "sxx", "syy", "sxy"});
}

/// Two bodies whose points lie unevenly: their contact at the walls is the whole one's.
TEST_P(Mirror, ContactOnTheWalls) {
  for (Scene* scene : {&quarter_, &whole_}) scene->walls.right = scene->walls.left = Wall::free_slip;
  add(plane_strain(3, 0.3), lattice(0.1, 0, 0.8, 0, 0.7), 1.3);
  auto outer = lattice(0.07, 0, 1.4, 0, 1.4, [](double x, double y) { return x > 0.83 || y > 0.75; });
  add(plane_strain(2, 0.2), outer, 1);
  for (Scene* scene : {&quarter_, &whole_}) {
    set_velocities(*scene, [](double x, double y) {
      const bool inner = std::abs(x) < 0.8 && std::abs(y) < 0.7;
      return inner ? Vec<2>{0.3 * x, 0.2 * y} : Vec<2>{-0.2 * x, -0.3 * y};
    });
  }
  expect_same(80, {"x", "y", "vx", "vy", "sxx", "syy", "sxy"});
}

}  // namespace
}  // namespace tether::mpm
