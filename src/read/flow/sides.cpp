// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <numeric>

#include "base/vec.hpp"
#include "grid/mesh_extent.hpp"
#include "grid/mesh_flaws.hpp"
#include "read/flow/flow.hpp"
#include "read/mesh/sides.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

constexpr const char* kinds = "no-slip, slip, moving, inflow, open or periodic";

/// The element sides of the boundary, by their ends.
class BoundaryParts {
 public:
  explicit BoundaryParts(const Mesh& mesh)
      : sides_(boundary_of(mesh)), per_side_(static_cast<std::size_t>(side_node_count_of(mesh.kind))) {
    for (std::size_t s = 0; s < sides_.size() / per_side_; ++s) number_[key(&sides_[s * per_side_])] = s;
    taken_.assign(number_.size(), 0);
  }
  /// The number of that side, or none where it lies within the mesh.
  std::optional<std::size_t> find(const int* side) const {
    const auto found = number_.find(key(side));
    return found == number_.end() ? std::nullopt : std::optional(found->second);
  }
  std::size_t per_side() const { return per_side_; }
  /// Returns what has taken a side, 0 for nothing.
  int& taken(std::size_t s) { return taken_[s]; }
  /// The sides that nothing has taken.
  Sides rest() const {
    Sides rest;
    for (std::size_t s = 0; s < taken_.size(); ++s) {
      if (taken_[s] == 0) rest.insert(rest.end(), &sides_[s * per_side_], &sides_[s * per_side_] + per_side_);
    }
    return rest;
  }

 private:
  std::pair<int, int> key(const int* side) const { return std::minmax(side[0], side[per_side_ - 1]); }

  Sides sides_;
  std::size_t per_side_;
  std::map<std::pair<int, int>, std::size_t> number_;
  std::vector<int> taken_;
};

/// Reads boundary_on and what belongs to it.
class SideReader {
 public:
  SideReader(const Deck& deck, const Mesh& mesh, Diagnostics& diagnostics)
      : deck_(deck), mesh_(mesh), parts_(mesh), diagnostics_(diagnostics) {}

  std::vector<FlowSide> read() {
    check_all_act(deck_, "boundary", "flow.boundary_on",
                  {"flow.boundary", "flow.boundary_u", "flow.boundary_v", "flow.boundary_time", "flow.boundary_factor",
                   "flow.boundary_with"},
                  diagnostics_);
    std::vector<FlowSide> sides;
    for (const Subscript at : deck_.given_elements("flow.boundary_on")) read_side(at[0], sides);
    if (Sides rest = parts_.rest(); !rest.empty()) sides.push_back({"other walls", Boundary::no_slip, rest, {}, 0});
    return sides;
  }

 private:
  void refuse(AnyVariable name, int k, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, {k, 1}, message, hint));
  }
  void read_side(int k, std::vector<FlowSide>& sides) {
    const Sides* named = take("flow.boundary_on", k);
    if (!deck_.given("flow.boundary", k))
      return refuse("flow.boundary_on", k, fmt::format("boundary({}) is not given: what side {} is", k, k), kinds);
    FlowSide side;
    side.name = deck_.text("flow.boundary_on", k), side.number = k;
    side.boundary = word<Boundary>(deck_, "flow.boundary", k);
    read_velocity(k, side);
    const Sides* partner = partner_of(k, side.boundary);
    if (!named) return;
    side.sides = *named;
    if (side.boundary == Boundary::slip) check_along_an_axis(k, side);
    sides.push_back(side);
    if (partner) sides.push_back({deck_.text("flow.boundary_with", k), Boundary::periodic, *partner, {}, k});
  }
  /// The sides that variable(k) names, which from now on nothing else may have; null where there are none.
  const Sides* take(TextVariable variable, int k) {
    const Sides* sides = named_sides(deck_, variable, k, mesh_, diagnostics_);
    if (!sides) return nullptr;
    const std::string name = deck_.text(variable, k);
    for (std::size_t s = 0; s < sides->size(); s += parts_.per_side()) {
      const auto part = parts_.find(&(*sides)[s]);
      const int by = part ? parts_.taken(*part) : 0;
      if (part && by == 0) {
        parts_.taken(*part) = k;
        continue;
      }
      const std::string at = place_text(mesh_, (*sides)[s]);
      if (!part) {
        refuse(variable, k, fmt::format("'{}' is no side of the fluid's boundary at {}: elements join there", name, at),
               "name an edge that no other block of the fluid has");
      } else {
        refuse(variable, k, fmt::format("'{}' and side {} of the boundary are one at {}", name, by, at),
               "each part of the boundary has one condition");
      }
      return nullptr;
    }
    return sides;
  }
  void read_velocity(int k, FlowSide& side) {
    const std::string kind = deck_.text("flow.boundary", k);
    const bool has = deck_.given("flow.boundary_u", k) || deck_.given("flow.boundary_v", k);
    if (side.boundary != Boundary::moving && side.boundary != Boundary::inflow) return check_no_velocity(k, kind);
    if (!has)
      refuse("flow.boundary", k, fmt::format("side {}, '{}', has no velocity", k, kind),
             fmt::format("give it by boundary_u({0}) and boundary_v({0}), expressions in x, y, t", k));
    const std::string of = fmt::format("boundary {} ({})", k, side.name);
    side.velocity = flow_vector_of(deck_, {"flow.boundary_u", "flow.boundary_v"}, k, of, diagnostics_);
    side.velocity.factor = amplitude_of(deck_, "flow.boundary", k, diagnostics_);
    side.velocity.factor.of = of;
  }
  void check_no_velocity(int k, const std::string& kind) {
    for (const AnyVariable name :
         Variables{"flow.boundary_u", "flow.boundary_v", "flow.boundary_time", "flow.boundary_factor"}) {
      const bool table = name.row().rank == 2;
      for (const Subscript at : deck_.given_elements(name)) {
        if (at[table ? 1 : 0] != k) continue;
        diagnostics_.add(deck_.remark(
            Severity::error, name, at, fmt::format("{} has no effect on side {}, which is '{}'", name, k, kind),
            "moving walls and inflows have a velocity: leave it away, or write one of these"));
        return;
      }
    }
  }
  /// The partner of a periodic side, or null.
  const Sides* partner_of(int k, Boundary boundary) {
    const bool given = deck_.given("flow.boundary_with", k);
    if (boundary == Boundary::periodic && !given)
      refuse("flow.boundary", k, fmt::format("the periodic side {} has no partner", k),
             fmt::format("boundary_with({}) names the side that is its image", k));
    if (boundary != Boundary::periodic && given)
      refuse("flow.boundary_with", k,
             fmt::format("boundary_with has no effect on side {}, which is '{}'", k, deck_.text("flow.boundary", k)),
             "periodic sides have a partner");
    return boundary == Boundary::periodic && given ? take("flow.boundary_with", k) : nullptr;
  }
  void check_along_an_axis(int k, const FlowSide& side) {
    double size = 0;
    const auto [low, high] = std::minmax_element(mesh_.x.begin(), mesh_.x.end());
    size = *high - *low;
    for (std::size_t s = 0; s < side.sides.size(); s += parts_.per_side()) {
      double across[2] = {0, 0};
      for (std::size_t a = 1; a < parts_.per_side(); ++a) {
        for (std::size_t i = 0; i < 2; ++i)
          across[i] = std::max(across[i], std::abs(coordinate(side.sides[s + a], i) - coordinate(side.sides[s], i)));
      }
      if (std::min(across[0], across[1]) <= 1e-9 * size) continue;
      return refuse("flow.boundary", k,
                    fmt::format("'{}' is neither along x nor along y at {}: slip along it is not modelled", side.name,
                                place_text(mesh_, side.sides[s])),
                    "make it no-slip, or place it along an axis");
    }
  }
  double coordinate(int node, std::size_t i) const { return mesh_.x[2 * static_cast<std::size_t>(node) + i]; }

  const Deck& deck_;
  const Mesh& mesh_;
  BoundaryParts parts_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::vector<FlowSide> flow_sides_of(const Deck& deck, const Mesh& mesh, Diagnostics& diagnostics) {
  return SideReader(deck, mesh, diagnostics).read();
}

namespace {

std::vector<int> nodes_of(const Sides& sides) {
  std::vector<int> nodes(sides);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Joins the nodes of periodic sides, of each node with the lowest one that it shares its unknowns with.
class Twins {
 public:
  explicit Twins(const Mesh& mesh) : mesh_(mesh), lowest_(mesh.node_count()) {
    std::iota(lowest_.begin(), lowest_.end(), 0);
    within_ = coincident * MeshExtent(mesh).size();
  }

  /// Says what is wrong with the pair, and what would be right; empty where its nodes are joined.
  std::array<std::string, 2> join(const FlowSide& side, const FlowSide& partner) {
    const std::vector<int> from = nodes_of(side.sides), to = nodes_of(partner.sides);
    const std::array ends{extent_of(from), extent_of(to)};
    Vec<2> move;
    for (std::size_t i = 0; i < 2; ++i) {
      move[i] = ends[1][0][i] - ends[0][0][i];
      if (std::abs(ends[1][1][i] - ends[0][1][i] - move[i]) > within_)
        return {fmt::format("'{}' is not '{}' moved in parallel: their extents differ in {}", partner.name, side.name,
                            "xy"[i]),
                "periodic sides have one shape"};
    }
    for (const int node : from) {
      const auto twin = std::find_if(to.begin(), to.end(), [&](int other) { return is_moved(node, other, move); });
      if (twin == to.end() || from.size() != to.size())
        return {
            fmt::format("the nodes of '{}' and '{}' do not match: {} and {}, and that at {} has {} at ({:.6g}, {:.6g})",
                        side.name, partner.name, from.size(), to.size(), place_text(mesh_, node),
                        twin == to.end() ? "none" : "one", at(node, 0) + move[0], at(node, 1) + move[1]),
            "one shape, and equally many cells with the same grading on both, in Gmsh by 'Periodic Curve'"};
      unite(node, *twin);
    }
    return {};
  }

  std::vector<int> twins() {
    std::vector<int> twins(lowest_.size());
    for (std::size_t n = 0; n < twins.size(); ++n) twins[n] = root(static_cast<int>(n));
    return twins;
  }

 private:
  double at(int node, std::size_t i) const { return mesh_.x[2 * static_cast<std::size_t>(node) + i]; }
  /// Lowest and highest coordinates.
  std::array<Vec<2>, 2> extent_of(const std::vector<int>& nodes) const {
    std::array<Vec<2>, 2> extent{Vec<2>{at(nodes[0], 0), at(nodes[0], 1)}, Vec<2>{at(nodes[0], 0), at(nodes[0], 1)}};
    for (const int node : nodes) {
      for (std::size_t i = 0; i < 2; ++i) {
        extent[0][i] = std::min(extent[0][i], at(node, i)), extent[1][i] = std::max(extent[1][i], at(node, i));
      }
    }
    return extent;
  }
  bool is_moved(int node, int other, const Vec<2>& move) const {
    return std::abs(at(other, 0) - at(node, 0) - move[0]) <= within_ &&
           std::abs(at(other, 1) - at(node, 1) - move[1]) <= within_;
  }
  int root(int node) const {
    while (lowest_[static_cast<std::size_t>(node)] != node) node = lowest_[static_cast<std::size_t>(node)];
    return node;
  }
  void unite(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    lowest_[static_cast<std::size_t>(high)] = low;
  }

  const Mesh& mesh_;
  std::vector<int> lowest_;  // or one that is lower, up to the lowest
  double within_ = 0;        // [length]
};

}  // namespace

std::vector<int> twins_of(const Deck& deck, const Mesh& mesh, const std::vector<FlowSide>& sides,
                          Diagnostics& diagnostics) {
  Twins twins(mesh);
  for (std::size_t s = 1; s < sides.size(); ++s) {
    if (sides[s].boundary != Boundary::periodic || sides[s].number != sides[s - 1].number) continue;
    const auto [message, hint] = twins.join(sides[s - 1], sides[s]);
    if (message.empty()) continue;
    diagnostics.add(deck.remark(Severity::error, "flow.boundary_with", {sides[s].number, 1}, message, hint));
  }
  return twins.twins();
}

}  // namespace tether
