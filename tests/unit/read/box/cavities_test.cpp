// SPDX-License-Identifier: GPL-3.0-or-later
// Whether bodies part the cells of a grid.
#include <gtest/gtest.h>

#include <algorithm>

#include "read/box/checks.hpp"

namespace tether {
namespace {

using Cell = std::array<int, 3>;

/// Triangles or tetrahedra of the blocks of a lattice, whose corners are at all combinations of `places`, but of some.
Mesh blocks(int dim, const std::vector<double>& places, const std::vector<Cell>& without) {
  Mesh mesh;
  mesh.kind = dim == 2 ? ElementKind::tri3 : ElementKind::tet4;
  const int n = static_cast<int>(places.size()), layers = dim == 3 ? n : 1;
  const auto place = [&](int i) { return places[static_cast<std::size_t>(i)]; };
  for (int k = 0; k < layers; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        mesh.x.insert(mesh.x.end(), {place(i), place(j)});
        if (dim == 3) mesh.x.push_back(place(k));
      }
    }
  }
  const auto add = [&](Cell corner, std::array<int, 3> order) {  // from the lowest corner along the axes in this order
    for (int a = 0; a <= dim; ++a) {
      mesh.nodes.push_back(corner[0] + n * (corner[1] + n * corner[2]));
      if (a < dim) ++corner[static_cast<std::size_t>(order[static_cast<std::size_t>(a)])];
    }
    const bool turned = (order[0] > order[1]) != (dim == 3 && (order[1] > order[2]) != (order[0] > order[2]));
    if (turned) std::swap(mesh.nodes.back(), mesh.nodes[mesh.nodes.size() - 2]);
    mesh.region.push_back(0);
  };
  for (int k = 0; k < std::max(layers - 1, 1); ++k) {
    for (int j = 0; j + 1 < n; ++j) {
      for (int i = 0; i + 1 < n; ++i) {
        if (std::find(without.begin(), without.end(), Cell{i, j, k}) != without.end()) continue;
        std::array<int, 3> order{0, 1, 2};
        do {
          add({i, j, k}, order);
        } while (std::next_permutation(order.begin(), order.begin() + dim));
      }
    }
  }
  return mesh;
}

/// Cells along each axis between -1 and 2.
Coupled grid_of(int dim, int cells) {
  Coupled coupled;
  StaggeredGrid& grid = coupled.grid;
  grid.dim = dim;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
    grid.n[i] = cells, grid.low[i] = -1, grid.d[i] = 3. / cells;
  return coupled;
}

const std::vector<double> thirds{0, 1. / 3, 2. / 3, 1}, thin{0, .01, .99, 1};

TEST(Cavities, ArePartedByThickAndThinWalls) {
  for (const int dim : {2, 3}) {
    const Cell middle{1, 1, dim == 3 ? 1 : 0};
    for (const int cells : {9, 10, 17, 30}) {
      EXPECT_TRUE(encloses_cells(grid_of(dim, cells), blocks(dim, thin, {middle}))) << dim << " " << cells;
      EXPECT_FALSE(encloses_cells(grid_of(dim, cells), blocks(dim, thin, {}))) << dim << " " << cells;
      EXPECT_TRUE(encloses_cells(grid_of(dim, cells), blocks(dim, thirds, {middle}))) << dim << " " << cells;
      EXPECT_FALSE(encloses_cells(grid_of(dim, cells), blocks(dim, thirds, {}))) << dim << " " << cells;
    }
  }
}

TEST(Cavities, WithAHoleAreNone) {
  for (const int dim : {2, 3}) {
    const int k = dim == 3 ? 1 : 0;
    for (const Cell& hole : {Cell{0, 1, k}, Cell{2, 1, k}, Cell{1, 0, k}, Cell{1, 2, k}}) {
      EXPECT_FALSE(encloses_cells(grid_of(dim, 18), blocks(dim, thirds, {{1, 1, k}, hole}))) << dim;
      EXPECT_FALSE(encloses_cells(grid_of(dim, 18), blocks(dim, thin, {{1, 1, k}, hole}))) << dim;
    }
  }
  EXPECT_FALSE(encloses_cells(grid_of(3, 18), blocks(3, thirds, {{1, 1, 1}, {1, 1, 2}})));
}

/// Of 4 cells the middles are at -.625, .125, .875, 1.625: none in the middle third.
TEST(Cavities, OfNoCellAreNone) {
  EXPECT_FALSE(encloses_cells(grid_of(2, 4), blocks(2, thirds, {{1, 1, 0}})));
  EXPECT_FALSE(encloses_cells(grid_of(3, 4), blocks(3, thirds, {{1, 1, 1}})));
}

/// A wall from side to side parts the box, and both parts are outside.
TEST(Cavities, AreNotClosedByTheBox) {
  Coupled coupled;
  coupled.grid.n = {8, 8, 1}, coupled.grid.d = {.125, .125, 1};
  const std::vector<Cell> all_but_the_middle{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
  EXPECT_FALSE(encloses_cells(coupled, blocks(2, {0, .45, .55, 1}, all_but_the_middle)));
}

/// An open cup of bodies, with an obstacle as its lid.
TEST(Cavities, MayBeClosedByObstacles) {
  const Mesh cup = blocks(2, thirds, {{1, 1, 0}, {1, 2, 0}});
  Coupled coupled = grid_of(2, 18);
  EXPECT_FALSE(encloses_cells(coupled, cup));
  coupled.obstacles.push_back({{.3, .8, 0}, {.7, 1.5, 1}});
  EXPECT_TRUE(encloses_cells(coupled, cup));
  coupled.obstacles[0].low[1] = .3;  // which fills it
  EXPECT_FALSE(encloses_cells(coupled, cup));
}

/// Where bodies overlap is no fluid.
TEST(Cavities, AreNotWhereBodiesOverlap) {
  for (const int dim : {2, 3}) {
    Mesh mesh = blocks(dim, thirds, {});
    Mesh other = blocks(dim, {.5, .8, 1.1, 1.4}, {});
    for (int& node : other.nodes) node += static_cast<int>(mesh.node_count());
    mesh.x.insert(mesh.x.end(), other.x.begin(), other.x.end());
    mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
    mesh.region.insert(mesh.region.end(), other.region.begin(), other.region.end());
    EXPECT_FALSE(encloses_cells(grid_of(dim, 18), mesh)) << dim;
  }
}

}  // namespace
}  // namespace tether
