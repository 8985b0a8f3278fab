// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of solids: what it encloses, and the pieces that cells cut it into.
#include <gtest/gtest.h>

#include "physics/box/surface_pieces.hpp"
#include "unit/physics/box/bodies_support.hpp"
#include "unit/total.hpp"

namespace tether::coupled {
namespace {

using namespace support;

Mesh block_of(int dim) { return solid_block(dim, 3, {0.48, 0.52, 0.45}, 0.4, 0.4); }

class InBothDimensions : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, InBothDimensions, testing::Values(2, 3));

TEST_P(InBothDimensions, ASolidEnclosesItsVolumeWithSidesThatCancel) {
  const int dim = GetParam();
  const SolidSurface surface = surface_of(block_of(dim));
  EXPECT_EQ(surface.side_count(), dim == 2 ? 12u : 108u);
  EXPECT_EQ(surface.sheets, 1);
  EXPECT_EQ(surface.cavity, std::vector<std::uint8_t>{0});
  EXPECT_NEAR(enclosed_volumes(surface, block_of(dim).x)[0], std::pow(0.4, dim), 1e-15);
  Vec<3> sum{};
  double size = 0;
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const Vec<3> area = area_of_side(surface, s, block_of(dim).x);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += area[i];
    size += std::hypot(area[0], area[1], area[2]);
  }
  for (const double x : sum) EXPECT_NEAR(x, 0, 1e-15);
  EXPECT_NEAR(size, dim == 2 ? 4 * 0.4 : 6 * 0.16, 1e-14);
}

TEST_P(InBothDimensions, ACavityIsASheetOfNegativeVolume) {
  const int dim = GetParam();
  const Mesh mesh = together(hollow_block(dim, 2, {0.3, 0.3, 0.3}, 0.3, 0.2), solid_block(dim, 1, {8, 8, 8}, 2, 0));
  const SolidSurface surface = surface_of(mesh);
  ASSERT_EQ(surface.sheets, 3);
  EXPECT_EQ(surface.parts, 2);
  const std::vector<double> volumes = enclosed_volumes(surface, mesh.x);
  for (std::size_t s = 0; s < 3; ++s) {
    const bool far = surface.part[at(static_cast<int>(std::find(surface.sheet.begin(), surface.sheet.end(), s) -
                                                      surface.sheet.begin()))] == 1;
    const double expected = far ? std::pow(2, dim) : surface.cavity[s] != 0 ? -std::pow(0.1, dim) : std::pow(0.3, dim);
    EXPECT_NEAR(volumes[s], expected, 1e-13) << s;
  }
  EXPECT_EQ(std::count(surface.cavity.begin(), surface.cavity.end(), 1), 1);
}

/// The place of a body costs no digits of its volume beyond those of its nodes.
TEST_P(InBothDimensions, AVolumeFarFromTheOriginKeepsItsDigits) {
  const int dim = GetParam();
  Mesh mesh = block_of(dim);
  for (double& x : mesh.x) x = std::round(x * 1024) / 1024;  // which far away are exact as well
  const SolidSurface surface = surface_of(mesh);
  const double near = enclosed_volumes(surface, mesh.x)[0];
  for (double& x : mesh.x) x += 1e6;
  EXPECT_NEAR(enclosed_volumes(surface, mesh.x)[0], near, 1e-15);
}

double polynomial(int degree, const Vec<3>& x) {
  const double line = 0.3 + x[0] - 0.7 * x[1] + 0.4 * x[2], other = 1 - 0.2 * x[0] + x[1] + 2 * x[2];
  return degree == 0 ? 1 : degree == 1 ? line : line * other;
}

/// Of a polynomial of degree 2 over a side: by the middles of edges, and by Simpson's rule on an edge.
double exact_integral(const SolidSurface& surface, std::span<const double> q, std::size_t side, int degree) {
  const auto nodes = surface.side(side);
  const Vec<3> area = area_of_side(surface, side, q);
  const auto middle = [&](std::size_t a, std::size_t b) {
    const Vec<3> x = place_of(q, nodes[a], surface.dim), y = place_of(q, nodes[b], surface.dim);
    return polynomial(degree, {(x[0] + y[0]) / 2, (x[1] + y[1]) / 2, (x[2] + y[2]) / 2});
  };
  const double mean = surface.dim == 2 ? (middle(0, 0) + middle(1, 1) + 4 * middle(0, 1)) / 6
                                       : (middle(0, 1) + middle(1, 2) + middle(2, 0)) / 3;
  return mean * std::hypot(area[0], area[1], area[2]);
}

TEST_P(InBothDimensions, PiecesOfSidesIntegrateExactlyAndLieInOneBox) {
  const int dim = GetParam();
  const Mesh mesh = hollow_block(dim, 1, {0.52, 0.45, 0.6}, 1.3, 0.7);  // part of it outside of the box
  const SolidSurface surface = surface_of(mesh);
  for (const int per_cell : {1, 2}) {
    const StaggeredGrid grid = fluid_in_box(dim, 7).grid;
    const SurfacePieces cut = cut_surface(surface, mesh.x, grid, per_cell);
    std::array<std::vector<double>, 3> integrals;
    for (auto& sums : integrals) sums.assign(surface.side_count(), 0.0);
    for (const SurfacePiece& piece : cut.pieces) {
      std::array<double, 3> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
      const Vec<3> area = cut.area[at(piece.side)];
      for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
        const SurfacePoint& point = cut.points[k];
        EXPECT_NEAR(point.share[0] + point.share[1] + point.share[2], 1, 1e-14);
        Vec<3> by_share{};
        for (std::size_t a = 0; a < at(dim); ++a) {
          const Vec<3> x = place_of(mesh.x, surface.side(at(piece.side))[a], dim);
          for (std::size_t i = 0; i < 3; ++i) by_share[i] += point.share[a] * x[i];
        }
        for (std::size_t i = 0; i < at(dim); ++i) {
          EXPECT_NEAR(by_share[i], point.x[i], 1e-14);
          low[i] = std::min(low[i], point.x[i]), high[i] = std::max(high[i], point.x[i]);
        }
        for (int degree = 0; degree < 3; ++degree)
          integrals[at(degree)][at(piece.side)] +=
              point.part * std::hypot(area[0], area[1], area[2]) * polynomial(degree, point.x);
      }
      for (std::size_t i = 0; i < at(dim); ++i) {
        const double size = grid.d[i] / per_cell;
        EXPECT_EQ(std::floor((low[i] - grid.low[i]) / size), std::floor((high[i] - grid.low[i]) / size));
        EXPECT_EQ(piece.cell[i], std::floor((low[i] - grid.low[i]) / grid.d[i]));
      }
    }
    for (std::size_t s = 0; s < surface.side_count(); ++s) {
      for (int degree = 0; degree < 3; ++degree)
        EXPECT_NEAR(integrals[at(degree)][s], exact_integral(surface, mesh.x, s, degree), 1e-13) << s;
    }
  }
}

/// Sides in the planes between cells belong to one piece, and their area is not lost.
TEST_P(InBothDimensions, SidesInThePlanesBetweenCellsAreWhole) {
  const int dim = GetParam();
  const Mesh mesh = solid_block(dim, 2, {0.5, 0.5, 0.5}, 0.5, 0);
  const SolidSurface surface = surface_of(mesh);
  const SurfacePieces cut = cut_surface(surface, mesh.x, fluid_in_box(dim, 4).grid, 1);
  EXPECT_EQ(cut.pieces.size(), surface.side_count());
  std::vector<double> parts;
  for (const SurfacePoint& point : cut.points) parts.push_back(point.part);
  EXPECT_NEAR(total(parts), static_cast<double>(surface.side_count()), 1e-12);
}

}  // namespace
}  // namespace tether::coupled
