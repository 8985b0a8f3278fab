// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "unit/physics/points/robust_support.hpp"

// Scenes whose points run by lanes.

namespace tether::mpm {

using namespace scenes;

inline bool in_ring(double x, double y) { return x * x + y * y < 1.1 && x * x + 2 * y * y > 0.1; }

/// Points off the lattice, each by another part of its distance.
inline std::vector<PointAt> scattered(std::vector<PointAt> points, double h) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto k = static_cast<double>(p);
    points[p].x += 0.45 * h * std::sin(12.9 * k), points[p].y += 0.45 * h * std::sin(78.2 * k);
  }
  return points;
}

struct LaneScene {
  const char* name;
  std::function<void(Scene&)> add;
  int steps = 60;
};
inline void PrintTo(const LaneScene& scene, std::ostream* out) { *out << scene.name; }

/// A solid and a gas that run into each other's cells, by another scheme than the robust set's.
inline std::function<void(Scene&)> by(StressOrder order, Kernel kernel, Transfer transfer,
                                      DensityRule rule = DensityRule::continuity) {
  return [=](Scene& s) {
    s.method.order = order, s.method.kernel = kernel, s.method.transfer = transfer;
    s.method.gas_energy = GasEnergy::rate, s.method.contact = ContactRule::none;
    IdealGas gas = robust_gas(0.02);
    gas.rule = rule;
    add_body(s, gas, scattered(lattice(0.1, -1.3, 0.2, -1, 1), 0.1), 1.3, 1.0);
    add_body(s, plane_strain(3, 0.3), scattered(lattice(0.08, 0.2, 1.2, -1, 1), 0.08), 1.7);
  };
}

/// A gas and a solid about an axis.
inline std::function<void(Scene&)> about_axis(const Method& method, DensityRule rule, bool ledger = false) {
  return [=](Scene& s) {
    s.grid = BackgroundGrid(23, 26, 0, 4, -2, 2), s.walls.left = Wall::axis;
    s.geometry = Geometry::axisymmetric, s.method = method, s.method.ledger = ledger;
    IdealGas gas = robust_gas(0.02);
    gas.rule = rule;
    add_body(s, gas, lattice(0.1, 0, 1.4, -1, 1), 1.3, 1.0);
    add_body(s, plane_strain(3, 0.3), scattered(lattice(0.08, 1.4, 2.2, -1, 1), 0.08), 1.7);
  };
}

/// Two solids side by side, by a method's contact.
inline std::function<void(Scene&)> touching(const Method& method) {
  return [=](Scene& s) {
    s.method = method;
    add_body(s, plane_strain(3, 0.3), lattice(0.08, -1.2, 0, -1, 1), 1.3);
    add_body(s, plane_strain(5, 0.2), lattice(0.08, 0, 1.2, -1, 1), 2);
  };
}

/// A body of a law that is asked point by point, and another that runs into it.
inline std::function<void(Scene&)> of_law(const Material& law, const Method& method,
                                          Geometry geometry = Geometry::plane) {
  return [=](Scene& s) {
    const double left = geometry == Geometry::plane ? -1.3 : 0.3;
    if (geometry == Geometry::axisymmetric)
      s.grid = BackgroundGrid(23, 26, 0, 4, -2, 2), s.walls.left = Wall::axis, s.geometry = geometry;
    s.method = method, s.method.contact = ContactRule::none;
    add_body(s, law, scattered(lattice(0.1, left, left + 1.5, -1, 1), 0.1), 1.3);
    add_body(s, plane_strain(3, 0.3), scattered(lattice(0.08, left + 1.5, left + 2.5, -1, 1), 0.08), 1.7);
  };
}
inline const FiniteElastic neo_hookean_points{NeoHookean::of({.E = 3, .nu = 0.3, .plane = Plane::strain}), 3, 0.3};

inline const LaneScene lane_scenes[] = {
    {"MuslLinearFlip", by(StressOrder::musl, Kernel::linear, Transfer::flip)},
    {"MuslLinearApic", by(StressOrder::musl, Kernel::linear, Transfer::apic), 30},
    {"MuslSplinesFlip", by(StressOrder::musl, Kernel::bspline, Transfer::flip)},
    {"MuslSplinesApic", by(StressOrder::musl, Kernel::bspline, Transfer::apic)},
    {"UslLinearFlip", by(StressOrder::usl, Kernel::linear, Transfer::flip)},
    {"UslLinearApic", by(StressOrder::usl, Kernel::linear, Transfer::apic), 30},
    {"UslSplinesFlip", by(StressOrder::usl, Kernel::bspline, Transfer::flip)},
    {"UslSplinesApic", by(StressOrder::usl, Kernel::bspline, Transfer::apic)},
    {"UsfLinearFlip", by(StressOrder::usf, Kernel::linear, Transfer::flip)},
    {"UsfLinearApic", by(StressOrder::usf, Kernel::linear, Transfer::apic)},
    {"UsfSplinesFlip", by(StressOrder::usf, Kernel::bspline, Transfer::flip)},
    {"UsfSplinesApic", by(StressOrder::usf, Kernel::bspline, Transfer::apic)},
    {"Solid", [](Scene& s) { add_body(s, plane_strain(3, 0.3), lattice(0.08, -1.2, 1.4, -1, 1.2, in_ring), 1.3); }},
    {"ScatteredSolid",
     [](Scene& s) { add_body(s, plane_stress(3, 0.2), scattered(lattice(0.08, -1.2, 1.4, -1, 1.2), 0.08), 1.3); }},
    {"HotGas",  // that expands into cells where no point was
     [](Scene& s) { add_body(s, robust_gas(0.02), lattice(0.1, -1, 1.2, -1, 1, in_ring), 1.3, 4.0); }},
    {"GasWithLedger",
     [](Scene& s) {
       s.method.ledger = true;
       add_body(s, robust_gas(), scattered(lattice(0.1, -1, 1.5, -1, 1), 0.1), 1.3, 1.0);
     }},
    {"GasHeatedByItsRate",
     [](Scene& s) {
       s.method.gas_energy = GasEnergy::rate;
       add_body(s, robust_gas(0.01), lattice(0.1, -1, 1.5, -1, 1), 1.3, 1.0);
     }},
    {"GasesAndASolid",
     [](Scene& s) {
       s.method.ledger = true;
       s.method.contact = ContactRule::none;
       add_body(s, robust_gas(0.01), lattice(0.1, -1.4, 0, -1, 1), 1.3, 1.0);
       add_body(s, plane_strain(3, 0.3), lattice(0.1, 0, 0.8, -1, 1), 5);
       add_body(s, robust_gas(), lattice(0.1, 0.8, 1.6, -1, 1), 0.3, 2.0);
     }},
    {"GasAroundAString",
     [](Scene& s) {
       s.method.ledger = true;
       add_body(s, Membrane{20, 0.2, true, Membrane::Kind::plane_stress}, arc(0.1, 0, 1.0, 0.8, 0, 2, 60, 0.05), 2, 0,
                true);
       add_body(s, robust_gas(), lattice(0.1, -1.2, 1.4, -1, 1, in_ring), 1.3, 1.0);
     }},
    {"AboutAnAxis", about_axis(robust_set(), DensityRule::grid)},
    {"AboutAnAxisWithLedger", about_axis(robust_set(), DensityRule::grid, true)},
    {"AboutAnAxisByContinuity", about_axis(robust_set(), DensityRule::continuity)},
    {"AboutAnAxisByTheThesis", about_axis({}, DensityRule::continuity)},
    {"AboutAnAxisUsl", about_axis({.order = StressOrder::usl}, DensityRule::continuity), 30},
    {"MuslByCells", by(StressOrder::musl, Kernel::linear, Transfer::flip, DensityRule::cell)},
    {"MuslByQuadraticCells", by(StressOrder::musl, Kernel::linear, Transfer::flip, DensityRule::quadratic)},
    {"MuslSplinesApicByCells", by(StressOrder::musl, Kernel::bspline, Transfer::apic, DensityRule::cell)},
    {"MuslSplinesByNodes", by(StressOrder::musl, Kernel::bspline, Transfer::flip, DensityRule::grid)},
    {"UslByCells", by(StressOrder::usl, Kernel::linear, Transfer::flip, DensityRule::quadratic)},
    {"UslSplinesApicByNodes", by(StressOrder::usl, Kernel::bspline, Transfer::apic, DensityRule::grid)},
    {"UsfByCells", by(StressOrder::usf, Kernel::linear, Transfer::flip, DensityRule::quadratic)},
    {"AboutAnAxisByCells", about_axis({}, DensityRule::cell)},
    {"LinearFluid", of_law(LinearFluid{20}, robust_set())},
    {"LinearFluidUsl", of_law(LinearFluid{20}, {.order = StressOrder::usl})},
    {"NeoHookean", of_law(neo_hookean_points, robust_set())},
    {"NeoHookeanMusl", of_law(neo_hookean_points, {})},
    {"NeoHookeanAboutAnAxis", of_law(neo_hookean_points, robust_set(), Geometry::axisymmetric)},
    {"Jaumann", of_law(plane_stress(3, 0.2), {.order = StressOrder::usf, .jaumann = true})},
    {"SolidsThatTouch", touching(robust_set())},
    {"SolidsThatTouchByTheThesis", touching({.contact = ContactRule::release})},
    {"GasAndASolidThatTouch",
     [](Scene& s) {
       s.method.ledger = true, s.method.contact = ContactRule::gap;
       add_body(s, robust_gas(0.02), lattice(0.1, -1.4, 0, -1, 1), 1.3, 1.0);
       add_body(s, plane_strain(3, 0.3), lattice(0.1, 0, 0.8, -1, 1), 5);
     }},
    {"GasByContinuityAndASolidThatTouch",
     [](Scene& s) {
       s.method.contact = ContactRule::gap;
       IdealGas gas = robust_gas(0.02);
       gas.rule = DensityRule::continuity;
       add_body(s, gas, lattice(0.1, -1.4, 0, -1, 1), 1.3, 1.0);
       add_body(s, plane_strain(3, 0.3), lattice(0.1, 0, 0.8, -1, 1), 5);
     }},
    {"GasAroundAStringByColours",
     [](Scene& s) {
       s.method.normals = NormalRule::quadratic, s.method.membrane_strain = MembraneStrain::point;
       add_body(s, Membrane{20, 0.2, true, Membrane::Kind::plane_stress}, arc(0.1, 0, 1.0, 0.8, 0, 2, 60, 0.05), 2, 0,
                true);
       add_body(s, robust_gas(), scattered(lattice(0.1, -1.2, 1.4, -1, 1), 0.1), 1.3, 1.0);
     }},
};

}  // namespace tether::mpm
