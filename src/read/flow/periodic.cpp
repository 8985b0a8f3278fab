// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "grid/mesh_flaws.hpp"
#include "read/flow/flow_of_deck.hpp"

namespace tether {
namespace {

using Place = std::array<double, 2>;

constexpr double tolerance = 1e-9;  // of the mesh's size

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
    const auto [low, high] = std::minmax_element(mesh.x.begin(), mesh.x.end());
    within_ = tolerance * (*high - *low);
  }

  /// What is wrong with the pair, and what would be right; empty where its nodes are joined.
  std::array<std::string, 2> join(const FlowSide& side, const FlowSide& partner) {
    const std::vector<int> from = nodes_of(side.sides), to = nodes_of(partner.sides);
    const std::array ends{extent_of(from), extent_of(to)};
    Place move;
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
  std::array<Place, 2> extent_of(const std::vector<int>& nodes) const {
    std::array<Place, 2> extent{Place{at(nodes[0], 0), at(nodes[0], 1)}, Place{at(nodes[0], 0), at(nodes[0], 1)}};
    for (const int node : nodes) {
      for (std::size_t i = 0; i < 2; ++i) {
        extent[0][i] = std::min(extent[0][i], at(node, i)), extent[1][i] = std::max(extent[1][i], at(node, i));
      }
    }
    return extent;
  }
  bool is_moved(int node, int other, const Place& move) const {
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
    diagnostics.add(deck.remark(Severity::error, "flow", "boundary_with", {sides[s].number, 1}, message, hint));
  }
  return twins.twins();
}

}  // namespace tether
