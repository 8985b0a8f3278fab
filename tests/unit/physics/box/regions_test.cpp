// SPDX-License-Identifier: GPL-3.0-or-later
// Closed regions of the fluid, crevices, and what a step's pressure does to the fluid.
#include "physics/box/closed_regions.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "physics/box/projection.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using Values = std::vector<double>;

Values scaled(const Mesh& mesh, double factor) {
  Values q = mesh.x;
  for (double& x : q) x = 0.5 + factor * (x - 0.5);
  return q;
}

Regions regions_at(const Coupled& coupled, const Mesh& mesh, const Values& q, double h, std::uint8_t held = 0) {
  const Surroundings about(coupled, mesh, q);
  const std::vector<std::uint8_t> all_held(q.size(), held);
  return regions_of(regions_of(about.domain, about.numbers), about.map, enclosed_volumes(about.surface, q),
                    enclosed_volumes(about.surface, mesh.x), all_held, h);
}

class ClosedRegions : public testing::TestWithParam<int> {
 protected:
  int dim = GetParam();
  double power(double x) const { return std::pow(x, dim); }
};
INSTANTIATE_TEST_SUITE_P(Coupled, ClosedRegions, testing::Values(2, 3));

/// The shell has grown: its cavity has flux out of its cells to lose the volume, the box's has it into them.
TEST_P(ClosedRegions, BringTheirVolumesBack) {
  const Mesh mesh = hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.6, 0);
  const double h = 0.1, grown = power(1.1) - 1;
  Coupled coupled = fluid_in_box(dim, 20);
  const Values q = scaled(mesh, 1.1);
  const int inner = Surroundings(coupled, mesh, q).region_at({0.5, 0.5, 0.5});
  const Regions closed = regions_at(coupled, mesh, q, h);
  const auto rate = [&](const Regions& regions, int r) {
    return h * regions.source[at(r)] * double(regions.cells[at(r)]);
  };
  ASSERT_EQ(closed.closed, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(closed.compliant, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_NEAR(rate(closed, inner), -grown * power(0.2), 1e-14);
  EXPECT_NEAR(rate(closed, 1 - inner), grown * power(0.6), 1e-14);
  coupled.sides[side_top] = BoxSide::open;
  const Regions open = regions_at(coupled, mesh, q, h);
  EXPECT_EQ(open.closed[at(1 - inner)], 0);
  EXPECT_EQ(open.source[at(1 - inner)], 0);
  EXPECT_NEAR(rate(open, inner), -grown * power(0.2), 1e-14);
  EXPECT_EQ(regions_at(coupled, mesh, q, h, 1).compliant, (std::vector<std::uint8_t>{0, 0}));
}

/// A block from floor to ceiling parts the box; what it takes is shared, and where one part is open none of it is.
TEST_P(ClosedRegions, ThatSeeOneSheetShare) {
  const Mesh mesh = lattice(dim, {1, 1, 1}, all, [](const Vec<3>& s) {
    return Vec<3>{0.3 + 0.2 * s[0], 1.2 * s[1] - 0.1, 1.2 * s[2] - 0.1};
  });
  Coupled coupled = fluid_in_box(dim, 10);
  Values q = mesh.x;
  for (std::size_t k = 0; k < q.size(); k += at(dim)) q[k] = 0.3 + 1.5 * (q[k] - 0.3);
  const Regions closed = regions_at(coupled, mesh, q, 1);
  ASSERT_EQ(closed.source.size(), 2u);
  EXPECT_NE(closed.cells[0], closed.cells[1]);
  EXPECT_EQ(closed.source[0], closed.source[1]);
  EXPECT_NEAR(closed.source[0] * double(closed.cells[0] + closed.cells[1]), 0.1 * std::pow(1.2, dim - 1), 1e-14);
  coupled.sides[side_right] = BoxSide::open;
  const Regions open = regions_at(coupled, mesh, q, 1);
  EXPECT_EQ(open.source, (Values{0, 0}));
  EXPECT_EQ(std::accumulate(open.closed.begin(), open.closed.end(), 0), 1);
}

/// A C that stands against a wall: its notch is a crevice where it is of a few cells.
TEST_P(ClosedRegions, OfAFewCellsThatASurfaceCutsOffArePockets) {
  const auto c_shape = [](const Cell& c) { return !(c[0] == 2 && c[1] == 1 && c[2] < 2); };
  const Mesh mesh =
      lattice(dim, {3, 3, 3}, c_shape, turned_block({0.71, 0.5, 0.3}, {0.6, 0.6, dim == 3 ? 0.62 : 0}, 0));
  Coupled coupled = fluid_in_box(dim, 10);
  const auto pockets = [&] {
    const Surroundings about(coupled, mesh);
    const auto found = find_pockets(about.domain, about.map);
    EXPECT_EQ(about.domain.regions, 2);
    return std::pair(found[at(about.region_at({0.85, 0.5, 0.25}))], found[at(about.region_at({0.1, 0.5, 0.25}))]);
  };
  EXPECT_EQ(pockets(), std::pair(std::uint8_t{1}, std::uint8_t{0}));
  coupled.sides[side_right] = BoxSide::open;
  EXPECT_EQ(pockets(), std::pair(std::uint8_t{0}, std::uint8_t{0}));
  coupled = fluid_in_box(dim, 20);
  EXPECT_EQ(pockets(), std::pair(std::uint8_t{0}, std::uint8_t{0}));
}

/// A small cavity is no crevice: nothing larger sees its sheet.
TEST_P(ClosedRegions, OfAFewCellsThatASolidEnclosesAreNoPockets) {
  const Mesh mesh = hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.6, 0);
  const Surroundings about(fluid_in_box(dim, 10), mesh);
  EXPECT_EQ(find_pockets(about.domain, about.map), (std::vector<std::uint8_t>{0, 0}));
}

TEST_P(ClosedRegions, ThatAreDroppedAreSolid) {
  const Mesh mesh = hollow_block(dim, 1, {0.5, 0.5, 0.5}, 0.6, 0);
  Surroundings about(fluid_in_box(dim, 10), mesh);
  const int inner = about.region_at({0.5, 0.5, 0.5});
  std::vector<std::uint8_t> drop(2, 0);
  drop[at(inner)] = 1;
  drop_regions(drop, about.domain);
  EXPECT_EQ(about.domain.regions, 1);
  EXPECT_EQ(about.region_at({0.5, 0.5, 0.5}), -1);
  EXPECT_EQ(about.region_at({0.1, 0.1, 0.1}), 0);
  for (int axis = 0; axis < dim; ++axis) {
    for (std::size_t f = 0; f < about.domain.face[at(axis)].size(); ++f) {
      const auto [low, high] = cells_beside(about.domain.grid, axis, f);
      for (const int c : {low, high}) {
        if (c < 0 || about.domain.kind[at(c)] == CellKind::fluid) continue;
        EXPECT_EQ(about.domain.face[at(axis)][f], FaceKind::closed);
        EXPECT_EQ(about.domain.area[at(axis)][f], 0);
      }
    }
  }
}

/// A cut domain with walls, an open side and closed faces, random velocities and pressures.
class Projection : public testing::TestWithParam<int> {
 protected:
  int dim = GetParam();
  Coupled coupled = [this] {
    Coupled box = fluid_in_box(dim, 9);
    box.coupling = coupling_of(CouplingMode::cut_cell), box.density = 3;
    box.sides[side_right] = BoxSide::open;
    return box;
  }();
  Surroundings about{coupled, hollow_block(dim, 1, {0.5, 0.48, 0.51}, 0.6, 0.3)};
  Values p = random_numbers(about.numbers.cell.size(), 4);
  FaceValues v = [this] {
    FaceValues values = face_values(coupled.grid);
    for (std::size_t a = 0; a < at(dim); ++a) values[a] = random_numbers(values[a].size(), 5 + unsigned(a));
    return values;
  }();
};
INSTANTIATE_TEST_SUITE_P(Coupled, Projection, testing::Values(2, 3));

TEST_P(Projection, PressuresChangeTheFluxByL) {
  const double by = 0.02 / coupled.density;
  const SparseMatrix L = pressure_matrix(about.domain, about.numbers, by);
  Values Lp(p.size());
  L.multiply(p, Lp);
  const Values before = net_flux(about.domain, about.numbers, v);
  FaceValues after = v;
  add_pressure(about.domain, about.numbers, p, by, after);
  const Values flux = net_flux(about.domain, about.numbers, after);
  double power = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(flux[k] - before[k], Lp[k], 1e-13);
    power += p[k] * Lp[k];
  }
  FaceValues change = after;
  for (std::size_t a = 0; a < at(dim); ++a) {
    for (std::size_t f = 0; f < change[a].size(); ++f) {
      change[a][f] -= v[a][f];
      EXPECT_TRUE(change[a][f] == 0 || about.domain.face[a][f] == FaceKind::open);
    }
  }
  EXPECT_NEAR(kinetic_energy(about.domain, change, change, coupled.density), 0.02 / 2 * power, 1e-13);
}

/// Power of the pressures, p . D v, is that of the fluid's change of velocity and of prescribed faces.
TEST_P(Projection, PowerIsThatOfTheFacesAndOfWhatIsPrescribed) {
  const double h = 0.02;
  FaceValues change = face_values(coupled.grid);
  add_pressure(about.domain, about.numbers, p, h / coupled.density, change);
  const Values flux = net_flux(about.domain, about.numbers, v);
  double power = 0;
  for (std::size_t k = 0; k < p.size(); ++k) power += p[k] * flux[k];
  EXPECT_NEAR(kinetic_energy(about.domain, v, change, coupled.density) * 2 / h +
                  prescribed_power(about.domain, about.numbers, p, v),
              power, 1e-13);
}

/// Constant pressures of closed regions are not felt; those of regions with an open side are.
TEST_P(Projection, LFeelsNoConstantsOfClosedRegions) {
  const SparseMatrix L = pressure_matrix(about.domain, about.numbers, 1);
  const int inner = about.region_at({0.5, 0.48, 0.51});
  Values one(p.size()), y(p.size());
  for (std::size_t k = 0; k < one.size(); ++k) one[k] = about.domain.region[about.numbers.cell[k]] == inner ? 1 : 0;
  L.multiply(one, y);
  for (const double flux : y) EXPECT_NEAR(flux, 0, 1e-14);
  for (double& x : one) x = 1 - x;
  L.multiply(one, y);
  const double out = std::accumulate(y.begin(), y.end(), 0.0);
  EXPECT_NEAR(out, 2.0 * 9, 1e-12);  // the open side's area over the half cell to it
}

}  // namespace
}  // namespace tether::coupled
