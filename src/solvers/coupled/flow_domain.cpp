// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

FaceValues face_values(const StaggeredGrid& grid, double value) {
  FaceValues values;
  for (int axis = 0; axis < grid.dim; ++axis)
    values[static_cast<std::size_t>(axis)].assign(grid.face_count(axis), value);
  return values;
}

std::array<int, 2> cells_beside(const StaggeredGrid& grid, int axis, std::size_t face) {
  auto upper = grid.place_of_face(axis, face), lower = upper;
  --lower[static_cast<std::size_t>(axis)];
  const auto number = [&](const std::array<int, 3>& c) {
    return grid.has_cell(c) ? static_cast<int>(grid.cell(c)) : -1;
  };
  return {number(lower), number(upper)};
}

}  // namespace tether::coupled
