// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// Nodes that a side of an element has at most, and numbers that those of a point on it are made of.
constexpr std::size_t most_carriers = 9;
using CarrierShares = std::array<double, most_carriers>;

/// The surface of solids: edges in the plane, triangles in space, between the nodes of the elements' sides. A place of
/// such a facet moves as the element's own functions say, of the nodes of the whole side, its carriers. Places q have
/// dim numbers a node.
struct SolidSurface {
  int dim = 2;
  Sides sides;  ///< dim nodes of each facet; in the plane the solid is to the left of an edge, in space below
                ///< a triangle whose nodes turn counter-clockwise as seen from above
  std::vector<int> sheet;  ///< of each facet the connected part of the surface that it belongs to, from 0
  int sheets = 0;
  std::vector<std::uint8_t> cavity;  ///< of each sheet, whether the solid is around it
  std::vector<int> part;             ///< of each facet the connected body, from 0
  int parts = 0;
  ElementKind kind = ElementKind::tri3;
  Sides whole_sides;                        ///< of the elements, each parted into as many facets, one after the other
  std::vector<std::array<int, 3>> parting;  ///< of each: facets_of_side()

  std::size_t side_count() const { return sheet.size(); }
  std::span<const int> side(std::size_t s) const {
    return std::span(sides).subspan(s * static_cast<std::size_t>(dim), static_cast<std::size_t>(dim));
  }
  std::span<const int> carriers(std::size_t s) const {
    const auto count = static_cast<std::size_t>(side_node_count_of(kind));
    return std::span(whole_sides).subspan(s / parting.size() * count, count);
  }
  /// Returns the parts of the carriers in the motion of a facet's place, of which the facet's nodes have these shares.
  CarrierShares carried(std::size_t s, const Vec<3>& share) const;
};

/// Returns the surface of a mesh.
SolidSurface surface_of(const Mesh& mesh);

/// Place of a node; z is 0 in the plane.
Vec<3> place_of(std::span<const double> q, int node, int dim);

/// The places in the middle of the way from q0 to q1.
std::vector<double> middle_of(std::span<const double> q0, std::span<const double> q1);

/// Volume enclosed by each sheet, per unit depth in the plane: positive where the solid is inside, negative around a
/// cavity [volume].
std::vector<double> enclosed_volumes(const SolidSurface& surface, std::span<const double> q);

/// Volume by which each sheet's grows on the way from q0 to q1 as its sides sweep it with the areas and normals that
/// they have at `middle`: with the middle of the way to the third order, exactly in the plane and where it only turns;
/// with q0 a sheet that turns by an angle a loses a^2 of its volume [volume].
std::vector<double> swept_volumes(const SolidSurface& surface, std::span<const double> middle,
                                  std::span<const double> q0, std::span<const double> q1);

/// A side's area times its normal out of the solid, per unit depth in the plane [area].
Vec<3> area_of_side(const SolidSurface& surface, std::size_t side, std::span<const double> q);
std::vector<Vec<3>> areas_of_sides(const SolidSurface& surface, std::span<const double> q);
/// The derivative of z times the side's area A by the place of its node k, with nodes at q: A is linear in it [length
/// z].
Vec<3> slope_of_area(const SolidSurface& surface, std::size_t side, std::span<const double> q, std::size_t k,
                     const Vec<3>& z);

}  // namespace tether
