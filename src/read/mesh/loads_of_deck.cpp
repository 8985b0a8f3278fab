// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "read/amplitude_of_deck.hpp"
#include "read/mesh/grid_edges.hpp"
#include "read/mesh/named_sides.hpp"
#include "read/mesh/solids_of_deck.hpp"
#include "read/regions_of_deck.hpp"

namespace tether {
namespace {

constexpr const char* plane_hint = "x and y are all there is; with z of the regions in $mesh there are bodies in space";

void refuse(const Deck& deck, const char* name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, "fem", name, at, message, hint));
}

std::string region_hint(const Deck& deck) {
  return regions_of(deck, true).empty() ? "regions are 1 to nreg"
                                        : "loads act on the regions that are no fluid; a fluid has bx, by of $flow";
}

/// Adds the nodes of a mesh that stand at an edge, held there as its wall does.
void add_wall(const Deck& deck, const GridEdge& edge, Solids& solids, Diagnostics& diagnostics) {
  const Mesh& mesh = solids.mesh;
  if (edge.wall == Wall::open) return;
  Support support;
  support.nodes = nodes_at(mesh, edge);
  support.amplitude.of = fmt::format("the wall {}", edge.variable);
  check_wall(deck, mesh, edge, support.nodes.size(), diagnostics);
  if (edge.wall == Wall::fixed) {
    support.fixed = {true, true, mesh.dim() == 3};
  } else {
    support.fixed[edge.axis] = true;
  }
  if (!support.nodes.empty()) solids.supports.push_back(std::move(support));
}

}  // namespace

void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  check_all_act(deck, "fem", "load", "load_on", {"load", "load_time", "load_factor", "load_expression"}, diagnostics);
  for (const Subscript at : deck.given_elements("fem", "load_on")) {
    const int k = at[0];
    Load load;
    const std::string on = deck.text("fem", "load_on", k);
    if (on.starts_with("region ")) {
      const auto named = std::find_if(solids.regions.begin(), solids.regions.end(),
                                      [&](const SolidRegion& region) { return region.name == on; });
      load.region = static_cast<int>(named - solids.regions.begin());
      if (named == solids.regions.end()) {
        refuse(deck, "load_on", at, fmt::format("there is no {}", on), region_hint(deck), diagnostics);
        continue;
      }
    } else if (const Sides* sides = named_sides(deck, "fem", "load_on", k, solids.mesh, diagnostics)) {
      load.sides = *sides;
    }
    bool sized = false;
    for (int i = 1; i <= 3; ++i) {
      load.force[static_cast<std::size_t>(i - 1)] = deck.real("fem", "load", i, k);
      sized |= deck.given("fem", "load", i, k);
    }
    if (!sized)
      refuse(deck, "load_on", at, fmt::format("load {} has no size: load(1,{}) is not given", k, k),
             fmt::format("write load(1:2,{0})=0.,-1., force per area along x and y", k), diagnostics);
    if (solids.mesh.dim() == 2 && load.force[2] != 0)
      refuse(deck, "load", {3, k}, fmt::format("load {} acts along z, but the mesh is plane", k), plane_hint,
             diagnostics);
    load.amplitude = amplitude_of(deck, "fem", "load", k, diagnostics);
    solids.loads.push_back(std::move(load));
  }
}

void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics) {
  check_all_act(deck, "fem", "support", "fix_on", {"fix", "fix_time", "fix_factor", "fix_expression"}, diagnostics);
  for (const GridEdge& edge : edges_of(scene)) add_wall(deck, edge, solids, diagnostics);
  for (const Subscript at : deck.given_elements("fem", "fix_on")) {
    const int k = at[0];
    const Sides* sides = named_sides(deck, "fem", "fix_on", k, solids.mesh, diagnostics);
    if (!sides) continue;
    Support support;
    support.nodes = *sides, support.number = k;
    std::sort(support.nodes.begin(), support.nodes.end());
    support.nodes.erase(std::unique(support.nodes.begin(), support.nodes.end()), support.nodes.end());
    for (int i = 1; i <= 3; ++i) {
      const auto axis = static_cast<std::size_t>(i - 1);
      support.fixed[axis] = deck.given("fem", "fix", i, k);
      if (support.fixed[axis]) support.displacement[axis] = deck.real("fem", "fix", i, k);
    }
    if (support.fixed == std::array<bool, 3>{})
      refuse(deck, "fix_on", at, fmt::format("support {} holds no direction", k),
             fmt::format("write fix(1,{0})=0,0{1}", k, solids.mesh.dim() == 3 ? ",0" : ""), diagnostics);
    if (solids.mesh.dim() == 2 && support.fixed[2])
      refuse(deck, "fix", {3, k}, fmt::format("support {} holds z, but the mesh is plane", k), plane_hint, diagnostics);
    support.amplitude = amplitude_of(deck, "fem", "fix", k, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

}  // namespace tether
