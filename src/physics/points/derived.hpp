// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// The slots in which points stand, body after body, in each by the points' numbers.
struct Order {
  std::vector<std::uint32_t> slots;
  std::vector<Range> bodies;  // of `slots`

  /// Returns the body that point k belongs to.
  std::size_t body_of(std::size_t k) const {
    std::size_t b = 0;
    while (k >= bodies[b].end) ++b;
    return b;
  }
  std::span<const std::uint32_t> of(std::size_t b) const {
    return {slots.data() + bodies[b].begin, bodies[b].end - bodies[b].begin};
  }
};
/// Returns the order of all points, or of those that no strip beyond an open edge holds.
Order order_of_all(const State& state);
Order order_within(const State& state);
/// Returns where the points of the scene stand that these run for.
Order unfolded(const Order& order, const Unfolding& unfolding);

/// Stored and internal energy [energy].
struct Energies {
  double strain = 0, internal = 0, ambient = 0;
  void add(const Scene& scene, std::size_t b, const State& state, const Order& order);
  double sum() const { return strain + internal + ambient; }
};
/// Sums the energy of all bodies, and heat that is under way to the gas.
Energies stored_energy(const Scene& scene, const State& state, const Order& order);

/// Returns what a body fills now [volume]: solids and linear fluids follow the strain that their stress shows, gas
/// follows its density, and a membrane has what it began with.
double volume_of(const Scene& scene, std::size_t b, const Points& points, const Order& order);

/// What a point fills, and its pressure.
struct Extent {
  double volume = 0, pressure = 0;
  double across = 0;  // stress across the plane, about an axis the hoop's [stress]
};
/// Returns the extent of slot p, whose point is of body b; `pressures` as StepSet::gas_pressures.
Extent extent_of(const Scene& scene, std::size_t b, const Points& points, std::size_t p,
                 const std::vector<double>& pressures);
/// Elastic strain of solids, tangent strain of strings.
Strain strain_of(const Scene& scene, std::size_t b, const Points& points, std::size_t p);

}  // namespace tether::mpm
