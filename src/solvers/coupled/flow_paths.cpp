// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/flow_paths.hpp"

namespace tether::coupled {
namespace {

constexpr std::uint16_t clear_bit = 1U << 15;

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

// Leaves clear the cells whose two neighbours along the axis are so, too.
void clear_along(const StaggeredGrid& grid, int axis, std::vector<std::uint8_t>& clear) {
  const auto a = static_cast<std::size_t>(axis);
  const std::vector<std::uint8_t> before = clear;
  const std::size_t stride = axis == 0   ? 1
                             : axis == 1 ? static_cast<std::size_t>(grid.n[0])
                                         : static_cast<std::size_t>(grid.n[0]) * static_cast<std::size_t>(grid.n[1]);
  const auto n = static_cast<std::size_t>(grid.n[a]);
  for (std::size_t c = 0; c < clear.size(); ++c) {
    const std::size_t i = c / stride % n;
    clear[c] = before[c] && i > 0 && before[c - stride] && i + 1 < n && before[c + stride];
  }
}

}  // namespace

CellJoins::CellJoins(const FlowDomain& domain) : bits_(domain.grid.cell_count()) {
  const StaggeredGrid& grid = domain.grid;
  const unsigned all = (1U << (2 * grid.dim)) - 1;
  std::vector<std::uint8_t> clear(bits_.size());
  std::size_t c = 0;
  for (int k = 0; k < grid.n[2]; ++k) {
    for (int j = 0; j < grid.n[1]; ++j) {
      for (int i = 0; i < grid.n[0]; ++i, ++c) {
        bits_[c] = joins_of_cell(domain, {i, j, k});
        clear[c] = bits_[c] == all;
      }
    }
  }
  for (int axis = 0; axis < grid.dim; ++axis) clear_along(grid, axis, clear);
  for (c = 0; c < clear.size(); ++c) bits_[c] = static_cast<std::uint16_t>(bits_[c] | (clear[c] ? clear_bit : 0));
}

}  // namespace tether::coupled
