// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of energy closes to rounding by every method: what is not in the total stands in a column of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "results/energy_drift.hpp"
#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

struct How {
  const char* name;
  StressOrder order;
  Kernel kernel;
  Transfer transfer;
  ContactRule contact;
  MembraneStrain strain;
};
void PrintTo(const How& how, std::ostream* out) { *out << how.name; }

constexpr How ways[] = {
    {"Thesis", StressOrder::musl, Kernel::linear, Transfer::flip, ContactRule::none, MembraneStrain::point},
    {"ThesisRelease", StressOrder::musl, Kernel::linear, Transfer::flip, ContactRule::release, MembraneStrain::point},
    {"ThesisGap", StressOrder::musl, Kernel::linear, Transfer::flip, ContactRule::gap, MembraneStrain::point},
    {"Usl", StressOrder::usl, Kernel::linear, Transfer::flip, ContactRule::none, MembraneStrain::point},
    {"Usf", StressOrder::usf, Kernel::linear, Transfer::flip, ContactRule::release, MembraneStrain::element},
    {"FlipBySplines", StressOrder::musl, Kernel::bspline, Transfer::flip, ContactRule::gap, MembraneStrain::element},
    {"ApicLinear", StressOrder::musl, Kernel::linear, Transfer::apic, ContactRule::release, MembraneStrain::point},
    {"ApicUsl", StressOrder::usl, Kernel::bspline, Transfer::apic, ContactRule::none, MembraneStrain::point},
    {"Robust", StressOrder::usf, Kernel::bspline, Transfer::apic, ContactRule::gap, MembraneStrain::element},
    {"RobustByPoints", StressOrder::usf, Kernel::bspline, Transfer::apic, ContactRule::gap, MembraneStrain::point},
};

Method method_of(const How& how) {
  Method method;
  method.order = how.order, method.kernel = how.kernel, method.transfer = how.transfer;
  method.contact = how.contact, method.membrane_strain = how.strain;
  return method;
}

/// What a run's history says of its balance.
struct Closed {
  double drift = 0, lost = 0, exchanged = 0;
  double largest_column = 0;  // of what is booked as lost
};

Closed closed(Scene scene, int rounds, int steps) {
  Running run(std::move(scene));
  History history{run.solver().history_layout(), {run.solver().record()}};
  for (int k = 0; k < rounds; ++k) {
    run.steps(steps);
    history.records.push_back(run.solver().record());
  }
  const auto total = history.column("energy_total");
  double largest = 0;
  for (const double energy : total) largest = std::max(largest, std::abs(energy - total.front()));
  double column = 0;
  for (const char* name : {"energy_transfer", "energy_integration"}) {
    for (const double energy : history.column(name)) column = std::max(column, std::abs(energy));
  }
  return {energy_drift(history), energy_lost(history), largest, column};
}

class EnergyBalance : public testing::TestWithParam<How> {};
INSTANTIATE_TEST_SUITE_P(Ways, EnergyBalance, testing::ValuesIn(ways),
                         [](const auto& info) { return std::string(info.param.name); });

/// Two soft blocks that meet, fall and hit a fixed floor, and no gas that could take heat.
Scene blocks(const Method& method, Geometry geometry) {
  const Walls walls{geometry == Geometry::plane ? Wall::free_slip : Wall::axis, Wall::free_slip, Wall::fixed,
                    Wall::free_slip};
  Scene scene = scene_on(BackgroundGrid(13, 13, 0, 2.4, 0, 2.4), walls, 0.004, method, geometry);
  add_body(scene, plane_strain(20, 0.3), lattice(0.1, 0.2, 0.8, 0.1, 0.9), 1.3);
  add_body(scene, plane_strain(50, 0.2), lattice(0.1, 1, 1.9, 0.2, 0.8), 2);
  scene.gravity = -3;
  set_velocities(scene, [](double x, double y) { return Vec<2>{x < 0.9 ? 1.1 : -0.8, -0.5 + 0.3 * x * y}; });
  return scene;
}

TEST_P(EnergyBalance, OfSolidsThatMeet) {
  for (const Geometry geometry : {Geometry::plane, Geometry::axisymmetric}) {
    const Closed found = closed(blocks(method_of(GetParam()), geometry), 6, 10);
    EXPECT_LT(found.drift, 1e-12);
    EXPECT_GT(found.exchanged, 1e-3);  // the total alone is far from constant
    EXPECT_NE(found.lost, 0);
  }
}

/// A string between two pins that carries a heavy point, in gravity.
Scene pinned_string(const Method& method, double x0, double x1, double y) {
  Scene scene = scene_on(BackgroundGrid(13, 13, 0, 2.4, 0, 2.4), all_walls(Wall::open), 0.002, method);
  add_body(scene, Membrane{400, 0, false}, line(x0, y, x1, y, 25, 0.05, true), 1);
  scene.points.mass[12] = 0.3;
  scene.pinned = {0, 24};
  scene.gravity = -10;
  return scene;
}

TEST_P(EnergyBalance, OfAPinnedString) {
  const bool unstable = GetParam().order == StressOrder::usl;  // after a few steps
  const Closed found =
      closed(pinned_string(method_of(GetParam()), 0.43, 1.97, 1.9), unstable ? 2 : 20, unstable ? 1 : 10);
  EXPECT_LT(found.drift, 1e-10);
  EXPECT_GT(found.exchanged, 1e-6);
}

// On a line rounding leaves a node a mass of 1e-17 and a whole force.
TEST_P(EnergyBalance, OfAPinnedStringOnALineOfTheGrid) {
  const bool unstable = GetParam().order == StressOrder::usl;
  const Closed found = closed(pinned_string(method_of(GetParam()), 0.4, 2, 1.8), unstable ? 2 : 20, unstable ? 1 : 10);
  EXPECT_LT(found.drift, 1e-10);
  EXPECT_LT(found.largest_column, 100);  // up to 1e12, of both signs, where such nodes count as others
}

// Gas that a piston of solid presses, with viscosity: heat is internal energy.
TEST_P(EnergyBalance, OfGasAndASolid) {
  Scene scene =
      scene_on(BackgroundGrid(13, 13, 0, 2.4, 0, 2.4), all_walls(Wall::free_slip), 0.002, method_of(GetParam()));
  IdealGas gas = robust_gas(0.02);
  if (GetParam().kernel == Kernel::linear) gas.rule = DensityRule::continuity;
  add_body(scene, gas, lattice(0.1, 0, 2.4, 0, 1.2), 1.3, 2);
  add_body(scene, plane_strain(300, 0.3), lattice(0.1, 0, 2.4, 1.4, 1.8), 4);
  set_velocities(scene, [](double x, double y) { return Vec<2>{0.1 * std::sin(2 * x), y > 1.3 ? -1.0 : 0.2}; });
  EXPECT_LT(closed(std::move(scene), 10, 10).drift, 1e-12);
}

// What pressure outside does to a ring is in the total.
TEST_P(EnergyBalance, OfARingUnderPressure) {
  Scene scene = scene_on(BackgroundGrid(21, 21, -2, 2, -2, 2), all_walls(Wall::open), 0.002, method_of(GetParam()));
  add_body(scene, Membrane{300, 0.3, false, Membrane::Kind::plane_stress}, arc(0, 0, 1.2, 0.9, 0, 2, 60, 0.05), 2, 0,
           true);
  scene.ambient = 0.7;
  EXPECT_LT(closed(std::move(scene), 10, 10).drift, 1e-12);
}

}  // namespace
}  // namespace tether::mpm
