// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/derived.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loops/points.hpp"
#include "physics/points/point_laws.hpp"

namespace tether::mpm {
namespace {

Stress stress_of(const Points& P, std::size_t p) { return {P.sxx[p], P.syy[p], P.sxy[p], P.at(&Points::szz, p)}; }

double stored(const PlaneElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  const Stress s = stress_of(P, p);
  return P.volume[p] * (geometry == Geometry::plane ? law.energy_density(s) : law.energy_density_about_axis(s));
}
FiniteResponse answer(const FiniteElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  const DeformationGradient F = deformation(P, p);
  return geometry == Geometry::plane ? law.respond(F) : law.respond_about_axis(F);
}
double stored(const FiniteElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  return P.volume[p] * answer(law, P, p, geometry).energy;
}
double stored(const LinearFluid& law, const Points& P, std::size_t p, Geometry) {
  return P.volume[p] * law.energy_density(fluid_pressure(law, P, p));
}
double stored(const Membrane& law, const Points& P, std::size_t p, Geometry) {
  return P.volume[p] * law.energy_density(P.strain[p], P.hoop[p]);
}
double stored(const IdealGas&, const Points&, std::size_t, Geometry) { return 0; }

/// Stress across the plane: what moves at a rate carries it about an axis alone.
double across(const PlaneElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  return geometry == Geometry::plane ? law.out_of_plane_stress(stress_of(P, p)) : P.szz[p];
}
double across(const FiniteElastic&, const Points& P, std::size_t p, Geometry) { return P.szz[p]; }
double across(const LinearFluid& law, const Points& P, std::size_t p, Geometry) {
  return law.mu == 0 ? P.sxx[p] : P.szz[p];
}
double across(const Membrane&, const Points& P, std::size_t p, Geometry) { return P.szz[p]; }

double pressure(const PlaneElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  const Stress s = stress_of(P, p);
  return -(s.xx + s.yy + across(law, P, p, geometry)) / 3;
}
double pressure(const FiniteElastic&, const Points& P, std::size_t p, Geometry) {
  return -(P.sxx[p] + P.syy[p] + P.szz[p]) / 3;
}
double pressure(const LinearFluid& law, const Points& P, std::size_t p, Geometry) { return fluid_pressure(law, P, p); }
double pressure(const Membrane&, const Points& P, std::size_t p, Geometry) { return -(P.sxx[p] + P.syy[p]) / 3; }

/// Rates of strain add up to the logarithm of the volume over that at the start.
double filled(const PlaneElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  return P.volume[p] * std::exp(-3 * (1 - 2 * law.nu) / law.E * pressure(law, P, p, geometry));
}
double filled(const FiniteElastic& law, const Points& P, std::size_t p, Geometry) { return law_volume(law, P, p); }
double filled(const LinearFluid& law, const Points& P, std::size_t p, Geometry) {
  return P.volume[p] * std::exp(-fluid_pressure(law, P, p) / law.beta);
}
double filled(const Membrane&, const Points& P, std::size_t p, Geometry) { return P.volume[p]; }
double filled(const IdealGas& law, const Points& P, std::size_t p, Geometry) { return law_volume(law, P, p); }

Strain strain(const PlaneElastic& law, const Points& P, std::size_t p, Geometry geometry) {
  return geometry == Geometry::plane ? law.strain(stress_of(P, p)) : law.strain_about_axis(stress_of(P, p));
}
Strain strain(const FiniteElastic&, const Points& P, std::size_t p, Geometry) {
  return green_strain(deformation(P, p));
}
Strain strain(const Membrane&, const Points& P, std::size_t p, Geometry) {
  const double e = P.strain[p], x = P.tx[p], y = P.ty[p];
  return {e * x * x, e * y * y, e * x * y};
}
Strain strain(const LinearFluid&, const Points&, std::size_t, Geometry) { return {}; }
Strain strain(const IdealGas&, const Points&, std::size_t, Geometry) { return {}; }

template <class Law>
Extent extent(const Law& law, const Points& P, std::size_t p, Geometry geometry, const std::vector<double>&) {
  return {law_volume(law, P, p), pressure(law, P, p, geometry), across(law, P, p, geometry)};
}
/// Gas that takes its density from the nodes has the pressure that their forces have, and the density that belongs to
/// this pressure and to its energy: where it meets another gas, its own. A gas whose energy was used up has no such.
/// Its stress across the plane is carried about an axis alone; else it is minus the pressure, without viscous parts.
Extent extent(const IdealGas& law, const Points& P, std::size_t p, Geometry geometry,
              const std::vector<double>& pressures) {
  const bool of_nodes = law.rule == DensityRule::grid && pressures[p] > 0 && P.energy[p] > 0;
  const double now = of_nodes ? pressures[p] : law.pressure(P.rho[p], P.energy[p]);
  const double volume = of_nodes ? P.mass[p] * law.pressure(1, P.energy[p]) / now : law_volume(law, P, p);
  return {volume, now, geometry == Geometry::plane ? -now : P.szz[p]};
}

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

template <class Counts>
Order order_where(const State& state, const Counts& counts) {
  Order order;
  const auto& id = state.points.id;
  for (const Slots range : state.ranges) {
    const std::size_t begin = order.slots.size();
    int first = std::numeric_limits<int>::max(), last = -1;
    for_points(state.points, range,
               [&](std::size_t p) { first = std::min(first, id[p]), last = std::max(last, id[p]); });
    // By their numbers, with gaps where points have gone.
    order.slots.resize(begin + static_cast<std::size_t>(std::max(0, last - first + 1)), nowhere);
    for_points(state.points, range, [&](std::size_t p) {
      if (counts(p)) order.slots[begin + static_cast<std::size_t>(id[p] - first)] = static_cast<std::uint32_t>(p);
    });
    std::erase(order.slots, nowhere);
    order.bodies.push_back({begin, order.slots.size()});
  }
  return order;
}

}  // namespace

Order order_of_all(const State& state) {
  return order_where(state, [](std::size_t) { return true; });
}

Order order_within(const State& state) {
  if (!state.strips.on()) return order_of_all(state);
  const Points& P = state.points;
  return order_where(state, [&](std::size_t p) { return !state.strips.holds(P.x[p], P.y[p]); });
}

Order unfolded(const Order& order, const Unfolding& unfolding) {
  if (!unfolding.on()) return order;
  Order all;
  for (const Range body : order.bodies) {
    const std::size_t begin = all.slots.size();
    for (std::size_t k = 0; k < unfolding.unfolded(body.begin, body.end); ++k)
      all.slots.push_back(order.slots[unfolding.runs_as(begin + k)]);
    all.bodies.push_back({begin, all.slots.size()});
  }
  return all;
}

void Energies::add(const Scene& scene, std::size_t b, const State& state, const Order& order) {
  const Body& body = scene.bodies[b];
  const Points& P = state.points;
  if (state.ambient_of[b]) ambient += state.ambient_of[b]->ambient_energy(P);
  if (state.elements_of[b]) {
    strain += state.elements_of[b]->strain_energy(P);
    ambient += state.elements_of[b]->ambient_energy(P);
    return;
  }
  const bool heats = std::holds_alternative<IdealGas>(body.material) || is_viscous_fluid(body.material);
  std::visit(
      [&](const auto& law) {
        for (const std::size_t p : order.of(b)) {
          strain += stored(law, P, p, scene.geometry);
          if (heats) internal += P.mass[p] * P.energy[p];
        }
      },
      body.material);
}

Energies stored_energy(const Scene& scene, const State& state, const Order& order) {
  Energies energies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) energies.add(scene, b, state, order);
  energies.internal += state.heat_under_way;
  return energies;
}

double volume_of(const Scene& scene, std::size_t b, const Points& points, const Order& order) {
  return std::visit(
      [&](const auto& law) {
        double volume = 0;
        for (const std::size_t p : order.of(b)) volume += filled(law, points, p, scene.geometry);
        return volume;
      },
      scene.bodies[b].material);
}

Extent extent_of(const Scene& scene, std::size_t b, const Points& P, std::size_t p,
                 const std::vector<double>& pressures) {
  return std::visit([&](const auto& law) { return extent(law, P, p, scene.geometry, pressures); },
                    scene.bodies[b].material);
}

Strain strain_of(const Scene& scene, std::size_t b, const Points& P, std::size_t p) {
  return std::visit([&](const auto& law) { return strain(law, P, p, scene.geometry); }, scene.bodies[b].material);
}

}  // namespace tether::mpm
