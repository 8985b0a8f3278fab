// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/mesh_place.hpp"
#include "grid/point_finder.hpp"
#include "model/solids.hpp"
#include "read/flow/checks.hpp"
#include "read/flow/edge.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/values.hpp"

// Whether immersed bodies lie within the fluid's mesh.

namespace tether {
namespace {

/// By how much a body may be outside of the fluid, in lengths of the fluid's side there: on a round wall with eight
/// sides or more these, and likewise a body's, are off the circle by less.
constexpr double most_outside = 0.1;

constexpr const char* within =
    "an immersed body lies within the fluid's mesh, which goes on beneath it; a hole is outside";

class BodyChecks {
 public:
  BodyChecks(const Deck& deck, Mesh& mesh, const Flow& flow, Diagnostics& diagnostics)
      : deck_(deck),
        mesh_(mesh),
        flow_(flow),
        edge_(flow),
        finder_(flow.mesh),
        regions_(regions_of(deck, false)),
        diagnostics_(diagnostics) {}

  /// Reports of each region the first node that is wrong. Returns whether any node was moved.
  bool nodes() {
    std::set<std::pair<int, int>> seen;
    std::map<int, Moved> moved;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const int r = mesh_.region[e];
      for (int a = 0; a < node_count_of(mesh_.kind); ++a) {
        const int node = mesh_.element(e)[a];
        if (!reported_.contains(r) && seen.emplace(r, node).second) place_node(r, node, moved[r]);
      }
    }
    bool any = false;
    for (const auto& [r, of_region] : moved) any |= warn_of(r, of_region);
    return any;
  }
  /// Reports of each region the first element that is outside of the fluid between its nodes: along a side or in its
  /// middle.
  void sides() {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (reported_.contains(mesh_.region[e])) continue;
      Sides sides;
      add_sides(mesh_.kind, mesh_.element(e), sides);
      for (std::size_t s = 0; s < sides.size(); s += per_side()) check_side(mesh_.region[e], &sides[s]);
      check_middle(e);
    }
  }
  /// Reports of each region the first node of the fluid's edge that is deep in it: a hole that none of its sides meets.
  void holes() {
    const Sides surface = boundary_of(mesh_);
    Box<2> all = box_of_side(mesh_, surface.data());
    for (std::size_t s = 0; s < surface.size(); s += per_side()) {
      all.add(box_of_side(mesh_, &surface[s]));
    }
    const auto step = static_cast<std::size_t>(side_node_count_of(flow_.mesh.kind));
    for (const FlowSide& side : flow_.sides) {
      for (std::size_t s = 0; s < side.sides.size(); s += step) {
        const Vec<2> at = node_place(flow_.mesh, side.sides[s]), end = node_place(flow_.mesh, side.sides[s + step - 1]);
        if (!all.meets({at, at})) continue;
        const double length = std::hypot(end[0] - at[0], end[1] - at[1]);
        if (nearest_of_sides(mesh_, surface, at).away > most_outside * length) check_hole(side, at);
      }
    }
  }

 private:
  /// Nodes of a region that were moved to the fluid's edge, and the one that was moved farthest.
  struct Moved {
    int count = 0, node = -1;
    double away = 0;
  };
  std::size_t per_side() const { return static_cast<std::size_t>(side_node_count_of(mesh_.kind)); }
  int number(int r) const { return regions_[static_cast<std::size_t>(r)]; }
  void refuse(int r, const std::string& message, const char* hint) {
    if (!reported_.insert(r).second) return;
    diagnostics_.add(
        remark_on_region(deck_, Severity::error, number(r), fmt::format("region {}: {}", number(r), message), hint));
  }
  void place_node(int r, int node, Moved& moved) {
    const Vec<2> at = node_place(mesh_, node);
    if (const FlowSide* inflow = edge_.inflow_at(at))
      return refuse(r, fmt::format("its node at {} lies on the inflow '{}'", place_text(mesh_, node), inflow->name),
                    "an immersed body goes with the fluid, and there its velocity is prescribed");
    if (finder_.find(at)) return;
    const OnEdge edge = edge_.nearest(at);
    if (edge.away > most_outside * edge.length)
      return refuse(r, fmt::format("its node at {} lies outside the fluid", place_text(mesh_, node)), within);
    const auto n = 2 * static_cast<std::size_t>(node);
    mesh_.x[n] = edge.place[0], mesh_.x[n + 1] = edge.place[1];
    if (++moved.count == 1 || edge.away > moved.away) moved.node = node, moved.away = edge.away;
  }
  bool warn_of(int r, const Moved& moved) {
    if (moved.count == 0) return false;
    diagnostics_.add(remark_on_region(
        deck_, Severity::warning, number(r),
        fmt::format("region {}: {} of its nodes lie outside the fluid's mesh by up to {:.3g} and {} moved to its edge, "
                    "that one to {}",
                    number(r), moved.count, moved.away, moved.count == 1 ? "is" : "are", place_text(mesh_, moved.node)),
        "the sides of elements come only near to a curved wall"));
    return true;
  }
  bool is_within(const Vec<2>& at) const {
    if (finder_.find(at)) return true;
    const OnEdge edge = edge_.nearest(at);
    return edge.away <= most_outside * edge.length;
  }
  void check_middle(std::size_t e) {
    const int count = node_count_of(mesh_.kind);
    Vec<2> middle{};
    for (int a = 0; a < count; ++a) {
      const Vec<2> at = node_place(mesh_, mesh_.element(e)[a]);
      middle[0] += at[0] / count, middle[1] += at[1] / count;
    }
    if (!is_within(middle))
      refuse(mesh_.region[e],
             fmt::format("its element at ({:.6g}, {:.6g}) lies outside the fluid", middle[0], middle[1]), within);
  }
  /// Checks places a quarter as far apart as the ends of the fluid's shortest side near by.
  void check_side(int r, const int* side) {
    const double shortest = edge_.shortest_in(box_of_side(mesh_, side));
    if (!std::isfinite(shortest)) return;
    const Vec<2> from = side_place(mesh_, side, -1), middle = side_place(mesh_, side, 0),
                 to = side_place(mesh_, side, 1);
    const double length =
        std::hypot(middle[0] - from[0], middle[1] - from[1]) + std::hypot(to[0] - middle[0], to[1] - middle[1]);
    const int parts = static_cast<int>(std::clamp(std::ceil(4 * length / shortest), 4.0, 4000.0));
    for (int k = 1; k < parts; ++k) {
      const Vec<2> at = side_place(mesh_, side, 2.0 * k / parts - 1);
      if (is_within(at)) continue;
      return refuse(r,
                    fmt::format("the side of its element from {} to {} lies outside the fluid at ({:.6g}, {:.6g})",
                                place_text(mesh_, side[0]), place_text(mesh_, side[per_side() - 1]), at[0], at[1]),
                    within);
    }
  }
  void check_hole(const FlowSide& side, const Vec<2>& at) {
    const NearestPlace nearest = nearest_place(mesh_, {at[0], at[1], 0});
    if (nearest.away > 1e-9 * nearest.element_size) return;
    refuse(mesh_.region[nearest.element],
           fmt::format("the fluid's edge '{}' is inside of it at ({:.6g}, {:.6g})", side.name, at[0], at[1]), within);
  }

  const Deck& deck_;
  Mesh& mesh_;
  const Flow& flow_;
  FlowEdge edge_;
  PointFinder finder_;
  std::vector<int> regions_;
  Diagnostics& diagnostics_;
  std::set<int> reported_;  // regions that something has been said of
};

}  // namespace

void place_bodies(const Deck& deck, Scene& scene, const Flow& flow, Diagnostics& diagnostics) {
  if (!scene.solids()) return;
  auto solids = std::make_shared<Solids>(*scene.solids());
  BodyChecks checks(deck, solids->mesh, flow, diagnostics);
  const bool moved = checks.nodes();
  checks.sides();
  checks.holes();
  if (moved) set_solids(scene.physics, std::move(solids));
}

}  // namespace tether
