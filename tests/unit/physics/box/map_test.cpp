// SPDX-License-Identifier: GPL-3.0-or-later
// The map between pressures and the solids' velocities.
#include "physics/box/coupling_map.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

class Mapped : public testing::TestWithParam<CouplingKind> {
 protected:
  Coupled box(int n) const {
    Coupled coupled = fluid_in_box(GetParam().dim, n);
    coupled.coupling = coupling_of(GetParam().mode);
    return coupled;
  }
};
INSTANTIATE_TEST_SUITE_P(Coupled, Mapped,
                         testing::Values(CouplingKind{2, CouplingMode::symmetric},
                                         CouplingKind{2, CouplingMode::cut_cell},
                                         CouplingKind{3, CouplingMode::symmetric},
                                         CouplingKind{3, CouplingMode::cut_cell}));

/// d/dt of what the sheets enclose when nodes move by u: exact, since volumes are of degree 3 at most in the places.
std::vector<double> rates(const SolidSurface& surface, const std::vector<double>& q, const std::vector<double>& u) {
  const auto by = [&](double e) {
    std::vector<double> ahead = q, behind = q;
    for (std::size_t k = 0; k < q.size(); ++k) ahead[k] += e * u[k], behind[k] -= e * u[k];
    std::vector<double> rate = enclosed_volumes(surface, ahead), less = enclosed_volumes(surface, behind);
    for (std::size_t s = 0; s < rate.size(); ++s) rate[s] = (rate[s] - less[s]) / (2 * e);
    return rate;
  };
  const std::vector<double> fine = by(0.05), coarse = by(0.1);
  std::vector<double> rate;
  for (std::size_t s = 0; s < fine.size(); ++s) rate.push_back((4 * fine[s] - coarse[s]) / 3);
  return rate;
}

/// Walls thicker and thinner than a cell.
TEST_P(Mapped, FluxIntoARegionIsWhatItsWallsTakeOfIt) {
  const int dim = GetParam().dim;
  for (const double side : {0.9, 0.6}) {
    for (const double angle : {0.0, 0.5}) {
      const Mesh mesh =
          hollow_block(dim, 2, {0.5, 0.51, 0.49}, dim == 3 && angle > 0 ? 0.62 * side : 0.7 * side, angle);
      const Surroundings about(box(dim == 2 ? 20 : 14), mesh);
      const int inner = about.region_at({0.5, 0.51, 0.49});
      ASSERT_EQ(about.domain.regions, 2);
      const std::vector<double> u = random_numbers(mesh.x.size(), 7), flux = product(about.map.B, u),
                                rate = rates(about.surface, mesh.x, u);
      std::array<double, 2> sum{};
      for (std::size_t p = 0; p < flux.size(); ++p) sum[at(about.domain.region[about.numbers.cell[p]])] += flux[p];
      for (std::size_t s = 0; s < 2; ++s) {
        const int region = about.surface.cavity[s] != 0 ? inner : 1 - inner;
        EXPECT_NEAR(sum[at(region)], -rate[s], 1e-12) << side << " " << angle;
        EXPECT_EQ(about.map.area_seen[s * 2 + at(1 - region)], 0);
      }
    }
  }
}

/// A cavity that grows has flux out of its cells.
TEST_P(Mapped, FluxIsPositiveWhereTheSurfaceRecedes) {
  const int dim = GetParam().dim;
  const Mesh mesh = hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.75, 0);
  const Surroundings about(box(16), mesh);
  std::vector<double> u(mesh.x.size());
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = mesh.x[k] - 0.5;
  const std::vector<double> flux = product(about.map.B, u);
  double sum = 0;
  for (std::size_t p = 0; p < flux.size(); ++p) {
    if (about.domain.region[about.numbers.cell[p]] == about.region_at({0.5, 0.5, 0.5})) sum += flux[p];
  }
  EXPECT_NEAR(sum, dim * std::pow(0.25, dim), 1e-13);
}

/// Of a constant pressure: on each node its share of the area, and none on the body.
TEST_P(Mapped, AConstantPressurePressesOnEachNodesArea) {
  const int dim = GetParam().dim;
  const Mesh mesh = hollow_block(dim, 2, {0.5, 0.51, 0.49}, 0.5, 0.4);
  const Surroundings about(box(15), mesh);
  const std::vector<double> forces = transposed_product(about.map.B, std::vector<double>(about.numbers.cell.size(), 3));
  std::vector<double> expected(mesh.x.size(), 0.0);
  for (std::size_t s = 0; s < about.surface.side_count(); ++s) {
    const Vec<3> area = area_of_side(about.surface, s, mesh.x);
    for (const int node : about.surface.side(s)) {
      for (std::size_t i = 0; i < at(dim); ++i) expected[at(node * dim) + i] -= 3 * area[i] / dim;
    }
  }
  Vec<3> sum{};
  for (std::size_t k = 0; k < forces.size(); ++k) {
    EXPECT_NEAR(forces[k], expected[k], 1e-13);
    sum[k % at(dim)] += forces[k];
  }
  for (const double force : sum) EXPECT_NEAR(force, 0, 1e-13);
}

/// All of the surface is seen, by one region each.
TEST_P(Mapped, TheAreasThatRegionsSeeAreTheSheets) {
  const int dim = GetParam().dim;
  const Mesh mesh = hollow_block(dim, 1, {0.5, 0.51, 0.49}, 0.5, 0.4);
  const Surroundings about(box(16), mesh);
  const double outer = dim == 2 ? 2.0 : 1.5, inner = outer / std::pow(3, dim - 1);
  double sum = 0;
  for (const double area : about.map.area_seen) sum += area;
  EXPECT_NEAR(sum, outer + inner, 1e-12);
}

/// Both faces of a plate thinner than a cell feel the fluid on their own side.
TEST_P(Mapped, TheSidesOfAPlateFeelTheirOwnFluid) {
  const int dim = GetParam().dim;
  for (const double angle : {0.0, 0.3}) {
    const auto plate = [&](const Vec<3>& s) {
      const double x = (s[0] - 0.5) * 0.013, y = (s[1] - 0.5) * 2;
      return Vec<3>{0.51 + std::cos(angle) * x - std::sin(angle) * y, 0.51 + std::sin(angle) * x + std::cos(angle) * y,
                    s[2] * 1.2 - 0.1};
    };
    const Mesh mesh = lattice(dim, {1, 12, 3}, all, plate);
    const Surroundings about(box(12), mesh);
    const int left = about.region_at({0.2, 0.5, 0.5}), right = about.region_at({0.8, 0.5, 0.5});
    std::vector<double> p;
    for (const std::size_t cell : about.numbers.cell) p.push_back(about.domain.region[cell] == left ? 2 : 0);
    ASSERT_NE(left, right);
    const std::vector<double> forces = transposed_product(about.map.B, p);
    double across = 0;
    for (std::size_t k = 0; k < forces.size(); ++k)
      across += forces[k] * (k % at(dim) == 0 ? std::cos(angle) : k % at(dim) == 1 ? std::sin(angle) : 0);
    EXPECT_NEAR(across, 2 / std::cos(angle), 0.03) << angle;  // but for what sticks out
  }
}

/// Pressures that are linear in place are found exactly between cells' middles, by halves behind the last one.
TEST(PressureStencils, AreLinearTowardsNeighbours) {
  const Mesh mesh = solid_block(2, 1, {0.5, 0.5, 0}, 0.26, 0);
  const Surroundings about(fluid_in_box(2, 10), mesh);
  const PressureSampler sampler(about.surface, mesh.x, about.pieces, about.domain);
  const StaggeredGrid& grid = about.domain.grid;
  const auto p = [](const Vec<3>& x) { return 2 + 3 * x[0] - x[1]; };
  const auto found = [&](const Vec<3>& x, const Cell& cell) {
    const PressureStencil stencil = sampler.at(x, grid.cell(cell));
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < stencil.size; ++k) {
      const Cell c = grid.place_of_cell(stencil.cell[k]);
      sum += stencil.weight[k] * p({grid.middle(0, c[0]), grid.middle(1, c[1]), 0}), weights += stencil.weight[k];
    }
    EXPECT_NEAR(weights, 1, 1e-15);
    return sum;
  };
  EXPECT_NEAR(found({0.12, 0.33, 0}, {1, 3, 0}), p({0.12, 0.33, 0}), 1e-14);
  EXPECT_NEAR(found({0.31, 0.36, 0}, {2, 3, 0}), p({0.31, 0.36, 0}), 1e-14);
  const Cell beside{3, 5, 0};  // its right neighbour is solid
  ASSERT_EQ(about.domain.kind[grid.cell({4, 5, 0})], CellKind::solid);
  EXPECT_NEAR(found({0.37, 0.55, 0}, beside), p({0.35 + 0.5 * 0.02, 0.55, 0}), 1e-14);
  EXPECT_NEAR(found({0.47, 0.55, 0}, beside), p({0.35 + 0.5 * 0.1, 0.55, 0}), 1e-14);  // no farther than a neighbour
  EXPECT_NEAR(found({0.31, 0.55, 0}, beside), p({0.31, 0.55, 0}), 1e-14);
}

}  // namespace
}  // namespace tether::coupled
