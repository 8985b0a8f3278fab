// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// The slots in which points stand, body after body, in each by the points' numbers.
struct Order {
  std::vector<std::size_t> slots;
  std::vector<Range> bodies;  // of `slots`

  std::span<const std::size_t> of(std::size_t b) const {
    return {slots.data() + bodies[b].begin, bodies[b].end - bodies[b].begin};
  }
};
/// Of all points, or of those that no strip beyond an open edge holds.
Order order_of_all(const State& state);
Order order_within(const State& state);

/// Stored and internal energy [energy].
struct Energies {
  double strain = 0, internal = 0, ambient = 0;
  void add(const Scene& scene, std::size_t b, const State& state, const Order& order);
  double sum() const { return strain + internal + ambient; }
};
/// Of all bodies, and heat that is under way to the gas.
Energies stored_energy(const Scene& scene, const State& state, const Order& order);

/// What a body fills now: of solids and linear fluids by the strain that their stress tells, of gas by its density; of
/// a membrane what it began with [volume].
double volume_of(const Scene& scene, std::size_t b, const Points& points, const Order& order);

/// Fields that follow from the state by the point's law, in the given order.
struct DerivedFields {
  std::vector<double> body, volume, density, pressure;
  std::vector<double> across;                           // stress across the plane, about an axis the hoop's [stress]
  std::vector<double> strain_xx, strain_yy, strain_xy;  // elastic strain of solids, tangent strain of strings
  std::vector<double> normal_x, normal_y;               // of strings: the tangent turned left by a right angle
};
/// `pressures` as StepSet::gas_pressures.
DerivedFields derived_fields(const Scene& scene, const Points& points, const Order& order,
                             const std::vector<double>& pressures);

}  // namespace tether::mpm
