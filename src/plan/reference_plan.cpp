// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/reference_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/hung_string.hpp"
#include "reference/riemann_tube.hpp"

namespace tether {
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

/// Of a tube whose ends have sent waves into it before the run ends.
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

/// By elements between the points, the first of which nothing joins to the wall.
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
