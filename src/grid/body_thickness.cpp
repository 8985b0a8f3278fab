// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/body_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/index.hpp"

namespace tether {
namespace {

std::size_t edge_count(const Mesh& mesh) { return is_simplex(mesh.kind) ? 3 : 4; }

/// Of an element between its corners, whose nodes stand at x [length^2].
double area_of(const Mesh& mesh, std::span<const double> x, std::size_t e) {
  double area = 0;
  for (std::size_t k = 0; k < edge_count(mesh); ++k) {
    const auto [a, b] = ends_of_edge(mesh, e, k);
    area += 0.5 * (x[2 * a] * x[2 * b + 1] - x[2 * b] * x[2 * a + 1]);
  }
  return area;
}

/// Which edges of the elements belong to no other one.
std::vector<std::array<bool, 4>> edges_on_outline(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  const auto ends = [&](std::size_t e, std::size_t k) {
    const auto [a, b] = ends_of_edge(mesh, e, k);
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t k = 0; k < edge_count(mesh); ++k) ++count[ends(e, k)];
  }
  std::vector<std::array<bool, 4>> alone(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t k = 0; k < edge_count(mesh); ++k) alone[e][k] = count[ends(e, k)] == 1;
  }
  return alone;
}

/// The shorter side of a rectangle; of an outline that no rectangle of the area has, a square's.
double thickness_of(double area, double outline) {
  const double half = 0.5 * outline, root = half * half - 4 * area;
  return root > 0 ? 2 * area / (half + std::sqrt(root)) : 0.5 * half;
}

}  // namespace

std::string thin_body_advice(int order_of_fluid) {
  if (order_of_fluid == 1)
    return "how far it bends may be wrong by a factor of three; two cells and more across it, or element='q2q1', "
           "bring it within a tenth";
  return "it may bend too far by a tenth to a third; one cell and more across it brings it within some percent";
}

BodyThickness::BodyThickness(const Mesh& below, const Mesh& bodies)
    : below_(below),
      bodies_(bodies),
      spacings_(below),
      on_outline_(edges_on_outline(bodies)),
      part_of_node_(parts_of(bodies)),
      element_below_(bodies.element_count(), -1),
      area_(at(count_parts(bodies))),
      outline_(area_.size()),
      region_(area_.size(), -1) {
  for (std::size_t e = 0; e < bodies.element_count(); ++e) {
    int& region = region_[at(part_of_node_[at(bodies.element(e)[0])])];
    if (region < 0) region = bodies.region[e];
  }
}

double BodyThickness::length_of_outline(std::size_t e, const std::array<NodeSpacing, 4>& spacing) const {
  const double in_cells = static_cast<double>(order_of(bodies_.kind)) / order_of(below_.kind);
  double length = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (on_outline_[e][k]) length += in_cells * spacing[k].ratio();
  }
  return length;
}

ThinBody BodyThickness::thinnest(std::span<const double> x) {
  std::ranges::fill(area_, 0.0), std::ranges::fill(outline_, 0.0);
  for (std::size_t e = 0; e < bodies_.element_count(); ++e) {
    const auto spacing = spacings_.of_element(bodies_, x, e, element_below_[e]);
    if (!spacing) continue;
    const std::size_t part = at(part_of_node_[at(bodies_.element(e)[0])]);
    area_[part] += std::abs(area_of(bodies_, x, e) / area_of(below_, below_.x, at(element_below_[e])));
    outline_[part] += length_of_outline(e, *spacing);
  }
  ThinBody thin;
  for (std::size_t part = 0; part < area_.size(); ++part) {
    const double cells = thickness_of(area_[part], outline_[part]);
    if (area_[part] > 0 && (thin.region < 0 || cells < thin.cells)) thin = {region_[part], cells};
  }
  return thin;
}

}  // namespace tether
