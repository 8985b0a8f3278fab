// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scene/solids_of_deck.hpp"

namespace tether {
namespace {

void refuse(const Deck& deck, const char* name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, "fem", name, at, message, hint));
}

/// The table of load or support k; where there is none, a static problem's grows in proportion to time.
Amplitude amplitude_of(const Deck& deck, const std::string& what, int k, Diagnostics& diagnostics) {
  const std::string times = what + "_time", factors = what + "_factor";
  Amplitude amplitude;
  for (int i = 1; i <= table_count && deck.given("fem", times, i, k); ++i) {
    if (!deck.given("fem", factors, i, k)) {
      refuse(deck, times.c_str(), {i, k}, fmt::format("{}({},{}) is not given", factors, i, k),
             "each time of a table has its factor", diagnostics);
      return {};
    }
    amplitude.time.push_back(deck.real("fem", times, i, k));
    amplitude.factor.push_back(deck.real("fem", factors, i, k));
    if (i > 1 && !(amplitude.time.back() > amplitude.time[amplitude.time.size() - 2])) {
      refuse(deck, times.c_str(), {i, k}, "the times of a table ascend", "write them in order", diagnostics);
      return {};
    }
  }
  if (amplitude.time.empty() && deck.logical("fem", "static")) return {{0, deck.real("in", "tmax")}, {0, 1}};
  return amplitude;
}

std::string names_of(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& side : mesh.sides) names.push_back(side.first);
  return fmt::format("sides of this mesh: {}", fmt::join(names, ", "));
}

/// The sides of that name, or null where the mesh has none, which is told.
const Sides* sides_of(const Deck& deck, const Mesh& mesh, const char* variable, int k, Diagnostics& diagnostics) {
  const std::string name = deck.text("fem", variable, k);
  const auto found = mesh.sides.find(name);
  if (found != mesh.sides.end()) return &found->second;
  refuse(deck, variable, {k, 1}, fmt::format("no side is called '{}'", name), names_of(mesh), diagnostics);
  return nullptr;
}

/// Adds the nodes of a mesh that stand on the line x_axis = place, held there as a wall of this kind does.
void add_wall(const Mesh& mesh, std::size_t axis, double place, double size, Wall wall, Solids& solids) {
  if (wall == Wall::open) return;
  const auto dim = static_cast<std::size_t>(mesh.dim());
  Support support;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (std::abs(mesh.x[n * dim + axis] - place) <= 1e-9 * size) support.nodes.push_back(static_cast<int>(n));
  }
  if (wall == Wall::fixed) {
    support.fixed = {true, true, dim == 3};
  } else {
    support.fixed[axis] = true;
  }
  if (!support.nodes.empty()) solids.supports.push_back(std::move(support));
}

}  // namespace

void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  for (const Subscript at : deck.given_elements("fem", "load_on")) {
    const int k = at[0];
    Load load;
    const std::string on = deck.text("fem", "load_on", k);
    if (on.starts_with("region ")) {
      const auto named = std::find_if(solids.regions.begin(), solids.regions.end(),
                                      [&](const SolidRegion& region) { return region.name == on; });
      load.region = static_cast<int>(named - solids.regions.begin());
      if (named == solids.regions.end()) {
        refuse(deck, "load_on", at, fmt::format("there is no {}", on), "regions are 1 to nreg", diagnostics);
        continue;
      }
    } else if (const Sides* sides = sides_of(deck, solids.mesh, "load_on", k, diagnostics)) {
      load.sides = *sides;
    }
    for (int i = 1; i <= 3; ++i) load.force[static_cast<std::size_t>(i - 1)] = deck.real("fem", "load", i, k);
    if (solids.mesh.dim() == 2 && load.force[2] != 0)
      refuse(deck, "load", {3, k}, "a plane mesh has no z", "give z of the regions in $mesh", diagnostics);
    load.amplitude = amplitude_of(deck, "load", k, diagnostics);
    solids.loads.push_back(std::move(load));
  }
}

void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics) {
  const BackgroundGrid& grid = scene.grid;
  const double width = grid.x1 - grid.x0, height = grid.y1 - grid.y0;
  add_wall(solids.mesh, 0, grid.x0, width, scene.walls.left, solids);
  add_wall(solids.mesh, 0, grid.x1, width, scene.walls.right, solids);
  add_wall(solids.mesh, 1, grid.y0, height, scene.walls.bottom, solids);
  add_wall(solids.mesh, 1, grid.y1, height, scene.walls.top, solids);
  for (const Subscript at : deck.given_elements("fem", "fix_on")) {
    const int k = at[0];
    const Sides* sides = sides_of(deck, solids.mesh, "fix_on", k, diagnostics);
    if (!sides) continue;
    Support support;
    support.nodes = *sides;
    std::sort(support.nodes.begin(), support.nodes.end());
    support.nodes.erase(std::unique(support.nodes.begin(), support.nodes.end()), support.nodes.end());
    for (int i = 1; i <= 3; ++i) {
      const auto axis = static_cast<std::size_t>(i - 1);
      support.fixed[axis] = deck.given("fem", "fix", i, k);
      if (support.fixed[axis]) support.displacement[axis] = deck.real("fem", "fix", i, k);
    }
    if (support.fixed == std::array<bool, 3>{})
      refuse(deck, "fix_on", at, fmt::format("support {} holds no direction", k),
             fmt::format("write fix(1:2,{})=0,0", k), diagnostics);
    support.amplitude = amplitude_of(deck, "fix", k, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

}  // namespace tether
