// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"

namespace tether {

/// Square sparse matrix by compressed columns, the rows of a column ascending.
struct SparseMatrix {
  std::int64_t n = 0;
  std::vector<std::int64_t> start;  ///< n + 1: where each column begins in row and value
  std::vector<std::int64_t> row;
  std::vector<double> value;

  void set_zero();
  /// y = A x, both of n numbers.
  void multiply(std::span<const double> x, std::span<double> y) const;
};

/// y = A x of a symmetric A that has both triangles, whose columns are its rows.
void multiply_symmetric(Team& team, const SparseMatrix& A, std::span<const double> x, std::span<double> y);

/// The matrix of a mesh whose nodes have `dim` unknowns each, dim A .. dim A + dim - 1, and couple with the nodes of
/// their elements; and where each element's numbers stand in it, so that an assembly neither searches nor allocates.
class NodalPattern {
 public:
  /// `nodes` has the nodes of the elements, `per_element` each.
  NodalPattern(int dim, std::size_t node_count, std::span<const int> nodes, int per_element);

  /// A matrix of this pattern, all zero.
  SparseMatrix matrix() const;
  /// Adds an element's matrix k (row-major, dim per_element squared; unknown dim a + i of its a-th node) to A.
  void add(std::size_t element, std::span<const double> k, SparseMatrix& A) const;

 private:
  int dim_, per_element_;
  std::span<const int> nodes_;
  std::vector<std::int64_t> start_, row_;
  std::vector<std::int32_t> rank_;  // of node a among those that couple with node b, for each pair of an element
};

/// Lists of numbers, one after the other: list k is number[start[k]] .. number[start[k + 1] - 1].
struct Lists {
  std::vector<int> start{0}, number;
  std::size_t size() const { return start.size() - 1; }
  std::span<const int> operator[](std::size_t k) const {
    return std::span(number).subspan(static_cast<std::size_t>(start[k]),
                                     static_cast<std::size_t>(start[k + 1] - start[k]));
  }
  void add(std::span<const int> list);
  bool operator==(const Lists&) const = default;
};

/// The matrix of nodes that have different numbers of unknowns, which couple where the nodes stand in one cluster
/// together, such as those of an element; and where each cluster's numbers stand in it.
class ClusterPattern {
 public:
  /// Unknowns first[A] .. first[A + 1] - 1 are those of node A, none or more.
  ClusterPattern(std::vector<int> first, Lists clusters);

  /// A matrix of this pattern, all zero.
  SparseMatrix matrix() const;
  /// Adds a cluster's matrix k, row-major, to A. Its rows and columns are places: place l belongs to node nodes[l] of
  /// the cluster, counted from 0 in it, and is unknown number[l] of the matrix, or none where that is negative.
  void add(std::size_t cluster, std::span<const int> nodes, std::span<const int> number, std::span<const double> k,
           SparseMatrix& A) const;
  const Lists& clusters() const { return clusters_; }

 private:
  std::vector<int> first_;
  Lists clusters_;
  std::vector<std::int64_t> start_, row_;
  std::vector<std::size_t> offsets_;  // of each cluster in offset_
  std::vector<std::int32_t> offset_;  // where node a's rows begin in node b's columns, for each pair of a cluster
};

/// Makes rows and columns of the unknowns marked `held` those of `diagonal` times the identity.
void hold(SparseMatrix& A, const std::vector<std::uint8_t>& held, double diagonal);

}  // namespace tether
