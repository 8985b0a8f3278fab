// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/matrix.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_entries.hpp"

namespace tether::coupled {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Puts a matrix together column by column.
class Builder {
 public:
  explicit Builder(std::int64_t n) {
    K_.n = n;
    K_.start.push_back(0);
  }
  void add(std::int64_t row, double value) { K_.row.push_back(row), K_.value.push_back(value); }
  void next_column() { K_.start.push_back(static_cast<std::int64_t>(K_.row.size())); }
  SparseMatrix take() { return std::move(K_); }

 private:
  SparseMatrix K_;
};

/// Where the pressures' rows stand: after those of velocities.
struct Slots {
  std::int64_t first = 0;            ///< of all
  std::vector<std::int64_t> of_row;  ///< of each pressure, from 0
  std::vector<std::int64_t> row;     ///< of each slot its pressure; -1: none
};

Slots slots(std::int64_t first, std::span<const std::size_t> cells, std::size_t count) {
  Slots out{first, {}, std::vector<std::int64_t>(count, -1)};
  for (const std::size_t cell : cells) {
    out.row[cell] = static_cast<std::int64_t>(out.of_row.size());
    out.of_row.push_back(static_cast<std::int64_t>(cell));
  }
  return out;
}

Slots dense_slots(std::int64_t first, std::int64_t count) {
  std::vector<std::size_t> cells(at(count));
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return slots(first, cells, at(count));
}

/// A's column, less rows and columns that are set.
void add_column(const SparseMatrix& A, std::int64_t column, bool lower, std::span<const std::uint8_t> set, Builder& K) {
  if (set[at(column)] != 0) {
    const double value = diagonal(A, column);
    K.add(column, value > 0 ? value : 1);
    return;
  }
  for (std::int64_t k = A.start[at(column)]; k < A.start[at(column + 1)]; ++k) {
    const std::int64_t row = A.row[at(k)];
    if ((!lower || row >= column) && set[at(row)] == 0) K.add(row, A.value[at(k)]);
  }
}

/// The column of sign L that stands in a slot, -1 or 1 on the diagonal where it is no pressure's.
void add_pressure_column(const SparseMatrix& L, std::size_t slot, const Slots& slots, double sign, bool lower,
                         std::span<const std::uint8_t> set, Builder& K) {
  const std::int64_t column = slots.row[slot];
  if (column < 0 || set[at(column)] != 0) {
    const double value = column < 0 ? 1 : diagonal(L, column);
    K.add(slots.first + static_cast<std::int64_t>(slot), sign * (value > 0 ? value : 1));
    return;
  }
  for (std::int64_t k = L.start[at(column)]; k < L.start[at(column + 1)]; ++k) {
    const std::int64_t row = L.row[at(k)];
    if ((!lower || row >= column) && set[at(row)] == 0)
      K.add(slots.first + slots.of_row[at(row)], sign * L.value[at(k)]);
  }
}

SparseMatrix matrix(const CoupledEquations& of, std::span<const std::uint8_t> pinned, const Slots& slots, bool lower) {
  const std::int64_t solids = of.A.n;
  Builder K(solids + static_cast<std::int64_t>(slots.row.size()));
  const EigenSparse flux = of.flux;
  for (std::int64_t u = 0; u < solids; ++u) {
    add_column(of.A, u, lower, of.held, K);
    for (EigenSparse::InnerIterator entry(flux, u); of.held[at(u)] == 0 && entry; ++entry) {
      if (pinned[at(entry.row())] == 0) K.add(solids + slots.of_row[at(entry.row())], -entry.value());
    }
    K.next_column();
  }
  for (std::size_t slot = 0; slot < slots.row.size(); ++slot) {
    const std::int64_t p = slots.row[slot];
    if (!lower && p >= 0 && pinned[at(p)] == 0) {
      for (CouplingMatrix::InnerIterator entry(of.B, p); entry; ++entry) {
        if (of.held[at(entry.col())] == 0) K.add(entry.col(), -entry.value());
      }
    }
    add_pressure_column(of.L, slot, slots, -1, lower, pinned, K);
    K.next_column();
  }
  return K.take();
}

}  // namespace

double diagonal(const SparseMatrix& A, std::int64_t column) { return entry_of(A, column, column); }

SparseMatrix with_symmetric_pattern(const SparseMatrix& K) {
  const auto view = eigen_of(K);
  return sparse_of(view + 0.0 * EigenSparse(view.transpose()));
}

std::vector<double> scales_of(const SparseMatrix& K) {
  std::vector<double> scales;
  for (std::int64_t k = 0; k < K.n; ++k) {
    const double size = std::abs(diagonal(K, k));
    scales.push_back(size > 0 ? std::sqrt(size) : 1);
  }
  return scales;
}

void scale(SparseMatrix& K, std::span<const double> scales) {
  for (std::int64_t column = 0; column < K.n; ++column) {
    for (std::int64_t k = K.start[at(column)]; k < K.start[at(column + 1)]; ++k)
      K.value[at(k)] /= scales[at(column)] * scales[at(K.row[at(k)])];
  }
}

double terms_size(const SparseMatrix& A, std::span<const double> u) {
  double size = 0;
  for (std::int64_t column = 0; column < A.n; ++column) {
    for (std::int64_t k = A.start[at(column)]; k < A.start[at(column + 1)]; ++k)
      size += std::abs(u[at(A.row[at(k)])] * A.value[at(k)] * u[at(column)]);
  }
  return size;
}

void add_product(const CouplingMatrix& B, double factor, std::span<const double> x, std::span<double> y) {
  for (std::int64_t row = 0; row < B.outerSize(); ++row) {
    for (CouplingMatrix::InnerIterator entry(B, row); entry; ++entry)
      y[at(row)] += factor * entry.value() * x[at(entry.col())];
  }
}

void add_transposed_product(const CouplingMatrix& B, double factor, std::span<const double> x, std::span<double> y) {
  for (std::int64_t row = 0; row < B.outerSize(); ++row) {
    for (CouplingMatrix::InnerIterator entry(B, row); entry; ++entry)
      y[at(entry.col())] += factor * entry.value() * x[at(row)];
  }
}

namespace {

/// The first loose region whose flux is more than rounding.
void find_unbalanced(const CoupledEquations& of, ReducedEquations& out) {
  constexpr double rounding = 1e-7;  // of what flows in it
  std::vector<double> sum(of.loose.size(), 0.0), flows(of.loose.size(), 0.0);
  for (std::size_t p = 0; p < out.r.size(); ++p) {
    sum[at(of.region[p])] += out.r[p], flows[at(of.region[p])] += std::abs(out.r[p]);
  }
  for (std::size_t r = 0; r < sum.size() && out.unbalanced < 0; ++r) {
    if (of.loose[r] != 0 && std::abs(sum[r]) > rounding * flows[r])
      out.unbalanced = static_cast<int>(r), out.flux = sum[r];
  }
}

}  // namespace

ReducedEquations reduced(const CoupledEquations& of, std::span<const double> u) {
  ReducedEquations out{{of.b.begin(), of.b.end()}, {of.r.begin(), of.r.end()}, {}};
  std::vector<double> known(of.b.size(), 0.0), forces(of.b.size());
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (of.held[k] != 0) known[k] = u[k];
  }
  of.A.multiply(known, forces);
  for (std::size_t k = 0; k < known.size(); ++k) out.b[k] -= forces[k];
  add_product(of.flux, 1, known, out.r);
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (of.held[k] == 0) continue;
    const double scale = diagonal(of.A, static_cast<std::int64_t>(k));
    out.b[k] = (scale > 0 ? scale : 1) * u[k];
  }
  find_unbalanced(of, out);
  balance(of, std::vector<double>(out.r.size(), 1.0), out.r);
  out.pinned = first_pressures(of, of.loose);
  for (std::size_t p = 0; p < out.r.size(); ++p) {
    if (out.pinned[p] != 0) out.r[p] = 0;
  }
  return out;
}

std::vector<std::uint8_t> first_pressures(const CoupledEquations& of, std::span<const std::uint8_t> regions) {
  std::vector<std::uint8_t> pinned(of.region.size(), 0), done(regions.size(), 0);
  for (std::size_t p = 0; p < pinned.size(); ++p) {
    const std::size_t region = at(of.region[p]);
    if (regions[region] != 0 && done[region] == 0) pinned[p] = done[region] = 1;
  }
  return pinned;
}

void balance(const CoupledEquations& of, std::span<const double> weight, std::span<double> r) {
  std::vector<double> sum(of.loose.size(), 0.0), weights(of.loose.size(), 0.0);
  for (std::size_t p = 0; p < r.size(); ++p) sum[at(of.region[p])] += r[p], weights[at(of.region[p])] += weight[p];
  for (std::size_t p = 0; p < r.size(); ++p) {
    const std::size_t region = at(of.region[p]);
    if (of.loose[region] != 0 && weights[region] > 0) r[p] -= sum[region] * weight[p] / weights[region];
  }
}

std::vector<double> areas_seen(const CouplingMatrix& B) {
  std::vector<double> areas(at(B.rows()), 0.0);
  for (std::int64_t row = 0; row < B.outerSize(); ++row) {
    for (CouplingMatrix::InnerIterator entry(B, row); entry; ++entry) areas[at(row)] += std::abs(entry.value());
  }
  return areas;
}

SparseMatrix held_matrix(const SparseMatrix& A, std::span<const std::uint8_t> set) {
  Builder K(A.n);
  for (std::int64_t column = 0; column < A.n; ++column) {
    add_column(A, column, false, set, K);
    K.next_column();
  }
  return K.take();
}

SparseMatrix pressures_by_cells(const CoupledEquations& of, std::span<const std::uint8_t> pinned) {
  const Slots at_cells = slots(0, of.cell, of.cells);
  Builder K(static_cast<std::int64_t>(of.cells));
  for (std::size_t slot = 0; slot < of.cells; ++slot) {
    add_pressure_column(of.L, slot, at_cells, 1, true, pinned, K);
    K.next_column();
  }
  return K.take();
}

SparseMatrix matrix_by_cells(const CoupledEquations& of, std::span<const std::uint8_t> pinned) {
  return matrix(of, pinned, slots(of.A.n, of.cell, of.cells), true);
}

SparseMatrix whole_matrix(const CoupledEquations& of, std::span<const std::uint8_t> pinned) {
  return matrix(of, pinned, dense_slots(of.A.n, of.L.n), false);
}

}  // namespace tether::coupled
