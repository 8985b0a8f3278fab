// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/solid_surface.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

#include "grid/block_mesh.hpp"
#include "grid/overlaps.hpp"

namespace tether {
namespace {

/// A block of 2 by 1 by 1 about the origin, in the plane or in space.
Mesh block(ElementKind kind) {
  Block of;
  of.edges = {straight({-1, -0.5}, {1, -0.5}), straight({1, -0.5}, {1, 0.5}), straight({1, 0.5}, {-1, 0.5}),
              straight({-1, 0.5}, {-1, -0.5})};
  of.cells = {3, 2, 2}, of.z_low = -0.5, of.z_high = 0.5;
  std::vector<MeshFlaw> flaws;
  return mesh_of_blocks({of}, kind, flaws);
}

std::vector<double> turned(const Mesh& mesh, double angle) {
  std::vector<double> q = mesh.x;
  const auto dim = static_cast<std::size_t>(mesh.dim());
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const double x = mesh.x[n * dim], y = mesh.x[n * dim + 1];
    q[n * dim] = std::cos(angle) * x - std::sin(angle) * y, q[n * dim + 1] = std::sin(angle) * x + std::cos(angle) * y;
  }
  return q;
}

/// With the normals of the start a turn by a sweeps 2 (cos a - 1) of the volume; with those of the middle nothing.
TEST(SolidSurface, SweepsAsItTurns) {
  constexpr double angle = 0.2, volume = 2;
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::quad9, ElementKind::hex8, ElementKind::tet4}) {
    const Mesh mesh = block(kind);
    const SolidSurface surface = surface_of(mesh);
    const std::vector<double> q1 = turned(mesh, angle);
    std::vector<double> middle(q1);
    for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (mesh.x[k] + q1[k]);
    EXPECT_NEAR(swept_volumes(surface, mesh.x, mesh.x, q1)[0], 2 * (std::cos(angle) - 1) * volume, 1e-12);
    EXPECT_NEAR(swept_volumes(surface, middle, mesh.x, q1)[0], 0, 1e-14);
  }
}

/// Places inside, outside and on a body that has turned.
TEST(OverlapFinder, FindsAPlaceThatABodyHolds) {
  for (const ElementKind kind : {ElementKind::quad4, ElementKind::tri6, ElementKind::hex8, ElementKind::tet10}) {
    const Mesh mesh = block(kind);
    const std::vector<double> q = turned(mesh, 0.7);
    const auto along = [](double x) { return Vec<3>{x * std::cos(0.7), x * std::sin(0.7), 0}; };
    OverlapFinder finder(mesh);
    EXPECT_FALSE(finder.find_held(std::array{along(1), along(1.01), Vec<3>{-3, 5, 0.2}}, q));
    EXPECT_EQ(finder.find_held(std::array{along(1.01), along(0.99), along(0)}, q), along(0.99));
  }
}

}  // namespace
}  // namespace tether
