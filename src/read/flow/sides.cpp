// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grid/mesh_flaws.hpp"
#include "read/amplitude_of_deck.hpp"
#include "read/flow/flow_of_deck.hpp"
#include "read/mesh/named_sides.hpp"
#include "read/word.hpp"

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
  /// What has taken a side, 0 for nothing.
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
    check_all_act(deck_, "flow", "boundary", "boundary_on",
                  {"boundary", "boundary_u", "boundary_v", "boundary_time", "boundary_factor", "boundary_with"},
                  diagnostics_);
    std::vector<FlowSide> sides;
    for (const Subscript at : deck_.given_elements("flow", "boundary_on")) read_side(at[0], sides);
    if (Sides rest = parts_.rest(); !rest.empty()) sides.push_back({"other walls", Boundary::no_slip, rest, {}, 0});
    return sides;
  }

 private:
  void refuse(const char* name, int k, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, "flow", name, {k, 1}, message, hint));
  }
  void read_side(int k, std::vector<FlowSide>& sides) {
    const Sides* named = take("boundary_on", k);
    if (!deck_.given("flow", "boundary", k))
      return refuse("boundary_on", k, fmt::format("boundary({}) is not given: what side {} is", k, k), kinds);
    FlowSide side;
    side.name = deck_.text("flow", "boundary_on", k), side.number = k;
    side.boundary = word<Boundary>(deck_, "flow", "boundary", k);
    read_velocity(k, side);
    const Sides* partner = partner_of(k, side.boundary);
    if (!named) return;
    side.sides = *named;
    if (side.boundary == Boundary::slip) check_along_an_axis(k, side);
    sides.push_back(side);
    if (partner) sides.push_back({deck_.text("flow", "boundary_with", k), Boundary::periodic, *partner, {}, k});
  }
  /// The sides that variable(k) names, which from now on nothing else may have; null where there are none.
  const Sides* take(const char* variable, int k) {
    const Sides* sides = named_sides(deck_, "flow", variable, k, mesh_, diagnostics_);
    if (!sides) return nullptr;
    const std::string name = deck_.text("flow", variable, k);
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
    const std::string kind = deck_.text("flow", "boundary", k);
    const bool has = deck_.given("flow", "boundary_u", k) || deck_.given("flow", "boundary_v", k);
    if (side.boundary != Boundary::moving && side.boundary != Boundary::inflow) return check_no_velocity(k, kind);
    if (!has)
      refuse("boundary", k, fmt::format("side {}, '{}', has no velocity", k, kind),
             fmt::format("give it by boundary_u({0}) and boundary_v({0}), expressions in x, y, t", k));
    const std::string of = fmt::format("boundary {} ({})", k, side.name);
    side.velocity = flow_vector_of(deck_, {"boundary_u", "boundary_v"}, k, of, diagnostics_);
    side.velocity.factor = amplitude_of(deck_, "flow", "boundary", k, diagnostics_);
    side.velocity.factor.of = of;
  }
  void check_no_velocity(int k, const std::string& kind) {
    for (const char* name : {"boundary_u", "boundary_v", "boundary_time", "boundary_factor"}) {
      const bool table = find_variable("flow", name)->rank == 2;
      for (const Subscript at : deck_.given_elements("flow", name)) {
        if (at[table ? 1 : 0] != k) continue;
        diagnostics_.add(deck_.remark(
            Severity::error, "flow", name, at, fmt::format("{} has no effect on side {}, which is '{}'", name, k, kind),
            "moving walls and inflows have a velocity: leave it away, or write one of these"));
        return;
      }
    }
  }
  /// The partner of a periodic side, or null.
  const Sides* partner_of(int k, Boundary boundary) {
    const bool given = deck_.given("flow", "boundary_with", k);
    if (boundary == Boundary::periodic && !given)
      refuse("boundary", k, fmt::format("the periodic side {} has no partner", k),
             fmt::format("boundary_with({}) names the side that is its image", k));
    if (boundary != Boundary::periodic && given)
      refuse("boundary_with", k,
             fmt::format("boundary_with has no effect on side {}, which is '{}'", k, deck_.text("flow", "boundary", k)),
             "periodic sides have a partner");
    return boundary == Boundary::periodic && given ? take("boundary_with", k) : nullptr;
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
      return refuse("boundary", k,
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

}  // namespace tether
