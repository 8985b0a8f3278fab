// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "base/diagnostics.hpp"
#include "model/scene.hpp"

namespace tether {

/// The points of a string or membrane, in order.
struct StringPoints {
  std::span<const double> x, y;
  bool closed = false;
};

/// How far neighbours stand from one another, along the axis where that is more cells. Neighbours that share no node of
/// the background grid feel nothing of each other where the strain is measured at points.
struct StringGaps {
  double widest = 0;          // [cells]
  std::size_t widest_at = 0;  // the first of the two points, from 0
  std::size_t apart = 0;      // neighbours that share no node
  std::size_t first_apart = 0;
};
StringGaps string_gaps(const BackgroundGrid& grid, Kernel kernel, const StringPoints& points);

/// Distance of neighbours from which they may come to share no node as they move, and of an end from the wall that its
/// string runs to from which the wall's nodes hold little of it [cells].
constexpr double widest_sound_gap = 1, widest_sound_end = 0.5;

/// An end of a string that runs to a wall.
struct StringEnd {
  const char* name = nullptr;  // the wall's; none where there is no such wall
  int side = 0;                // left, right, bottom, top
  Wall wall = Wall::open;
  double cells = 0;  // from it
};
/// The last point's, or with `first` the first one's: the wall that the string would meet within one and a half cells
/// if it went on.
StringEnd string_end(const BackgroundGrid& grid, const Walls& walls, const StringPoints& points, bool first);

/// The end of a body's string that needs its wall: none where it is pinned or closed, and at a wall that mirrors, where
/// an element goes on beyond it, none but where fluid minds the gap.
StringEnd end_at_wall(const Scene& scene, const Body& body, const StringPoints& points, bool first);
/// How far a place is from the wall of an end [cells].
double cells_off(const BackgroundGrid& grid, const StringEnd& end, double x, double y);

/// What is to be said of a body of points at the start: an error, or a warning, or nothing.
struct GapRemark {
  Severity severity = Severity::warning;
  std::size_t point = 0;  // in the body, from 0
  std::string message, hint;
};
/// Lists the gaps of a string or membrane; the other paths need no grid to hold one together.
std::vector<GapRemark> gap_remarks(const Scene& scene, const Body& body);

}  // namespace tether
