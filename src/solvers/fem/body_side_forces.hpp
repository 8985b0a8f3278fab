// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "grid/point_finder.hpp"
#include "solvers/fem/flow_elements.hpp"
#include "solvers/fem/immersed_forces.hpp"

namespace tether::fem {

/// The force of the fluid's stress on sides of immersed bodies. In the fluid's elements that a body's surface cuts, the
/// stress is of both: it is taken from two places outside of them and led on to the surface in a straight line. Where a
/// side lies on a wall there is no fluid and no force.
class BodySideForces {
 public:
  /// All must outlive it; the sides are those of the solids' mesh.
  BodySideForces(const Flow& flow, const FlowElements& elements, const Mesh& solids);

  /// On these sides, with nodes at `places`, about a centre.
  PlaneForce of(const Sides& sides, std::span<const double> places, const std::array<double, 2>& centre,
                const FlowMoment& m) const;

 private:
  template <int p>
  PlaneForce along(const Sides& sides, std::span<const double> places, const std::array<double, 2>& centre,
                   const FlowMoment& m) const;
  std::array<double, 3> stress_outside(const std::array<double, 2>& at, const std::array<double, 2>& normal,
                                       const FlowMoment& m) const;
  double size_at(const std::array<double, 2>& at) const;

  const FlowElements& elements_;
  const Mesh& fluid_;
  const Mesh& solids_;
  PointFinder finder_;
};

}  // namespace tether::fem
