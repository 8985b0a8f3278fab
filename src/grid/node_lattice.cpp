// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/node_lattice.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "base/numbers.hpp"

namespace tether {
namespace {

/// Node (i, j) of an element's own lattice.
int node_of(const Mesh& mesh, std::size_t e, std::size_t i, std::size_t j) {
  return mesh.element(e)[j * (at(order_of(mesh.kind)) + 1) + i];
}

/// Returns whether element b stands next to a along an axis.
bool follows(const Mesh& mesh, std::size_t a, std::size_t b, std::size_t axis) {
  const std::size_t order = at(order_of(mesh.kind));
  for (std::size_t k = 0; k <= order; ++k) {
    const bool same = axis == 0 ? node_of(mesh, a, order, k) == node_of(mesh, b, 0, k)
                                : node_of(mesh, a, k, order) == node_of(mesh, b, k, 0);
    if (!same) return false;
  }
  return true;
}

bool in_rows(const Mesh& mesh, std::size_t from, std::size_t along, std::size_t rows) {
  for (std::size_t e = 0; e < along * rows; ++e) {
    if ((e + 1) % along != 0 && !follows(mesh, from + e, from + e + 1, 0)) return false;
    if (e + along < along * rows && !follows(mesh, from + e, from + e + along, 1)) return false;
  }
  return true;
}

/// The lattice of elements from .. to - 1, if they stand in rows.
std::optional<NodeLattice> lattice_of(const Mesh& mesh, std::size_t from, std::size_t to) {
  std::size_t along = 1;
  while (from + along < to && follows(mesh, from + along - 1, from + along, 0)) ++along;
  const std::size_t rows = (to - from) / along, order = at(order_of(mesh.kind));
  if (rows * along != to - from || !in_rows(mesh, from, along, rows)) return std::nullopt;
  NodeLattice lattice{{order * along + 1, order * rows + 1}, {}, from, {along, rows}};
  for (std::size_t j = 0; j < lattice.count[1]; ++j) {
    for (std::size_t i = 0; i < lattice.count[0]; ++i) {
      const std::size_t column = std::min(i / order, along - 1), row = std::min(j / order, rows - 1);
      lattice.nodes.push_back(node_of(mesh, from + row * along + column, i - order * column, j - order * row));
    }
  }
  return lattice;
}

}  // namespace

std::vector<int> NodeLattice::edge(std::size_t k) const {
  const std::size_t way = k % 2;
  const std::size_t across = k == 1 || k == 2 ? count[1 - way] - 1 : 0;
  std::vector<int> of_edge;
  for (std::size_t i = 0; i < count[way]; ++i) of_edge.push_back(way == 0 ? node(i, across) : node(across, i));
  return of_edge;
}

std::vector<NodeLattice> node_lattices_of(const Mesh& mesh) {
  std::vector<NodeLattice> lattices;
  if (is_simplex(mesh.kind)) return lattices;
  for (std::size_t from = 0, to = 0; from < mesh.element_count(); from = to) {
    while (to < mesh.element_count() && mesh.region[to] == mesh.region[from]) ++to;
    if (auto lattice = lattice_of(mesh, from, to)) lattices.push_back(std::move(*lattice));
  }
  return lattices;
}

namespace {

using LatticeWay = std::pair<std::size_t, std::size_t>;  // lattice and way
/// A way along an edge, and whether its nodes are listed from its end.
using OnEdge = std::pair<LatticeWay, bool>;

/// Returns for the nodes of each edge the ways that run along it.
std::map<std::vector<int>, std::vector<OnEdge>> ways_of_edges(const std::vector<NodeLattice>& lattices) {
  std::map<std::vector<int>, std::vector<OnEdge>> ways;
  for (std::size_t l = 0; l < lattices.size(); ++l) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::vector<int> nodes = lattices[l].edge(k);
      const bool reversed = nodes.back() < nodes.front();
      if (reversed) std::reverse(nodes.begin(), nodes.end());
      ways[nodes].push_back({{l, k % 2}, reversed});
    }
  }
  return ways;
}

}  // namespace

LatticeChains chains_of(const std::vector<NodeLattice>& lattices) {
  const auto ways_of = ways_of_edges(lattices);
  LatticeChains chains;
  chains.of.resize(lattices.size());
  const auto link = [&](const LatticeWay& way) -> LatticeChains::Link& { return chains.of[way.first][way.second]; };
  std::vector<LatticeWay> open;
  const auto go_on_from = [&](const LatticeWay& from, const std::vector<OnEdge>& along) {
    const auto here = std::ranges::find(along, from, &OnEdge::first);
    for (const auto& [other, reversed] : along) {
      if (here == along.end() || link(other).chain >= 0) continue;
      link(other) = {link(from).chain, link(from).reversed != (here->second != reversed)};
      open.push_back(other);
    }
  };
  for (std::size_t k = 0; k < 2 * lattices.size(); ++k) {
    const LatticeWay first{k / 2, k % 2};
    if (link(first).chain >= 0) continue;
    link(first) = {static_cast<int>(chains.lines.size()), false};
    chains.lines.push_back(lattices[first.first].count[first.second]);
    for (open = {first}; !open.empty();) {
      const LatticeWay from = open.back();
      open.pop_back();
      for (const auto& [nodes, along] : ways_of) go_on_from(from, along);
    }
  }
  return chains;
}

}  // namespace tether
