// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces nearer to a wall or to each other than the cells can tell.
#include "physics/box/film_pressures.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "grid/crossings.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

constexpr int cells = 16;

class Films : public testing::TestWithParam<CouplingKind> {
 protected:
  int dim() const { return GetParam().dim; }
  Coupled box() const {
    Coupled coupled = fluid_in_box(dim(), cells);
    coupled.coupling = coupling_of(GetParam().mode);
    return coupled;
  }
  /// With this lowest corner; its height .3 is not one of the cells'.
  Mesh block(const Vec<3>& low) const {
    return lattice(dim(), {3, 2, 3}, all, [=](const Vec<3>& s) {
      return Vec<3>{low[0] + 0.4 * s[0], low[1] + 0.3 * s[1], low[2] + 0.4 * s[2]};
    });
  }
  double volume() const { return dim() == 2 ? 0.12 : 0.048; }
  /// Of a pressure that is a function of the place.
  template <class Pressure>
  Vec<3> force(const Surroundings& about, const Pressure& pressure) const {
    std::vector<double> p;
    const StaggeredGrid& grid = about.domain.grid;
    for (const std::size_t cell : about.numbers.cell) p.push_back(pressure(grid.middle(grid.place_of_cell(cell))));
    const std::vector<double> forces = transposed_product(about.map.B, p);
    Vec<3> sum{};
    for (std::size_t k = 0; k < forces.size(); ++k) sum[k % at(dim())] += forces[k];
    return sum;
  }
};
INSTANTIATE_TEST_SUITE_P(Coupled, Films,
                         testing::Values(CouplingKind{2, CouplingMode::symmetric},
                                         CouplingKind{2, CouplingMode::cut_cell},
                                         CouplingKind{3, CouplingMode::symmetric},
                                         CouplingKind{3, CouplingMode::cut_cell}));

/// At walls, a hair and nearly half a cell from them, and on an obstacle.
TEST_P(Films, AConstantPressurePressesFromAllSides) {
  for (const Vec<3>& low : {Vec<3>{0.31, 0, 0.31}, Vec<3>{0.31, 1e-4, 0.31}, Vec<3>{0.31, 0.03, 0.31},
                            Vec<3>{0.01, 0.02, 0.33}, Vec<3>{0.31, 0.25, 0.31}}) {
    Coupled coupled = box();
    if (low[1] == 0.25) coupled.obstacles.push_back({{0, 0, 0}, {1, 0.25, 1}});
    const Mesh mesh = block(low);
    const Surroundings about(coupled, mesh);
    std::vector<double> pressed(mesh.x.size(), 0.0);
    for (std::size_t s = 0; s < about.surface.side_count(); ++s) {
      for (const int node : about.surface.side(s)) {
        for (int i = 0; i < dim(); ++i)
          pressed[at(node * dim() + i)] -= area_of_side(about.surface, s, mesh.x)[at(i)] / dim();
      }
    }
    const std::vector<double> forces = transposed_product(about.map.B, std::vector(about.numbers.cell.size(), 1.0));
    for (std::size_t k = 0; k < forces.size(); ++k)
      EXPECT_NEAR(forces[k], pressed[k], 1e-12) << low[0] << " " << low[1];
  }
}

/// The pressure of water at rest lifts by its weight, but for what the cells at the top make of it.
TEST_P(Films, ABlockNearAWallFloats) {
  const bool cut = GetParam().mode == CouplingMode::cut_cell;
  const double top = cut ? 0.04 * volume() : 0.5 / cells * volume() / 0.3;  // half of what lies above the surface
  for (const Vec<3>& low : {Vec<3>{0.31, 0, 0.31}, Vec<3>{0.31, 0.01, 0.31}, Vec<3>{0.31, 0.03, 0.31},
                            Vec<3>{0, 0.35, 0.31}, Vec<3>{0.02, 0.35, 0.31}}) {
    const Surroundings about(box(), block(low));
    const Vec<3> lift = force(about, [](const Vec<3>& x) { return 2 - x[1]; });
    EXPECT_NEAR(lift[0], 0, low[0] < 0.1 ? 0.04 * volume() : 1e-6) << low[0] << " " << low[1];
    EXPECT_NEAR(lift[1], volume(), top) << low[0] << " " << low[1];
  }
}

/// Linear between both ends of a film: no moment about the block's middle that would turn it to the wall.
TEST(Films2D, TheFilmAtASideFallsWithTheHeight) {
  const Mesh mesh = lattice(2, {3, 3, 1}, all, [](const Vec<3>& s) {
    return Vec<3>{0.01 + 0.3 * s[0], 0.3125 + 0.375 * s[1], 0};
  });
  const Surroundings about(fluid_in_box(2, cells), mesh);
  std::vector<double> p;
  for (const std::size_t cell : about.numbers.cell)
    p.push_back(0.5 - about.domain.grid.middle(1, about.domain.grid.place_of_cell(cell)[1]));
  const std::vector<double> forces = transposed_product(about.map.B, p);
  double left = 0;
  for (std::size_t k = 0; k < mesh.x.size(); k += 2) {
    if (mesh.x[k] == 0.01) left += forces[k] * (mesh.x[k + 1] - 0.5);
  }
  EXPECT_NEAR(left, -std::pow(0.375, 3) / 12, 0.06 * std::pow(0.375, 3) / 12);
}

/// A block that reaches from wall to wall divides the fluid: nothing gets between it and the walls.
TEST_P(Films, ASealHasNoFilm) {
  const Mesh mesh = lattice(dim(), {3, 6, 3}, all, [](const Vec<3>& s) {
    return Vec<3>{0.31 + 0.4 * s[0], 0.01 + 0.98 * s[1], s[2]};
  });
  Coupled coupled = box();
  coupled.coupling = coupling_of(CouplingMode::symmetric);  // parts of cells know this gap, and let the fluid pass
  const Surroundings about(coupled, mesh);
  ASSERT_EQ(about.domain.regions, 2);
  const std::vector<double> forces = transposed_product(about.map.B, std::vector(about.numbers.cell.size(), 1.0));
  for (std::size_t k = 1; k < forces.size(); k += at(dim())) EXPECT_NEAR(forces[k], 0, 1e-14);
}

/// Blocks that touch have a film between them, blocks in each other have none: there they are pressed together. (Cut
/// cells take what both are in twice off the fluid, and hold some in places.)
TEST_P(Films, BlocksInEachOtherHaveNoFilm) {
  Coupled coupled = box();
  coupled.coupling = coupling_of(CouplingMode::symmetric);
  const double side = dim() == 2 ? 0.3 : 0.12;
  for (const auto& [way, pressed] : {std::pair(0.42, 0.0), std::pair(0.4, 0.0), std::pair(0.38, side)}) {
    const Mesh mesh = together(block({0.1, 0.35, 0.3}), block({0.1 + way, 0.35, 0.3}));
    const Surroundings about(coupled, mesh);
    const std::vector<double> forces = transposed_product(about.map.B, std::vector(about.numbers.cell.size(), 1.0));
    double left = 0;
    for (std::size_t k = 0; k < forces.size() / 2; k += at(dim())) left += forces[k];
    EXPECT_NEAR(left, pressed, 0.1 * side) << way;
  }
}

/// Beside a wall and out of an open top: the film's pressure falls to zero there.
TEST(Films2D, EndAtAnOpenSide) {
  Coupled coupled = fluid_in_box(2, cells);
  coupled.sides[3] = BoxSide::open;
  const Mesh mesh = lattice(2, {3, 6, 1}, all, [](const Vec<3>& s) {
    return Vec<3>{0.01 + 0.3 * s[0], 0.5 + 0.6 * s[1], 0};
  });
  const Surroundings about(coupled, mesh);
  std::vector<double> p;
  for (const std::size_t cell : about.numbers.cell)
    p.push_back(1 - about.domain.grid.middle(1, about.domain.grid.place_of_cell(cell)[1]));
  const std::vector<double> forces = transposed_product(about.map.B, p);
  double left = 0;
  for (std::size_t k = 0; k < mesh.x.size(); k += 2) left += mesh.x[k] == 0.01 ? forces[k] : 0;
  EXPECT_NEAR(left, 0.5 * 0.5 * 0.5, 0.06 * 0.125);
}

TEST(Winding, CountsTheBodiesAboutAPlace) {
  for (const int dim : {2, 3}) {
    const Mesh mesh =
        together(solid_block(dim, 2, {0.4, 0.5, 0.5}, 0.4, 0.3), hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.9, 0));
    const SolidSurface surface = surface_of(mesh);
    const auto turns = [&](const Vec<3>& x, int but) {
      return turns_about(surface, mesh.x, {x[0], x[1], dim == 3 ? x[2] : 0}, but);
    };
    EXPECT_NEAR(turns({0.3, 0.5, 0.5}, -1), 2, 1e-12);
    EXPECT_NEAR(turns({0.3, 0.5, 0.5}, 0), 1, 1e-12);
    EXPECT_NEAR(turns({0.45, 0.5, 0.5}, 0), 0, 1e-12);  // in the cavity
    EXPECT_NEAR(turns({0.98, 0.5, 0.5}, -1), 0, 1e-12);
  }
}

}  // namespace
}  // namespace tether::coupled
