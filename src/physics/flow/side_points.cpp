// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/side_points.hpp"

#include <map>
#include <span>
#include <utility>

namespace tether::fem {
namespace {

/// An element's side, 0 to 3 as add_sides() counts them.
struct ElementSide {
  std::size_t element = 0;
  int number = 0;
};

/// The elements' sides by their first and last node.
std::map<std::pair<int, int>, ElementSide> sides_by_ends(const Mesh& mesh) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  std::map<std::pair<int, int>, ElementSide> found;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Sides sides;
    add_sides(mesh.kind, mesh.element(e), sides);
    for (int k = 0; k < 4; ++k) {
      const std::size_t first = static_cast<std::size_t>(k) * per_side;
      found[{sides[first], sides[first + per_side - 1]}] = {e, k};
    }
  }
  return found;
}

/// Returns the place in the reference element of a place on its side, which runs from -1 to 1.
Vec<2> place_on(int side, double along) {
  const auto axis = static_cast<std::size_t>(side / 2);
  const int end = side % 2;
  Vec<2> s;
  s[axis] = end == 1 ? 1 : -1;
  s[1 - axis] = (axis == 0) == (end == 1) ? along : -along;  // whether the side runs with the element's coordinate
  return s;
}

SidePoint side_point(const Mesh& mesh, std::span<const int> nodes, const ElementSide& of, const PlaneSidePoint& on) {
  Vec<2> tangent{};
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double* x = &mesh.x[2 * static_cast<std::size_t>(nodes[a])];
    tangent[0] += on.slopes[a] * x[0], tangent[1] += on.slopes[a] * x[1];
  }
  SidePoint point;
  point.element = of.element;
  point.at = plane_point(mesh.kind, place_on(of.number, on.s));
  point.normal = {on.weight * tangent[1], -on.weight * tangent[0]};
  const auto count = static_cast<std::size_t>(node_count_of(mesh.kind));
  point.G = plane_map(count, gathered(mesh, of.element, mesh.x), point.at).gradients;
  return point;
}

}  // namespace

void add_side_points(const Mesh& mesh, const Sides& sides, std::vector<SidePoint>& points) {
  const auto by_ends = sides_by_ends(mesh);
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  const auto rule = plane_side_points(mesh.kind);
  for (std::size_t first = 0; first < sides.size(); first += per_side) {
    const auto nodes = std::span(sides).subspan(first, per_side);
    const ElementSide of = by_ends.at({nodes.front(), nodes.back()});
    for (const PlaneSidePoint& on : rule) points.push_back(side_point(mesh, nodes, of, on));
  }
}

}  // namespace tether::fem
