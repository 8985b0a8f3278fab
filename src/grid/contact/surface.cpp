// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/surface.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.hpp"
#include "grid/contact/side_parting.hpp"
#include "grid/side_tangents.hpp"
#include "grid/solid_surface.hpp"

namespace tether {
namespace {

/// Area of a reference side's place over that of the side at the start.
template <class Side>
double area_ratio(std::span<const int> nodes, std::span<const double> x, const Vec<Side::dim>& s) {
  const auto t = tangents_at<Side>(nodes.data(), x, Side::gradients(s));
  return std::sqrt((t.transpose() * t).determinant());
}

/// Makes a surface side by side.
class Builder {
 public:
  Builder(const Mesh& mesh, int parts, ContactSurface& surface) : mesh_(mesh), parts_(parts), surface_(surface) {}

  template <class Side>
  void add_sides(const Sides& sides, std::span<const int> part, std::span<const int> region);
  void add_guards();
  void add_obstacle(const Box<3>& box);
  void join();

 private:
  void add_facet(int side, const std::vector<int>& places, const std::vector<int>& names);
  int shared_place(int node, std::span<const int> nodes, std::span<const double> shares);
  int guard_place(int node);

  const Mesh& mesh_;
  int parts_;
  ContactSurface& surface_;
  std::vector<std::array<int, 3>> names_;  // of each facet's corners: a node; below 0, of its own
  std::map<int, int> guard_, shared_;      // place of a node, and of the corner of facets that it names
  int own_ = -1;
};

void Builder::add_facet(int side, const std::vector<int>& places, const std::vector<int>& names) {
  ContactFacet facet;
  std::array<int, 3> name{-1, -1, -1};
  for (std::size_t k = 0; k < places.size(); ++k) facet.corners[k] = places[k], name[k] = names[k];
  facet.side = side;
  surface_.facets.push_back(facet), names_.push_back(name);
}

int Builder::shared_place(int node, std::span<const int> nodes, std::span<const double> shares) {
  if (node < 0) return surface_.places.add(nodes, shares);
  const auto [known, is_new] = shared_.try_emplace(node, -1);
  if (is_new) known->second = surface_.places.add(nodes, shares);
  return known->second;
}

template <class Side>
void Builder::add_sides(const Sides& sides, std::span<const int> part, std::span<const int> region) {
  static const SideFacets parting = facets_of<Side>();
  const auto points = side_points<Side>(parts_);
  for (std::size_t s = 0; s < part.size(); ++s) {
    const auto nodes = std::span(sides).subspan(s * Side::nodes, Side::nodes);
    surface_.side_nodes.emplace_back(nodes.begin(), nodes.end());
    surface_.side_part.push_back(part[s]), surface_.side_region.push_back(region[s]);
    for (const auto& point : points) {
      const auto N = Side::values(point.place);
      const double area = point.weight * area_ratio<Side>(nodes, mesh_.x, point.place);
      surface_.points.push_back({surface_.places.add(nodes, N), static_cast<int>(s), area});
    }
    std::vector<int> corners, names;
    for (const SideCorner& corner : parting.corners) {
      names.push_back(corner.node < 0 ? --own_ : nodes[at(corner.node)]);
      corners.push_back(shared_place(corner.node < 0 ? -1 : names.back(), nodes, corner.shares));
    }
    for (const auto& facet : parting.facets) {
      std::vector<int> of, called;
      for (int a = 0; a < surface_.dim(); ++a)
        of.push_back(corners[at(facet[at(a)])]), called.push_back(names[at(facet[at(a)])]);
      add_facet(static_cast<int>(s), of, called);
    }
    for (const auto& [a, b] : parting.edges) {
      const Vec<3> way =
          minus(place_of(mesh_.x, nodes[at(b)], surface_.dim()), place_of(mesh_.x, nodes[at(a)], surface_.dim()));
      surface_.shortest = std::min(surface_.shortest, std::sqrt(dot(way, way)));
    }
  }
}

/// Facets by the ends that they share: each edge, in space, and each corner.
void Builder::join() {
  const int dim = surface_.dim();
  std::map<std::array<int, 2>, std::vector<std::array<int, 3>>> edges;  // facet, and its corners there
  std::map<int, std::vector<std::array<int, 2>>> corners;
  for (std::size_t f = 0; f < names_.size(); ++f) {
    for (int a = 0; a < dim; ++a) {
      corners[names_[f][at(a)]].push_back({static_cast<int>(f), a});
      const int b = (a + 1) % dim;
      if (dim == 2) continue;
      const bool turned = names_[f][at(b)] < names_[f][at(a)];
      const int low = turned ? b : a, high = turned ? a : b;
      edges[{names_[f][at(low)], names_[f][at(high)]}].push_back({static_cast<int>(f), low, high});
    }
  }
  const auto place = [&](const auto& list, std::size_t which) {
    return surface_.facets[at(list[0][0])].corners[at(list[0][which])];
  };
  std::map<int, double> edges_at;
  for (const auto& [names, list] : edges) {
    if (list.size() < 2) continue;
    const double weight = 1 - static_cast<double>(list.size());
    ContactJoint joint{{place(list, 1), place(list, 2)}, {}, weight};
    for (const auto& entry : list) joint.facets.push_back(entry[0]);
    for (const int name : names) edges_at[name] += weight;
    surface_.joints.push_back(std::move(joint));
  }
  for (const auto& [name, list] : corners) {
    const double weight = 1 - static_cast<double>(list.size()) - edges_at[name];
    if (weight == 0) continue;
    ContactJoint joint{{place(list, 1), -1}, {}, weight};
    for (const auto& entry : list) joint.facets.push_back(entry[0]);
    surface_.joints.push_back(std::move(joint));
  }
}

int Builder::guard_place(int node) {
  const auto [known, is_new] = guard_.try_emplace(node, -1);
  if (is_new) {
    const double whole = 1;
    known->second = surface_.places.add(std::span(&node, 1), std::span(&whole, 1));
  }
  return known->second;
}

/// Nodes with their parts of the sides' areas, and the facets and edges between them.
void Builder::add_guards() {
  const auto parting = facets_of_side(mesh_.kind);
  const int dim = surface_.dim();
  std::map<int, double> area;
  std::map<int, int> side_of;
  std::map<std::array<int, 2>, int> edges;
  for (std::size_t s = 0, point = 0; s < surface_.side_nodes.size(); ++s) {
    double whole = 0;
    for (; point < surface_.points.size() && surface_.points[point].side == static_cast<int>(s); ++point)
      whole += surface_.points[point].area;
    const auto& nodes = surface_.side_nodes[s];
    for (const int node : nodes) area[node] += whole / static_cast<double>(nodes.size()), side_of.try_emplace(node, s);
    for (const auto& facet : parting) {
      ContactFacet guard;
      guard.side = static_cast<int>(s);
      for (int a = 0; a < dim; ++a) {
        const int node = nodes[at(facet[at(a)])], next = nodes[at(facet[at((a + 1) % dim)])];
        guard.corners[at(a)] = guard_place(node);
        if (dim == 3) edges.try_emplace({std::min(node, next), std::max(node, next)}, static_cast<int>(s));
      }
      surface_.guard_facets.push_back(guard);
    }
  }
  for (const auto& [node, whole] : area) surface_.guards.push_back({guard_place(node), side_of[node], whole});
  for (const auto& [ends, side] : edges)
    surface_.guard_edges.push_back({{guard_place(ends[0]), guard_place(ends[1]), -1}, side});
}

/// The box's corners are fixed; its facets press and guard alike. Corners stand for as much area as the least of the
/// bodies' nodes does: what is narrower than the bodies' sides is to stop them, too.
void Builder::add_obstacle(const Box<3>& box) {
  const int dim = surface_.dim(), count = 1 << dim;
  double least = 0;
  for (const ContactPoint& guard : surface_.guards) {
    if (guard.side >= 0 && (least == 0 || guard.area < least)) least = guard.area;
  }
  std::vector<int> corners;
  std::vector<int> names;
  for (int c = 0; c < count; ++c) {
    Vec<3> place{};
    for (std::size_t i = 0; i < at(dim); ++i) place[i] = (c >> i & 1) == 1 ? box.high[i] : box.low[i];
    corners.push_back(surface_.places.add_fixed(place)), names.push_back(--own_);
    surface_.guards.push_back({corners.back(), -1, least});
  }
  const auto add = [&](const std::vector<int>& of) {
    std::vector<int> places, called;
    for (const int c : of) places.push_back(corners[at(c)]), called.push_back(names[at(c)]);
    add_facet(-1, places, called);
    surface_.guard_facets.push_back(surface_.facets.back());
  };
  for (int a = 0; a < count; ++a) {
    for (int i = 0; i < dim; ++i) {
      const int b = a | 1 << i;
      if (a == b) continue;
      if (dim == 2) add({a, b});
      if (dim == 3) surface_.guard_edges.push_back({{corners[at(a)], corners[at(b)], -1}, -1});
      const int j = (i + 1) % 3;
      if (dim == 3 && (a >> j & 1) == 0) add({a, b, b | 1 << j}), add({a, b | 1 << j, a | 1 << j});
    }
  }
}

}  // namespace

ContactSurface contact_surface(const Mesh& mesh, std::span<const int> taking_part, const std::vector<Box<3>>& obstacles,
                               int parts) {
  ContactSurface surface;
  surface.places.dim = mesh.dim(), surface.shortest = INFINITY;
  const Sides all = boundary_of(mesh);
  const std::vector<std::size_t> elements = elements_of_sides(mesh, all);
  const std::vector<int> body = parts_of(mesh);
  const auto per_side = at(side_node_count_of(mesh.kind));
  Sides sides;
  std::vector<int> part, region;
  for (std::size_t s = 0; s < elements.size(); ++s) {
    const auto nodes = std::span(all).subspan(s * per_side, per_side);
    const bool takes_part = taking_part.empty() || std::all_of(nodes.begin(), nodes.end(), [&](int node) {
                              return std::binary_search(taking_part.begin(), taking_part.end(), node);
                            });
    if (!takes_part) continue;
    sides.insert(sides.end(), nodes.begin(), nodes.end());
    part.push_back(body[at(nodes[0])]), region.push_back(mesh.region[elements[s]]);
  }
  Builder builder(mesh, parts, surface);
  with_shapes(mesh.kind, [&](auto shapes) { builder.add_sides<typename decltype(shapes)::Side>(sides, part, region); });
  builder.add_guards();
  for (const Box<3>& box : obstacles) builder.add_obstacle(box);
  builder.join();
  std::vector<double> x;
  surface.places.find(mesh.x, x);
  for (const ContactFacet& edge : surface.guard_edges) {
    const Vec<3> way = minus(place_of(x, edge.corners[1], surface.dim()), place_of(x, edge.corners[0], surface.dim()));
    surface.edge_lengths.push_back(std::sqrt(dot(way, way)));
  }
  return surface;
}

}  // namespace tether
