// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/surface.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <map>
#include <vector>

#include "base/numbers.hpp"
#include "grid/contact/apart.hpp"
#include "grid/solid_surface.hpp"
#include "unit/grid/mesh_support.hpp"

namespace tether {
namespace {

Mesh block(ElementKind kind) { return meshed({block_between(0, 1, dimension_of(kind) == 3 ? 1 : 0)}, kind); }

constexpr std::array kinds{ElementKind::quad4, ElementKind::quad9, ElementKind::tri3, ElementKind::tri6,
                           ElementKind::hex8,  ElementKind::hex27, ElementKind::tet4, ElementKind::tet10};

/// The parts that the nodes at x = 0 have of a pressure of 1 there, of its facets, or of its points.
std::vector<double> parts_of_pressure(const Mesh& mesh, const ContactSurface& surface, bool of_points) {
  std::vector<double> x, forces(surface.places.size() * at(mesh.dim()), 0.0), f(mesh.x.size(), 0.0);
  surface.places.find(mesh.x, x);
  const auto at_left = [&](int place) { return std::abs(place_of(x, place, mesh.dim())[0]) < 1e-12; };
  for (const ContactPoint& point : surface.points) {
    if (of_points && at_left(point.place)) forces[at(point.place) * at(mesh.dim())] += point.area;
  }
  for (const ContactFacet& facet : surface.facets) {
    const Vec<3> a = place_of(x, facet.corners[0], mesh.dim()), b = place_of(x, facet.corners[1], mesh.dim());
    if (of_points || !at_left(facet.corners[0]) || !at_left(facet.corners[1])) continue;
    if (mesh.dim() == 3 && !at_left(facet.corners[2])) continue;
    const Vec<3> e = minus(b, a);
    double area = std::sqrt(dot(e, e));
    if (mesh.dim() == 3) {
      const Vec<3> n = cross(e, minus(place_of(x, facet.corners[2], 3), a));
      area = 0.5 * std::sqrt(dot(n, n));
    }
    for (int c = 0; c < mesh.dim(); ++c) forces[at(facet.corners[at(c)]) * at(mesh.dim())] += area / mesh.dim();
  }
  surface.places.add_to_nodes(forces, f);
  std::vector<double> parts;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) parts.push_back(f[n * at(mesh.dim())]);
  return parts;
}

/// A constant pressure pushes at the nodes as much from the facets as from the points, which is what the side's own
/// functions ask.
TEST(ContactSurface, PushesAtTheNodesAsTheSideDoes) {
  for (const ElementKind kind : kinds) {
    const Mesh mesh = block(kind);
    const ContactSurface surface = contact_surface(mesh, {}, {});
    const auto facets = parts_of_pressure(mesh, surface, false), points = parts_of_pressure(mesh, surface, true);
    double whole = 0;
    for (std::size_t n = 0; n < facets.size(); ++n) {
      EXPECT_NEAR(facets[n], points[n], 1e-12) << element_name(kind) << " in " << mesh.dim() << ", node " << n;
      whole += facets[n];
    }
    EXPECT_NEAR(whole, 1, 1e-12);
  }
}

/// Each place of a closed surface counts once: facets less edges and corners.
TEST(ContactSurface, CountsEachPlaceOnce) {
  for (const ElementKind kind : kinds) {
    const ContactSurface surface = contact_surface(block(kind), {}, {{{2, 0, 0}, {3, 1, 1}}});
    double count = static_cast<double>(surface.facets.size());
    std::map<int, double> at_corner;
    for (const ContactFacet& facet : surface.facets) {
      for (int c = 0; c < surface.dim(); ++c) at_corner[facet.corners[at(c)]] += 1;
    }
    for (const ContactJoint& joint : surface.joints) {
      count += joint.weight;
      for (const int end : joint.ends) {
        if (end >= 0) at_corner[end] += joint.weight;
      }
    }
    for (const auto& [corner, sum] : at_corner) EXPECT_EQ(sum, 1) << element_name(kind) << ", place " << corner;
    // Two closed surfaces: of spheres Euler's number is 2, and of rings in the plane 0.
    EXPECT_EQ(count, surface.dim() == 3 ? 4 : 0);
  }
}

TEST(ContactSurface, KnowsHowFarItIsFromOthers) {
  Team team;
  for (const ElementKind kind : kinds) {
    const Mesh mesh = block(kind);
    const ContactSurface surface = contact_surface(mesh, {}, {{{1.25, -1, -1}, {3, 2, 2}}});
    const std::vector<SurfacePlane> floor{{{0, -0.125, 0}, {0, 1, 0}}};
    EXPECT_NEAR(nearest_surfaces(surface, {.itself = false}, {}, mesh.x, 0.3, team).away, 0.25, 1e-12);
    EXPECT_NEAR(nearest_surfaces(surface, {.itself = false}, floor, mesh.x, 0.3, team).away, 0.125, 1e-12);
    EXPECT_TRUE(std::isinf(nearest_surfaces(surface, {.itself = false}, {}, mesh.x, 0.2, team).away));
  }
}

/// Sides of which not all nodes take part meet nothing.
TEST(ContactSurface, LeavesOutSides) {
  const Mesh mesh = block(ElementKind::quad9);
  std::vector<int> nodes;
  for (int n = 0; n < static_cast<int>(mesh.node_count()); ++n) {
    if (place_of(mesh.x, n, 2)[0] < 1e-12) nodes.push_back(n);
  }
  const ContactSurface surface = contact_surface(mesh, nodes, {});
  EXPECT_EQ(surface.side_nodes.size(), 3U);
}

}  // namespace
}  // namespace tether
