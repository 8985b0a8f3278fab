// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "physics/box/mesh/sizes_about.hpp"
#include "physics/box/mesh/split_facets.hpp"
#include "unit/physics/box/bodies_support.hpp"

// How large the cells of a mesh are.

namespace tether::coupled {
namespace {

Vec<3> between(const std::array<Vec<3>, 3>& corners, double s, double t) {
  Vec<3> x{};
  for (std::size_t a = 0; a < 3; ++a)
    x[a] = corners[0][a] + s * (corners[1][a] - corners[0][a]) + t * (corners[2][a] - corners[0][a]);
  return x;
}

/// The least size about a place, and the nearest facet, are those that many places on all facets have.
TEST(SizeTree, FindsTheLeastSizeAndTheNearestFacet) {
  constexpr double growth = 0.3, most = 0.5, apart = 0.6;
  constexpr int parts = 100;
  for (const int dim : {2, 3}) {
    const auto at = support::random_numbers(3000, 7);
    std::vector<SizeTree::Facet> facets(60);
    std::size_t next = 0;
    const auto place = [&](const Vec<3>& about, double reach) {
      Vec<3> x{};
      for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) x[a] = about[a] + reach * at[next++];
      return x;
    };
    for (SizeTree::Facet& facet : facets) {
      facet.corners[0] = place({}, 1);
      facet.corners[1] = place(facet.corners[0], 0.2), facet.corners[2] = place(facet.corners[0], 0.2);
      facet.size = 0.2 * std::abs(at[next++]);
    }
    const SizeTree tree(dim, facets);
    for (int k = 0; k < 50; ++k) {
      const Vec<3> x = place({}, 1), half = place({}, 0.05);
      double size = most, nearest = std::numeric_limits<double>::max();
      for (const SizeTree::Facet& facet : facets) {
        for (int i = 0; i <= parts; ++i) {
          for (int j = 0; i + j <= (dim == 3 ? parts : i); ++j) {
            const double way =
                distance(x, between(facet.corners, double(i) / parts, dim == 3 ? double(j) / parts : 0.0));
            size = std::min(size, facet.size + growth * way), nearest = std::min(nearest, way);
          }
        }
      }
      const auto found = tree.about(x, growth, most, apart);
      EXPECT_NEAR(found.size, size, 0.001) << dim;
      EXPECT_LE(found.size, size + 1e-12);
      if (nearest < apart * size) {
        EXPECT_NEAR(found.nearest, nearest, 0.003) << dim;
      }
      if (nearest > apart * size + 0.003) {
        EXPECT_GE(found.nearest, apart * found.size) << dim;
      }
      const Vec<3> width{std::abs(half[0]), std::abs(half[1]), std::abs(half[2])};
      EXPECT_LE(tree.least_in(x, width, growth, most), size + 1e-12);
    }
  }
}

/// The surface of a plate that is cut into short edges is as closed and as large as before, part by part.
TEST(SplitFacets, LeavesTheSurfaceAsItIs) {
  constexpr double size = 0.11;
  const Mesh plate =
      support::lattice(3, {1, 1, 2}, support::all, support::turned_block({0.5, 0.5, 0.5}, {0.04, 0.3, 0.7}, 0.4));
  const SolidSurface surface = surface_of(plate);
  Outline outline;
  outline.dim = 3;
  for (std::size_t n = 0; n < plate.node_count(); ++n)
    outline.places.push_back(place_of(plate.x, static_cast<int>(n), 3));
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    Outline::Facet facet{{}, {BoundaryKind::solid, static_cast<int>(s)}};
    std::ranges::transform(surface.side(s), facet.corners.begin(), [](int n) { return static_cast<std::size_t>(n); });
    outline.facets.push_back(facet);
  }
  Outline as_it_was = outline;
  split_facets(outline.facets.size(), size, as_it_was);
  EXPECT_EQ(as_it_was.places, outline.places);
  split_facets(0, size, outline);
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::vector<Vec<3>> area(surface.side_count());
  for (const Outline::Facet& facet : outline.facets) {
    std::array<Vec<3>, 3> x{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = facet.corners[k], b = facet.corners[(k + 1) % 3];
      EXPECT_LE(distance(outline.places[a], outline.places[b]), size * (1 + 1e-12));
      ++edges[std::minmax(a, b)], x[k] = outline.places[a];
    }
    const Vec<3> twice = cross(minus(x[1], x[0]), minus(x[2], x[0]));
    for (std::size_t a = 0; a < 3; ++a) area[static_cast<std::size_t>(facet.boundary.number)][a] += 0.5 * twice[a];
  }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2);
  for (std::size_t s = 0; s < surface.side_count(); ++s)
    EXPECT_LT(distance(area[s], area_of_side(surface, s, plate.x)), 1e-15);
}

}  // namespace
}  // namespace tether::coupled
