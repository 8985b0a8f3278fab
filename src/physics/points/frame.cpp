// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "grid/kernels.hpp"

namespace tether::mpm {
namespace {

constexpr int room = 6;  // cells beyond an open edge that points may move into

/// Nodes that the kernel needs before a wall's row, or the strip before an edge's.
int padding(Kernel kernel, Wall wall, const Edge& edge) {
  if (edge.open()) return strip_cells + 2;
  if (kernel == Kernel::linear) return 0;
  return wall == Wall::open ? room + 1 : 1;
}

/// Along one axis: padding on both sides and the node numbers of the walls.
struct Axis {
  int nodes, before, after;
  bool fold_low, fold_high;

  struct Side {
    Wall wall;
    const Edge& edge;
  };
  Axis(Kernel kernel, int deck_nodes, Side low, Side high)
      : nodes(deck_nodes + padding(kernel, low.wall, low.edge) + padding(kernel, high.wall, high.edge)),
        before(padding(kernel, low.wall, low.edge)),
        after(padding(kernel, high.wall, high.edge)),
        fold_low(kernel == Kernel::bspline && low.wall != Wall::open),
        fold_high(kernel == Kernel::bspline && high.wall != Wall::open) {}

  int low_wall() const { return before; }
  int high_wall() const { return nodes - 1 - after; }
  bool ghost_low(int i) const { return fold_low && i < low_wall(); }
  bool ghost_high(int i) const { return fold_high && i > high_wall(); }
  int image(int i) const {
    if (ghost_low(i)) return 2 * low_wall() - i;
    return ghost_high(i) ? 2 * high_wall() - i : i;
  }
};

/// Signs of a vector's two components beyond a wall across the axis `normal`.
Pair reflection(Wall wall, int normal) {
  if (wall == Wall::fixed) return pair(-1, -1);
  return normal == 0 ? pair(-1, 1) : pair(1, -1);
}

std::vector<Ghost> ghosts_of(const Axis& x, const Axis& y, const Walls& walls) {
  std::vector<Ghost> ghosts;
  for (int j = 0; j < y.nodes; ++j) {
    for (int i = 0; i < x.nodes; ++i) {
      const int at_i = x.image(i), at_j = y.image(j);
      if (at_i == i && at_j == j) continue;
      Ghost ghost{j * x.nodes + i, at_j * x.nodes + at_i, pair(1, 1)};
      if (x.ghost_low(i)) ghost.sign *= reflection(walls.left, 0);
      if (x.ghost_high(i)) ghost.sign *= reflection(walls.right, 0);
      if (y.ghost_low(j)) ghost.sign *= reflection(walls.bottom, 1);
      if (y.ghost_high(j)) ghost.sign *= reflection(walls.top, 1);
      ghosts.push_back(ghost);
    }
  }
  return ghosts;
}

std::vector<std::uint8_t> held_nodes(const Axis& x, const Axis& y, const Walls& walls) {
  const auto nx = static_cast<std::size_t>(x.nodes), ny = static_cast<std::size_t>(y.nodes);
  std::vector<std::uint8_t> held(nx * ny, holds_none);
  const auto left = static_cast<std::size_t>(x.low_wall()), right = static_cast<std::size_t>(x.high_wall());
  const auto bottom = static_cast<std::size_t>(y.low_wall()), top = static_cast<std::size_t>(y.high_wall());
  for (std::size_t j = 0; j < ny; ++j) {
    held[j * nx + left] |= held_by(walls.left, holds_x);
    held[j * nx + right] |= held_by(walls.right, holds_x);
  }
  for (std::size_t i = 0; i < nx; ++i) {
    held[bottom * nx + i] |= held_by(walls.bottom, holds_y);
    held[top * nx + i] |= held_by(walls.top, holds_y);
  }
  return held;
}

double shape_value(Kernel kernel, double cells) {  // of one node's function, this many cells from it
  const double a = std::abs(cells);
  if (kernel == Kernel::linear) return std::max(0.0, 1 - a);
  return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0.0;
}

/// int N_i w dx over the scene (dy; about an axis 2 pi r dr) with the ghosts' parts at their images. Between the nodes
/// and the cells' middles the integrand is a cubic at most, which two Gauss points a piece integrate exactly.
std::vector<double> integrals(Kernel kernel, const Axis& axis, double first, double h,
                              const std::function<double(double)>& weight) {
  std::vector<double> of(static_cast<std::size_t>(axis.nodes), 0.0);
  const int begin = axis.fold_low ? axis.low_wall() : 0, end = axis.fold_high ? axis.high_wall() : axis.nodes - 1;
  for (int piece = 2 * begin; piece < 2 * end; ++piece) {
    for (const double gauss : {-1.0, 1.0}) {
      const double place = 0.5 * piece + 0.25 * (1 + gauss / std::sqrt(3.0));  // in cells from node 0
      const int nearest = static_cast<int>(std::floor(place + 0.5));
      for (int i = std::max(0, nearest - 1); i <= std::min(axis.nodes - 1, nearest + 1); ++i) {
        of[static_cast<std::size_t>(axis.image(i))] +=
            0.25 * h * weight(first + place * h) * shape_value(kernel, place - i);
      }
    }
  }
  return of;
}

/// The deck's grid with more nodes around it, at the same distances.
BackgroundGrid enlarged(const BackgroundGrid& deck, const Axis& x, const Axis& y) {
  BackgroundGrid grid = deck;
  grid.nx = x.nodes, grid.ny = y.nodes;
  grid.x0 -= x.before * deck.dx, grid.x1 += x.after * deck.dx;
  grid.y0 -= y.before * deck.dy, grid.y1 += y.after * deck.dy;
  return grid;
}

}  // namespace

Frame::Frame(const BackgroundGrid& deck_, const Walls& walls, Geometry geometry, Kernel kernel, const Edges& edges,
             const Strip* strip)
    : deck(deck_) {
  const auto& [left_edge, right_edge, bottom_edge, top_edge] = edges.of;
  const Axis x(kernel, deck.nx, {walls.left, left_edge}, {walls.right, right_edge});
  const Axis y(kernel, deck.ny, {walls.bottom, bottom_edge}, {walls.top, top_edge});
  shape = enlarged(deck, x, y);
  left = x.before, bottom = y.before;
  first_row = 0, last_row = shape.ny - 1;
  const auto margin = [&](Wall wall, const Edge& edge, double h) {
    if (edge.open()) return (strip_cells + 1) * h;
    return kernel == Kernel::bspline && wall == Wall::open ? room * h : 0;
  };
  x0 = deck.x0 - margin(walls.left, left_edge, deck.dx), x1 = deck.x1 + margin(walls.right, right_edge, deck.dx);
  y0 = deck.y0 - margin(walls.bottom, bottom_edge, deck.dy), y1 = deck.y1 + margin(walls.top, top_edge, deck.dy);
  if (geometry == Geometry::axisymmetric) x0 = std::max(x0, 0.0);  // room beyond an open edge ends at the axis
  ghosts = ghosts_of(x, y, walls);
  held = held_nodes(x, y, walls);
  for (std::size_t n = 0; n < held.size(); ++n) {
    if (held[n] != holds_none) at_walls.push_back(n);
  }
  image.resize(shape.nodes());
  std::iota(image.begin(), image.end(), std::uint32_t{0});
  sign.assign(shape.nodes(), {});
  for (const Ghost& ghost : ghosts) {
    image[static_cast<std::size_t>(ghost.node)] = static_cast<std::uint32_t>(ghost.image);
    sign[static_cast<std::size_t>(ghost.node)] = {static_cast<std::int8_t>(ghost.sign[0]),
                                                  static_cast<std::int8_t>(ghost.sign[1])};
  }
  // Nodes of the room may lie beyond the axis, where no point comes but whose functions reach back.
  const auto width = integrals(kernel, x, shape.x0, deck.dx, [&](double r) { return depth(geometry, std::abs(r)); });
  const auto height = integrals(kernel, y, shape.y0, deck.dy, [](double) { return 1.0; });
  const auto nx = static_cast<std::size_t>(shape.nx);
  per_volume.reserve(image.size());
  for (const std::size_t n : image) per_volume.push_back(1 / (width[n % nx] * height[n / nx]));
  if (strip && strip->across == 1) leave_out_ghosts_across();
}

/// Half way between two walls a spline's third node has neither weight nor slope, but for the square of rounding and
/// rounding: the rows beyond a strip along x stay as they are, zero. Along y they are columns, which stand among the
/// eights of neighbours that are worked on together.
void Frame::leave_out_ghosts_across() {
  first_row = bottom, last_row = bottom + deck.ny - 1;
  std::erase_if(ghosts, [&](const Ghost& ghost) { return ghost.node / shape.nx != ghost.image / shape.nx; });
}

Pair Frame::before_walls(std::size_t n, Pair place) const {
  if (image[n] == n) return place;
  const auto nx = static_cast<std::size_t>(shape.nx);
  const std::size_t i = n % nx, j = n / nx, at_i = image[n] % nx, at_j = image[n] / nx;
  // The wall is half way between ghost and image.
  if (i != at_i) place[0] = 2 * shape.x0 + static_cast<double>(i + at_i) * shape.dx - place[0];
  if (j != at_j) place[1] = 2 * shape.y0 + static_cast<double>(j + at_j) * shape.dy - place[1];
  return place;
}

}  // namespace tether::mpm
