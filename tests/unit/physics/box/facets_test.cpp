// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grid/figures.hpp"
#include "grid/solid_surface.hpp"
#include "physics/box/liquid/facets.hpp"

// Facets of figures, and of a liquid's surface.

namespace tether::liquid {
namespace {

class Facets : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(InPlaneAndSpace, Facets, testing::Values(2, 3));

/// Parts of a simplex and of its faces add up.
TEST(LiquidFacets, PartsOfSimplices) {
  Simplex simplex;
  simplex.corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int cut = 0; cut < 16; ++cut) {
    Simplex other = simplex;
    for (int k = 0; k < 4; ++k) {
      simplex.distance[at(k)] = (cut >> k & 1 ? 1 : -1) * (0.3 + 0.2 * k);
      other.distance[at(k)] = -simplex.distance[at(k)];
    }
    EXPECT_NEAR(cut_of(simplex, 3).volume + cut_of(other, 3).volume, 1.0 / 6, 1e-14) << cut;
    EXPECT_NEAR(cut_of(simplex, 2).volume + cut_of(other, 2).volume, 0.5, 1e-14) << cut;
    EXPECT_EQ(cut_of(simplex, 3).facets, cut_of(other, 3).facets);
  }
  simplex.distance = {-0.5, 0.5, 0.5, 0.5};
  const Cut cut = cut_of(simplex, 3);
  EXPECT_NEAR(cut.volume, 1.0 / 48, 1e-15);
  EXPECT_NEAR(area_of(cut.facet[0], 3), std::sqrt(3.0) / 8, 1e-15);
  const Facet& f = cut.facet[0];
  EXPECT_LT(dot(cross(minus(f[1], f[0]), minus(f[2], f[0])), minus(simplex.corner[0], f[0])), 0);  // it is below
}

/// Facets of a figure enclose as much as the figure.
TEST_P(Facets, FiguresEncloseTheirVolume) {
  const int dim = GetParam();
  const Box<3> box{{0, 0, 0}, {1, 1, dim == 3 ? 1.0 : 0.0}};
  const auto enclosed = [&](const Figure& figure) {
    const FigureSurface made = surface_of(figure, dim, box, 0.1);
    SolidSurface surface;
    surface.dim = dim, surface.sides = made.sides, surface.sheets = 1;
    surface.sheet.assign(made.sides.size() / at(dim), 0);
    return enclosed_volumes(surface, made.x)[0];
  };
  const double r = 0.3;
  EXPECT_NEAR(enclosed(Ellipsoid{{0.5, 0.5, 0.5}, {r, 2 * r, dim == 3 ? r : 0}}),
              dim == 2 ? 2 * std::numbers::pi * r * r : 8 * std::numbers::pi * r * r * r / 3, 1e-12);
  const double depth = dim == 3 ? 1.4 : 1;  // two cells beyond the box on both sides
  EXPECT_NEAR(enclosed(Prism{{.x = {0, 0, 0.5, 1, 1}, .y = {0, 1, 0.5, 1, 0}}}), 0.75 * depth, 1e-12);
  EXPECT_GT(enclosed(HalfSpace{{0.5, 0.5, 0.5}, {0.6, 0.8, 0}}), 1);
}

}  // namespace
}  // namespace tether::liquid
