// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "grid/block_mesh.hpp"
#include "physics/solids/make_elements.hpp"
#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

// Elements that are squeezed to half their height: one that gives way in a pattern of its own, as enhanced strains do,
// has a frequency far below the body's.

namespace tether::fem {
namespace {

using namespace support;

Solids unit_block(const Element& element, int cells, double nu) {
  Block block;
  const std::array<Vec<2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {cells, cells, cells}, block.z_high = 1;
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({block}, element.kind, flaws);
  solids.dilatation = element.dilatation;
  solids.regions = {{"block", NeoHookean::of({.E = 1, .nu = nu}), 1, {}, {}}};
  return solids;
}

/// Unknowns of nodes that no wall holds: all walls hold what stands at them across.
std::vector<int> free_unknowns(const Mesh& mesh) {
  std::vector<int> free;
  for (std::size_t k = 0; k < mesh.x.size(); ++k) {
    if (mesh.x[k] > 1e-9 && mesh.x[k] < 1 - 1e-9) free.push_back(static_cast<int>(k));
  }
  return free;
}

double number_at(const SparseMatrix& A, int row, int column) {
  for (auto k = A.start[static_cast<std::size_t>(column)]; k < A.start[static_cast<std::size_t>(column + 1)]; ++k) {
    if (A.row[static_cast<std::size_t>(k)] == row) return A.value[static_cast<std::size_t>(k)];
  }
  return 0;
}

/// The least omega^2 of the squeezed block between smooth walls.
double least_frequency(const Element& element, int cells, double nu) {
  const Solids solids = unit_block(element, cells, nu);
  const Mesh& mesh = solids.mesh;
  const auto elements = make_elements(solids, alone());
  const int dim = mesh.dim();
  std::vector<double> q = mesh.x;
  for (std::size_t k = 1; k < q.size(); k += static_cast<std::size_t>(dim)) q[k] *= 0.5;
  const NodalPattern pattern(dim, mesh.node_count(), mesh.nodes, node_count_of(mesh.kind));
  SparseMatrix K = pattern.matrix();
  elements->add_tangent(StressAt::end, q, q, 0, pattern, K);
  const SparseMatrix M = elements->mass();
  const std::vector<int> free = free_unknowns(mesh);
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd stiffness(n, n), mass(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const int a = free[static_cast<std::size_t>(i)], b = free[static_cast<std::size_t>(j)];
      stiffness(i, j) = number_at(K, a, b);
      mass(i, j) = a % dim == b % dim ? number_at(M, a / dim, b / dim) : 0;
    }
  }
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff();
}

TEST(Squeezed, ElementsHaveNoPatternOfTheirOwn) {
  for (const double nu : {0.3, 0.49}) {
    const double plane = least_frequency({ElementKind::quad9, Dilatation::mean}, 6, nu);
    const double space = least_frequency({ElementKind::hex27, Dilatation::mean}, 2, nu);
    for (const Element& element : all_elements()) {
      SCOPED_TRACE(element);
      const bool flat = dimension_of(element.kind) == 2;
      const double found = least_frequency(element, flat ? 6 : order_of(element.kind) == 1 ? 4 : 2, nu);
      EXPECT_GT(found / (flat ? plane : space), 0.9) << nu;
    }
  }
}

}  // namespace
}  // namespace tether::fem
