// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "grid/gmsh_mesh.hpp"

namespace tether::gmsh {
namespace {

constexpr std::size_t most_told = 5;  // of one kind of mistake, the last with the number of those that follow

/// " (and 12 others)" at the last that is told.
std::string others(std::size_t k, std::size_t count) {
  return k + 1 == most_told && count > most_told ? fmt::format(" (and {} others)", count - most_told) : "";
}

void check_places(const NamedMesh& named, Remarks& remarks) {
  const auto pairs = coinciding_nodes(named.mesh);
  for (std::size_t k = 0; k < std::min(pairs.size(), most_told); ++k) {
    const Node& first = *named.nodes[static_cast<std::size_t>(pairs[k].first)];
    const Node& second = *named.nodes[static_cast<std::size_t>(pairs[k].second)];
    remarks.error(second.line, 1,
                  fmt::format("nodes {} and {} are in one place, {}{}", first.number, second.number,
                              place_text(named.mesh, pairs[k].first), others(k, pairs.size())),
                  "Parts are joined by shared nodes: in Gmsh, 'Coherence' joins geometry, 'Coherence Mesh' nodes.");
  }
}

void check_inverted(const NamedMesh& named, Remarks& remarks) {
  const auto inverted = inverted_elements(named.mesh);
  for (std::size_t k = 0; k < std::min(inverted.size(), most_told); ++k) {
    const std::size_t e = inverted[k];
    const Element& element = *named.elements[e];
    remarks.error(element.line, 1,
                  fmt::format("element {} of region {} at {} is turned inside out or flat{}", element.number,
                              named.numbers[static_cast<std::size_t>(named.mesh.region[e])],
                              place_text(named.mesh, named.mesh.element(e)[0]), others(k, inverted.size())),
                  named.mesh.dim() == 2
                      ? "Plane elements go counter-clockwise, as the outer Curve Loop of their surface does: turn "
                        "that, or write 'ReverseMesh Surface{...};' in the .geo."
                      : "Gmsh's 'Tools, Statistics' shows such elements; a finer mesh may have none.");
  }
}

void check_hanging(const NamedMesh& named, Remarks& remarks) {
  const auto hanging = hanging_node(named.mesh);
  if (!hanging) return;
  const Node& node = *named.nodes[static_cast<std::size_t>(hanging->node)];
  remarks.error(node.line, 1,
                fmt::format("node {} at {} hangs: it lies within a side of an element that does not have it",
                            node.number, place_text(named.mesh, hanging->node)),
                "Parts that touch share their nodes: in Gmsh, 'Coherence' joins their geometry before meshing.");
}

}  // namespace

bool check_once(const NamedMesh& named, Remarks& remarks) {
  const auto per_element = static_cast<std::size_t>(node_count_of(named.mesh.kind));
  std::map<std::vector<int>, const Element*> seen;
  bool all = true;
  for (std::size_t e = 0; e < named.elements.size(); ++e) {
    std::vector<int> nodes(named.mesh.element(e), named.mesh.element(e) + per_element);
    std::sort(nodes.begin(), nodes.end());
    const auto [first, fresh] = seen.emplace(std::move(nodes), named.elements[e]);
    if (fresh) continue;
    all = false;
    remarks.error(
        named.elements[e]->line, 1,
        fmt::format("elements {} and {} have the same nodes", first->second->number, named.elements[e]->number),
        "Does a surface or volume belong to two physical groups? Each element has one region.");
  }
  return all;
}

void check_used(const NamedMesh& whole, Remarks& remarks) {
  std::vector<char> used(whole.nodes.size(), 0);
  for (const int node : whole.mesh.nodes) used[static_cast<std::size_t>(node)] = 1;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  for (std::size_t n = 0, k = 0; n < used.size() && k < most_told; ++n) {
    if (used[n]) continue;
    const Node& node = *whole.nodes[n];
    remarks.error(node.line, 1,
                  fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}) belongs to no element{}", node.number, node.x[0],
                              node.x[1], node.x[2], others(k++, count)),
                  "With physical groups Gmsh saves only their elements and nodes; a centre of an arc is such a node.");
  }
}

void check_shape(const NamedMesh& named, Remarks& remarks) {
  check_places(named, remarks);
  check_inverted(named, remarks);
  if (!remarks.has_errors()) check_hanging(named, remarks);
}

}  // namespace tether::gmsh
