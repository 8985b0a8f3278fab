// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <ostream>
#include <random>
#include <vector>

#include "grid/block_mesh.hpp"
#include "model/solids.hpp"

// Blocks of every element for the tests of solids.

namespace tether::fem::support {

/// A kind of element, and what its law sees of the dilatation.
struct Element {
  ElementKind kind;
  Dilatation dilatation;
};
inline std::ostream& operator<<(std::ostream& out, const Element& of) {
  return out << element_name(of.kind) << " in " << dimension_of(of.kind) << " dimensions, " << word_of(of.dilatation)
             << " dilatation";
}

/// Every kind by the dilatation of its points; those in which it changes by its mean, too.
inline std::vector<Element> all_elements() {
  std::vector<Element> all;
  for (const ElementRow& row : element_rows) {
    all.push_back({row.kind, Dilatation::point});
    if (row.nodes > row.dim + 1) all.push_back({row.kind, Dilatation::mean});
  }
  return all;
}

/// One skew block of one law.
inline Solids skew_block(const Element& element, const ElasticLaw& law, std::array<int, 3> cells = {2, 2, 2}) {
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {2, 0.3}, {2.2, 1.4}, {-0.2, 1}}};
  Block block;
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = cells;
  block.z_high = 1.1;
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({block}, element.kind, flaws);
  solids.dilatation = element.dilatation;
  solids.regions = {{"block", law, 2.5, {}, {}}};
  return solids;
}

inline ElasticLaw neo_hookean() { return NeoHookean{2, 1.3, Volumetric::log, Plane::strain}; }

/// Places of the nodes under a linear map.
inline std::vector<double> mapped(const Mesh& mesh, const Eigen::Matrix3d& F) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::vector<double> q(mesh.x.size());
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    Eigen::Vector3d X = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < dim; ++i) X[static_cast<int>(i)] = mesh.x[n * dim + i];
    const Eigen::Vector3d x = F * X;
    for (std::size_t i = 0; i < dim; ++i) q[n * dim + i] = x[static_cast<int>(i)];
  }
  return q;
}

inline std::vector<double> shaken(const Mesh& mesh, unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> q = mesh.x;
  for (double& x : q) x += number(random);
  return q;
}

}  // namespace tether::fem::support
