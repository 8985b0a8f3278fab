// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/watches.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "grid/outline.hpp"
#include "loops/points.hpp"
#include "physics/points/point_laws.hpp"

namespace tether::mpm {
namespace {

/// The edge of the grid at which a membrane ends, left, right, bottom, top; -1 where there is none within half a cell
/// of its end, which lies half a piece beyond its last point.
int side_at(const BackgroundGrid& grid, const Vec<2>& at, const Vec<2>& before) {
  const double half_a_piece = 0.5 * std::hypot((at[0] - before[0]) / grid.dx, (at[1] - before[1]) / grid.dy);
  const double cells[] = {(at[0] - grid.x0) / grid.dx, (grid.x1 - at[0]) / grid.dx, (at[1] - grid.y0) / grid.dy,
                          (grid.y1 - at[1]) / grid.dy};
  const auto nearest = std::min_element(std::begin(cells), std::end(cells));
  return *nearest <= 0.5 + half_a_piece ? static_cast<int>(nearest - std::begin(cells)) : -1;
}

/// Distance of a place from the piece between two others.
double distance(const Vec<2>& a, const Vec<2>& b, const Vec<2>& at) {
  const double x = b[0] - a[0], y = b[1] - a[1], squared = x * x + y * y;
  const double part = squared > 0 ? std::clamp(((at[0] - a[0]) * x + (at[1] - a[1]) * y) / squared, 0.0, 1.0) : 0;
  return std::hypot(at[0] - a[0] - part * x, at[1] - a[1] - part * y);
}

}  // namespace

LeakWatch::LeakWatch(const Scene& scene, const State& state) : deep_(0.5 * std::min(scene.grid.dx, scene.grid.dy)) {
  if (!find_body<IdealGas>(scene)) return;
  const Points& P = state.points;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material) || body.count < 3) continue;
    Corners points;
    for_points(state.ranges[b].full(), [&](std::size_t p) { points.push_back({P.x[p], P.y[p]}); });
    Parting parting{b, -1, -1, {}};
    if (!body.closed) {
      parting.first_side = side_at(scene.grid, points.front(), points[1]);
      parting.last_side = side_at(scene.grid, points.back(), points[points.size() - 2]);
      if (parting.first_side < 0 || parting.last_side < 0) continue;
    }
    const Outline around(closed(parting, scene.grid, std::move(points)));
    parting.inside.resize(scene.bodies.back().first + scene.bodies.back().count);
    for_points(P, Slots{0, P.size()}, [&](std::size_t p) {
      const auto number = static_cast<std::size_t>(P.id[p]);  // strips have points that are not the scene's
      if (number < parting.inside.size()) parting.inside[number] = around.holds({P.x[p], P.y[p]}) ? 1 : 0;
    });
    walls_.push_back(std::move(parting));
  }
}

/// Closes the membrane along edges of the grid, far enough off that no point lies beyond.
LeakWatch::Corners LeakWatch::closed(const Parting& parting, const BackgroundGrid& grid, Corners points) {
  const int first = parting.first_side, last = parting.last_side;
  if (first == last) return points;
  const double far = (grid.x1 - grid.x0) + (grid.y1 - grid.y0);
  const auto beyond = [&](int side, Vec<2> at) {
    if (side == 0) at[0] = grid.x0 - far;
    if (side == 1) at[0] = grid.x1 + far;
    if (side == 2) at[1] = grid.y0 - far;
    if (side == 3) at[1] = grid.y1 + far;
    return at;
  };
  const bool across = (first < 2) == (last < 2);  // from an edge to the opposite one
  const int round = first < 2 ? 3 : 1;
  const Vec<2> start = beyond(first, points.front()), end = beyond(last, points.back());
  points.push_back(end);
  points.push_back(across ? beyond(round, end) : beyond(first, end));
  if (across) points.push_back(beyond(round, start));
  points.push_back(start);
  return points;
}

std::size_t LeakWatch::passed(const Parting& parting, const State& state, const Scene& scene) const {
  const Points& P = state.points;
  Corners points;
  for_points(state.ranges[parting.body].full(), [&](std::size_t p) { points.push_back({P.x[p], P.y[p]}); });
  const std::size_t pieces = points.size() - (scene.bodies[parting.body].closed ? 0 : 1), count = points.size();
  const Outline around(closed(parting, scene.grid, std::move(points)));
  const Corners& corners = around.corners();
  std::size_t passed = 0;
  for (const Slots range : state.gas) {
    for_points(P, range, [&](std::size_t p) {
      const auto number = static_cast<std::size_t>(P.id[p]);
      const Vec<2> at{P.x[p], P.y[p]};
      if (number >= parting.inside.size() || around.holds(at) == (parting.inside[number] != 0)) return;
      double nearest = 2 * deep_;
      for (std::size_t k = 0; k < pieces; ++k)
        nearest = std::min(nearest, distance(corners[k], corners[(k + 1) % count], at));
      passed += nearest > deep_;
    });
  }
  return passed;
}

void LeakWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  std::size_t all = 0;
  for (const Parting& parting : walls_) {
    const std::size_t here = passed(parting, state, scene);
    all += here;
    if (here == 0 || !note_warning(state.warned, PointDoubt::leak)) continue;
    messages.push_back(fmt::format(
        "t = {:.6g}: body {}, {}: gas seeps through it: points of gas half a cell and more beyond the side that they "
        "began on: {}: use more points and smaller cells, or method='robust' of $mpm",
        state.time, parting.body + 1, scene.bodies[parting.body].name, here));
  }
  state.gas_leaked = static_cast<long long>(all);
}

namespace {

/// Distance of neighbours from which the stress begins to scatter from point to point [cells]. Measured on a column
/// that hangs under its own weight, on 10 to 40 cells: neighbours that begin half a cell apart and are stretched to
/// 0.63 leave an error of 1.3 per cent instead of 0.3 to 0.5, at 0.75 of 3 to 6, which cells do not mend.
constexpr double doubtful_distance = 0.6;

/// Distance of the neighbours of a point along its body's lattice, in cells of the grid along either axis.
double apart(const Points& P, std::size_t p, const Scene& scene) {
  const Unfolding unfolding(scene.strip.get());
  const double volume = P.volume[p] * unfolding.share(unfolding.first_of(static_cast<std::size_t>(P.id[p])));
  const double s = std::sqrt(volume / depth(scene.geometry, P.x[p] / P.fzz[p]));  // at the start, r = R fzz
  return s * std::max(std::max(std::abs(P.fxx[p]), std::abs(P.fxy[p])) / scene.grid.dx,
                      std::max(std::abs(P.fyx[p]), std::abs(P.fyy[p])) / scene.grid.dy);
}

}  // namespace

void StretchWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  const Points& P = state.points;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!std::holds_alternative<FiniteElastic>(scene.bodies[b].material)) continue;
    std::optional<std::size_t> far;
    for_points(P, state.ranges[b], [&](std::size_t p) {
      if (!far || apart(P, p, scene) > apart(P, *far, scene)) far = p;
    });
    if (!far) continue;
    const std::size_t widest = *far;
    const double cells = apart(P, widest, scene);
    state.points_apart = std::max(state.points_apart, cells);
    if (cells <= doubtful_distance || !note_warning(state.warned, PointDoubt::apart)) continue;
    messages.push_back(fmt::format(
        "t = {:.6g}: body {}, {}: points at ({:.6g}, {:.6g}) are stretched {:.3g} cells apart: their stress "
        "scatters, and beyond a cell the body comes apart: use more points in a cell (nprg)",
        state.time, b + 1, scene.bodies[b].name, P.x[widest], P.y[widest], cells));
  }
}

namespace {

/// From its wall, of an end that began at it: the wall's nodes hold little of a point further away [cells].
constexpr double off_the_wall = 0.75;

/// The points of a membrane, whose slots stay in their order.
StringPoints points_of(const State& state, std::size_t b, bool closed) {
  const Range range = state.ranges[b].full();
  const std::span<const double> x(state.points.x), y(state.points.y);
  return {x.subspan(range.begin, range.end - range.begin), y.subspan(range.begin, range.end - range.begin), closed};
}

std::string text_of(const State& state, const Scene& scene, std::size_t b, std::size_t k, const char* what) {
  const Body& body = scene.bodies[b];
  const std::size_t p = state.ranges[b].begin + k;
  return fmt::format("t = {:.6g}: body {}, {}: points {} and {} at ({:.6g}, {:.6g}) {}: use more points", state.time,
                     b + 1, body.name, k + 1, (k + 1) % body.count + 1, state.points.x[p], state.points.y[p], what);
}

/// Says what there is to say of neighbours.
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

StringWatch::StringWatch(const Scene& scene, const State& state) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<Membrane>(body.material)) continue;
    on_ = true;
    for (const bool first : {true, false}) {
      const StringEnd end = end_at_wall(scene, body, points_of(state, b, body.closed), first);
      // The deck's remarks report what is too far away at the start.
      if (end.name && end.cells <= widest_sound_end) ends_.push_back({b, first ? 0 : body.count - 1, end});
    }
  }
}

void StringWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!std::holds_alternative<Membrane>(scene.bodies[b].material)) continue;
    std::string text = gap_text(state, scene, b);
    if (!text.empty() && note_warning(state.warned, PointDoubt::gap)) messages.push_back(std::move(text));
  }
  if (!is_warned(state.warned, PointDoubt::end)) look_at_ends(state, scene, messages);
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
    note_warning(state.warned, PointDoubt::end);
    return;
  }
}

}  // namespace tether::mpm
