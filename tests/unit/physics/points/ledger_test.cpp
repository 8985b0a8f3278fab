// SPDX-License-Identifier: GPL-3.0-or-later
// The heat ledger: what it books, and that with it total energy is kept.
#include "physics/points/passes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "physics/points/state.hpp"
#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm::heat_ledger {
namespace {

using namespace scenes;
using Splines = Scheme<SplineKernel, Apic, Geometry::plane>;

bool in_blob(double x, double y) { return x * x + y * y < 0.7; }

/// A grid with random velocities before and after the solve at its nodes, behind walls their images.
class Transfer : public testing::TestWithParam<Wall> {
 protected:
  Transfer()
      : scene_(scene_on(BackgroundGrid(9, 7, 0, 1.6, 0, 1.8), all_walls(GetParam()), 0.01, robust_set())),
        grid_(scene_, instruction_set()),
        points_((add_body(scene_, robust_gas(), lattice(0.1, 0, 1.6, 0, 1.8), 1, 1), scene_), scene_.points) {
    for (std::size_t n = 0; n < grid_.frame.shape.nodes(); ++n) {
      grid_.convected[n] = any(), grid_.motion.u[n] = any();
      if (grid_.frame.held[n] & holds_x) grid_.convected[n][0] = grid_.motion.u[n][0] = 0;
      if (grid_.frame.held[n] & holds_y) grid_.convected[n][1] = grid_.motion.u[n][1] = 0;
    }
    grid_.unfold_convected(), grid_.unfold_motion();
    for (std::size_t n = 0; n < grid_.frame.shape.nodes(); ++n)
      grid_.squares[n] = squares(grid_.convected[n]) + squares(grid_.motion.u[n]);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const Pair v = any(), x = any(), y = any();
      points_.vx[p] = v[0], points_.vy[p] = v[1];
      points_.vxx[p] = 5 * x[0], points_.vyx[p] = 5 * x[1], points_.vxy[p] = 5 * y[0], points_.vyy[p] = 5 * y[1];
    }
  }
  static double squares(Pair v) { return v[0] * v[0] + v[1] * v[1]; }
  Pair any() { return pair(spread_(random_), spread_(random_)); }
  /// sum_i N_i |v_p + C (x_i - x_p) - velocity_i|^2.
  template <class Velocity>
  double scatter(std::size_t p, const Velocity& velocity) const {
    const Locator locator(grid_.frame.shape);
    const auto at = SplineKernel::locate(locator, points_.x[p], points_.y[p]);
    double sum = 0;
    SplineKernel::spread(locator, at, SplineKernel::nodes(locator, at), field_about(points_, p),
                         [&](std::size_t n, double N, Pair v) { sum += N * squares(v - velocity(n)); });
    return sum;
  }
  double book(std::size_t p) {
    const Locator locator(grid_.frame.shape);
    const auto at = SplineKernel::locate(locator, points_.x[p], points_.y[p]);
    double squares = 0;
    return accelerate_and_book<Splines>(points_, p, grid_, locator, at, SplineKernel::nodes(locator, at), squares);
  }

  std::mt19937 random_{5};
  std::uniform_real_distribution<double> spread_{-1, 1};
  Scene scene_;
  Grid grid_;
  Points points_;
};

INSTANTIATE_TEST_SUITE_P(Walls, Transfer, testing::Values(Wall::open, Wall::free_slip, Wall::fixed),
                         [](const auto& info) { return "Wall" + std::to_string(static_cast<int>(info.param)); });

// .5 sum N (|u_p + C dx - v_old|^2 + |v_new - u' - C' dx|^2), at walls with what stands behind them.
TEST_P(Transfer, BooksTheScatterOnBothWays) {
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const double to_nodes = scatter(p, [&](std::size_t n) -> Pair { return grid_.convected[n]; });
    const double booked = book(p);
    const double back = scatter(p, [&](std::size_t n) -> Pair { return grid_.motion.u[n]; });
    EXPECT_NEAR(booked, 0.5 * (to_nodes + back), 1e-14);
    EXPECT_GT(booked, 0);
  }
}

/// A field that the nodes hold exactly costs nothing.
TEST_P(Transfer, BooksNothingOfALinearField) {
  if (GetParam() != Wall::open) return;
  const auto linear = [](double x, double y) { return pair(0.1 + 0.3 * x - 0.7 * y, -0.2 + 0.5 * x + 0.9 * y); };
  const BackgroundGrid& shape = grid_.frame.shape;
  for (std::size_t n = 0; n < shape.nodes(); ++n) {
    const auto nx = static_cast<std::size_t>(shape.nx);
    grid_.convected[n] =
        linear(shape.x0 + static_cast<double>(n % nx) * shape.dx, shape.y0 + static_cast<double>(n / nx) * shape.dy);
    grid_.motion.u[n] = grid_.convected[n];
    grid_.squares[n] = 2 * squares(grid_.convected[n]);
  }
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Pair v = linear(points_.x[p], points_.y[p]);
    points_.vx[p] = v[0], points_.vy[p] = v[1];
    points_.vxx[p] = 0.3, points_.vyx[p] = 0.5, points_.vxy[p] = -0.7, points_.vyy[p] = 0.9;
    EXPECT_NEAR(book(p), 0, 1e-14);
  }
}

struct Violent {
  const char* name;
  std::function<Scene()> scene;
};
void PrintTo(const Violent& one, std::ostream* out) { *out << one.name; }

constexpr Membrane taut{30, 0.3, true, Membrane::Kind::plane_stress};

Scene open_scene() {
  return scene_on(BackgroundGrid(21, 21, -2, 2, -2, 2), all_walls(Wall::open), 0.004, robust_set());
}

void stir_all(Scene& scene, double scale = 1) {
  set_velocities(scene, [=](double x, double y) {
    return Vec<2>{scale * (0.3 * std::sin(3 * x) - 0.5 * y), scale * 0.6 * x * std::cos(2 * y)};
  });
}

/// Hot gas in a bag, all in wild motion.
void add_bag(Scene& scene) {
  add_body(scene, robust_gas(0.02), lattice(0.1, -1, 1, -1, 1, in_blob), 1.3, 3);
  add_body(scene, taut, arc(0, 0, 1.2, 0.95, 0, 2, 60, 0.05), 2, 0, true);
}

const Violent violent_scenes[] = {
    {"GasAlone",
     [] {
       Scene scene = open_scene();
       add_body(scene, robust_gas(0.02), lattice(0.1, -1, 1, -1, 1, in_blob), 1.3, 0.02);
       stir_all(scene);
       return scene;
     }},
    {"GasInAClosedMembrane",
     [] {
       Scene scene = open_scene();
       add_bag(scene), stir_all(scene);
       return scene;
     }},
    {"UnderPressureFromOutside",
     [] {
       Scene scene = open_scene();
       add_bag(scene), stir_all(scene);
       scene.ambient = 0.7;
       return scene;
     }},
    // Most of the gas' mass is far from the loose string: what that loses goes to all gas, heat or not.
    {"StringFarFromTheGas",
     [] {
       Scene scene = open_scene();
       add_body(scene, robust_gas(0.02), lattice(0.1, -1, 1, -1, 1, in_blob), 1.3, 0.05);
       add_body(scene, Membrane{300, 0, false}, line(-1.6, 1.5, 1.6, 1.6, 60, 0.05), 2);
       set_velocities(scene, [](double x, double y) {
         return y > 1.4 ? Vec<2>{0.3 * x * x, std::cos(4 * x)} : Vec<2>{};
       });
       return scene;
     }},
    {"PinnedStringInGas",
     [] {
       Scene scene = open_scene();
       add_body(scene, robust_gas(0.02), lattice(0.1, -1, 1, -1, 1, in_blob), 1.3, 0.1);
       add_body(scene, taut, line(-0.7, 0.1, 0.8, 0.2, 31, 0.05, true), 2);
       scene.pinned = {scene.bodies[1].first, scene.points.size() - 1};
       stir_all(scene);
       return scene;
     }},
    {"QuarterBetweenWalls",
     [] {
       Scene scene = scene_on(BackgroundGrid(11, 11, 0, 2, 0, 2), all_walls(Wall::free_slip), 0.01, robust_set());
       add_body(scene, robust_gas(0.02), lattice(0.1, 0, 1, 0, 1, in_blob), 1.3, 3);
       add_body(scene, taut, arc(0, 0, 1.2, 0.95, 0, 0.5, 15, 0.05), 2);
       scene.ambient = 0.7;
       stir_all(scene, 0.5);
       return scene;
     }},
    {"GasBetweenFixedWalls",
     [] {
       Scene scene = scene_on(BackgroundGrid(11, 11, 0, 2, 0, 2), all_walls(Wall::fixed), 0.01, robust_set());
       add_body(scene, robust_gas(0.02), lattice(0.1, 0, 2, 0, 2), 1.3, 0.5);
       stir_all(scene, 0.5);
       return scene;
     }},
    {"BagAboutAnAxis",
     [] {
       Scene scene = scene_on(BackgroundGrid(11, 21, 0, 2, -2, 2), all_walls(Wall::open), 0.005, robust_set(),
                              Geometry::axisymmetric);
       scene.walls.left = Wall::axis;
       add_body(scene, robust_gas(0.02), lattice(0.1, 0, 1, -1, 1, in_blob), 1.3, 3);
       add_body(scene, taut, arc(0, 0, 1.2, 0.95, -0.5, 0.5, 30, 0.05), 2);
       scene.ambient = 0.7;
       set_velocities(scene, [](double x, double y) {
         return Vec<2>{0.3 * x * std::cos(3 * y), 0.3 * std::sin(2 * x)};
       });
       return scene;
     }},
    {"BagThatHitsARigidBlock",
     [] {
       Scene scene = open_scene();
       add_bag(scene);
       add_body(scene, plane_strain(1e-14, 0), lattice(0.1, -1.2, -0.9, -1.9, -1.3), 3);  // too soft for a stress
       set_velocities(scene, [](double, double y) { return Vec<2>{0, y < -1.2 ? 0.4 : -0.1}; });
       return scene;
     }},
    // Loose bodies, the third between the others: the ledger's gas is elsewhere.
    {"ThreeBodiesAtANode",
     [] {
       Scene scene = open_scene();
       add_body(scene, robust_gas(0.02), lattice(0.1, -1.9, -1.5, -1.9, -1.5), 1.3, 0.05);
       add_body(scene, plane_strain(1e-14, 0), lattice(0.1, -0.6, 0, -0.7, 0.7), 1);
       add_body(scene, plane_strain(1e-14, 0), lattice(0.1, 0.3, 1, -0.6, 0.8), 2);
       add_body(scene, plane_strain(1e-14, 0), lattice(0.1, 0, 0.3, -0.5, 0.5), 0.5);
       set_velocities(scene, [](double x, double y) {
         return x < -1.4 ? Vec<2>{} : x < 0 ? Vec<2>{0.2, 0.05} : x > 0.3 ? Vec<2>{-0.3, 0} : Vec<2>{0.2 * y, 0};
       });
       return scene;
     }},
};

class KeptEnergy : public testing::TestWithParam<Violent> {};
INSTANTIATE_TEST_SUITE_P(Energy, KeptEnergy, testing::ValuesIn(violent_scenes),
                         [](const auto& info) { return std::string(info.param.name); });

// What impulses of contact take is told beside the total.
TEST_P(KeptEnergy, TotalEnergyOverFiveHundredSteps) {
  Running run(GetParam().scene());
  const bool touching = find_body<PlaneElastic>(run.scene()) != nullptr;
  const auto total = [&] { return run.value("energy_total") + (touching ? run.value("energy_contact") : 0); };
  const double before = total(), kinetic = run.value("energy_kinetic");
  double drift = 0, exchanged = 0;
  for (int k = 0; k < 50; ++k) {
    run.steps(10);
    drift = std::max(drift, std::abs(total() - before));
    exchanged = std::max(exchanged, std::abs(run.value("energy_kinetic") - kinetic));
  }
  EXPECT_LT(drift, 1e-13 * before);
  EXPECT_GT(exchanged, 0.1 * kinetic);  // the scene is violent indeed
  EXPECT_GT(run.value("energy_ledger"), 0.01 * before);
  if (touching) {
    EXPECT_GT(run.value("energy_contact"), 1e-3 * before);
  }
}

// Elements give energy back, too, where they move fast under little tension; far from the gas all of it bears that.
TEST(Ledger, TakesBackWhatElementsGiveTooMuch) {
  Scene scene = open_scene();
  add_body(scene, robust_gas(0.02), lattice(0.1, -1.9, -1.6, -1.9, -1.6), 1.3, 0.05);
  add_body(scene, Membrane{300, 0, false}, line(-1, 1, 1, 1, 40, 0.05), 2);
  set_velocities(scene, [](double x, double y) { return y > 0.5 ? Vec<2>{0.5 * std::sin(1.5 * x), 0} : Vec<2>{}; });
  Running run(std::move(scene));
  const double before = run.value("energy_total");
  double least = 0;
  for (int k = 0; k < 100; ++k) {
    run.steps(1);
    least = std::min(least, run.solver().save().at("heat_for_all").front());
    ASSERT_NEAR(run.value("energy_total"), before, 1e-13 * before) << k;
  }
  EXPECT_LT(least, -1e-9 * before);
}

// Without the ledger energy falls by what it would have booked: the same run but for the heat's own effect.
TEST(WithoutLedger, EnergyFallsByWhatWouldHaveBeenBooked) {
  for (const int steps : {5, 20}) {
    Scene with = open_scene(), without;
    add_bag(with), stir_all(with);
    without = with;
    without.method.ledger = false;
    Running on(std::move(with)), off(std::move(without));
    const double before = off.value("energy_total");
    on.steps(steps), off.steps(steps);
    const double booked = on.value("energy_ledger"), fallen = before - off.value("energy_total");
    EXPECT_NEAR(fallen, booked, 0.02 * booked) << steps;
  }
}

}  // namespace
}  // namespace tether::mpm::heat_ledger
