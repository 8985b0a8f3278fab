// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that are thinner than a cell are found, and told with their place.
#include "physics/box/bodies.hpp"

#include <gtest/gtest.h>

#include "unit/alone.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

ThinBodies found(int dim, const Mesh& mesh, CouplingMode mode = CouplingMode::cut_cell) {
  Coupled coupled = fluid_in_box(dim, 16);
  coupled.coupling = coupling_of(mode);
  const SolidSurface surface = surface_of(mesh);
  const FlowBox box(coupled);
  const Outside outside(coupled, {});
  return thin_bodies(Placer(coupled, surface, mesh.x.size(), box, outside, alone()).at(mesh.x), surface);
}

/// A plate .5 long (and, in space, wide) about the middle of the box, turned.
Mesh plate(int dim, double cells_across, double angle, double y = 0.503) {
  return lattice(dim, {8, 1, 8}, all,
                 turned_block({0.497, y, 0.501}, {0.5, cells_across / 16, dim == 3 ? 0.5 : 0}, angle));
}

class Thin : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, Thin, testing::Values(2, 3));

TEST_P(Thin, PlatesOfLessThanACellAreFound) {
  const int dim = GetParam();
  for (const double angle : {0.0, 0.3, 0.8}) {
    for (const double across : {0.05, 0.4, 0.8}) {
      const ThinBodies thin = found(dim, plate(dim, across, angle));
      EXPECT_GT(thin.cells, 0u) << angle << ' ' << across;
      EXPECT_GT(thin.of_cells, 0u);
      EXPECT_EQ(thin.body, 0);
      EXPECT_LT(std::abs(thin.place[0] - 0.5), 0.3);
      EXPECT_LT(std::abs(thin.place[1] - 0.5), 0.3);
    }
  }
}

TEST_P(Thin, BodiesOfThreeCellsAreNot) {
  const int dim = GetParam();
  for (const double angle : {0.0, 0.3, 0.7}) EXPECT_EQ(found(dim, plate(dim, 4, angle)).cells, 0u) << angle;
}

/// The thick body is the first; the number that is reported is the thin one's.
TEST_P(Thin, TheBodyIsNamed) {
  const int dim = GetParam();
  const Mesh both = together(plate(dim, 4, 0, 0.75), plate(dim, 0.3, 0, 0.253));
  const ThinBodies thin = found(dim, both);
  EXPECT_EQ(thin.body, 1);
  EXPECT_NEAR(thin.place[1], 0.253, 0.1);
  EXPECT_NE(thin_text(thin, dim).find("body 2"), std::string::npos);
  EXPECT_NE(thin_text({.cells = 2, .of_cells = 9}, dim).find("at 2 cells (their surface goes through 9): these cells"),
            std::string::npos);
  EXPECT_NE(thin_text({.cells = 1, .of_cells = 9}, dim).find("at 1 cell (their surface goes through 9): it counts"),
            std::string::npos);
}

TEST_P(Thin, ModesOfWholeCellsHaveNone) {
  const ThinBodies thin = found(GetParam(), plate(GetParam(), 0.3, 0.3), CouplingMode::symmetric);
  EXPECT_EQ(thin.cells, 0u);
  EXPECT_EQ(thin_text(thin, GetParam()), "");
}

}  // namespace
}  // namespace tether::coupled
