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
                               std::span<const double> mass)
    : dim_(at(mesh.dim)), faces_(mesh.faces()), two_levels_(mesh.dim == 3) {
  number_faces(mesh, holds);
  number_nodes(holds, mass);
  if (count_ == 0) return;
  r_.resize(count_), z_.resize(count_);
  const SparseMatrix A = matrix(mesh, strain, holds, mass);
  const bool found =
      two_levels_ ? levels_.set_up(rows_of(A), coarse(mesh, holds)) : factors_.factorise(A, Definite::positive);
  if (!found)
    throw RunError("the fluid's friction has no factors: likely cause, values that ran away",
                   Failure::does_not_converge);
}

/// Those that are free along any axis.
void FrictionLevels::number_faces(const FlowMesh& mesh, const FaceHolds& holds) {
  of_face_.assign(faces_, -1);
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    for (std::size_t a = 0; a < dim_; ++a) {
      if (holds.held[f * dim_ + a] == 0 && of_face_[f] < 0) of_face_[f] = static_cast<int>(count_++);
    }
  }
}

/// Likewise of the nodes that carry faces.
void FrictionLevels::number_nodes(const FaceHolds& holds, std::span<const double> mass) {
  of_node_.assign(mass.size() / dim_, -1);
  for (const FaceHolds::Carried& carried : holds.carried) {
    for (const auto& [node, share] : carried.nodes) {
      for (std::size_t a = 0; a < dim_; ++a) {
        if (mass[node * dim_ + a] > 0 && of_node_[node] < 0) of_node_[node] = static_cast<int>(count_++);
      }
    }
  }
}

SparseMatrix FrictionLevels::matrix(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                                    std::span<const double> mass) const {
  std::vector<NodeShares> parts(faces_);
  for (std::size_t f = 0; f < faces_; ++f) {
    if (of_face_[f] >= 0) parts[f].emplace_back(of_face_[f], 1.0);
  }
  for (const FaceHolds::Carried& carried : holds.carried) {
    for (const auto& [node, share] : carried.nodes) {
      if (of_node_[node] >= 0) parts[carried.face].emplace_back(of_node_[node], share);
    }
  }
  Entries entries;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    strain.each_of_cell(cell, [&](std::size_t k, std::size_t l, double value) {
      for (const auto& [i, of_k] : parts[k]) {
        for (const auto& [j, of_l] : parts[l]) entries.emplace_back(i, j, of_k * of_l * value);
      }
    });
  }
  for (std::size_t node = 0; node < of_node_.size(); ++node) {
    double largest = 0;
    for (std::size_t a = 0; a < dim_; ++a) largest = std::max(largest, mass[node * dim_ + a]);
    if (of_node_[node] >= 0) entries.emplace_back(of_node_[node], of_node_[node], largest);
  }
  EigenSparse A(static_cast<Eigen::Index>(count_), static_cast<Eigen::Index>(count_));
  A.setFromTriplets(entries.begin(), entries.end());
  return sparse_of(A);
}

/// Velocities that are linear in each cell and 0 at the nodes of held faces; those of faces of flat cells are stiff.
CoarseUnknowns FrictionLevels::coarse(const FlowMesh& mesh, const FaceHolds& holds) const {
  std::vector<NodeShares> of(mesh.x.size());
  std::vector<std::uint8_t> is_held(mesh.x.size(), 0);
  for (std::size_t f = 0; f < faces_; ++f) {
    if (of_face_[f] >= 0) continue;
    for (const int n : mesh.face_nodes(f)) is_held[at(n)] = 1;
  }
  std::vector<std::size_t> number(of_node_.size(), 0);
  std::size_t count = 0;
  for (std::size_t k = 0; k < of_node_.size(); ++k) {
    if (of_node_[k] >= 0) number[k] = count++;
  }
  for (const auto& [n, nodes] : holds.corners) {
    for (const auto& [node, share] : nodes) {
      if (of_node_[node] >= 0) of[n].emplace_back(number[node], share);
    }
  }
  for (std::size_t n = 0; n < of.size(); ++n) {
    if (is_held[n] == 0) of[n].emplace_back(count++, 1.0);
  }
  Entries entries;
  CoarseUnknowns coarse;
  const std::vector<std::uint8_t> is_flat = mesh.faces_of_flat_cells();
  for (std::size_t f = 0; f < faces_; ++f) {
    if (of_face_[f] < 0) continue;
    if (is_flat[f] != 0) coarse.stiff.push_back(at(of_face_[f]));
    for (const int n : mesh.face_nodes(f)) {
      for (const auto& [column, share] : of[at(n)]) entries.emplace_back(of_face_[f], column, share / mesh.dim);
    }
  }
  for (std::size_t k = 0; k < of_node_.size(); ++k) {
    if (of_node_[k] >= 0) entries.emplace_back(of_node_[k], number[k], 1.0);
  }
  coarse.interpolation.resize(static_cast<Eigen::Index>(count_), static_cast<Eigen::Index>(count));
  coarse.interpolation.setFromTriplets(entries.begin(), entries.end());
  return coarse;
}

void FrictionLevels::precondition(std::span<const std::uint8_t> is_free, std::span<const double> r,
                                  std::span<double> z) {
  std::fill(z.begin(), z.end(), 0.0);
  for (std::size_t a = 0; a < dim_ && count_ > 0; ++a) {
    const auto each = [&](const auto& of, std::size_t first, const auto& f) {
      for (std::size_t k = 0; k < of.size(); ++k) {
        if (of[k] >= 0) f(at(of[k]), (first + k) * dim_ + a);
      }
    };
    const auto take = [&](std::size_t unknown, std::size_t number) {
      r_[unknown] = is_free[number] != 0 ? r[number] : 0;
    };
    const auto give = [&](std::size_t unknown, std::size_t number) {
      z[number] = is_free[number] != 0 ? z_[unknown] : 0;
    };
    each(of_face_, 0, take), each(of_node_, faces_, take);
    two_levels_ ? levels_.precondition(r_, z_) : factors_.solve(r_, z_);
    each(of_face_, 0, give), each(of_node_, faces_, give);
  }
}

}  // namespace tether::coupled
