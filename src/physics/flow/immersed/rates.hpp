// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether::fem {

/// How the nodes of plane bodies move: places, velocities and accelerations, 2 numbers a node.
struct BodyMotion {
  std::span<const double> places, velocities, rates;
};

/// Integrals over a body, of plane bodies per unit depth.
struct BodyRates {
  double volume = 0;      ///< at the start
  Vec<2> centre{};        ///< mean of its places [length]
  Vec<2> acceleration{};  ///< dv/dt [volume length/time2]
};

/// Returns the rates of each region of a plane mesh; dv/dt = rate + (v . grad) v by the mesh's own functions, as
/// ExcessInertia has it.
std::vector<BodyRates> body_rates(const Mesh& mesh, const BodyMotion& motion);

/// Adds the forces at the region's nodes that make something of this density in its place go with it, in spite of
/// gravity along y [length/time2].
void add_body_inertia(const Mesh& mesh, const BodyMotion& motion, int region, double density, double gravity,
                      std::span<double> f);

/// Places of the points of quadrature of a mesh whose nodes stand at x, element by element.
std::vector<Vec<2>> body_points(const Mesh& mesh, std::span<const double> x);
/// Adds the region's <grad N_A, sigma> there, of a stress xx, yy, xy at each of these points [force].
void add_body_stress(const Mesh& mesh, std::span<const double> x, int region,
                     std::span<const std::array<double, 3>> stress, std::span<double> f);

}  // namespace tether::fem
