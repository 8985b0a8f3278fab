// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.hpp"
#include "scene/solids_of_deck.hpp"

namespace tether {
namespace {

constexpr const char* plane_hint = "x and y are all there is; with z of the regions in $mesh there are bodies in space";

void refuse(const Deck& deck, const char* name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, "fem", name, at, message, hint));
}

/// The times and factors of load or support k as far as they ascend; what is wrong with them is told.
Amplitude table_of(const Deck& deck, const std::string& what, int k, Diagnostics& diagnostics) {
  const std::string times = what + "_time", factors = what + "_factor";
  Amplitude amplitude;
  for (int i = 1; i <= table_count; ++i) {
    const bool time = deck.given("fem", times, i, k), factor = deck.given("fem", factors, i, k);
    if (time != factor) {
      refuse(deck, (time ? times : factors).c_str(), {i, k},
             fmt::format("{}({},{}) is not given", time ? factors : times, i, k), "each time of a table has its factor",
             diagnostics);
      return {};
    }
    if (!time) continue;
    if (!amplitude.time.empty() && !(deck.real("fem", times, i, k) > amplitude.time.back())) {
      refuse(deck, times.c_str(), {i, k},
             fmt::format("the times of a table ascend: {:.6g} is not behind {:.6g}", deck.real("fem", times, i, k),
                         amplitude.time.back()),
             "write times and factors in order", diagnostics);
      return {};
    }
    amplitude.time.push_back(deck.real("fem", times, i, k));
    amplitude.factor.push_back(deck.real("fem", factors, i, k));
  }
  return amplitude;
}

/// The expression of load or support k in t, or null where it is wrong, which is told.
std::shared_ptr<const Expression> expression_of(const Deck& deck, const std::string& name, int k,
                                                Diagnostics& diagnostics) {
  try {
    return std::make_shared<const Expression>(deck.text("fem", name, k), std::vector<std::string>{"t"});
  } catch (const ExpressionError& error) {
    diagnostics.add(deck.remark_within(Severity::error, "fem", name, {k, 1}, error.at(), error.what(), error.hint()));
    return nullptr;
  }
}

/// The factor of load or support k; where none is given, a static problem's grows in proportion to time.
Amplitude amplitude_of(const Deck& deck, const std::string& what, int k, Diagnostics& diagnostics) {
  Amplitude amplitude = table_of(deck, what, k, diagnostics);
  amplitude.of = fmt::format("{} {}", what == "fix" ? "support" : what, k);
  const std::string name = what + "_expression";
  if (deck.given("fem", name, k)) {
    if (!amplitude.time.empty())
      refuse(deck, name.c_str(), {k, 1}, fmt::format("{} has a table and an expression", amplitude.of),
             fmt::format("leave {}_time and {}_factor away, or this", what, what), diagnostics);
    amplitude.expression = expression_of(deck, name, k, diagnostics);
  } else if (amplitude.time.empty() && deck.logical("fem", "static")) {
    amplitude.time = {0, deck.real("in", "tmax")}, amplitude.factor = {0, 1};
  }
  return amplitude;
}

/// What a user may have meant, or all names there are.
std::string hint_for(const std::string& name, const Mesh& mesh) {
  std::vector<std::string> names;
  for (const auto& side : mesh.sides) names.push_back(side.first);
  const std::string near = nearest_name(name, names);
  const std::string all = fmt::format("The sides of this mesh: {}.", fmt::join(names, ", "));
  return near.empty() ? all : fmt::format("Did you mean '{}'? {}", near, all);
}

/// The sides of that name, or null where the mesh has none, which is told.
const Sides* sides_of(const Deck& deck, const Mesh& mesh, const char* variable, int k, Diagnostics& diagnostics) {
  const std::string name = deck.text("fem", variable, k);
  const auto found = mesh.sides.find(name);
  if (found != mesh.sides.end()) return &found->second;
  refuse(deck, variable, {k, 1}, fmt::format("no side is called '{}'", name), hint_for(name, mesh), diagnostics);
  return nullptr;
}

/// Tells of numbers of loads (or supports) that act on nothing.
void check_all_act(const Deck& deck, const std::string& on, const std::vector<std::string>& others,
                   Diagnostics& diagnostics) {
  std::set<int> told;
  for (const std::string& name : others) {
    const bool listed = find_variable("fem", name)->rank == 1;
    for (const Subscript at : deck.given_elements("fem", name)) {
      const int k = at[listed ? 0 : 1];
      if (deck.given("fem", on, k) || !told.insert(k).second) continue;
      refuse(deck, name.c_str(), at,
             fmt::format("{} {} acts on nothing: {}({}) is not given", on.starts_with("fix") ? "support" : "load", k,
                         on, k),
             fmt::format("{}({}) names a side", on, k), diagnostics);
    }
  }
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
  check_all_act(deck, "load_on", {"load", "load_time", "load_factor", "load_expression"}, diagnostics);
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
      refuse(deck, "load", {3, k}, fmt::format("load {} acts along z, but the mesh is plane", k), plane_hint,
             diagnostics);
    load.amplitude = amplitude_of(deck, "load", k, diagnostics);
    solids.loads.push_back(std::move(load));
  }
}

void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics) {
  check_all_act(deck, "fix_on", {"fix", "fix_time", "fix_factor", "fix_expression"}, diagnostics);
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
             fmt::format("write fix(1,{0})=0,0{1}", k, solids.mesh.dim() == 3 ? ",0" : ""), diagnostics);
    if (solids.mesh.dim() == 2 && support.fixed[2])
      refuse(deck, "fix", {3, k}, fmt::format("support {} holds z, but the mesh is plane", k), plane_hint, diagnostics);
    support.amplitude = amplitude_of(deck, "fix", k, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

}  // namespace tether
