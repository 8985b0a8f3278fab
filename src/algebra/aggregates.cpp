// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/aggregates.hpp"

#include <algorithm>
#include <cmath>

#include "base/blocks.hpp"

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
  const Lists members = members_of(aggregates);
  SymmetricRows coarse;
  coarse.n = aggregates.count;
  coarse.start.assign(1, 0);
  coarse.column.reserve(A.column.size() / 2), coarse.value.reserve(A.column.size() / 2);
  RowSum row(A, aggregates);
  for (int I = 0; I < aggregates.count; ++I) {
    row.begin(I);
    for (const int member : members[at(I)]) row.add(at(member));
    row.append_to(coarse);
  }
  return coarse;
}

}  // namespace

Lists members_of(const Aggregates& aggregates) {
  Lists members;
  members.start.assign(at(aggregates.count) + 1, 0);
  for (const int I : aggregates.of) {
    if (I >= 0) ++members.start[at(I) + 1];
  }
  for (std::size_t I = 0; I + 1 < members.start.size(); ++I) members.start[I + 1] += members.start[I];
  members.number.resize(at(members.start.back()));
  std::vector<int> next = members.start;
  for (std::size_t i = 0; i < aggregates.of.size(); ++i) {
    if (const int I = aggregates.of[i]; I >= 0) members.number[at(next[at(I)]++)] = static_cast<int>(i);
  }
  return members;
}

void SymmetricRows::multiply(Team& team, std::span<const double> x, std::span<double> y) const {
  each_block(team, y.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double sum = diagonal[i] * x[i];
      for (auto k = at(start[i]); k < at(start[i + 1]); ++k) sum += value[k] * x[at(column[k])];
      y[i] = sum;
    }
  });
}

namespace {

/// Puts rows together entry by entry, the columns of a row ascending.
class RowWriter {
 public:
  RowWriter(std::int64_t n, std::size_t nonzeros) {
    rows_.n = static_cast<int>(n);
    rows_.start.assign(1, 0), rows_.diagonal.assign(at(n), 0.0);
    rows_.start.reserve(at(n) + 1), rows_.middle.reserve(at(n));
    rows_.column.reserve(nonzeros), rows_.value.reserve(nonzeros);
  }
  void begin() { left_ = rows_.start.back(); }
  void add(std::int64_t row, std::int64_t column, double value) {
    if (column == row) {
      rows_.diagonal[at(row)] = value;
      return;
    }
    left_ += column < row;
    rows_.column.push_back(static_cast<std::int32_t>(column)), rows_.value.push_back(value);
  }
  void end() {
    rows_.middle.push_back(left_);
    rows_.start.push_back(static_cast<std::int64_t>(rows_.column.size()));
  }
  SymmetricRows take() {
    rows_.scale = rows_.diagonal;
    return std::move(rows_);
  }

 private:
  SymmetricRows rows_;
  std::int64_t left_ = 0;
};

}  // namespace

SymmetricRows rows_of(const SparseMatrix& A) {
  RowWriter rows(A.n, A.row.size());
  for (std::int64_t i = 0; i < A.n; ++i) {
    rows.begin();
    for (auto k = at(A.start[at(i)]); k < at(A.start[at(i) + 1]); ++k) rows.add(i, A.row[k], A.value[k]);
    rows.end();
  }
  return rows.take();
}

SymmetricRows rows_of_sum(const SparseMatrix& A, const EigenSparse& S) {
  RowWriter rows(A.n, A.row.size() + at(S.nonZeros()));
  for (std::int64_t i = 0; i < A.n; ++i) {
    rows.begin();
    EigenSparse::InnerIterator other(S, i);
    for (auto k = at(A.start[at(i)]); k < at(A.start[at(i) + 1]); ++k) {
      for (; other && other.row() < A.row[k]; ++other) rows.add(i, other.row(), other.value());
      const bool both = other && other.row() == A.row[k];
      rows.add(i, A.row[k], both ? A.value[k] + other.value() : A.value[k]);
      if (both) ++other;
    }
    for (; other; ++other) rows.add(i, other.row(), other.value());
    rows.end();
  }
  return rows.take();
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
