// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/string_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "scene/string_gaps.hpp"

namespace tether::mpm {
namespace {

/// The points of a membrane, whose slots stay in their order.
StringPoints points_of(const State& state, std::size_t b, bool closed) {
  const Range range = state.ranges[b];
  const std::span<const double> x(state.points.x), y(state.points.y);
  return {x.subspan(range.begin, range.end - range.begin), y.subspan(range.begin, range.end - range.begin), closed};
}

std::string text_of(const State& state, const Scene& scene, std::size_t b, std::size_t k, const char* what) {
  const Body& body = scene.bodies[b];
  const std::size_t p = state.ranges[b].begin + k;
  return fmt::format("t = {:.6g}: body {}, {}: points {} and {} at ({:.6g}, {:.6g}) {}: use more points", state.time,
                     b + 1, body.name, k + 1, (k + 1) % body.count + 1, state.points.x[p], state.points.y[p], what);
}

}  // namespace

std::optional<std::string> watch_strings(State& state, const Scene& scene) {
  const bool of_points = scene.method.membrane_strain == MembraneStrain::point;
  const bool fluid = find_body<IdealGas>(scene) || find_body<LinearFluid>(scene);
  std::optional<std::string> text;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material)) continue;
    const StringGaps gaps = string_gaps(state.grid.frame.shape, scene.method.kernel, points_of(state, b, body.closed));
    state.widest_gap = std::max(state.widest_gap, gaps.widest);
    if (state.gap_told) continue;
    if (of_points && gaps.apart > 0) {
      text = text_of(state, scene, b, gaps.first_apart,
                     "share no node any more, and the string does not hold together there");
    } else if (!of_points && fluid && gaps.widest > widest_sound_gap) {
      text = text_of(state, scene, b, gaps.widest_at, "are more than a cell apart, and fluid passes between them");
    }
    state.gap_told = text.has_value();
  }
  return text;
}

}  // namespace tether::mpm
