// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "unit/physics/solids/elements_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;
using std::numbers::pi;

Scene box(Geometry geometry, const Walls& walls) {
  return scene_on(BackgroundGrid(21, 21, 0.4, 4.4, -2, 2), walls, 0.01, robust_set(), geometry);
}

struct Shape {
  const char* name;
  std::function<void(Scene&, const Membrane&)> add;
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

/// Quarters of a circle about a corner of the box, from wall to wall, either way round.
void add_quarter(Scene& scene, const Membrane& law, double xc, double yc, double from, double to) {
  scene.walls = all_walls(Wall::symmetry);
  add_body(scene, law, arc(xc, yc, 1.3, 1.3, from, to, 8, 0.05), 2);
}

const Shape shapes[] = {
    {"Open", [](Scene& s, const Membrane& law) { add_body(s, law, line(1, -1, 3, 0.5, 9, 0.05), 2); }},
    {"OpenWithHalfEnds",
     [](Scene& s, const Membrane& law) { add_body(s, law, line(1, -1, 3, 0.5, 9, 0.05, true), 2); }},
    {"Closed",
     [](Scene& s, const Membrane& law) { add_body(s, law, arc(2.2, 0.1, 1.1, 0.9, 0, 2, 12, 0.05), 2, 0, true); }},
    {"ClosedTheOtherWay",
     [](Scene& s, const Membrane& law) { add_body(s, law, arc(2.2, 0.1, 1.1, 0.9, 2, 0, 12, 0.05), 2, 0, true); }},
    {"LeftBottom", [](Scene& s, const Membrane& law) { add_quarter(s, law, 0.4, -2, 0, 0.5); }},
    {"BottomRight", [](Scene& s, const Membrane& law) { add_quarter(s, law, 4.4, -2, 0.5, 1); }},
    {"RightTop", [](Scene& s, const Membrane& law) { add_quarter(s, law, 4.4, 2, 1, 1.5); }},
    {"TopLeft", [](Scene& s, const Membrane& law) { add_quarter(s, law, 0.4, 2, 1.5, 2); }},
    {"LeftTop", [](Scene& s, const Membrane& law) { add_quarter(s, law, 0.4, 2, 2, 1.5); }},
    {"LeftLeft", [](Scene& s, const Membrane& law) { add_quarter(s, law, 0.4, 0, -0.5, 0.5); }},
    {"RightRight", [](Scene& s, const Membrane& law) { add_quarter(s, law, 4.4, 0, 0.5, 1.5); }},
    {"LeftRight",
     [](Scene& s, const Membrane& law) {
       s.walls = all_walls(Wall::free_slip);
       add_body(s, law, line(0.4, 0.3, 4.4, 0.8, 12, 0.05), 2);
     }},
};

class EveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Elements, EveryShape, testing::ValuesIn(shapes),
                         [](const auto& info) { return std::string(info.param.name); });

// By central differences, of the elements' strain energy and the pressure's, plane and about an axis, for points moved
// any way: parts are taut, parts wrinkled one way, the other, or slack.
TEST_P(EveryShape, ForcesAreTheSlopesOfTheEnergy) {
  for (const Geometry geometry : {Geometry::plane, Geometry::axisymmetric}) {
    for (const Membrane& law : {string, both_ways, two_way}) {
      Scene scene = box(geometry, all_walls(Wall::open));
      GetParam().add(scene, law);
      scene.ambient = 0.6;
      scene.points.sxx.assign(scene.points.size(), 0.5);  // and a little strain at the start
      Chain chain(std::move(scene));
      Points& P = chain.points();
      std::mt19937 random(11);
      std::uniform_real_distribution<double> any(-0.05, 0.05);
      for (std::size_t p = 0; p < P.size(); ++p) P.x[p] += any(random), P.y[p] += any(random);
      chain.update();
      const double e = 1e-6;
      for (std::size_t p = 0; p < P.size(); ++p) {
        const Pair force = chain.elements().force(p);
        const auto slope = [&](double& at) {
          const double here = at;
          at = here + e;
          const double above = chain.energy();
          at = here - e;
          const double below = chain.energy();
          at = here;
          return (above - below) / (2 * e);
        };
        EXPECT_NEAR(force[0], -slope(P.x[p]), 1e-7) << p;
        EXPECT_NEAR(force[1], -slope(P.y[p]), 1e-7) << p;
      }
    }
  }
}

// What a step's ledger books of the elements: energy lost but not given by the forces on the way of the mid-step.
TEST_P(EveryShape, SettlesTheWorkDefect) {
  for (const Geometry geometry : {Geometry::plane, Geometry::axisymmetric}) {
    Scene scene = box(geometry, all_walls(Wall::open));
    GetParam().add(scene, both_ways);
    scene.ambient = 0.6;
    Chain chain(std::move(scene));
    Points& P = chain.points();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-0.05, 0.05);
    for (std::size_t p = 0; p < P.size(); ++p) P.x[p] += any(random), P.y[p] += any(random);
    for (int step = 0; step < 2; ++step) {  // nothing is left of the step before
      chain.update();
      const double before = chain.energy();
      double expected = 0;
      for (std::size_t p = 0; p < P.size(); ++p) {
        const Pair moved = pair(any(random), any(random)), work = chain.elements().force(p) * moved;
        chain.elements().book(p, pair(P.x[p], P.y[p]), moved, 0.01 * any(random));
        expected += chain.elements().heat(p) - work[0] - work[1];
        P.x[p] += moved[0] + 0.1 * any(random), P.y[p] += moved[1];
      }
      chain.elements().settle(P);
      expected += before - chain.energy();
      double heat = 0;
      for (std::size_t p = 0; p < P.size(); ++p) heat += chain.elements().heat(p);
      EXPECT_NEAR(heat, expected, 1e-14);
    }
  }
}

TEST_P(EveryShape, StandsUnstrainedAtTheStart) {
  for (const Geometry geometry : {Geometry::plane, Geometry::axisymmetric}) {
    Scene scene = box(geometry, all_walls(Wall::open));
    GetParam().add(scene, both_ways);
    Chain chain(std::move(scene));
    EXPECT_EQ(chain.energy(), 0);
    for (std::size_t p = 0; p < chain.points().size(); ++p) {
      EXPECT_EQ(chain.elements().force(p)[0], 0);
      EXPECT_EQ(chain.elements().force(p)[1], 0);
    }
  }
}

// Which way the points run says nothing of which side is inside.
TEST(Ambient, PressesOnWhatIsEnclosed) {
  for (const Geometry geometry : {Geometry::plane, Geometry::axisymmetric}) {
    for (const Shape& shape : shapes) {
      Scene scene = box(geometry, all_walls(Wall::open));
      shape.add(scene, string);
      scene.ambient = 0.6;
      Chain chain(std::move(scene));
      const std::string name = shape.name;
      double inward = 0;
      const bool right = name == "BottomRight" || name == "RightTop" || name == "RightRight";
      const bool closed = name.starts_with("Closed");
      const double xc = closed ? 2.2 : right ? 4.4 : 0.4;
      const double yc = closed ? 0.1 : name.find("Bottom") < 9 ? -2 : name.find("Top") < 9 ? 2 : 0;
      for (std::size_t p = 0; p < chain.points().size(); ++p) {
        const Pair f = chain.elements().force(p);
        inward -= f[0] * (chain.points().x[p] - xc) + f[1] * (chain.points().y[p] - yc);
      }
      if (name.starts_with("Open")) {
        EXPECT_EQ(inward, 0) << name;
      } else if (name == "LeftRight") {
        EXPECT_LT(chain.total_force()[1], 0);  // what lies below is inside
      } else {
        EXPECT_GT(inward, 0.1) << name;
      }
    }
  }
}

// p A of the half circle's opening, whatever its wall.
TEST(Ambient, PullsOnAWallWithThePressureOnItsOpening) {
  for (const char* name : {"LeftLeft", "RightRight"}) {
    for (const Shape& shape : shapes) {
      if (std::string(shape.name) != name) continue;
      Scene scene = box(Geometry::plane, all_walls(Wall::open));
      shape.add(scene, string);
      scene.ambient = 0.6;
      Chain chain(std::move(scene));
      const double opening = 2 * 1.3 * std::sin(pi / 2 * (1 - 1 / 8.0));  // from first to last point
      EXPECT_NEAR(std::abs(chain.total_force()[0]), 0.6 * opening, 1e-12);
      EXPECT_NEAR(chain.total_force()[1], 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace tether::mpm
