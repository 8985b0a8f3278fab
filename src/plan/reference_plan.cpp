// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/reference_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/hung_string.hpp"
#include "reference/riemann.hpp"

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

namespace {

/// Part of a period by which what a solution leaves out may change it without a word.
constexpr double told_part = 1e-3;
/// Strain from which a pendulum's string is said to be too soft: the square of it is left out.
constexpr double told_stretch = 0.02;

std::string arrival(const char* end, double begin) {
  if (begin == 0) return fmt::format("the {} end sends waves from the start", end);
  if (std::isinf(begin)) return fmt::format("no wave reaches the {} end", end);
  return fmt::format("the first wave reaches the {} end at t = {:.4g}", end, begin);
}

std::string riemann_text(const Scene& scene) {
  const RiemannTube tube = riemann_tube(scene);
  const TubePart part = compared_part(scene, tube, scene.clock.tmax);
  return fmt::format("'riemann', of an endless tube: {}, {}; compared from x = {:.4g} to {:.4g} at t = {:.4g}",
                     arrival("left", tube.left_begins()), arrival("right", tube.right_begins()), part.from, part.to,
                     scene.clock.tmax);
}

std::string string_text(const Scene& scene, const char* name, const char* own_mass) {
  const HungString string = hung_string(scene);
  return fmt::format(
      "'{}': {:.4g} long from ({:.4g}, {:.4g}), where it is held, to the mass; its own mass, {:.3g} of "
      "that at its end, {}",
      name, string.length, string.x, string.y, string.string_mass / string.mass, own_mass);
}

std::string text_of(const Scene& scene) {
  switch (scene.reference) {
    case ReferenceKind::riemann:
      return riemann_text(scene);
    case ReferenceKind::spring:
      return string_text(scene, "spring", "is spread along it");
    case ReferenceKind::string:
      return string_text(scene, "string", "is left out");
    case ReferenceKind::pendulum:
      return string_text(scene, "pendulum", "is spread along it; it is as long as the mass at rest stretches it");
    case ReferenceKind::piston:
      return string_text(scene, "piston", "is left out");
    case ReferenceKind::radial_gas:
      return "'radial-gas': a cylinder of gas in endless vacuum";
    case ReferenceKind::thin_ring:
      return "'thin-ring': the circle in which the membrane rests when no energy is lost";
    case ReferenceKind::none:
      break;
  }
  return "";
}

/// Warns of a tube whose ends have sent waves into it before the run ends.
std::vector<std::string> riemann_warnings(const Scene& scene) {
  const RiemannTube tube = riemann_tube(scene);
  const double first = std::min(tube.left_begins(), tube.right_begins());
  const TubePart part = compared_part(scene, tube, scene.clock.tmax);
  if (scene.reference_window || first >= scene.clock.tmax) return {};
  return {
      fmt::format("the exact solution is that of an endless tube, and waves come from the ends of this one from t = "
                  "{:.4g} on: at t = {:.4g} it is compared from x = {:.4g} to {:.4g} alone",
                  first, scene.clock.tmax, part.from, part.to)};
}

/// Returns whether elements act between the points, the first of which nothing joins to the wall.
bool is_loose(const Scene& scene) {
  return scene.path() == Path::mpm && scene.method.membrane_strain == MembraneStrain::element && scene.pinned.empty();
}

std::vector<std::string> string_warnings(const Scene& scene) {
  std::vector<std::string> warnings;
  if (is_loose(scene)) {
    warnings.push_back(fmt::format(
        "the exact solution takes the string as held where its line meets the wall, but elements join its points alone "
        "and the first one slides in its cell: pin it (points.pinned(1)=.true.)"));
  }
  const HungString string = hung_string(scene);
  // Rayleigh: a third of a spring's mass swings with the mass.
  const double late = string.string_mass / string.mass / 6;
  if (scene.reference == ReferenceKind::string && late > told_part) {
    warnings.push_back(fmt::format(
        "the exact solution takes the string without mass: what it has makes its times about {:.2g} % longer",
        100 * late));
  }
  const double stretch = string.mass * -scene.gravity / string.stiffness / string.length;
  if (scene.reference == ReferenceKind::pendulum && stretch > told_stretch) {
    warnings.push_back(
        fmt::format("the exact solution takes the string as long as the mass at rest stretches it, by {:.2g} %: it is "
                    "not for strings "
                    "that stretch by more than {:.2g} %",
                    100 * stretch, 100 * told_stretch));
  }
  return warnings;
}

}  // namespace

std::vector<Term> reference_terms(const Scene& scene) {
  if (scene.reference == ReferenceKind::none) return {};
  try {
    return {{"exact solution", true, text_of(scene)}};
  } catch (const std::domain_error& error) {
    return {{"exact solution", false, error.what()}};
  }
}

std::vector<std::string> reference_warnings(const Scene& scene) {
  try {
    switch (scene.reference) {
      case ReferenceKind::riemann:
        return riemann_warnings(scene);
      case ReferenceKind::spring:
      case ReferenceKind::string:
      case ReferenceKind::pendulum:
        return string_warnings(scene);
      default:
        return {};
    }
  } catch (const std::domain_error& error) {
    return {fmt::format("there will be no comparison with the exact solution: {}", error.what())};
  }
}

}  // namespace tether
