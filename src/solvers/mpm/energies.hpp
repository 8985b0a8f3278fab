// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"
#include "solvers/mpm/arrays.hpp"

namespace tether::mpm {

/// Stored and internal energy [energy]. `slots` says where each point of the scene stands.
struct Energies {
  double strain = 0, internal = 0;
  void add(const Body& body, const Points& points, const std::vector<std::size_t>& slots);
};

/// Fields that follow from the state by the point's law, in the order of the scene.
struct DerivedFields {
  std::vector<double> body, volume, density, pressure;
};
DerivedFields derived_fields(const Scene& scene, const Points& points, const std::vector<std::size_t>& slots);

}  // namespace tether::mpm
