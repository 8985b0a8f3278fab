// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/normals_grid.hpp"

#include <algorithm>
#include <array>

#include "grid/kernels.hpp"
#include "loops/points.hpp"

namespace tether::mpm {
namespace {

double least_slope(const BackgroundGrid& shape) { return least_color_slope / std::max(shape.dx, shape.dy); }

/// A node on a wall that mirrors gets from the images what it gets from the points: twice the sum, and no component
/// across the wall.
std::vector<double> sides(int nodes, bool mirror_low, bool mirror_high) {
  std::vector<double> of(static_cast<std::size_t>(nodes), 1.0);
  if (mirror_low) of.front() = 2;
  if (mirror_high) of.back() = 2;
  return of;
}

/// Calls `with(i, j, N)` for the four nodes of a cell.
template <class With>
void at_corners(const CellPlace& at, const With& with) {
  const LinearShape shape(at);
  with(at.i, at.j, shape.N[0]);
  with(at.i + 1, at.j, shape.N[1]);
  with(at.i + 1, at.j + 1, shape.N[2]);
  with(at.i, at.j + 1, shape.N[3]);
}

}  // namespace

CellColor::CellColor(const BackgroundGrid& shape, const Walls& walls)
    : locator_(shape),
      column_(folded_axis(AxisOf::cells, shape.cells_x(), 0, shape.cells_x() - 1, mirrors(walls.left),
                          mirrors(walls.right), 1)),
      row_(folded_axis(AxisOf::cells, shape.cells_y(), 0, shape.cells_y() - 1, mirrors(walls.bottom),
                       mirrors(walls.top), column_.size())),
      color_(column_.size() * row_.size()) {}

void CellColor::add(const PlaceArrays& places, std::size_t p) {
  const CellPlace at = locator_.locate(places.x[p], places.y[p]);
  const auto wx = quadratic_weights(at.r - 0.5), wy = quadratic_weights(at.s - 0.5);
  const auto i = static_cast<std::size_t>(at.i), j = static_cast<std::size_t>(at.j);
  for (std::size_t b = 0; b < 3; ++b) {
    for (std::size_t a = 0; a < 3; ++a) color_.add(column_[i + a] + row_[j + b], wx[a] * wy[b]);  // (7.4), (9.10)
  }
}

Pair CellColor::gradient(int i, int j) const {
  const double sw = cell(i - 1, j - 1), se = cell(i, j - 1), nw = cell(i - 1, j), ne = cell(i, j);
  return pair(0.5 * (se - sw + ne - nw) * locator_.per_dx, 0.5 * (nw - sw + ne - se) * locator_.per_dy);
}

double CellColor::around(int i, int j) const {
  return cell(i - 1, j - 1) + cell(i, j - 1) + cell(i - 1, j) + cell(i, j);
}

ColorNormals::ColorNormals(const BackgroundGrid& shape, const Walls& walls)
    : locator_(shape),
      least_(least_slope(shape)),
      sides_x_(sides(shape.nx, mirrors(walls.left), mirrors(walls.right))),
      sides_y_(sides(shape.ny, mirrors(walls.bottom), mirrors(walls.top))),
      sums_(shape.nodes()) {}

void ColorNormals::add(const PlaceArrays& places, Slots range) {
  for_points(places, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(places.x[p], places.y[p]);
    const LinearGradient G(at, locator_.per_dx, locator_.per_dy);
    const auto slopes = G.minus_divergence(pair(-1, 0), pair(0, -1));
    const std::size_t n = locator_.lower_left_node(at), nx = static_cast<std::size_t>(locator_.nx);
    const std::array<std::size_t, 4> nodes{n, n + 1, n + nx + 1, n + nx};
    for (std::size_t k = 0; k < 4; ++k) sums_.add(nodes[k], slopes[k]);  // (7.2)
  });
}

Pair ColorNormals::normal(int i, int j) const {
  const double across = sides_x_[static_cast<std::size_t>(i)], up = sides_y_[static_cast<std::size_t>(j)];
  const Pair sum = sums_[locator_.lower_left_node({i, j, 0, 0})];
  return sum * pair((2 - across) * up, across * (2 - up));
}

void ColorNormals::update(const PlaceArrays& places, Range membrane, std::span<const Slots> others,
                          const Tangents& tangents) {
  sums_.clear();
  add(places, membrane);
  for (const Slots range : others) add(places, range);
  for_points(membrane, [&](std::size_t p) {
    Pair gradient{};
    at_corners(locator_.locate(places.x[p], places.y[p]),
               [&](int i, int j, double N) { gradient += N * normal(i, j); });  // (7.3)
    turn_across(tangents, p, gradient, least_);
  });
}

QuadraticNormals::QuadraticNormals(const BackgroundGrid& shape, const Walls& walls)
    : locator_(shape), least_(least_slope(shape)), color_(shape, walls) {}

void QuadraticNormals::update(const PlaceArrays& places, Range membrane, std::span<const Slots> others,
                              const Tangents& tangents) {
  color_.clear();
  const auto add = [&](std::size_t p) { color_.add(places, p); };
  for_points(membrane, add);
  for (const Slots range : others) for_points(places, range, add);
  for_points(membrane, [&](std::size_t p) {
    Pair gradient{};
    at_corners(locator_.locate(places.x[p], places.y[p]),
               [&](int i, int j, double N) { gradient += N * color_.gradient(i, j); });  // (7.3)
    turn_across(tangents, p, gradient, least_);
  });
}

CubicNormals::CubicNormals(const BackgroundGrid& shape, const Walls& walls)
    : locator_(shape),
      least_(least_slope(shape)),
      column_(folded_axis(AxisOf::nodes, shape.nx, 0, shape.nx - 1, mirrors(walls.left), mirrors(walls.right), 1)),
      row_(folded_axis(AxisOf::nodes, shape.ny, 0, shape.ny - 1, mirrors(walls.bottom), mirrors(walls.top),
                       column_.size())),
      sides_x_(sides(shape.nx, mirrors(walls.left), mirrors(walls.right))),
      sides_y_(sides(shape.ny, mirrors(walls.bottom), mirrors(walls.top))),
      color_(column_.size() * row_.size()) {
  // By place, like column_ and row_: a node behind a wall has no place of its own, or no image.
  sides_x_.insert(sides_x_.begin(), 1.0), sides_x_.push_back(1.0);
  sides_y_.insert(sides_y_.begin(), 1.0), sides_y_.push_back(1.0);
}

void CubicNormals::add(const PlaceArrays& places, Slots range) {
  for_points(places, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(places.x[p], places.y[p]);
    const auto wx = cubic_weights(at.r), wy = cubic_weights(at.s);
    const auto i = static_cast<std::size_t>(at.i), j = static_cast<std::size_t>(at.j);
    for (std::size_t b = 0; b < 4; ++b) {
      const std::size_t row = row_[j + b];
      const double in_row = wy[b] * sides_y_[row / column_.size()];
      for (std::size_t a = 0; a < 4; ++a) {
        const std::size_t column = column_[i + a];
        color_.add(column + row, wx[a] * sides_x_[column] * in_row);  // (7.6)
      }
    }
  });
}

Pair CubicNormals::gradient(const CellPlace& at) const {
  const auto wx = cubic_weights(at.r), wy = cubic_weights(at.s), dx = cubic_slopes(at.r), dy = cubic_slopes(at.s);
  const auto i = static_cast<std::size_t>(at.i), j = static_cast<std::size_t>(at.j);
  Pair sum{};
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a < 4; ++a)
      sum += color_[column_[i + a] + row_[j + b]] * pair(dx[a] * wy[b], wx[a] * dy[b]);  // (7.7)
  }
  return sum * pair(locator_.per_dx, locator_.per_dy);
}

void CubicNormals::update(const PlaceArrays& places, Range membrane, std::span<const Slots> others,
                          const Tangents& tangents) {
  color_.clear();
  add(places, membrane);
  for (const Slots range : others) add(places, range);
  for_points(membrane, [&](std::size_t p) {
    turn_across(tangents, p, gradient(locator_.locate(places.x[p], places.y[p])), least_);
  });
}

}  // namespace tether::mpm
