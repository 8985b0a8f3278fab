// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_matrix.hpp"

#include <algorithm>

#include "base/blocks.hpp"

namespace tether {
namespace {

/// Returns for each node the nodes of its clusters, itself among them, ascending.
std::vector<std::vector<int>> neighbours_of(std::size_t node_count, const Lists& clusters) {
  std::vector<std::vector<int>> neighbours(node_count);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const int node : clusters[c]) {
      auto& list = neighbours[static_cast<std::size_t>(node)];
      list.insert(list.end(), clusters[c].begin(), clusters[c].end());
    }
  }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

Lists lists_of_equal_size(std::span<const int> numbers, int size) {
  Lists lists;
  lists.number.assign(numbers.begin(), numbers.end());
  for (std::size_t end = static_cast<std::size_t>(size); end <= numbers.size(); end += static_cast<std::size_t>(size))
    lists.start.push_back(static_cast<int>(end));
  return lists;
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

void multiply_symmetric(Team& team, const SparseMatrix& A, std::span<const double> x, std::span<double> y) {
  each_block(team, y.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double sum = 0;
      for (auto k = static_cast<std::size_t>(A.start[i]); k < static_cast<std::size_t>(A.start[i + 1]); ++k)
        sum += A.value[k] * x[static_cast<std::size_t>(A.row[k])];
      y[i] = sum;
    }
  });
}

NodalPattern::NodalPattern(int dim, std::size_t node_count, std::span<const int> nodes, int per_element)
    : dim_(dim), per_element_(per_element), nodes_(nodes) {
  const auto neighbours = neighbours_of(node_count, lists_of_equal_size(nodes, per_element));
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

void Lists::add(std::span<const int> list) {
  number.insert(number.end(), list.begin(), list.end());
  start.push_back(static_cast<int>(number.size()));
}

ClusterPattern::ClusterPattern(std::vector<int> first, Lists clusters)
    : first_(std::move(first)), clusters_(std::move(clusters)) {
  const auto neighbours = neighbours_of(first_.size() - 1, clusters_);
  const auto unknowns = [&](int node) {
    return first_[static_cast<std::size_t>(node) + 1] - first_[static_cast<std::size_t>(node)];
  };
  start_.push_back(0);
  for (std::size_t b = 0; b < neighbours.size(); ++b) {
    for (int c = 0; c < unknowns(static_cast<int>(b)); ++c) {
      for (const int a : neighbours[b]) {
        for (int r = 0; r < unknowns(a); ++r) row_.push_back(first_[static_cast<std::size_t>(a)] + r);
      }
      start_.push_back(static_cast<std::int64_t>(row_.size()));
    }
  }
  std::vector<std::vector<std::int32_t>> before(neighbours.size());
  for (std::size_t b = 0; b < neighbours.size(); ++b) {
    before[b].reserve(neighbours[b].size());
    std::int32_t rows = 0;
    for (const int a : neighbours[b]) before[b].push_back(rows), rows += unknowns(a);
  }
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    offsets_.push_back(offset_.size());
    for (const int a : clusters_[c]) {
      for (const int b : clusters_[c]) {
        const auto& list = neighbours[static_cast<std::size_t>(b)];
        const auto rank = std::lower_bound(list.begin(), list.end(), a) - list.begin();
        offset_.push_back(before[static_cast<std::size_t>(b)][static_cast<std::size_t>(rank)]);
      }
    }
  }
}

SparseMatrix ClusterPattern::matrix() const {
  return {static_cast<std::int64_t>(start_.size()) - 1, start_, row_, std::vector<double>(row_.size(), 0.0)};
}

void ClusterPattern::add(std::size_t cluster, std::span<const int> nodes, std::span<const int> number,
                         std::span<const double> k, SparseMatrix& A) const {
  const auto members = clusters_[cluster];
  const std::int32_t* offset = &offset_[offsets_[cluster]];
  for (std::size_t l = 0; l < number.size(); ++l) {
    if (number[l] < 0) continue;
    const auto a = static_cast<std::size_t>(nodes[l]);
    const std::int32_t within = number[l] - first_[static_cast<std::size_t>(members[a])];
    const double* row = &k[l * number.size()];
    for (std::size_t m = 0; m < number.size(); ++m) {
      if (number[m] < 0) continue;
      const std::int32_t in_column = offset[a * members.size() + static_cast<std::size_t>(nodes[m])] + within;
      A.value[static_cast<std::size_t>(start_[static_cast<std::size_t>(number[m])] + in_column)] += row[m];
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
