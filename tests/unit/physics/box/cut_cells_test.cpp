// SPDX-License-Identifier: GPL-3.0-or-later
// Cells that solids cut: the fluid that is left, what holds it at rest, and what a solid that moves in it does.
#include "physics/box/cut_cells.hpp"

#include <gtest/gtest.h>

#include "physics/box/projection.hpp"
#include "unit/alone.hpp"
#include "unit/full_length.hpp"
#include "unit/physics/box/bodies_support.hpp"
#include "unit/total.hpp"

namespace tether::coupled {
namespace {

using namespace support;

Coupled box_of(int dim, int n, CouplingMode mode) {
  Coupled coupled = fluid_in_box(dim, n);
  coupled.coupling = coupling_of(mode);
  return coupled;
}

double largest(const std::vector<double>& x) {
  double most = 0;
  for (const double value : x) most = std::max(most, std::abs(value));
  return most;
}

class Cut : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, Cut, testing::Values(2, 3));

TEST_P(Cut, LeavesTheFluidThatTheSolidDoesNotHold) {
  const int dim = GetParam();
  for (const double angle : {0.0, 0.3, 0.9}) {
    const Mesh mesh = hollow_block(dim, 1, {0.51, 0.48, 0.5}, 0.5, angle);
    const Surroundings at_rest(box_of(dim, 16, CouplingMode::cut_cell), mesh);
    const double solid = std::pow(0.5, dim) - std::pow(0.5 / 3, dim);
    for (int axis = 0; axis < dim; ++axis) EXPECT_NEAR(total(at_rest.cut.fluid[at(axis)]), 1 - solid, 1e-12);
  }
}

/// A side in the plane between cells cuts nothing off them.
TEST_P(Cut, LeavesCellsBetweenPlanesWhole) {
  const int dim = GetParam();
  const Mesh mesh = solid_block(dim, 3, {0.5, 0.5, 0.5}, 0.5, 0);
  const Surroundings whole(box_of(dim, 8, CouplingMode::symmetric), mesh),
      cut(box_of(dim, 8, CouplingMode::cut_cell), mesh);
  for (int axis = 0; axis < dim; ++axis) {
    for (std::size_t f = 0; f < cut.domain.face[at(axis)].size(); ++f) {
      const auto [low, high] = cells_beside(cut.domain.grid, axis, f);
      if (low < 0 || high < 0 || whole.domain.kind[at(low)] != whole.domain.kind[at(high)]) continue;
      EXPECT_EQ(cut.domain.volume[at(axis)][f], whole.domain.volume[at(axis)][f]);
      EXPECT_EQ(cut.domain.area[at(axis)][f], whole.domain.area[at(axis)][f]);
    }
  }
}

/// Fluid of density 1 under a weight of 1 in a box that is open at the top: the pressure y_top - y leaves it at rest.
struct AtRest {
  double left = 0;  // flux that is left, of one step of length 1
  Vec<3> lift{};
};
AtRest rest_of(int dim, int n, CouplingMode mode, const Mesh& mesh) {
  Coupled coupled = box_of(dim, n, mode);
  coupled.sides[side_top] = BoxSide::open;
  const Surroundings about(coupled, mesh);
  FaceValues v = face_values(coupled.grid);
  std::vector<double> p;
  for (const std::size_t cell : about.numbers.cell)
    p.push_back(1 - coupled.grid.middle(1, coupled.grid.place_of_cell(cell)[1]));
  for (std::size_t f = 0; f < v[1].size(); ++f) v[1][f] = about.domain.face[1][f] == FaceKind::open ? -1 : 0;
  add_pressure(about.domain, about.numbers, p, 1, v);
  AtRest rest;
  for (const auto& values : v) rest.left = std::max(rest.left, largest(values));
  const std::vector<double> forces = transposed_product(about.map.B, p);
  for (std::size_t k = 0; k < forces.size(); ++k) rest.lift[k % at(dim)] += forces[k];
  return rest;
}

TEST_P(Cut, LiftIsTheWeightOfTheFluidThatTheSolidHolds) {
  const int dim = GetParam();
  const Mesh mesh = lattice(dim, {6, 4, 3}, all, turned_block({0.5, 0.5, 0.5}, {0.3, 0.2, dim == 3 ? 0.25 : 0}, 0.5));
  const double volume = enclosed_volumes(surface_of(mesh), mesh.x)[0];
  for (const int n : dim == 2 ? std::vector<int>{16, 32, 64, 128} : std::vector<int>{12, 16, 24}) {
    const AtRest rest = rest_of(dim, n, CouplingMode::cut_cell, mesh);
    EXPECT_LE(rest.left, 1e-10);
    EXPECT_NEAR(rest.lift[1] / volume, 1, 3e-12) << n;
    EXPECT_NEAR(rest.lift[0] / volume, 0, 3e-12) << n;
  }
}

/// A post through the open side at the top, whose end is nearer to it than a cell's middle: the pressure falls to zero.
TEST_P(Cut, LiftOfWhatStandsOutAtAnOpenSideIsThatOfItsPartInside) {
  const int dim = GetParam();
  for (const double depth : {0.02, 0.2}) {
    const Mesh mesh = lattice(dim, {3, 3, 3}, all, [=](const Vec<3>& s) {
      return Vec<3>{0.31 + 0.4 * s[0], 1 - depth + 0.5 * s[1], 0.33 + 0.4 * s[2]};
    });
    const AtRest rest = rest_of(dim, 16, CouplingMode::cut_cell, mesh);
    EXPECT_NEAR(rest.lift[1] / (depth * std::pow(0.4, dim - 1)), 1, 1e-11) << depth;
  }
}

/// Where cells are wholly fluid or not the pressure is sampled up to half a cell away: of order 1.
TEST(WholeCells, LiftIsOfOrderOne) {
  const Mesh mesh = lattice(2, {6, 4, 1}, all, turned_block({0.5, 0.5, 0}, {0.3, 0.2, 0}, 0.5));
  const double bounds[] = {0.24, 0.11, 0.06, 0.032};
  for (int k = 0; k < 4; ++k) {
    const AtRest rest = rest_of(2, 16 << k, CouplingMode::symmetric, mesh);
    EXPECT_LE(rest.left, 1e-10);
    EXPECT_LT(std::abs(rest.lift[1] / 0.06 - 1), bounds[k]) << k;
  }
}

/// Box and body move with one velocity: D v + B u.
std::vector<double> flux_of_common_motion(const Surroundings& about, const CouplingMatrix& B, const Vec<3>& velocity,
                                          std::size_t unknowns) {
  const FlowDomain& domain = about.domain;
  FaceValues v = face_values(domain.grid);
  for (std::size_t axis = 0; axis < at(domain.grid.dim); ++axis)
    std::fill(v[axis].begin(), v[axis].end(), velocity[axis]);
  std::vector<double> flux = net_flux(domain, about.numbers, v), u(unknowns);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = velocity[k % at(domain.grid.dim)];
  const std::vector<double> caused = product(B, u);
  for (std::size_t p = 0; p < flux.size(); ++p) flux[p] += caused[p];
  return flux;
}

/// But for boxes about faces with next to no fluid, 1e-9 of a box, which count as empty: in space their surface is of
/// the order of the power 2/3 of that; in the plane there are none here.
TEST_P(Cut, ABodyThatMovesWithTheFluidMakesNoFlow) {
  const int dim = GetParam();
  for (const double angle : {0.0, 0.4, 1.2}) {
    for (const Mesh& mesh : {solid_block(dim, 3, {0.47, 0.52, 0.5}, 0.45, angle),
                             hollow_block(dim, 1, {0.503, 0.49, 0.497}, 0.54, angle)}) {
      const int n = dim == 2 ? 24 : 20;
      const Surroundings about(box_of(dim, n, CouplingMode::cut_cell), mesh);
      const auto flux = flux_of_common_motion(about, about.map.B, {0.7, -0.4, 1.3}, mesh.x.size());
      EXPECT_LT(largest(flux), 1e-11 * about.domain.grid.area(0)) << angle << ' ' << mesh.node_count();
    }
  }
}

/// Also where it leaves by an open side: nearer to it than half a cell, a hair from it, at it but for rounding, and
/// partly beyond. A body that meets the side at an angle is off by half a face's flow in the cells of the wedge before
/// it.
TEST_P(Cut, ABodyThatLeavesWithTheFluidMakesNoFlow) {
  const int dim = GetParam();
  for (const bool right : {false, true}) {
    for (const double beyond : {-0.04, -0.02, -1e-5, -1e-12, 0.0, 1e-12, 0.01, 0.1}) {
      for (const double angle : {0.0, 0.3}) {
        const double middle = right ? 0.85 + beyond : 0.15 - beyond;
        const Mesh mesh = solid_block(dim, 3, {middle, 0.52, 0.5}, 0.3, angle);
        Coupled coupled = box_of(dim, dim == 2 ? 16 : 12, CouplingMode::cut_cell);
        coupled.sides[right ? 1 : 0] = BoxSide::open;
        const Surroundings about(coupled, mesh);
        const auto flux = flux_of_common_motion(about, about.map.B, {0.7, -0.4, 1.3}, mesh.x.size());
        const double most = angle > 0 ? 0.6 : 1e-9;
        EXPECT_LT(largest(flux), most * about.domain.grid.area(0)) << right << ' ' << beyond << ' ' << angle;
      }
    }
  }
}

/// With the paper's map as well, since faces are closed where lines cross the surface, whatever its shape.
TEST_P(Cut, ABodyThatMovesWithTheFluidMakesNoFlowByCrossings) {
  const int dim = GetParam();
  for (const double side : {0.5, 0.03}) {
    const Mesh mesh = solid_block(dim, 3, {0.46, 0.49, 0.49}, side, 0.4);
    const Surroundings about(box_of(dim, 13, CouplingMode::paper), mesh);
    const CouplingMatrix B = map_by_crossings(alone(), {about.surface, about.pieces, about.domain, about.numbers},
                                              about.crossings, mesh.x.size());
    ASSERT_GT(B.nonZeros(), 0);
    const auto flux = flux_of_common_motion(about, B, {0.7, -0.4, 1.3}, mesh.x.size());
    EXPECT_LT(largest(flux), 1e-14);
  }
}

/// A plate turned about z, much longer than the box.
Mesh plate(int dim, double thickness, double angle, const Vec<3>& middle) {
  return lattice(dim, {1, 20, 2}, all, [=](const Vec<3>& s) {
    const double x = (s[0] - 0.5) * thickness, y = (s[1] - 0.5) * 3;
    return Vec<3>{middle[0] + std::cos(angle) * x - std::sin(angle) * y,
                  middle[1] + std::sin(angle) * x + std::cos(angle) * y, 2 * s[2] - 0.5};
  });
}

bool divides(int dim, CouplingMode mode, double thickness, double angle, const Vec<3>& middle, const Box<3>* floor) {
  Coupled coupled = box_of(dim, dim == 2 ? 16 : 10, mode);
  if (floor != nullptr) coupled.obstacles.push_back(*floor);
  const Surroundings about(coupled, plate(dim, thickness, angle, middle));
  const double c = 0.3 * std::cos(angle), s = 0.3 * std::sin(angle);
  const int one = about.region_at({middle[0] - c, middle[1] - s, 0.4}),
            other = about.region_at({middle[0] + c, middle[1] + s, 0.4});
  return one >= 0 && other >= 0 && one != other;
}

/// Shells of a quarter of a cell to four cells, anyhow: what is inside and what is outside are never one region, though
/// cells whose middle is in the shell hold fluid.
TEST_P(Cut, ShellsDoNotLeak) {
  const int dim = GetParam(), n = dim == 2 ? 12 : 10;
  const double side = dim == 2 ? 0.66 : 0.5;
  for (unsigned seed = 0; seed < (dim == 2 ? 400u : 30u); ++seed) {
    const std::vector<double> r = random_numbers(5, seed);
    const double inner = std::max(0.2, 1 - 2 * (2.125 + 1.875 * r[0]) / n / side);
    const auto block = turned_block({0.5 + 0.04 * r[1], 0.5 + 0.04 * r[2], 0.5 + 0.04 * r[3]},
                                    {side, side, dim == 3 ? side : 0}, 3 * r[4]);
    const auto shell = [&](Vec<3> s) {
      for (double& x : s) x = x < 0.2 ? 0 : x > 0.8 ? 1 : 0.5 + (x < 0.5 ? -inner : inner) / 2;
      return block(s);
    };
    const auto keep = [=](const Cell& c) { return c != Cell{1, 1, dim == 3 ? 1 : 0}; };
    const Surroundings about(box_of(dim, n, CouplingMode::cut_cell), lattice(dim, {3, 3, 3}, keep, shell));
    std::array<std::vector<int>, 2> sides{std::vector<int>(std::size_t(about.domain.regions), 0), {}};
    sides[1] = sides[0];
    for (std::size_t c = 0; c < about.domain.region.size(); ++c) {
      if (about.crossings.inside[c] == 0) sides[about.crossings.in_cavity[c]][std::size_t(about.domain.region[c])] = 1;
    }
    for (std::size_t r2 = 0; r2 < sides[0].size(); ++r2) EXPECT_LT(sides[0][r2] + sides[1][r2], 2) << seed;
  }
}

/// From one side of the box to the other, through corners and along the middles of cells, some far thinner than a
/// cell: no open faces lead from one side of the plate to the other. Neither at an obstacle. In space, where the plates
/// of the plane are cut by more faces, by default the thinnest and the thickest.
TEST_P(Cut, PlatesDoNotLeak) {
  const Box<3> floor{{0, 0, 0}, {1, 0.2, 1}};
  std::vector<double> thicknesses{1e-4, 0.15};
  if (GetParam() == 2 || test::at_full_length()) thicknesses.insert(thicknesses.end(), {0.03, 0.06, 0.1});
  for (const CouplingMode mode : {CouplingMode::symmetric, CouplingMode::cut_cell}) {
    for (const double thickness : thicknesses) {
      for (const double angle : {0.0, 0.2, 0.78539816339744831, 1.1}) {
        for (const double y : {0.5, 0.5625}) {
          for (const Box<3>* obstacle : {static_cast<const Box<3>*>(nullptr), &floor}) {
            EXPECT_TRUE(divides(GetParam(), mode, thickness, angle, {0.53125, y, 0.5}, obstacle))
                << word_of(mode) << " " << thickness << " " << angle << " " << y << " " << (obstacle != nullptr);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace tether::coupled
