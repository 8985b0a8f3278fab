// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "grid/block_mesh.hpp"
#include "grid/shapes.hpp"

namespace tether {

/// Of blocks that are to give a mesh without a flaw.
inline Mesh meshed(const std::vector<Block>& blocks, ElementKind kind) {
  std::vector<MeshFlaw> flaws;
  Mesh mesh = mesh_of_blocks(blocks, kind, flaws);
  EXPECT_TRUE(flaws.empty());
  return mesh;
}

/// From x = left to right, y = 0 to 1 and, unless it is flat, z = 0 to z_high; 2 x 3 x 2 cells.
inline Block block_between(double left, double right, double z_high = 0) {
  Block block;
  const std::array<Vec<2>, 4> corners{{{left, 0}, {right, 0}, {right, 1}, {left, 1}}};
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {2, 3, 2}, block.z_high = z_high;
  return block;
}

inline double volume(const Mesh& mesh) {
  return with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    double sum = 0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (int k = 0; k < Shapes::points; ++k)
        sum += Shapes::weight(k) * jacobian_at<Shapes>(mesh, e, Shapes::place(k)).determinant;
    }
    return sum;
  });
}

}  // namespace tether
