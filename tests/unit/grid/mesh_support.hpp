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
