// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_matrix.hpp"

#include <algorithm>

namespace tether {
namespace {

/// For each node the nodes of its elements, itself among them, ascending.
std::vector<std::vector<int>> neighbours_of(std::size_t node_count, std::span<const int> nodes, int per_element) {
  std::vector<std::vector<int>> neighbours(node_count);
  const auto size = static_cast<std::size_t>(per_element);
  for (std::size_t first = 0; first < nodes.size(); first += size) {
    const auto element = nodes.subspan(first, size);
    for (const int node : element) {
      auto& list = neighbours[static_cast<std::size_t>(node)];
      list.insert(list.end(), element.begin(), element.end());
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

}  // namespace

void SparseMatrix::set_zero() { std::fill(value.begin(), value.end(), 0.0); }

void SparseMatrix::multiply(std::span<const double> x, std::span<double> y) const {
  std::fill(y.begin(), y.end(), 0.0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) {
    for (auto k = static_cast<std::size_t>(start[j]); k < static_cast<std::size_t>(start[j + 1]); ++k) {
      y[static_cast<std::size_t>(row[k])] += value[k] * x[j];
    }
  }
}

NodalPattern::NodalPattern(int dim, std::size_t node_count, std::span<const int> nodes, int per_element)
    : dim_(dim), per_element_(per_element), nodes_(nodes) {
  const auto neighbours = neighbours_of(node_count, nodes, per_element);
  start_.push_back(0);
  for (const auto& list : neighbours) {
    for (int c = 0; c < dim; ++c) {
      for (const int node : list) {
        for (int r = 0; r < dim; ++r) row_.push_back(std::int64_t{node} * dim + r);
      }
      start_.push_back(static_cast<std::int64_t>(row_.size()));
    }
  }
  const auto size = static_cast<std::size_t>(per_element);
  rank_.reserve(nodes.size() * size);
  for (std::size_t first = 0; first < nodes.size(); first += size) {
    for (const int a : nodes.subspan(first, size)) {
      for (const int b : nodes.subspan(first, size)) {
        const auto& list = neighbours[static_cast<std::size_t>(b)];
        rank_.push_back(static_cast<std::int32_t>(std::lower_bound(list.begin(), list.end(), a) - list.begin()));
      }
    }
  }
}

SparseMatrix NodalPattern::matrix() const {
  return {static_cast<std::int64_t>(start_.size()) - 1, start_, row_, std::vector<double>(row_.size(), 0.0)};
}

void NodalPattern::add(std::size_t element, std::span<const double> k, SparseMatrix& A) const {
  const auto size = static_cast<std::size_t>(per_element_), dim = static_cast<std::size_t>(dim_);
  const int* nodes = &nodes_[element * size];
  const std::int32_t* rank = &rank_[element * size * size];
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      const std::size_t column = static_cast<std::size_t>(nodes[b]) * dim;
      for (std::size_t c = 0; c < dim; ++c) {
        double* at =
            &A.value[static_cast<std::size_t>(start_[column + c]) + static_cast<std::size_t>(rank[a * size + b]) * dim];
        const double* from = &k[a * dim * size * dim + b * dim + c];
        for (std::size_t r = 0; r < dim; ++r) at[r] += from[r * size * dim];
      }
    }
  }
}

void hold(SparseMatrix& A, const std::vector<std::uint8_t>& held, double diagonal) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(A.n); ++j) {
    for (auto k = static_cast<std::size_t>(A.start[j]); k < static_cast<std::size_t>(A.start[j + 1]); ++k) {
      const auto i = static_cast<std::size_t>(A.row[k]);
      if (held[i] || held[j]) A.value[k] = i == j ? diagonal : 0;
    }
  }
}

}  // namespace tether
