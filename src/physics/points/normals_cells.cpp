// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/normals_cells.hpp"

#include <algorithm>
#include <tuple>

#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// The first of the two cells that are nearest to a place along one axis. Where there is neither a cell nor an image
/// behind the edge, the two at the edge.
int first_of_two(int cell, double r, int cells, bool mirror_low, bool mirror_high) {
  const int first = r < 0.5 ? cell - 1 : cell;
  if (first < 0 && !mirror_low) return 0;
  return first > cells - 2 && !mirror_high ? std::max(cells - 2, 0) : first;
}

/// Number of the cell that is seen at `cell`, which is one behind an edge at the most: itself, its image's, or -1.
int seen_at(int cell, int cells, bool mirror_low, bool mirror_high) {
  if (cell < 0) return mirror_low ? 0 : -1;
  if (cell >= cells) return mirror_high ? cells - 1 : -1;
  return cell;
}

/// Returns where a place of that cell is seen, counted in cells from the edge.
double seen_place(double place, int cell, int cells) {
  if (cell < 0) return -place;
  return cell >= cells ? 2 * cells - place : place;
}

}  // namespace

MembraneCells::MembraneCells(const BackgroundGrid& shape, const Walls& walls, std::size_t most_points)
    : shape_(shape),
      left_(mirrors(walls.left)),
      right_(mirrors(walls.right)),
      bottom_(mirrors(walls.bottom)),
      top_(mirrors(walls.top)) {
  members_.reserve(most_points);
  cells_.reserve(std::min(most_points, shape.cells()));
}

void MembraneCells::sort(const PlaceArrays& places, Range membrane) {
  const Locator locator(shape_);
  members_.clear();
  for_points(membrane, [&](std::size_t p) { members_.push_back({locator.locate(places.x[p], places.y[p]), p}); });
  std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) {
    return std::tie(a.at.j, a.at.i, a.point) < std::tie(b.at.j, b.at.i, b.point);
  });
  cells_.clear();
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const CellPlace& at = members_[k].at;
    if (cells_.empty() || cells_.back().i != at.i || cells_.back().j != at.j) cells_.push_back({at.i, at.j, k, k});
    cells_.back().end = k + 1;
  }
}

const MembraneCells::Cell* MembraneCells::find(int i, int j) const {
  const auto before = [](const Cell& cell, const std::pair<int, int>& to) { return std::pair(cell.j, cell.i) < to; };
  const auto at = std::lower_bound(cells_.begin(), cells_.end(), std::pair(j, i), before);
  return at != cells_.end() && at->i == i && at->j == j ? &*at : nullptr;
}

void MembraneCells::ghost_places(const Cell& cell, std::vector<LocalPlace>& places) const {
  const int cells_x = shape_.cells_x(), cells_y = shape_.cells_y();
  const CellPlace& near = members(cell).front().at;
  const int i = first_of_two(near.i, near.r, cells_x, left_, right_);
  const int j = first_of_two(near.j, near.s, cells_y, bottom_, top_);
  places.clear();
  const auto add_seen_at = [&](int at_i, int at_j, const Cell& held) {
    for (const auto& [at, point] : members(held)) {
      const double x = seen_place(at.i + at.r, at_i, cells_x), y = seen_place(at.j + at.s, at_j, cells_y);
      places.push_back({0.5 * (x - i), 0.5 * (y - j)});
    }
  };
  add_seen_at(cell.i, cell.j, cell);
  for (const int at_j : {j, j + 1}) {
    for (const int at_i : {i, i + 1}) {
      const Cell* held = find(seen_at(at_i, cells_x, left_, right_), seen_at(at_j, cells_y, bottom_, top_));
      if (held && !(at_i == cell.i && at_j == cell.j)) add_seen_at(at_i, at_j, *held);
    }
  }
}

template <class Color>
CellMatrixNormals<Color>::CellMatrixNormals(const BackgroundGrid& shape, const Walls& walls, LonePoint alone,
                                            std::size_t most_points)
    : dx_(shape.dx), dy_(shape.dy), alone_(alone), cells_(shape, walls, most_points) {
  places_.reserve(4 * most_points);  // a ghost cell may hold images
  gradients_.reserve(4 * most_points);
}

template <class Color>
void CellMatrixNormals<Color>::update(const PlaceArrays& places, Range membrane, const Tangents& tangents) {
  cells_.sort(places, membrane);
  for (const Cell& cell : cells_.cells()) fit_cell(cell, tangents);
}

template <class Color>
void CellMatrixNormals<Color>::fit_cell(const Cell& cell, const Tangents& tangents) {
  const auto members = cells_.members(cell);
  places_.clear();
  for (const auto& [at, point] : members) places_.push_back({at.r, at.s});
  const NearestLine line = nearest_line(places_, dx_, dy_);
  if (line.one_place()) {
    if (alone_ == LonePoint::ghost) fit_ghost(cell, tangents);
    return;
  }
  gradients_.resize(places_.size());
  fit_gradients<Color>(places_, extra_point(line, dx_, dy_).at, gradients_);
  for (std::size_t k = 0; k < members.size(); ++k) {
    turn_across(tangents, members[k].point, gradients_[k] / pair(dx_, dy_), 0);
  }
}

/// The ghost cell's fit has linear shape functions, whatever the cells' (7.7); only the points of `cell` take its
/// normals. Where the membrane has no other point in the four cells, the tangents of before stay.
template <class Color>
void CellMatrixNormals<Color>::fit_ghost(const Cell& cell, const Tangents& tangents) {
  cells_.ghost_places(cell, places_);
  const NearestLine line = nearest_line(places_, 2 * dx_, 2 * dy_);
  if (line.one_place()) return;
  gradients_.resize(places_.size());
  fit_gradients<LinearColor>(places_, extra_point(line, 2 * dx_, 2 * dy_).at, gradients_);
  const auto members = cells_.members(cell);
  for (std::size_t k = 0; k < members.size(); ++k) {
    turn_across(tangents, members[k].point, gradients_[k] / pair(dx_, dy_), 0);
  }
}

template class CellMatrixNormals<LinearColor>;
template class CellMatrixNormals<QuadraticColor>;

}  // namespace tether::mpm
