// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/aggregates.hpp"

#include <algorithm>
#include <cmath>

namespace tether {
namespace {

constexpr int pairings = 3;
constexpr double strong = 0.25;  // of a row's strongest coupling
constexpr double dominant = 5;   // times the row's other entries: the diagonal of an unknown that stays alone
constexpr int unpaired = -2;

std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }

bool stays_alone(const SymmetricRows& A, std::size_t i) {
  double others = 0;
  for (auto k = at(A.start[i]); k < at(A.start[i + 1]); ++k) others += std::abs(A.value[k]);
  return A.diagonal[i] >= dominant * others;
}

/// The unpaired unknown most strongly coupled with i, the first of equals, or none.
int partner(const SymmetricRows& A, std::size_t i, const std::vector<int>& pair_of) {
  double strongest = 0;
  for (auto k = at(A.start[i]); k < at(A.start[i + 1]); ++k) strongest = std::max(strongest, -A.value[k]);
  double best = strong * strongest;
  int found = -1;
  for (auto k = at(A.start[i]); k < at(A.start[i + 1]); ++k) {
    if (pair_of[at(A.column[k])] == unpaired && -A.value[k] > best) best = -A.value[k], found = A.column[k];
  }
  return found;
}

Aggregates pairs(const SymmetricRows& A) {
  Aggregates pair{std::vector<int>(at(A.n), unpaired), 0};
  for (std::size_t i = 0; i < at(A.n); ++i) {
    if (stays_alone(A, i)) pair.of[i] = Aggregates::alone;
  }
  for (std::size_t i = 0; i < at(A.n); ++i) {
    if (pair.of[i] != unpaired) continue;
    const int other = partner(A, i, pair.of);
    pair.of[i] = pair.count;
    if (other >= 0) pair.of[at(other)] = pair.count;
    ++pair.count;
  }
  return pair;
}

/// The unknowns of each aggregate, one aggregate after the other.
struct Members {
  std::vector<int> start, unknown;
  explicit Members(const Aggregates& aggregates) : start(at(aggregates.count) + 1, 0) {
    for (const int I : aggregates.of) {
      if (I >= 0) ++start[at(I) + 1];
    }
    for (std::size_t I = 0; I + 1 < start.size(); ++I) start[I + 1] += start[I];
    unknown.resize(at(start.back()));
    std::vector<int> next = start;
    for (std::size_t i = 0; i < aggregates.of.size(); ++i) {
      if (const int I = aggregates.of[i]; I >= 0) unknown[at(next[at(I)]++)] = static_cast<int>(i);
    }
  }
};

/// Sums the rows of A that belong to one aggregate.
class RowSum {
 public:
  RowSum(const SymmetricRows& A, const Aggregates& aggregates)
      : A_(A), aggregates_(aggregates), sum_(at(aggregates.count)), last_(at(aggregates.count), -1) {}

  void begin(int I) { I_ = I, diagonal_ = scale_ = 0, columns_.clear(); }
  void add(std::size_t i) {
    diagonal_ += A_.diagonal[i], scale_ += A_.scale[i];
    for (auto k = at(A_.start[i]); k < at(A_.start[i + 1]); ++k) {
      const int J = aggregates_.of[at(A_.column[k])];
      if (J == I_) {
        diagonal_ += A_.value[k];
      } else if (J >= 0) {
        if (last_[at(J)] != I_) last_[at(J)] = I_, sum_[at(J)] = 0, columns_.push_back(J);
        sum_[at(J)] += A_.value[k];
      }
    }
  }
  void append_to(SymmetricRows& coarse) {
    std::sort(columns_.begin(), columns_.end());
    const auto left = std::lower_bound(columns_.begin(), columns_.end(), I_) - columns_.begin();
    coarse.middle.push_back(coarse.start.back() + left);
    for (const int J : columns_) coarse.column.push_back(J), coarse.value.push_back(sum_[at(J)]);
    coarse.start.push_back(static_cast<std::int64_t>(coarse.column.size()));
    coarse.diagonal.push_back(diagonal_), coarse.scale.push_back(scale_);
  }

 private:
  const SymmetricRows& A_;
  const Aggregates& aggregates_;
  int I_ = 0;
  double diagonal_ = 0, scale_ = 0;
  std::vector<double> sum_;
  std::vector<int> last_, columns_;  // last_: the aggregate that each sum is of
};

SymmetricRows coarse_matrix(const SymmetricRows& A, const Aggregates& aggregates) {
  const Members members(aggregates);
  SymmetricRows coarse;
  coarse.n = aggregates.count;
  coarse.start.assign(1, 0);
  coarse.column.reserve(A.column.size() / 2), coarse.value.reserve(A.column.size() / 2);
  RowSum row(A, aggregates);
  for (int I = 0; I < aggregates.count; ++I) {
    row.begin(I);
    for (int m = members.start[at(I)]; m < members.start[at(I) + 1]; ++m) row.add(at(members.unknown[at(m)]));
    row.append_to(coarse);
  }
  return coarse;
}

}  // namespace

void SymmetricRows::multiply(std::span<const double> x, std::span<double> y) const {
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = diagonal[i] * x[i];
    for (auto k = at(start[i]); k < at(start[i + 1]); ++k) sum += value[k] * x[at(column[k])];
    y[i] = sum;
  }
}

SymmetricRows rows_of(const SparseMatrix& A) {
  SymmetricRows rows;
  rows.n = static_cast<int>(A.n);
  rows.start.assign(1, 0), rows.diagonal.assign(at(A.n), 0.0);
  rows.column.reserve(A.row.size()), rows.value.reserve(A.row.size());
  for (std::int64_t i = 0; i < A.n; ++i) {
    auto left = rows.start.back();
    for (auto k = at(A.start[at(i)]); k < at(A.start[at(i) + 1]); ++k) {
      left += A.row[k] < i;
      if (A.row[k] == i) {
        rows.diagonal[at(i)] = A.value[k];
      } else {
        rows.column.push_back(static_cast<std::int32_t>(A.row[k])), rows.value.push_back(A.value[k]);
      }
    }
    rows.middle.push_back(left);
    rows.start.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  rows.scale = rows.diagonal;
  return rows;
}

SparseMatrix columns_of(const SymmetricRows& A) {
  SparseMatrix columns{A.n, {0}, {}, {}};
  const auto add = [&](std::int64_t row, double value) { columns.row.push_back(row), columns.value.push_back(value); };
  for (std::size_t j = 0; j < at(A.n); ++j) {
    for (auto k = at(A.start[j]); k < at(A.middle[j]); ++k) add(A.column[k], A.value[k]);
    add(static_cast<std::int64_t>(j), A.diagonal[j]);
    for (auto k = at(A.middle[j]); k < at(A.start[j + 1]); ++k) add(A.column[k], A.value[k]);
    columns.start.push_back(static_cast<std::int64_t>(columns.row.size()));
  }
  return columns;
}

Aggregates aggregate(const SymmetricRows& A, SymmetricRows& coarse) {
  Aggregates all = pairs(A);
  coarse = coarse_matrix(A, all);
  for (int pairing = 1; pairing < pairings; ++pairing) {
    const Aggregates pair = pairs(coarse);
    for (int& I : all.of) I = I >= 0 ? pair.of[at(I)] : Aggregates::alone;
    all.count = pair.count;
    coarse = coarse_matrix(coarse, pair);
  }
  return all;
}

}  // namespace tether
