// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells solids hold, by the lines between the cells' middles.
#include "grid/crossings.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

using Inside = std::function<bool(const Vec<3>&)>;

Vec<3> centre_of(const StaggeredGrid& grid, std::size_t cell) {
  const Cell c = grid.place_of_cell(cell);
  return {grid.middle(0, c[0]), grid.middle(1, c[1]), grid.dim == 3 ? grid.middle(2, c[2]) : 0};
}

void expect_inside(const Mesh& mesh, const StaggeredGrid& grid, const Inside& solid, const Inside& cavity) {
  const Crossings found = find_crossings(surface_of(mesh), mesh.x, grid);
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    const Vec<3> x = centre_of(grid, c);
    ASSERT_EQ(found.inside[c] != 0, solid(x)) << x[0] << " " << x[1] << " " << x[2];
    ASSERT_EQ(found.in_cavity[c] != 0, cavity(x)) << x[0] << " " << x[1] << " " << x[2];
  }
}

bool nowhere(const Vec<3>&) { return false; }

/// Whether a place lies in the block of turned_block(middle, {side, ...}, angle).
Inside in_block(int dim, const Vec<3>& middle, double side, double angle) {
  const auto to = turned_block({0, 0, 0}, {1, 1, dim == 3 ? 1.0 : 0.0}, angle);
  std::array<Vec<3>, 3> axes{};
  for (std::size_t a = 0; a < at(dim); ++a) {
    Vec<3> end{0.5, 0.5, 0.5};
    end[a] = 1.5;
    axes[a] = to(end);
  }
  return [=](const Vec<3>& x) {
    for (std::size_t a = 0; a < at(dim); ++a) {
      double along = 0;
      for (std::size_t i = 0; i < at(dim); ++i) along += axes[a][i] * (x[i] - middle[i]);
      if (std::abs(along) > side / 2) return false;
    }
    return true;
  };
}

class Crossed : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, Crossed, testing::Values(2, 3));

TEST_P(Crossed, MarksTheCellsInATurnedBlock) {
  const int dim = GetParam();
  for (const double angle : {0.0, 0.3, 1.1, 2.0}) {
    const Vec<3> middle{0.47, 0.53, 0.49};
    expect_inside(solid_block(dim, 3, middle, 0.5, angle), fluid_in_box(dim, 19).grid,
                  in_block(dim, middle, 0.5, angle), nowhere);
  }
}

TEST_P(Crossed, TellsCavitiesFromSolids) {
  const int dim = GetParam();
  const Vec<3> middle{0.47, 0.53, 0.49};
  const Inside outer = in_block(dim, middle, 0.75, 0.3), inner = in_block(dim, middle, 0.25, 0.3);
  expect_inside(
      hollow_block(dim, 1, middle, 0.75, 0.3), fluid_in_box(dim, 17).grid,
      [&](const Vec<3>& x) { return outer(x) && !inner(x); }, inner);
}

TEST_P(Crossed, CountsWhatSticksOutOfTheBoxAndTakesOverlappingSolidsAsOne) {
  const int dim = GetParam();
  const Vec<3> one{0.05, 0.1, 0.9}, other{0.3, 0.3, 0.7};
  const Inside a = in_block(dim, one, 0.6, 0.5), b = in_block(dim, other, 0.4, 0.1);
  expect_inside(
      together(solid_block(dim, 2, one, 0.6, 0.5), solid_block(dim, 2, other, 0.4, 0.1)), fluid_in_box(dim, 15).grid,
      [&](const Vec<3>& x) { return a(x) || b(x); }, nowhere);
}

/// Nodes, edges and sides on the lines: a cell is in the solid or not, but no line goes in without coming out.
TEST_P(Crossed, HasNoGapsWhereNodesAreOnTheLines) {
  const int dim = GetParam();
  const StaggeredGrid grid = fluid_in_box(dim, 8).grid;
  const Mesh mesh = solid_block(dim, 4, {0.4375, 0.4375, 0.4375}, 0.5, 0);  // nodes at middles of cells
  const Crossings found = find_crossings(surface_of(mesh), mesh.x, grid);
  std::size_t count = 0;
  for (const std::uint8_t inside : found.inside) count += inside;
  EXPECT_EQ(count, dim == 2 ? 16u : 64u);
}

/// Random bodies: no face without a crossing leads from outside to inside, or into a cavity. Where nodes are on the
/// lines a middle on the surface may count as outside, but there is no way past it into the cavity.
TEST_P(Crossed, DoesNotLeakThroughRandomMeshes) {
  const int dim = GetParam();
  const StaggeredGrid grid = fluid_in_box(dim, 12).grid;
  for (unsigned seed = 0; seed < (dim == 2 ? 200u : 25u); ++seed) {
    Mesh mesh = hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.6, 0.1 * seed);
    const bool on_lines = seed % 2 == 1;
    const std::vector<double> shift = random_numbers(mesh.x.size(), seed, on_lines ? 0.02 : 0.07);
    for (std::size_t k = 0; k < shift.size(); ++k) {
      mesh.x[k] += shift[k];
      if (on_lines) mesh.x[k] = (std::floor(mesh.x[k] * 12) + 0.5) / 12;
    }
    const Crossings found = find_crossings(surface_of(mesh), mesh.x, grid);
    for (int axis = 0; axis < dim; ++axis) {
      for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
        const auto [low, high] = cells_beside(grid, axis, f);
        if (low < 0 || high < 0 || found.lowest[at(axis)][f] >= 0) continue;
        const bool outside = found.inside[at(low)] == 0 && found.inside[at(high)] == 0;
        ASSERT_TRUE(on_lines || found.inside[at(low)] == found.inside[at(high)]) << seed << " " << axis << " " << f;
        ASSERT_TRUE(!outside || found.in_cavity[at(low)] == found.in_cavity[at(high)])
            << seed << " " << axis << " " << f;
      }
    }
  }
}

/// Shares and places belong together; the lowest is the lowest.
TEST_P(Crossed, SaysWhereOnItsSideItIs) {
  const int dim = GetParam();
  const StaggeredGrid grid = fluid_in_box(dim, 9).grid;
  const Mesh mesh = solid_block(dim, 2, {0.45, 0.49, 0.49}, 0.06, 0.4);  // thinner than a cell
  const SolidSurface surface = surface_of(mesh);
  const Crossings found = find_crossings(surface, mesh.x, grid);
  ASSERT_GT(found.all.size(), 0u);
  std::size_t pairs = 0;
  for (int axis = 0; axis < dim; ++axis) {
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      const int low = found.lowest[at(axis)][f], high = found.highest[at(axis)][f];
      EXPECT_EQ(low >= 0, high >= 0);
      if (low < 0) continue;
      EXPECT_LE(found.all[at(low)].place, found.all[at(high)].place);
      pairs += low != high ? 1 : 0;
      for (const int k : {low, high}) {
        const Crossing& one = found.all[at(k)];
        const Cell face = grid.place_of_face(axis, f);
        Vec<3> x{};
        for (std::size_t a = 0; a < at(dim); ++a) {
          const Vec<3> node = place_of(mesh.x, surface.side(at(one.side))[a], dim);
          for (std::size_t i = 0; i < 3; ++i) x[i] += one.share[a] * node[i];
        }
        for (int b = 0; b < dim; ++b) EXPECT_NEAR(x[at(b)], b == axis ? one.place : grid.middle(b, face[at(b)]), 1e-14);
        EXPECT_LE(std::abs(one.place - grid.face_place(axis, face[at(axis)])), 0.5 * grid.d[at(axis)] + 1e-14);
      }
    }
  }
  EXPECT_GT(pairs, 0u);
}

}  // namespace
}  // namespace tether::coupled
