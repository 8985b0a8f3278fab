// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "grid/block_mesh.hpp"
#include "grid/thickness.hpp"

// How thick bodies are in cells of the mesh that they lie over.

namespace tether {
namespace {

using Corners = std::array<std::array<double, 2>, 4>;

Block block_of(const Corners& corners, int nx, int ny) {
  Block block;
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {nx, ny, 1};
  return block;
}

Mesh mesh_of(const std::vector<Block>& blocks, ElementKind kind) {
  std::vector<MeshFlaw> flaws;
  return mesh_of_blocks(blocks, kind, flaws);
}

/// Cells of 0.1 x 0.2.
Mesh cells() { return mesh_of({block_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, 40, 20)}, ElementKind::quad9); }

double thickness(const std::vector<Block>& bodies, ElementKind kind = ElementKind::quad9) {
  const Mesh below = cells(), mesh = mesh_of(bodies, kind);
  return BodyThickness(below, mesh).thinnest(mesh.x).cells;
}

Corners plate(double x, double y, double length, double thick, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{x, y},
           {x + c * length, y + s * length},
           {x + c * length - s * thick, y + s * length + c * thick},
           {x - s * thick, y + c * thick}}};
}

TEST(BodyThickness, OfPlatesAlongTheCellsIsExact) {
  EXPECT_NEAR(thickness({block_of(plate(1.03, 1.07, 1.5, 0.13, 0), 30, 1)}), 0.13 / 0.2, 1e-9);
  EXPECT_NEAR(thickness({block_of(plate(1.03, 1.07, 1.5, 0.13, 0.5 * std::numbers::pi), 30, 1)}), 0.13 / 0.1, 1e-9);
  EXPECT_NEAR(thickness({block_of(plate(1.03, 1.07, 1.5, 0.13, 0), 30, 2)}, ElementKind::quad4), 0.65, 1e-9);
  EXPECT_NEAR(thickness({block_of(plate(1.03, 1.07, 1.5, 0.13, 0), 30, 2)}, ElementKind::tri3), 0.65, 1e-9);
}

/// In cells of 0.1 x 0.2 a plate at 45 degrees is as thick as its area over its length in cells.
TEST(BodyThickness, OfAPlateThatLeans) {
  const double length = 1.5 * std::hypot(std::sqrt(0.5) / 0.1, std::sqrt(0.5) / 0.2);
  const double area = 1.5 * 0.08 / 0.02;
  EXPECT_NEAR(thickness({block_of(plate(1, 1, 1.5, 0.08, 0.25 * std::numbers::pi), 30, 1)}), area / length, 0.03);
}

/// Layers that share their nodes are one body; of two bodies the thinner one is taken.
TEST(BodyThickness, IsThatOfWholeBodies) {
  const Block lower = block_of(plate(1, 1, 1.5, 0.1, 0), 15, 1), upper = block_of(plate(1, 1.1, 1.5, 0.1, 0), 15, 1);
  EXPECT_NEAR(thickness({lower, upper}), 1, 1e-9);
  EXPECT_NEAR(thickness({block_of(plate(1, 2, 1.5, 0.4, 0), 15, 4), lower}), 0.5, 1e-9);
}

}  // namespace
}  // namespace tether
