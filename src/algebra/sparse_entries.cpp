// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_entries.hpp"

#include <algorithm>

namespace tether {
namespace {

/// Returns where an entry stands, or where all of them end.
std::size_t place_of(const SparseMatrix& A, std::int64_t row, std::int64_t column) {
  const auto first = A.row.begin() + A.start[static_cast<std::size_t>(column)],
             end = A.row.begin() + A.start[static_cast<std::size_t>(column + 1)],
             place = std::lower_bound(first, end, row);
  return static_cast<std::size_t>((place != end && *place == row ? place : A.row.end()) - A.row.begin());
}

}  // namespace

double entry_of(const SparseMatrix& A, std::int64_t row, std::int64_t column) {
  const std::size_t place = place_of(A, row, column);
  return place < A.value.size() ? A.value[place] : 0;
}

void add_to_entry(SparseMatrix& A, std::int64_t row, std::int64_t column, double value) {
  const std::size_t place = place_of(A, row, column);
  if (place < A.value.size()) A.value[place] += value;
}

}  // namespace tether
