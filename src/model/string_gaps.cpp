// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/string_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "grid/kernels.hpp"

namespace tether {
namespace {

constexpr double slack = 1e-9;  // of a number of cells
/// From a wall further away than this the points of a string's end get nothing [cells].
constexpr double reach_of_walls = 1.5;

/// Two cells of a kernel have nodes in common where they are no further apart than this.
template <class K>
constexpr int reach = K::size == 4 ? 1 : 2;

template <class K>
StringGaps gaps_by(const BackgroundGrid& grid, const StringPoints& points) {
  const Locator locator(grid);
  const std::size_t n = points.x.size();
  StringGaps gaps;
  const auto look = [&](std::size_t a, std::size_t b) {
    const double across = std::abs(points.x[b] - points.x[a]) * locator.per_dx;
    const double up = std::abs(points.y[b] - points.y[a]) * locator.per_dy;
    const double cells = std::max(across, up);
    if (cells > gaps.widest) gaps.widest = cells, gaps.widest_at = a;
    if (cells <= widest_sound_gap) return;
    const auto here = K::locate(locator, points.x[a], points.y[a]),
               there = K::locate(locator, points.x[b], points.y[b]);
    if (std::abs(there.i - here.i) <= reach<K> && std::abs(there.j - here.j) <= reach<K>) return;
    if (gaps.apart++ == 0) gaps.first_apart = a;
  };
  for (std::size_t p = 0; p + 1 < n; ++p) look(p, p + 1);
  if (points.closed && n > 2) look(n - 1, 0);
  return gaps;
}

StringPoints points_of(const Scene& scene, const Body& body) {
  const std::span<const double> x(scene.points.x), y(scene.points.y);
  return {x.subspan(body.first, body.count), y.subspan(body.first, body.count), body.closed};
}

bool has_fluid(const Scene& scene) { return find_body<IdealGas>(scene) || find_body<LinearFluid>(scene); }

void remark_gaps(const Scene& scene, const Body& body, std::vector<GapRemark>& remarks) {
  const StringGaps gaps = string_gaps(scene.grid, scene.method.kernel, points_of(scene, body));
  const bool of_points = scene.method.membrane_strain == MembraneStrain::point;
  if (gaps.apart > 0 && of_points) {
    remarks.push_back({Severity::error, gaps.first_apart,
                       fmt::format("points {} and {} share no node of the grid: {} of {} neighbours do not, and the "
                                   "string does not hold together there",
                                   gaps.first_apart + 1, (gaps.first_apart + 1) % body.count + 1, gaps.apart,
                                   body.count - (body.closed ? 0 : 1)),
                       "half a cell between points is good, one cell is the most"});
    return;
  }
  if (gaps.widest <= widest_sound_gap + slack || !(of_points || has_fluid(scene))) return;
  remarks.push_back({Severity::warning, gaps.widest_at,
                     fmt::format("points {} and {} are {:.3g} cells apart: {}", gaps.widest_at + 1,
                                 (gaps.widest_at + 1) % body.count + 1, gaps.widest,
                                 of_points ? "as they move they can come to share no node, and the string comes apart"
                                           : "fluid passes between points more than a cell apart"),
                     "half a cell between points is good, one cell is the most"});
}

void remark_ends(const Scene& scene, const Body& body, std::vector<GapRemark>& remarks) {
  for (const bool first : {true, false}) {
    const StringEnd end = end_at_wall(scene, body, points_of(scene, body), first);
    if (!end.name || end.cells <= widest_sound_end + slack) continue;
    remarks.push_back(
        {Severity::warning, first ? 0 : body.count - 1,
         fmt::format("its {} point stands {:.3g} of a cell off the {} wall, whose nodes hold little of "
                     "it: the string comes off, and fluid passes there",
                     first ? "first" : "last", end.cells, end.name),
         "begin within half a cell of the wall, or pin the point and write strain='element' in $membrane"});
  }
}

}  // namespace

StringGaps string_gaps(const BackgroundGrid& grid, Kernel kernel, const StringPoints& points) {
  return kernel == Kernel::linear ? gaps_by<LinearKernel>(grid, points) : gaps_by<SplineKernel>(grid, points);
}

StringEnd string_end(const BackgroundGrid& grid, const Walls& walls, const StringPoints& points, bool first) {
  const std::size_t n = points.x.size(), p = first ? 0 : n - 1, q = first ? 1 : n - 2;
  const double x = points.x[p], y = points.y[p];
  const double across = (x - points.x[q]) / grid.dx, up = (y - points.y[q]) / grid.dy;
  const double length = std::hypot(across, up);
  StringEnd nearest{nullptr, 0, Wall::open, std::numeric_limits<double>::infinity()};
  // `towards`: cells towards the wall that the string runs in a cell's length of its own.
  const auto look = [&](const char* name, int side, Wall wall, double towards) {
    const double cells = cells_off(grid, {name, side, wall, 0}, x, y);
    const bool meets = towards > 0 && cells <= reach_of_walls * towards;
    if (wall != Wall::open && wall != Wall::axis && meets && cells < nearest.cells) nearest = {name, side, wall, cells};
  };
  if (!(length > 0)) return nearest;
  look("left", 0, walls.left, -across / length);
  look("right", 1, walls.right, across / length);
  look("bottom", 2, walls.bottom, -up / length);
  look("top", 3, walls.top, up / length);
  return nearest;
}

double cells_off(const BackgroundGrid& grid, const StringEnd& end, double x, double y) {
  const double cells[] = {(x - grid.x0) / grid.dx, (grid.x1 - x) / grid.dx, (y - grid.y0) / grid.dy,
                          (grid.y1 - y) / grid.dy};
  return cells[end.side];
}

StringEnd end_at_wall(const Scene& scene, const Body& body, const StringPoints& points, bool first) {
  if (body.closed || body.count < 2 || is_pinned(scene, body.first + (first ? 0 : body.count - 1))) return {};
  const StringEnd end = string_end(scene.grid, scene.walls, points, first);
  const bool element = scene.method.membrane_strain == MembraneStrain::element;
  if (end.name && mirrors(end.wall) && (element || !has_fluid(scene))) return {};
  return end;
}

std::vector<GapRemark> gap_remarks(const Scene& scene, const Body& body) {
  std::vector<GapRemark> remarks;
  if (scene.path() != Path::mpm) return remarks;
  remark_gaps(scene, body, remarks);
  remark_ends(scene, body, remarks);
  return remarks;
}

}  // namespace tether
