// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/density.hpp"

#include <algorithm>
#include <array>

#include "grid/kernels.hpp"
#include "loops/points.hpp"
#include "physics/points/normals_grid.hpp"

namespace tether::mpm {

CellDensity::CellDensity(const Frame& frame, const Walls& walls, Geometry geometry, DensityRule rule,
                         const Strip* strip)
    : locator_(frame.shape),
      rule_(rule),
      across_(strip ? strip->across : -1),
      column_(folded_axis(AxisOf::cells, frame.shape.cells_x(), frame.left, frame.left + frame.deck.cells_x() - 1,
                          mirrors(walls.left), mirrors(walls.right), 1)),
      row_(folded_axis(AxisOf::cells, frame.shape.cells_y(), frame.bottom, frame.bottom + frame.deck.cells_y() - 1,
                       mirrors(walls.bottom), mirrors(walls.top), column_.size())),
      mass_(column_.size() * row_.size(), 0.0) {
  const BackgroundGrid& shape = frame.shape;
  for (int i = 0; i < shape.cells_x(); ++i) {
    volume_.push_back(depth(geometry, shape.x0 + (i + 0.5) * shape.dx) * (shape.dx * shape.dy));
  }
}

double CellDensity::operator()(int i, int j) const { return mass_[index(i, j)] / volume_[static_cast<std::size_t>(i)]; }

void CellDensity::clear_around(const Points& points, Slots range) {
  for_points(points, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(points.x[p], points.y[p]);
    for (int j = at.j - 1; j <= at.j + 1; ++j) {
      for (int i = at.i - 1; i <= at.i + 1; ++i) mass_[index(i, j)] = 0;
    }
  });
}

void CellDensity::add_cell(const Points& points, Slots range) {
  for_points(points, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(points.x[p], points.y[p]);
    mass_[index(at.i, at.j)] += points.mass[p];  // (4.5)
  });
}

void CellDensity::add_quadratic(const Points& points, Slots range) {
  for_points(points, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(points.x[p], points.y[p]);
    const auto wx = quadratic_weights(at.r - 0.5), wy = quadratic_weights(at.s - 0.5);
    for (int j = 0; j < 3; ++j) {
      const double m = points.mass[p] * wy[static_cast<std::size_t>(j)];
      for (int i = 0; i < 3; ++i)
        mass_[index(at.i + i - 1, at.j + j - 1)] += m * wx[static_cast<std::size_t>(i)];  // (4.6)
    }
  });
}

/// Across a strip the one cell gets all: the ring beyond its walls is itself, and the weights add up to 1.
template <int across>
void CellDensity::add_along_the_strip(const Points& points, Slots range) {
  const std::vector<std::size_t>& cells = across == 1 ? column_ : row_;
  const std::size_t first = across == 1 ? row_[1] : column_[1];
  for_points(points, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(points.x[p], points.y[p]);
    const auto w = quadratic_weights((across == 1 ? at.r : at.s) - 0.5);
    const auto cell = static_cast<std::size_t>(across == 1 ? at.i : at.j);
    for (std::size_t k = 0; k < 3; ++k) mass_[first + cells[cell + k]] += points.mass[p] * w[k];  // (4.6)
  });
}

/// Few cells, as a strip has, are cleared at once.
void CellDensity::clear(const Points& points, const std::vector<Slots>& gas) {
  if (across_ >= 0) return std::fill(mass_.begin(), mass_.end(), 0.0);
  for (const Slots range : gas) clear_around(points, range);
}

void CellDensity::add(const Points& points, Slots range) {
  if (rule_ != DensityRule::quadratic) return add_cell(points, range);
  if (across_ < 0) return add_quadratic(points, range);
  across_ == 1 ? add_along_the_strip<1>(points, range) : add_along_the_strip<0>(points, range);
}

void CellDensity::update(Points& points, const std::vector<Slots>& gas, const std::vector<Slots>& takers) {
  clear(points, gas);
  for (const Slots range : gas) add(points, range);
  for (const Slots range : takers) {
    for_points(points, range, [&](std::size_t p) {
      const CellPlace at = locator_.locate(points.x[p], points.y[p]);
      points.rho[p] = (*this)(at.i, at.j);
    });
  }
}

}  // namespace tether::mpm
