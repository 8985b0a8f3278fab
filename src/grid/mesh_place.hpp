// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "grid/point_finder.hpp"

namespace tether {

/// A place in a mesh: nodes of its element, and the values of their shape functions there, whose sum is 1.
struct MeshPlace {
  std::vector<int> nodes;
  std::vector<double> parts;
  /// The value at the place of component i of `per_node` numbers a node.
  double of(std::span<const double> values, std::size_t per_node, std::size_t i) const;
};

/// The place of a mesh that is nearest to one that was asked for.
struct NearestPlace {
  MeshPlace place;
  std::size_t element = 0;  ///< of the place
  double away = 0;          ///< how far the place that was asked for lies outside of all elements [length]
  double element_size = 0;  ///< the longest extent of the element along an axis [length]
};

/// The place of the mesh nearest to `x`, whose components beyond the mesh's dimension do not count. Where several
/// elements share the place the first of them has it; a place at a node, as near as rounding allows, is the node alone.
/// A distance that is not small compared with the element is an upper bound of the distance. The mesh has an element.
NearestPlace nearest_place(const Mesh& mesh, const Vec<3>& x);

/// Returns whether a place lies in an element, its sides included, as near as rounding allows.
bool is_in_element(const Mesh& mesh, std::size_t e, const Vec<3>& x);

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

  /// Returns the spacing of element e of a body whose nodes stand at x, along its edges 0 to 3 (bottom, right, top,
  /// left; of triangles the fourth is the first), or nothing where its middle lies off the mesh. `hint` is the element
  /// below, as find() takes it and gives it.
  std::optional<std::array<NodeSpacing, 4>> of_element(const Mesh& body, std::span<const double> x, std::size_t e,
                                                       int& hint) const;

 private:
  const Mesh& below_;
  PointFinder finder_;
};

}  // namespace tether
