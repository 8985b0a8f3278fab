// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/string_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace tether::mpm {
namespace {

/// From its wall, of an end that began at it: the wall's nodes hold little of a point further away [cells].
constexpr double off_the_wall = 0.75;

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

/// What there is to say of neighbours.
std::string gap_text(State& state, const Scene& scene, std::size_t b) {
  const bool of_points = scene.method.membrane_strain == MembraneStrain::point;
  const bool fluid = find_body<IdealGas>(scene) || find_body<LinearFluid>(scene);
  const StringGaps gaps =
      string_gaps(state.grid.frame.shape, scene.method.kernel, points_of(state, b, scene.bodies[b].closed));
  state.widest_gap = std::max(state.widest_gap, gaps.widest);
  if (of_points && gaps.apart > 0)
    return text_of(state, scene, b, gaps.first_apart,
                   "share no node any more, and the string does not hold together there");
  if (!of_points && fluid && gaps.widest > widest_sound_gap)
    return text_of(state, scene, b, gaps.widest_at, "are more than a cell apart, and fluid passes between them");
  return "";
}

}  // namespace

StringWatch::StringWatch(const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material)) continue;
    on_ = true;
    for (const bool first : {true, false}) {
      const StringEnd end = end_at_wall(scene, body, first);
      // What is too far away at the start the deck's remarks tell.
      if (end.name && end.cells <= widest_sound_end) ends_.push_back({b, first ? 0 : body.count - 1, end});
    }
  }
}

void StringWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!std::holds_alternative<Membrane>(scene.bodies[b].material)) continue;
    std::string text = gap_text(state, scene, b);
    if (text.empty() || state.gap_told) continue;
    state.gap_told = true;
    messages.push_back(std::move(text));
  }
  if (!state.end_told) look_at_ends(state, scene, messages);
}

void StringWatch::look_at_ends(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  for (const End& end : ends_) {
    const std::size_t p = state.ranges[end.body].begin + end.point;
    const double x = state.points.x[p], y = state.points.y[p], cells = cells_off(scene.grid, end.at, x, y);
    if (cells <= off_the_wall) continue;
    messages.push_back(fmt::format(
        "t = {:.6g}: body {}, {}: its {} point at ({:.6g}, {:.6g}) has come {:.3g} of a cell off the {} wall, whose "
        "nodes hold little of it: the string comes off, and fluid passes there: pin the point and write "
        "strain='element' in $membrane, or use more points",
        state.time, end.body + 1, scene.bodies[end.body].name, end.point == 0 ? "first" : "last", x, y, cells,
        end.at.name));
    state.end_told = true;
    return;
  }
}

}  // namespace tether::mpm
