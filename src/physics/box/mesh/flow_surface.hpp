// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"

namespace tether::coupled {

/// The surface of bodies together with that of the obstacles of a scene: these are the last sheets and parts of it, and
/// have nodes of their own after those of the bodies, which never move.
class FlowSurface {
 public:
  /// The bodies have so many numbers of places. Sides of curved obstacles are about as long as the mesh's size there.
  FlowSurface(const Coupled& scene, const SolidSurface& bodies, std::size_t places);

  const SolidSurface& all() const { return all_; }
  bool is_body(std::size_t side) const { return side < body_sides_; }
  /// Returns whether a side is one of an obstacle that is a box.
  bool is_brick(std::size_t side) const { return !is_body(side) && side < brick_sides_; }
  /// Places of all nodes, with the bodies' at q, each at least a gap away from what it does not belong to, and from the
  /// walls of the box, or nearly so: it is moved back into its own body for that [gap: length].
  std::vector<double> places_apart(std::span<const double> q, double gap) const;

 private:
  std::vector<Vec<3>> normals(std::span<const double> q) const;
  void hold_apart(std::size_t node, std::size_t side, const Vec<3>& x, double gap, std::span<const double> q,
                  std::span<const Vec<3>> normal, std::span<double> back) const;
  void hold_off_walls(std::span<double> q, double gap) const;

  const Coupled& scene_;
  SolidSurface all_;
  std::size_t body_sides_, body_nodes_, brick_sides_ = 0;
  std::vector<double> fixed_;      // places of the obstacles' nodes
  std::vector<int> part_of_node_;  // -1: at no side
};

}  // namespace tether::coupled
