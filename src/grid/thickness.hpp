// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "grid/mesh.hpp"
#include "grid/mesh_place.hpp"

namespace tether {

/// How a connected part of a mesh is divided across its thin direction.
struct ElementsAcross {
  double count = 0;      ///< layers of elements from one side to the other
  double thickness = 0;  ///< [length]
  double along = 0;      ///< length of an element across the thin direction, in the mean [length]
  double longest = 0;    ///< longest extent of the part along an axis [length]
  /// How far edges of order 2 stand off the line between their ends, in the mean of each element's largest [length].
  double bulge = 0;
  /// How far edges of quadrilaterals and hexahedra lean from the right angle, in the mean of each element's largest
  /// [rad].
  double lean = 0;
  std::vector<int> regions;
};

/// Counts the elements across each connected part of a mesh, in the order of parts_of(), by their corners. It uses the
/// sides alone, so that it holds for any mesh: the shortest of the ways_across() that leave opposite, from a tenth of
/// the boundary. The thickness is at right angles to it, whatever the angle of the elements' other sides: a body bends
/// as its own shape does.
std::vector<ElementsAcross> elements_across(const Mesh& mesh);

/// The thinnest of connected bodies in cells of the mesh that it lies over.
struct ThinBody {
  int region = -1;   ///< of its first element, from 0; -1 where there is no body
  double cells = 0;  ///< how thick it is
};

/// Below how many cells a body's thickness is reported, by the order of the fluid's elements. Of a cantilever across a
/// stream, five times as long as thick, the way of the tip over that at fine cells is, in bilinear cells, 0.35 to 2.3
/// at one across and 0.92 to 1.02 at two; in biquadratic ones 1.15 to 1.32 at a half and 0.93 to 1.02 at one.
constexpr double least_cells_across(int order_of_fluid) { return order_of_fluid == 1 ? 1.9 : 0.6; }

/// Says what a body thinner than that does, and what helps.
std::string thin_body_advice(int order_of_fluid);

/// Measures connected plane bodies over a mesh of quadrilaterals. A body is as thick as the rectangle of its area and
/// outline, both in cells of the mesh.
class BodyThickness {
 public:
  /// The meshes must outlive it.
  BodyThickness(const Mesh& below, const Mesh& bodies);

  /// Finds the thinnest of the bodies whose nodes stand at x; elements off the mesh below do not count.
  ThinBody thinnest(std::span<const double> x);

 private:
  double length_of_outline(std::size_t e, const std::array<NodeSpacing, 4>& spacing) const;

  const Mesh &below_, &bodies_;
  NodeSpacings spacings_;
  std::vector<std::array<bool, 4>> on_outline_;  // of each element's edges
  std::vector<int> part_of_node_;
  std::vector<int> element_below_;
  std::vector<double> area_, outline_;  // of each connected body [cells^2], [cells]
  std::vector<int> region_;
};

}  // namespace tether
