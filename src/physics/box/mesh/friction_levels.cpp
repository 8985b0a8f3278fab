// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/friction_levels.hpp"

#include "algebra/eigen_sparse.hpp"
#include "base/diagnostics.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

using Entries = std::vector<Eigen::Triplet<double, std::int64_t>>;

}  // namespace

FrictionLevels::FrictionLevels(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                               const NodeInertia& nodes)
    : of_faces_(holds.held.size()), unknown_(of_faces_ + nodes.size(), -1), two_levels_(mesh.dim == 3) {
  number_unknowns(holds, nodes);
  if (number_.empty()) return;
  r_.resize(number_.size()), z_.resize(number_.size());
  const SparseMatrix A = matrix(mesh, strain, holds, nodes);
  const bool found =
      two_levels_ ? levels_.set_up(rows_of(A), coarse(mesh, holds)) : factors_.factorise(A, Definite::positive);
  if (!found)
    throw RunError("the fluid's friction has no factors: likely cause, values that ran away",
                   Failure::does_not_converge);
}

void FrictionLevels::number_unknowns(const FaceHolds& holds, const NodeInertia& nodes) {
  const auto take = [&](std::size_t number) {
    unknown_[number] = static_cast<int>(number_.size());
    number_.push_back(number);
  };
  for (std::size_t k = 0; k < of_faces_; ++k) {
    if (holds.held[k] == 0) take(k);
  }
  if (holds.carried.empty()) return;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes.held[k] == 0) take(of_faces_ + k);
  }
}

/// What makes each number of the faces: itself, or those of nodes.
std::vector<NodeShares> FrictionLevels::unknowns_of_faces(const FlowMesh& mesh, const FaceHolds& holds) const {
  const std::size_t dim = at(mesh.dim);
  std::vector<NodeShares> of(of_faces_);
  for (std::size_t k = 0; k < of_faces_; ++k) {
    if (is_free(k)) of[k].emplace_back(unknown_[k], 1.0);
  }
  for (const FaceHolds::Carried& carried : holds.carried) {
    for (const auto& [node, share] : carried.nodes) {
      for (std::size_t a = 0; a < dim; ++a) {
        const int unknown = unknown_[of_faces_ + node * dim + a];
        if (unknown >= 0) of[carried.face * dim + a].emplace_back(unknown, share);
      }
    }
  }
  return of;
}

SparseMatrix FrictionLevels::matrix(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                                    const NodeInertia& nodes) const {
  const std::vector<NodeShares> of = unknowns_of_faces(mesh, holds);
  Entries entries;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    strain.each_of_cell(cell, [&](std::size_t k, std::size_t l, double value) {
      for (const auto& [i, of_k] : of[k]) {
        for (const auto& [j, of_l] : of[l]) entries.emplace_back(i, j, of_k * of_l * value);
      }
    });
  }
  const auto mass = eigen_of(nodes.mass);
  for (Eigen::Index k = 0; k < mass.cols(); ++k) {
    for (decltype(mass)::InnerIterator entry(mass, k); entry; ++entry) {
      const int i = unknown_[of_faces_ + static_cast<std::size_t>(entry.row())],
                j = unknown_[of_faces_ + static_cast<std::size_t>(k)];
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, entry.value());
    }
  }
  const auto count = static_cast<Eigen::Index>(number_.size());
  EigenSparse A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  return sparse_of(A);
}

/// Velocities that are linear in each cell and 0 at the nodes of held faces; those of faces of flat cells are stiff.
CoarseUnknowns FrictionLevels::coarse(const FlowMesh& mesh, const FaceHolds& holds) const {
  const std::size_t dim = at(mesh.dim);
  std::vector<NodeShares> of(mesh.x.size() * dim);  // columns that make the velocity of each node of the mesh
  std::vector<std::uint8_t> is_held(of.size(), 0);
  const auto each_of_face = [&](std::size_t number, const auto& f) {
    for (const int n : mesh.face_nodes(number / dim)) f(at(n) * dim + number % dim);
  };
  for (std::size_t k = 0; k < of_faces_; ++k) {
    if (!is_free(k)) each_of_face(k, [&](std::size_t corner) { is_held[corner] = 1; });
  }
  Entries entries;
  std::size_t count = 0;
  std::vector<std::size_t> column(unknown_.size() - of_faces_, 0);
  for (std::size_t k = 0; k < column.size(); ++k) {
    if (!is_free(of_faces_ + k)) continue;
    entries.emplace_back(unknown_[of_faces_ + k], count, 1.0);
    column[k] = count++;
  }
  for (const auto& [n, nodes] : holds.corners) {
    for (const auto& [node, share] : nodes) {
      for (std::size_t a = 0; a < dim; ++a) {
        if (is_free(of_faces_ + node * dim + a)) of[n * dim + a].emplace_back(column[node * dim + a], share);
      }
    }
  }
  for (std::size_t corner = 0; corner < of.size(); ++corner) {
    if (is_held[corner] == 0) of[corner].emplace_back(count++, 1.0);
  }
  CoarseUnknowns coarse;
  const std::vector<std::uint8_t> is_flat = mesh.faces_of_flat_cells();
  for (std::size_t k = 0; k < of_faces_; ++k) {
    if (!is_free(k)) continue;
    if (is_flat[k / dim] != 0) coarse.stiff.push_back(at(unknown_[k]));
    each_of_face(k, [&](std::size_t corner) {
      for (const auto& [c, share] : of[corner]) entries.emplace_back(unknown_[k], c, share / mesh.dim);
    });
  }
  coarse.interpolation.resize(static_cast<Eigen::Index>(number_.size()), static_cast<Eigen::Index>(count));
  coarse.interpolation.setFromTriplets(entries.begin(), entries.end());
  return coarse;
}

void FrictionLevels::precondition(std::span<const double> r, std::span<double> z) {
  std::fill(z.begin(), z.end(), 0.0);
  if (number_.empty()) return;
  for (std::size_t k = 0; k < number_.size(); ++k) r_[k] = r[number_[k]];
  two_levels_ ? levels_.precondition(r_, z_) : factors_.solve(r_, z_);
  for (std::size_t k = 0; k < number_.size(); ++k) z[number_[k]] = z_[k];
}

}  // namespace tether::coupled
