// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/bar_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether {
namespace {

/// What a step of one node and its bar costs on a machine of 2020's make; only for the estimate [s].
constexpr double seconds_per_node_step = 9e-9;
/// A node's state and masses, its bar, and the same again in a checkpoint of them.
constexpr double bytes_per_bar_node = 30 * sizeof(double);

std::string bars_reason(const BarMesh& mesh) {
  const auto by_section = [](const Bar& a, const Bar& b) { return a.section < b.section; };
  const auto [thin, thick] = std::minmax_element(mesh.bars.begin(), mesh.bars.end(), by_section);
  return fmt::format("{} with two nodes, sections {:.4g} to {:.4g} by the points' volumes", mesh.bars.size(),
                     thin->section, thick->section);
}

std::string one_end(const WallEnd& end) {
  const char* moves = end.slides ? ", and slides along" : "";
  if (end.length == 0) return fmt::format("point {} is held at the {} wall{}", end.point + 1, end.wall, moves);
  return fmt::format("a bar of {:.4g} joins point {} to the {} wall{}", end.length, end.point + 1, end.wall, moves);
}

std::string ends_reason(const BarMesh& mesh) {
  std::string text;
  for (const WallEnd& end : mesh.wall_ends) text += (text.empty() ? "" : "; ") + one_end(end);
  return text;
}

}  // namespace

StepRule bar_step_rule(const Scene& scene, const BarMesh& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  StepRule rule;
  rule.deck_step = scene.clock.tstep;
  rule.cfl = scene.clock.cfl;
  rule.h = std::min(scene.grid.dx, scene.grid.dy);
  const double highest = highest_frequency(scene, mesh);
  rule.element_limit = highest > 0 ? 2 / highest : infinity;
  rule.limit_name = "2/omega";
  rule.first_limit = rule.limit(0);
  rule.sharp_limit = infinity;
  return rule;
}

std::vector<Term> bar_terms(const Scene& scene, const BarMesh& mesh) {
  const bool ends = !mesh.wall_ends.empty();
  return {
      {"bars", true, bars_reason(mesh)},
      {"strain", true, "change of length over the length at the start, with that of the points' stress at the start"},
      {"mass", true, "the points', lumped at the nodes"},
      {"time", true, "central differences"},
      {"gravity", scene.gravity != 0,
       scene.gravity != 0 ? fmt::format("gravc = {:.6g} in y", scene.gravity) : "gravc = 0"},
      {"pins", !scene.pinned.empty(),
       scene.pinned.empty() ? "no point is pinned" : fmt::format("hold {} points", scene.pinned.size())},
      {"ends at walls", ends, ends ? ends_reason(mesh) : "no string would meet a wall on less than another spacing"},
      {"walls elsewhere", false, "bars feel them at their ends only"},
      {"contact", false, "bars do not feel each other"},
      {"bending", false, "bars turn freely at their nodes"},
      {"grid", false, "bars need none: its edges are the walls"},
      {"third dimension", false, "the scene is plane, one unit deep"},
  };
}

Cost bar_cost(const Scene& scene, const BarMesh& mesh, const StepRule& rule) {
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.first_step() * (1 - 1e-9));
  cost.point_steps = cost.steps * static_cast<double>(scene.points.size());
  cost.megabytes = 1e-6 * bytes_per_bar_node * static_cast<double>(scene.points.size() + mesh.anchors.size());
  cost.seconds = cost.point_steps * seconds_per_node_step;
  return cost;
}

}  // namespace tether
