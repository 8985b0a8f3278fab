// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/flow_paths.hpp"

#include <limits>

namespace tether::coupled {
namespace {

std::uint16_t joins_of_cell(const FlowDomain& domain, const std::array<int, 3>& cell) {
  unsigned bits = 0;
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (int side = 0; side < 2; ++side) {
      auto face = cell;
      face[a] += side;
      const FaceKind kind = domain.face[a][domain.grid.face(axis, face)];
      const bool inside = face[a] > 0 && face[a] < domain.grid.n[a];
      if (kind == FaceKind::open && inside) bits |= 1U << (2 * axis + side);
      if (kind == FaceKind::closed) bits |= 1U << (2 * axis + side + 6);
    }
  }
  return static_cast<std::uint16_t>(bits);
}

// Steps to the cells that come before a cell in number, of those around it.
std::vector<std::ptrdiff_t> earlier_around(const StaggeredGrid& grid) {
  const auto row = static_cast<std::ptrdiff_t>(grid.cell(0, 1, 0)),
             layer = static_cast<std::ptrdiff_t>(grid.cell(0, 0, 1));
  std::vector<std::ptrdiff_t> steps;
  for (std::ptrdiff_t k = grid.dim == 3 ? -1 : 0; k <= 0; ++k) {
    for (std::ptrdiff_t j = -1; j <= 1; ++j) {
      for (std::ptrdiff_t i = -1; i <= 1; ++i) {
        if (k < 0 || (k == 0 && (j < 0 || (j == 0 && i < 0)))) steps.push_back(i + row * j + layer * k);
      }
    }
  }
  return steps;
}

// Of cells that are 0 or not, the number of layers of such as are not 0 that each has around it, with itself: by one
// pass upwards and one downwards. Cells at the box's sides are 0.
void count_layers(const StaggeredGrid& grid, std::vector<std::uint8_t>& layers) {
  const std::vector<std::ptrdiff_t> earlier = earlier_around(grid);
  const auto pass = [&](std::size_t c, std::ptrdiff_t sign) {
    if (layers[c] == 0) return;
    int least = std::numeric_limits<std::uint8_t>::max() - 1;
    for (const std::ptrdiff_t step : earlier)
      least = std::min<int>(least, layers[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(c) + sign * step)]);
    layers[c] = static_cast<std::uint8_t>(std::min<int>(layers[c], least + 1));
  };
  for (std::size_t c = 0; c < layers.size(); ++c) pass(c, 1);
  for (std::size_t c = layers.size(); c-- > 0;) pass(c, -1);
}

}  // namespace

CellJoins::CellJoins(const FlowDomain& domain) : bits_(domain.grid.cell_count()), room_(bits_.size()) {
  const StaggeredGrid& grid = domain.grid;
  const unsigned all = (1U << (2 * grid.dim)) - 1;
  std::size_t c = 0;
  for (int k = 0; k < grid.n[2]; ++k) {
    for (int j = 0; j < grid.n[1]; ++j) {
      for (int i = 0; i < grid.n[0]; ++i, ++c) {
        bits_[c] = joins_of_cell(domain, {i, j, k});
        room_[c] = bits_[c] == all ? std::numeric_limits<std::uint8_t>::max() : 0;
      }
    }
  }
  count_layers(grid, room_);
  for (std::uint8_t& room : room_) room = room > 0 ? static_cast<std::uint8_t>(room - 1) : 0;  // without itself
}

}  // namespace tether::coupled
