// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "grid/block_mesh.hpp"
#include "grid/carried_nodes.hpp"
#include "unit/grid/mesh_support.hpp"

// Which nodes of a body the fluid carries, and how the others follow.

namespace tether {
namespace {

Block rectangle(double x0, double y0, double x1, double y1, int nx, int ny) {
  Block block;
  const std::array<std::array<double, 2>, 4> corners{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {nx, ny, 1};
  return block;
}

/// A quarter of a ring about the origin, counted the wrong way round from block to block if `turned`.
Block quarter(double from, bool turned, int along, int across) {
  const auto at = [&](double r, double angle) { return std::array{r * std::cos(angle), r * std::sin(angle)}; };
  const double to = from + 0.5 * std::numbers::pi;
  const std::array<std::array<double, 2>, 4> c{at(0.2, from), at(0.4, from), at(0.4, to), at(0.2, to)};
  Block block;
  block.edges = {straight(c[0], c[1]), elliptic(c[1], c[2], {0, 0}, 0.4, 0.4), straight(c[2], c[3]),
                 elliptic(c[3], c[0], {0, 0}, 0.2, 0.2)};
  block.cells = {across, along, 1};
  if (!turned) return block;
  std::rotate(block.edges.begin(), block.edges.begin() + 1, block.edges.end());
  std::swap(block.cells[0], block.cells[1]);
  return block;
}

/// The largest difference between a field at the nodes and what follows of its values at the carried ones.
template <class Field>
double difference(const CarriedNodes& carried, const Mesh& mesh, const Field& field) {
  std::vector<double> at_carried, V(mesh.x.size());
  for (const int n : carried.nodes()) {
    const double* x = &mesh.x[2 * static_cast<std::size_t>(n)];
    at_carried.insert(at_carried.end(), {field(x[0], x[1]), field(x[1], x[0])});
  }
  carried.follow(at_carried, V);
  double worst = 0;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    worst = std::max(worst, std::abs(V[2 * n] - field(mesh.x[2 * n], mesh.x[2 * n + 1])));
    worst = std::max(worst, std::abs(V[2 * n + 1] - field(mesh.x[2 * n + 1], mesh.x[2 * n])));
  }
  return worst;
}

/// A body of 1.0 x 0.2 in cells of 0.1: 10 x 2 coarse elements of order 2 have 21 x 5 nodes, however fine the body is.
TEST(CarriedNodes, AreAsManyAsTheFluidHasThere) {
  const Mesh fluid = meshed({rectangle(0, 0, 2, 1, 20, 10)}, ElementKind::quad9);
  for (const auto kind : {ElementKind::quad4, ElementKind::quad9}) {
    for (const int finer : {2, 4, 8}) {
      const Mesh body = meshed({rectangle(0.32, 0.37, 1.32, 0.57, 10 * finer, 2 * finer)}, kind);
      CarriedNodes carried(fluid, body);
      carried.choose(body.x);
      EXPECT_EQ(carried.nodes().size(), 21u * 5u) << finer;
      EXPECT_NEAR(carried.coarsest(), 1, 1e-9);
    }
  }
  const Mesh coarse = meshed({rectangle(0.32, 0.37, 1.32, 0.57, 5, 1)}, ElementKind::quad9);
  CarriedNodes carried(fluid, coarse);
  carried.choose(coarse.x);
  EXPECT_TRUE(carried.all());
  EXPECT_NEAR(carried.coarsest(), 2, 1e-9);
}

TEST(CarriedNodes, GiveBackWhatTheirElementsHold) {
  const Mesh fluid = meshed({rectangle(0, 0, 2, 1, 20, 10)}, ElementKind::quad9);
  const Mesh body = meshed({rectangle(0.32, 0.37, 1.32, 0.57, 77, 13)}, ElementKind::quad9);
  CarriedNodes carried(fluid, body);
  carried.choose(body.x);
  EXPECT_LT(carried.nodes().size(), body.node_count() / 20);
  EXPECT_LT(difference(carried, body, [](double x, double y) { return 1 + 2 * x - 3 * y + x * y + y * y; }), 1e-12);
}

/// A ring of four blocks whose lines go on from one to the next, two of them numbered the other way round: a rigid
/// motion is kept to rounding although the lines are curved, and each line goes all round.
TEST(CarriedNodes, GoOnFromBlockToBlock) {
  const Mesh fluid = meshed({rectangle(-1, -1, 1, 1, 20, 20)}, ElementKind::quad9);
  std::vector<Block> blocks;
  for (int k = 0; k < 4; ++k) blocks.push_back(quarter(0.5 * std::numbers::pi * k, k % 2 == 1, 40, 16));
  const Mesh body = meshed(blocks, ElementKind::quad4);
  const auto lattices = node_lattices_of(body);
  ASSERT_EQ(lattices.size(), 4u);
  EXPECT_EQ(chains_of(lattices).lines.size(), 5u);  // one across all of them, and one along each
  CarriedNodes carried(fluid, body);
  carried.choose(body.x);
  EXPECT_LT(carried.nodes().size(), body.node_count() / 8);
  EXPECT_LT(difference(carried, body, [](double x, double y) { return 3 + x - 2 * y; }), 1e-12);
}

/// Where the cells are longer fewer are carried: of a bar over cells of 0.05 and of 0.1.
TEST(CarriedNodes, ChangeAsTheBodyMoves) {
  const Mesh fluid = meshed({rectangle(0, 0, 1, 1, 20, 20), rectangle(1, 0, 2, 1, 10, 20)}, ElementKind::quad9);
  const Mesh body = meshed({rectangle(0.1, 0.4, 0.7, 0.5, 48, 8)}, ElementKind::quad9);
  CarriedNodes carried(fluid, body);
  std::vector<double> x = body.x;
  std::size_t before = 25 * 5;
  for (int step = 0; step <= 12; ++step) {
    carried.choose(x);
    EXPECT_LE(carried.nodes().size(), before);
    EXPECT_GE(carried.nodes().size() + 15, before) << "two lines at the most at a time";
    before = carried.nodes().size();
    for (std::size_t n = 0; n < body.node_count(); ++n) x[2 * n] += 0.08;
  }
  EXPECT_EQ(before, 13u * 5u);
}

}  // namespace
}  // namespace tether
