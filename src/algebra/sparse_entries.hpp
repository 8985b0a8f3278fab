// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// The entry of a row and column; 0 where there is none.
double entry_of(const SparseMatrix& A, std::int64_t row, std::int64_t column);
/// Adds to an entry; A is as it was where there is none.
void add_to_entry(SparseMatrix& A, std::int64_t row, std::int64_t column, double value);

}  // namespace tether
