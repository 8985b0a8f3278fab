// SPDX-License-Identifier: GPL-3.0-or-later
// Maps whose facets turn, and the derivatives of what they make of velocities and pressures.
#include "physics/box/side_matrix.hpp"

#include <gtest/gtest.h>

#include "grid/block_mesh.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

/// A block in a box of the same dimension, of elements whose sides are facets, or several.
class Turned : public testing::TestWithParam<ElementKind> {
 protected:
  static Mesh block() {
    Block of;
    of.edges = {straight({0.31, 0.42}, {0.73, 0.36}), straight({0.73, 0.36}, {0.69, 0.64}),
                straight({0.69, 0.64}, {0.34, 0.61}), straight({0.34, 0.61}, {0.31, 0.42})};
    of.cells = {3, 2, 1}, of.z_low = 0.33, of.z_high = 0.62;
    std::vector<MeshFlaw> flaws;
    return mesh_of_blocks({of}, GetParam(), flaws);
  }
  Turned() : mesh(block()), about(fluid_in_box(mesh.dim(), 9), mesh) {}

  /// The map with the areas of nodes that are e times `way` from where they are.
  CouplingMatrix ahead(double e) const {
    std::vector<double> q = mesh.x;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += e * way[k];
    return about.map.fluxes.with(alone(), areas_of_sides(about.surface, q));
  }

  Mesh mesh;
  support::Surroundings about;
  std::vector<double> way = random_numbers(mesh.x.size(), 3);
};
INSTANTIATE_TEST_SUITE_P(Coupled, Turned,
                         testing::Values(ElementKind::tri3, ElementKind::quad9, ElementKind::tet4, ElementKind::tet10,
                                         ElementKind::hex8, ElementKind::hex27));

constexpr double apart = 0.01;  // areas are of degree 2 at most in the places: differences have their slopes exactly

std::vector<double> slope_between(const std::vector<double>& after, const std::vector<double>& before) {
  std::vector<double> slope;
  for (std::size_t k = 0; k < after.size(); ++k) slope.push_back((after[k] - before[k]) / (2 * apart));
  return slope;
}

void expect_alike(const std::vector<double>& found, const std::vector<double>& expected) {
  double size = 0;
  for (const double value : expected) size = std::max(size, std::abs(value));
  ASSERT_GT(size, 0);
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12 * size);
}

TEST_P(Turned, FluxesChangeByTheirSlopes) {
  const std::vector<double> w = random_numbers(mesh.x.size(), 5);
  expect_alike(product(about.map.fluxes.slopes(alone(), mesh.x, w), way),
               slope_between(product(ahead(apart), w), product(ahead(-apart), w)));
}

TEST_P(Turned, ForcesChangeByTheirSlopes) {
  const std::vector<double> p = random_numbers(about.numbers.cell.size(), 6);
  const NodalPattern pattern(mesh.dim(), mesh.node_count(), mesh.nodes, node_count_of(mesh.kind));
  SparseMatrix K = pattern.matrix();
  about.map.fluxes.add_force_slopes(mesh.x, p, -0.5, K);
  std::vector<double> found(way.size());
  K.multiply(way, found);
  for (double& force : found) force /= -0.5;
  expect_alike(found, slope_between(transposed_product(ahead(apart), p), transposed_product(ahead(-apart), p)));
}

}  // namespace
}  // namespace tether::coupled
