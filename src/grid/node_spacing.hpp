// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "grid/mesh.hpp"
#include "grid/point_finder.hpp"

namespace tether {

/// How far apart nodes stand along an edge of a body's element, and those of the mesh below it in the same direction.
/// Of biquadratic elements that is half their length. [length]
struct NodeSpacing {
  double of_body = 0, of_mesh = 0;
  double ratio() const { return of_mesh > 0 ? of_body / of_mesh : 0; }
};

/// The corners at the ends of edge k of element e of a plane mesh: 0 to 3 bottom, right, top, left, the element to the
/// left of it; of triangles the fourth is the first.
std::array<std::size_t, 2> ends_of_edge(const Mesh& mesh, std::size_t e, std::size_t k);

/// Compares the elements of plane bodies with those of a mesh of quadrilaterals that they lie over.
class NodeSpacings {
 public:
  /// The mesh must outlive it.
  explicit NodeSpacings(const Mesh& below) : below_(below), finder_(below) {}

  /// Of element e of a body whose nodes stand at x along its edges 0 to 3 (bottom, right, top, left; of triangles the
  /// fourth is the first); nothing where its middle lies off the mesh. `hint` is the element below, as find() takes it
  /// and gives it.
  std::optional<std::array<NodeSpacing, 4>> of_element(const Mesh& body, std::span<const double> x, std::size_t e,
                                                       int& hint) const;

 private:
  const Mesh& below_;
  PointFinder finder_;
};

}  // namespace tether
