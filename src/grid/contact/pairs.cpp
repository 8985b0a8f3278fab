// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "grid/box_tree.hpp"

namespace tether {
namespace {

constexpr double nearly_parallel = 1e-3;  // square of the sine

}  // namespace

ContactPairs::ContactPairs(const ContactSurface& surface, WhoMeets who, Team& team)
    : surface_(surface), who_(who), team_(team) {}

void ContactPairs::find_boxes(std::initializer_list<std::span<const double>> times, double slack) {
  low_.assign(times.begin()->begin(), times.begin()->end()), high_ = low_;
  for (const auto& x : times) {
    for (std::size_t k = 0; k < x.size(); ++k) low_[k] = std::min(low_[k], x[k]), high_[k] = std::max(high_[k], x[k]);
  }
  const auto d = at(surface_.dim());
  for (std::size_t p = 0; p < surface_.places.size(); ++p) {
    if (surface_.places.is_fixed(static_cast<int>(p))) continue;
    for (std::size_t k = p * d; k < (p + 1) * d; ++k) low_[k] -= slack, high_[k] += slack;
  }
}

bool ContactPairs::hold(std::span<const double> x) const {
  if (low_.size() != x.size()) return false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(x[k] >= low_[k] && x[k] <= high_[k])) return false;
  }
  return true;
}

Box<3> ContactPairs::box_of(std::span<const int> places) const {
  const auto d = at(surface_.dim());
  Box<3> box;
  for (std::size_t i = 0; i < d; ++i) box.low[i] = INFINITY, box.high[i] = -INFINITY;
  for (const int place : places) {
    for (std::size_t i = 0; i < d; ++i) {
      box.low[i] = std::min(box.low[i], low_[at(place) * d + i]);
      box.high[i] = std::max(box.high[i], high_[at(place) * d + i]);
    }
  }
  return box;
}

bool ContactPairs::can_meet(int side, int other) const {
  if (side < 0 || other < 0) return side >= 0 || other >= 0;
  return surface_.side_part[at(side)] == surface_.side_part[at(other)] ? who_.itself : who_.bodies;
}

bool ContactPairs::share_a_node(int side, int other) const {
  if (side < 0 || other < 0 || surface_.side_part[at(side)] != surface_.side_part[at(other)]) return false;
  const auto& nodes = surface_.side_nodes[at(side)];
  return std::any_of(nodes.begin(), nodes.end(), [&](int node) {
    const auto& others = surface_.side_nodes[at(other)];
    return std::find(others.begin(), others.end(), node) != others.end();
  });
}

/// A point of quadrature meets facets, and what these count twice. Two bodies press each other from both sides, by
/// half.
void ContactPairs::find_of_point(const BoxTree& facets, const BoxTree& joints, std::size_t number, double gap,
                                 std::vector<ContactPair>& pairs) const {
  const ContactPoint& point = surface_.points[number];
  for (const int f : facets.meeting(box_of(std::span(&point.place, 1)), gap)) {
    const ContactFacet& facet = surface_.facets[at(f)];
    if (!can_meet(point.side, facet.side) || share_a_node(point.side, facet.side)) continue;
    const auto& c = facet.corners;
    pairs.push_back({.kind = surface_.dim() == 3 ? PairKind::triangle : PairKind::edge,
                     .places = {point.place, c[0], c[1], c[2]},
                     .side = point.side,
                     .other = facet.side,
                     .area = facet.side < 0 ? point.area : 0.5 * point.area,
                     .point = number});
  }
  for (const int j : joints.meeting(box_of(std::span(&point.place, 1)), gap)) {
    const ContactJoint& joint = surface_.joints[at(j)];
    const int side = surface_.facets[at(joint.facets[0])].side;
    if (!can_meet(point.side, side) || std::any_of(joint.facets.begin(), joint.facets.end(), [&](int f) {
          return share_a_node(point.side, surface_.facets[at(f)].side);
        }))
      continue;
    pairs.push_back({.kind = joint.ends[1] < 0 ? PairKind::corner : PairKind::edge,
                     .places = {point.place, joint.ends[0], joint.ends[1], -1},
                     .side = point.side,
                     .other = side,
                     .area = joint.weight * (side < 0 ? point.area : 0.5 * point.area),
                     .point = number});
  }
}

void ContactPairs::find_of_guard(const BoxTree& tree, const ContactPoint& guard, double gap,
                                 std::vector<ContactPair>& pairs) const {
  for (const int f : tree.meeting(box_of(std::span(&guard.place, 1)), gap)) {
    const ContactFacet& facet = surface_.guard_facets[at(f)];
    const auto& c = facet.corners;
    if (!can_meet(guard.side, facet.side) || std::find(c.begin(), c.end(), guard.place) != c.end()) continue;
    pairs.push_back({.kind = surface_.dim() == 3 ? PairKind::triangle : PairKind::edge,
                     .places = {guard.place, c[0], c[1], c[2]},
                     .side = guard.side,
                     .other = facet.side,
                     .area = guard.area,
                     .guard = true});
  }
}

/// Each pair of edges once, from the edge with the smaller number.
void ContactPairs::find_of_edge(const BoxTree& tree, std::size_t e, double gap, std::vector<ContactPair>& pairs) const {
  const ContactFacet& edge = surface_.guard_edges[e];
  const auto& a = edge.corners;
  for (const int f : tree.meeting(box_of(std::span(a).first(2)), gap)) {
    if (at(f) <= e) continue;
    const ContactFacet& other = surface_.guard_edges[at(f)];
    const auto& b = other.corners;
    if (!can_meet(edge.side, other.side) || a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
    const double area = surface_.edge_lengths[e] * surface_.edge_lengths[at(f)];
    pairs.push_back({.kind = PairKind::edges,
                     .places = {a[0], a[1], b[0], b[1]},
                     .side = edge.side,
                     .other = other.side,
                     .area = 0.25 * area,
                     .guard = true,
                     .parallel = nearly_parallel * area * area});
  }
}

template <class Corners>
BoxTree ContactPairs::tree_of(std::size_t count, const Corners& corners) const {
  std::vector<Box<3>> boxes;
  for (std::size_t k = 0; k < count; ++k) boxes.push_back(box_of(corners(k)));
  return BoxTree(boxes);
}

void ContactPairs::find(std::initializer_list<std::span<const double>> times, double gap, double slack) {
  find_boxes(times, slack);
  const auto of = [&](const std::vector<ContactFacet>& list, std::size_t corners) {
    return tree_of(list.size(), [&, corners](std::size_t k) { return std::span(list[k].corners).first(corners); });
  };
  const auto corners = at(surface_.dim());
  const BoxTree facets = of(surface_.facets, corners), guards = of(surface_.guard_facets, corners),
                edges = of(surface_.guard_edges, 2), joints = tree_of(surface_.joints.size(), [&](std::size_t k) {
                                                       const auto& ends = surface_.joints[k].ends;
                                                       return std::span(ends).first(ends[1] < 0 ? 1 : 2);
                                                     });
  constexpr std::size_t at_a_time = 64;
  const std::size_t points = surface_.points.size(), nodes = surface_.guards.size(),
                    count = points + nodes + surface_.guard_edges.size();
  std::vector<std::vector<ContactPair>> found((count + at_a_time - 1) / at_a_time);
  team_.each(0, found.size(), [&](std::size_t block) {
    for (std::size_t k = block * at_a_time; k < std::min(count, (block + 1) * at_a_time); ++k) {
      if (k < points) {
        find_of_point(facets, joints, k, gap, found[block]);
      } else if (k < points + nodes) {
        find_of_guard(guards, surface_.guards[k - points], gap, found[block]);
      } else {
        find_of_edge(edges, k - points - nodes, gap, found[block]);
      }
    }
  });
  pairs_.clear();
  for (const auto& block : found) pairs_.insert(pairs_.end(), block.begin(), block.end());
}

namespace {

template <PairKind kind, int dim>
double squared_distance_of(const PairVectors<dim, vector_count(kind)>& r) {
  return squared_distance<dim, vector_count(kind)>(r, nearest<kind>(products_of<dim, vector_count(kind)>(r)));
}

/// The fastest that any place of one comes to any place of the other: an edge's places go between its ends' ways.
template <PairKind kind, int dim>
double fastest(const ContactPair& pair, std::span<const double> ways) {
  const auto way = [&](int k) { return column_at<dim>(&ways[at(pair.places[at(k)]) * dim]); };
  constexpr int first = kind == PairKind::edges ? 2 : 1;
  double most = 0;
  for (int a = 0; a < first; ++a) {
    for (int b = first; b <= vector_count(kind); ++b) most = std::max(most, (way(a) - way(b)).norm());
  }
  return most;
}

template <PairKind kind, int dim>
double part_of_way_of(const ContactPair& pair, std::span<const double> x, std::span<const double> ways, double to) {
  constexpr int count = vector_count(kind);
  constexpr double least = 0.8;  // of the distance that it is to go to
  const auto r = vectors_of<kind, dim>(pair, x), change = vectors_of<kind, dim>(pair, ways);
  const auto away = [&](double part) {
    return std::sqrt(squared_distance_of<kind, dim>(PairVectors<dim, count>(r + part * change)));
  };
  const double speed = fastest<kind, dim>(pair, ways);
  double now = away(0), part = 0;
  if (speed <= now - to) return 1;
  constexpr int most_turns = 1000;
  for (int k = 0; k < most_turns && now > to; ++k) {
    part += (now - least * to) / speed;
    if (part >= 1) return 1;
    now = away(part);
  }
  return part;
}

template <class Function>
auto with_dim_and_kind(int dim, PairKind kind, const Function& f) {
  return with_dim(dim, [&](auto d) { return with_kind<decltype(d)::value>(kind, [&](auto k) { return f(d, k); }); });
}

}  // namespace

double part_of_way(const ContactPair& pair, int dim, std::span<const double> x, std::span<const double> ways,
                   double to) {
  return with_dim_and_kind(dim, pair.kind, [&](auto d, auto kind) {
    return part_of_way_of<decltype(kind)::value, decltype(d)::value>(pair, x, ways, to);
  });
}

double squared_distance(const ContactPair& pair, int dim, std::span<const double> x) {
  return with_dim_and_kind(dim, pair.kind, [&](auto d, auto kind) {
    constexpr PairKind of = decltype(kind)::value;
    return squared_distance_of<of, decltype(d)::value>(vectors_of<of, decltype(d)::value>(pair, x));
  });
}

}  // namespace tether
