// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/boxes.hpp"

namespace tether {

Mesh mesh_of_middles(const StaggeredGrid& grid) {
  Mesh mesh;
  mesh.kind = grid.dim == 2 ? ElementKind::quad4 : ElementKind::hex8;
  const int thick = grid.dim == 3 ? 1 : 0;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    const auto place = grid.place_of_cell(c);
    for (int axis = 0; axis < grid.dim; ++axis)
      mesh.x.push_back(grid.middle(axis, place[static_cast<std::size_t>(axis)]));
  }
  for (int k = 0; k < grid.n[2] - thick; ++k) {
    for (int j = 0; j < grid.n[1] - 1; ++j) {
      for (int i = 0; i < grid.n[0] - 1; ++i) {
        for (int corner = 0; corner < (4 << thick); ++corner) {
          mesh.nodes.push_back(
              static_cast<int>(grid.cell(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2))));
        }
        mesh.region.push_back(0);
      }
    }
  }
  return mesh;
}

}  // namespace tether
