// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/sides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.hpp"
#include "read/values.hpp"

namespace tether {

std::array<GridEdge, 4> edges_of(const Scene& scene) {
  const BackgroundGrid& grid = scene.grid;
  const double width = grid.x1 - grid.x0, height = grid.y1 - grid.y0;
  return {{{"in.wl", 0, grid.x0, width, scene.walls.left},
           {"in.wr", 0, grid.x1, width, scene.walls.right},
           {"in.wb", 1, grid.y0, height, scene.walls.bottom},
           {"in.wt", 1, grid.y1, height, scene.walls.top}}};
}

std::vector<int> nodes_at(const Mesh& mesh, const GridEdge& edge) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::vector<int> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (std::abs(mesh.x[n * dim + edge.axis] - edge.place) <= 1e-9 * edge.size) nodes.push_back(static_cast<int>(n));
  }
  return nodes;
}

namespace {

/// Sorts them and leaves of each the first alone.
void keep_each_once(std::vector<int>& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Says what a user may have meant, or all names there are; those of sets of nodes where these would do, too.
std::string hint_for(const std::string& name, const Mesh& mesh, bool sets) {
  std::vector<std::string> names, of_sets;
  for (const auto& side : mesh.sides) names.push_back(side.first);
  for (const auto& set : mesh.node_sets) of_sets.push_back(set.first);
  std::string all = fmt::format("The sides of this mesh: {}.", fmt::join(names, ", "));
  if (names.empty()) all = "this mesh has no sides with names: its file has no physical groups of curves or surfaces";
  if (!of_sets.empty())
    all +=
        fmt::format(" {}: {}.", sets ? "Its sets of nodes" : "Sets of nodes do not do here", fmt::join(of_sets, ", "));
  if (sets) names.insert(names.end(), of_sets.begin(), of_sets.end());
  const std::string near = nearest_name(name, names);
  return near.empty() ? all : fmt::format("Did you mean '{}'? {}", near, all);
}

}  // namespace

const Sides* named_sides(const Deck& deck, TextVariable variable, int k, const Mesh& mesh, Diagnostics& diagnostics) {
  const std::string name = deck.text(variable, k);
  const auto found = mesh.sides.find(name);
  if (found != mesh.sides.end()) return &found->second;
  diagnostics.add(deck.remark(Severity::error, variable, {k, 1}, fmt::format("no side is called '{}'", name),
                              hint_for(name, mesh, false)));
  return nullptr;
}

std::vector<int> NamedPart::all_nodes() const {
  if (nodes) return *nodes;
  std::vector<int> all = sides ? *sides : Sides{};
  keep_each_once(all);
  return all;
}

NamedPart named_part(const Deck& deck, TextVariable variable, int k, const Mesh& mesh, Diagnostics& diagnostics) {
  const std::string name = deck.text(variable, k);
  if (const auto sides = mesh.sides.find(name); sides != mesh.sides.end()) return {.sides = &sides->second};
  if (const auto set = mesh.node_sets.find(name); set != mesh.node_sets.end()) return {.nodes = &set->second};
  diagnostics.add(
      deck.remark(Severity::error, variable, {k, 1},
                  fmt::format("no side{} is called '{}'", mesh.node_sets.empty() ? "" : " and no set of nodes", name),
                  hint_for(name, mesh, true)));
  return {};
}

namespace {

/// Nodes of the elements of a region, from 0.
std::vector<int> nodes_of_region(const Mesh& mesh, int region) {
  std::vector<int> nodes;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.region[e] == region)
      nodes.insert(nodes.end(), mesh.element(e), mesh.element(e) + node_count_of(mesh.kind));
  }
  keep_each_once(nodes);
  return nodes;
}

}  // namespace

std::vector<int> named_nodes(const Deck& deck, TextVariable variable, int k, const Solids& solids,
                             Diagnostics& diagnostics) {
  const std::string on = deck.text(variable, k);
  if (!on.starts_with("region ")) return named_part(deck, variable, k, solids.mesh, diagnostics).all_nodes();
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    if (solids.regions[r].name == on) return nodes_of_region(solids.mesh, static_cast<int>(r));
  }
  refuse(deck, variable, {k, 1}, fmt::format("there is no {}", on), "regions are 1 to nreg", diagnostics);
  return {};
}

void check_all_act(const Deck& deck, const char* what, AnyVariable on, Variables others, Diagnostics& diagnostics) {
  std::set<int> told;
  for (const AnyVariable name : others) {
    const bool listed = name.row().rank == 1;
    for (const Subscript at : deck.given_elements(name)) {
      const int k = at[listed ? 0 : 1];
      if (deck.given(on, k) || !told.insert(k).second) continue;
      Diagnostic nothing = deck.remark(Severity::error, name, at,
                                       fmt::format("{} {} acts on nothing: {}({}) is not given", what, k, on, k),
                                       fmt::format("{}({}) names a side", on, k));
      nothing.moot = deck.remark(Severity::error, on, {k, 1}, "").moot;  // it was given in vain
      diagnostics.add(std::move(nothing));
    }
  }
}

}  // namespace tether
