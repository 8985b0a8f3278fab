// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/stretch_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solvers/mpm/point_laws.hpp"

namespace tether::mpm {
namespace {

/// Distance of neighbours from which the stress begins to scatter from point to point [cells]. Measured on a column
/// that hangs under its own weight, on 10 to 40 cells: neighbours that begin half a cell apart and are stretched to .63
/// leave an error of 1.3 per cent instead of .3 to .5, at .75 of 3 to 6, which cells do not mend.
constexpr double doubtful_distance = 0.6;

/// Distance of the neighbours of a point along its body's lattice, in cells of the grid along either axis.
double apart(const Points& P, std::size_t p, const Scene& scene) {
  const double s = std::sqrt(P.volume[p] / depth(scene.geometry, P.x[p] / P.fzz[p]));  // at the start, r = R fzz
  return s * std::max(std::max(std::abs(P.fxx[p]), std::abs(P.fxy[p])) / scene.grid.dx,
                      std::max(std::abs(P.fyx[p]), std::abs(P.fyy[p])) / scene.grid.dy);
}

}  // namespace

void StretchWatch::look(State& state, const Scene& scene, std::vector<std::string>& messages) const {
  const Points& P = state.points;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!std::holds_alternative<FiniteElastic>(scene.bodies[b].material)) continue;
    std::size_t widest = state.ranges[b].begin;
    for (std::size_t p = widest; p < state.ranges[b].end; ++p) {
      if (apart(P, p, scene) > apart(P, widest, scene)) widest = p;
    }
    const double cells = apart(P, widest, scene);
    state.points_apart = std::max(state.points_apart, cells);
    if (cells <= doubtful_distance || state.apart_told) continue;
    state.apart_told = true;
    messages.push_back(fmt::format(
        "t = {:.6g}: body {}, {}: points at ({:.6g}, {:.6g}) are stretched {:.3g} cells apart: their stress "
        "scatters, and beyond a cell the body comes apart: use more points in a cell (nprg)",
        state.time, b + 1, scene.bodies[b].name, P.x[widest], P.y[widest], cells));
  }
}

}  // namespace tether::mpm
