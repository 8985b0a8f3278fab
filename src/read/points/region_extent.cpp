// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/region_extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace tether {
namespace {

/// Lines across a region, shared among the parts between heights at which its outline may turn, and those of each part.
constexpr int lines_in_all = 512, fewest_lines = 16, most_lines = 256;

struct Stretch {
  double from, to;  // in x [length]
};
using Stretches = std::vector<Stretch>;  // in their order, apart

/// Returns where the line of this height runs inside the polygon.
Stretches inside(const Polygon& polygon, double y) {
  std::vector<double> crossings;
  for (std::size_t k = 0, before = polygon.x.size() - 1; k < polygon.x.size(); before = k++) {
    const double xa = polygon.x[before], ya = polygon.y[before], xb = polygon.x[k], yb = polygon.y[k];
    if ((ya > y) != (yb > y)) crossings.push_back(xa + (y - ya) * (xb - xa) / (yb - ya));
  }
  std::sort(crossings.begin(), crossings.end());
  Stretches found;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) found.push_back({crossings[k], crossings[k + 1]});
  return found;
}

/// Half the length of the line within an ellipse; below 0 where it passes by.
double half_chord(const Ellipse& ellipse, double y) {
  if (!(ellipse.a > 0) || !(ellipse.b > 0)) return -1;
  const double v = (y - ellipse.yc) / ellipse.b;
  return v * v < 1 ? ellipse.a * std::sqrt(1 - v * v) : -1;
}

Stretches common(const Stretches& one, const Stretches& other) {
  Stretches found;
  for (const Stretch& a : one) {
    for (const Stretch& b : other) {
      const Stretch both{std::max(a.from, b.from), std::min(a.to, b.to)};
      if (both.to > both.from) found.push_back(both);
    }
  }
  return found;
}

Stretches inside(const RegionShape& shape, double y) {
  Stretches found = inside(shape.polygon, y);
  const double outer = half_chord(shape.outer, y), inner = half_chord(shape.inner, y);
  if (outer < 0) return {};
  found = common(found, {{shape.outer.xc - outer, shape.outer.xc + outer}});
  if (inner < 0) return found;
  constexpr double far = std::numeric_limits<double>::infinity();
  return common(found, {{-far, shape.inner.xc - inner}, {shape.inner.xc + inner, far}});
}

/// Heights at which an outline may turn or begin: between them its width is smooth, but where sides cross.
void add_turns(const RegionShape& shape, std::vector<double>& turns) {
  turns.insert(turns.end(), shape.polygon.y.begin(), shape.polygon.y.end());
  for (const Ellipse& ellipse : {shape.outer, shape.inner})
    turns.insert(turns.end(), {ellipse.yc - ellipse.b, ellipse.yc + ellipse.b});
}

/// Those within the box that all shapes and the grid share, in their order, each once; none where there is no such box.
std::vector<double> common_turns(std::span<const RegionShape* const> shapes, const BackgroundGrid& grid) {
  double left = grid.x0, right = grid.x1, low = grid.y0, high = grid.y1;
  std::vector<double> turns;
  for (const RegionShape* shape : shapes) {
    const auto [x0, x1] = std::ranges::minmax(shape->polygon.x);
    const auto [y0, y1] = std::ranges::minmax(shape->polygon.y);
    const Ellipse& outer = shape->outer;
    left = std::max({left, x0, outer.xc - outer.a}), right = std::min({right, x1, outer.xc + outer.a});
    low = std::max({low, y0, outer.yc - outer.b}), high = std::min({high, y1, outer.yc + outer.b});
    add_turns(*shape, turns);
  }
  if (!(left < right) || !(low < high)) return {};
  turns.insert(turns.end(), {low, high});
  std::erase_if(turns, [&](double turn) { return turn < low || turn > high; });
  std::sort(turns.begin(), turns.end());
  turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
  return turns;
}

/// The integral over what all shapes share, by strips between two turns with the width in the middle of each: exact
/// where that is linear in y. Strips are thin next to both turns, where the width of an ellipse is a square root: their
/// ends are y = middle - half cos(pi s) for s in equal parts of 0 to 1.
Extent extent_of(std::span<const RegionShape* const> shapes, const BackgroundGrid& grid, Geometry geometry) {
  const std::vector<double> turns = common_turns(shapes, grid);
  const int lines =
      std::clamp(lines_in_all / std::max(1, static_cast<int>(turns.size()) - 1), fewest_lines, most_lines);
  Extent extent;
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const double middle = 0.5 * (turns[k] + turns[k + 1]), half = 0.5 * (turns[k + 1] - turns[k]);
    const auto end = [&](int line) { return middle - half * std::cos(std::numbers::pi * line / lines); };
    for (int line = 0; line < lines; ++line) {
      const double y = 0.5 * (end(line) + end(line + 1)), height = end(line + 1) - end(line);
      Stretches there{{grid.x0, grid.x1}};
      for (const RegionShape* shape : shapes) there = common(there, inside(*shape, y));
      for (const Stretch& part : there) {
        const double area = height * (part.to - part.from);
        extent.area += area, extent.volume += area * depth(geometry, 0.5 * (part.from + part.to));
      }
    }
  }
  return extent;
}

}  // namespace

Extent drawn_extent(const RegionShape& shape, const BackgroundGrid& grid, Geometry geometry) {
  const std::array shapes{&shape};
  return extent_of(shapes, grid, geometry);
}

Extent shared_extent(const RegionShape& one, const RegionShape& other, const BackgroundGrid& grid, Geometry geometry) {
  const std::array shapes{&one, &other};
  return extent_of(shapes, grid, geometry);
}

}  // namespace tether
