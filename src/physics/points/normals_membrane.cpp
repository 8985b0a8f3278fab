// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/normals_membrane.hpp"

#include <algorithm>
#include <limits>

namespace tether::mpm {
namespace {

constexpr std::size_t no_number = std::numeric_limits<std::size_t>::max();

/// Adds weight row^T row, and value row to the right-hand side.
template <std::size_t n>
void add_square(const std::array<double, n>& row, double weight, std::array<std::array<double, n>, n>& block) {
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b <= a; ++b) block[a][b] += weight * row[a] * row[b];
  }
}

}  // namespace

template <class Color>
MembraneMatrixNormals<Color>::MembraneMatrixNormals(const BackgroundGrid& shape, const Walls& walls,
                                                    std::size_t most_points)
    : shape_(shape), cells_(shape, walls, most_points) {
  const std::size_t most_cells = std::min(most_points, shape.cells()), most = most_cells * Color::count;
  for (auto* list : {&keys_, &numbers_, &first_}) list->reserve(most);
  order_.reserve(most_cells);
  reached_.reserve(most_cells);
  unknowns_.reserve(most_cells);
  factors_.reserve(most_cells);
  gradients_.reserve(most_points);
  colors_.reserve(most);
  cell_places_.reserve(most_points);
  ghost_places_.reserve(4 * most_points);  // images, too
  matrix_.reserve(most, 16 * most);        // a curve's; rows grow where a membrane is crumpled into many cells
  for (const Row& bend : Color::bends) add_square(bend, softest.bend, stiffness_);
  for (const Row& twist : Color::twists) add_square(twist, softest.twist, stiffness_);
}

template <class Color>
void MembraneMatrixNormals<Color>::update(const PlaceArrays& places, Range membrane, const Tangents& tangents) {
  cells_.sort(places, membrane);
  number_unknowns();
  set_profile();
  const auto cells = cells_.cells();
  factors_.assign(cells.size(), 1.0);
  solve(tangents);
  for (int round = 0; round < most_rounds && stiffen_what_turns_round(); ++round) solve(tangents);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    gradients_of(c);
    const auto members = cells_.members(cells[c]);
    for (std::size_t k = 0; k < members.size(); ++k) {
      turn_across(tangents, members[k].point, gradients_[k] / pair(shape_.dx, shape_.dy), 0);
    }
  }
}

/// (7.12) for the present stiffness of the cells.
template <class Color>
void MembraneMatrixNormals<Color>::solve(const Tangents& tangents) {
  matrix_.shape(first_);
  colors_.assign(numbered_, 0.0);
  for (std::size_t c = 0; c < unknowns_.size(); ++c) assemble(c, tangents);
  matrix_.factor();
  matrix_.solve(colors_);
}

/// Returns whether there is a cell to make stiffer; see fit_gradients().
template <class Color>
bool MembraneMatrixNormals<Color>::stiffen_what_turns_round() {
  bool any = false;
  for (std::size_t c = 0; c < factors_.size(); ++c) {
    gradients_of(c);
    if (go_together(gradients_)) continue;
    factors_[c] *= stiffer;
    any = true;
  }
  return any;
}

template <class Color>
auto MembraneMatrixNormals<Color>::keys_of(const Cell& cell) const -> Unknowns {
  const auto stride = static_cast<std::size_t>(shape_.cells_x()) + 2;  // quadratic colours stand behind the edges, too
  Unknowns keys;
  for (std::size_t k = 0; k < Color::count; ++k) {
    keys[k] = static_cast<std::size_t>(cell.j + Color::steps[k][1]) * stride +
              static_cast<std::size_t>(cell.i + Color::steps[k][0]);
  }
  return keys;
}

/// Numbers the colours in the order in which a walk from cell to neighbouring cell comes by: their rows stay short.
template <class Color>
void MembraneMatrixNormals<Color>::number_unknowns() {
  const auto cells = cells_.cells();
  keys_.clear();
  for (const Cell& cell : cells) {
    for (const std::size_t key : keys_of(cell)) keys_.push_back(key);
  }
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  numbers_.assign(keys_.size(), no_number);
  reached_.assign(cells.size(), 0);
  unknowns_.resize(cells.size());
  order_.clear();
  numbered_ = 0;
  for (std::size_t seed = 0; seed < cells.size(); ++seed) visit_around(seed);
}

template <class Color>
void MembraneMatrixNormals<Color>::visit_around(std::size_t seed) {
  const auto cells = cells_.cells();
  const auto reach = [&](std::size_t c) {
    if (!reached_[c]) order_.push_back(c);
    reached_[c] = 1;
  };
  std::size_t next = order_.size();
  reach(seed);
  for (; next < order_.size(); ++next) {
    const Cell& cell = cells[order_[next]];
    number(order_[next]);
    for (int j = cell.j - 1; j <= cell.j + 1; ++j) {
      for (int i = cell.i - 1; i <= cell.i + 1; ++i) {
        const Cell* neighbour = cells_.find(i, j);
        if (neighbour) reach(static_cast<std::size_t>(neighbour - cells.data()));
      }
    }
  }
}

template <class Color>
void MembraneMatrixNormals<Color>::number(std::size_t cell) {
  const Unknowns keys = keys_of(cells_.cells()[cell]);
  for (std::size_t k = 0; k < Color::count; ++k) {
    const auto at = std::lower_bound(keys_.begin(), keys_.end(), keys[k]) - keys_.begin();
    std::size_t& of_key = numbers_[static_cast<std::size_t>(at)];
    if (of_key == no_number) of_key = numbered_++;
    unknowns_[cell][k] = of_key;
  }
}

template <class Color>
void MembraneMatrixNormals<Color>::set_profile() {
  first_.resize(numbered_);
  for (std::size_t u = 0; u < numbered_; ++u) first_[u] = u;
  for (const Unknowns& unknowns : unknowns_) {
    const std::size_t least = *std::min_element(unknowns.begin(), unknowns.end());
    for (const std::size_t u : unknowns) first_[u] = std::min(first_[u], least);
  }
}

template <class Color>
void MembraneMatrixNormals<Color>::assemble(std::size_t c, const Tangents& tangents) {
  const Cell& cell = cells_.cells()[c];
  const Unknowns& unknowns = unknowns_[c];
  Block block = stiffness_;
  for (Row& row : block) {
    for (double& entry : row) entry *= factors_[c];
  }
  Row right{};
  cell_places_.clear();
  for (const auto& member : cells_.members(cell)) {
    cell_places_.push_back({member.at.r, member.at.s});
    add_square(Color::weights(cell_places_.back()), 1, block);  // (7.11); the membrane's colour is 0
  }
  add_extra(cell, tangents, block, right);
  for (std::size_t a = 0; a < Color::count; ++a) {
    colors_[unknowns[a]] += right[a];
    for (std::size_t b = 0; b <= a; ++b) {
      matrix_.at(std::max(unknowns[a], unknowns[b]), std::min(unknowns[a], unknowns[b])) += block[a][b];
    }
  }
}

/// The line nearest to a cell's points. Where they show no direction it has that of the ghost cell's.
template <class Color>
NearestLine MembraneMatrixNormals<Color>::line_of(const Cell& cell) {
  NearestLine line = nearest_line(cell_places_, shape_.dx, shape_.dy);
  if (!line.one_place()) return line;
  cells_.ghost_places(cell, ghost_places_);
  const LocalPlace middle = line.middle;
  line = nearest_line(ghost_places_, 2 * shape_.dx, 2 * shape_.dy);
  line.middle = middle;
  return line;
}

/// The point of another colour. Where not even a ghost cell shows a line, the tangent of before is to stay: the point
/// stands off it, and the colour is not to change along it.
template <class Color>
void MembraneMatrixNormals<Color>::add_extra(const Cell& cell, const Tangents& tangents, Block& block, Row& right) {
  NearestLine line = line_of(cell);
  double left_x = 0, left_y = 0;
  for (const auto& [at, point] : cells_.members(cell)) left_x -= tangents.y[point], left_y += tangents.x[point];
  if (line.one_place()) {
    const double length = std::hypot(left_x, left_y);
    if (length > 0) line.nx = left_x / length, line.ny = left_y / length;
    const auto slopes = Color::slopes(line.middle);
    Row along;
    for (std::size_t k = 0; k < Color::count; ++k) {
      along[k] = line.ny * slopes[k][0] * shape_.dy - line.nx * slopes[k][1] * shape_.dx;
    }
    add_square(along, 1 / (shape_.dx * shape_.dy), block);
  }
  const ExtraPoint extra = extra_point(line, shape_.dx, shape_.dy);
  const double color = line.nx * left_x + line.ny * left_y < 0 ? -extra.height : extra.height;
  const Row weights = Color::weights(extra.at);
  add_square(weights, 1, block);                                                  // (7.11)
  for (std::size_t k = 0; k < Color::count; ++k) right[k] += weights[k] * color;  // (7.10)
}

template <class Color>
void MembraneMatrixNormals<Color>::gradients_of(std::size_t c) {
  Row colors;
  for (std::size_t k = 0; k < Color::count; ++k) colors[k] = colors_[unknowns_[c][k]];
  gradients_.clear();
  for (const auto& member : cells_.members(cells_.cells()[c])) {
    gradients_.push_back(color_gradient<Color>(colors, {member.at.r, member.at.s}));
  }
}

template class MembraneMatrixNormals<LinearColor>;
template class MembraneMatrixNormals<QuadraticColor>;

}  // namespace tether::mpm
