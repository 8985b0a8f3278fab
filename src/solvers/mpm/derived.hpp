// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"
#include "solvers/mpm/state.hpp"

namespace tether::mpm {

/// The slot in which each point of the scene stands now.
std::vector<std::size_t> slots_by_id(const Points& points);

/// Stored and internal energy [energy]. `slots` says where each point of the scene stands.
struct Energies {
  double strain = 0, internal = 0, ambient = 0;
  void add(const Scene& scene, std::size_t b, const State& state, const std::vector<std::size_t>& slots);
  double sum() const { return strain + internal + ambient; }
};
/// Of all bodies, and heat that is under way to the gas.
Energies stored_energy(const Scene& scene, const State& state);

/// Fields that follow from the state by the point's law, in the order of the scene.
struct DerivedFields {
  std::vector<double> body, volume, density, pressure;
  std::vector<double> strain_xx, strain_yy, strain_xy;  // elastic strain of solids, tangent strain of strings
  std::vector<double> normal_x, normal_y;               // of strings: the tangent turned left by a right angle
};
/// `pressures` as StepSet::gas_pressures.
DerivedFields derived_fields(const Scene& scene, const Points& points, const std::vector<std::size_t>& slots,
                             const std::vector<double>& pressures);

}  // namespace tether::mpm
