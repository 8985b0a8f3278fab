// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/aggregates.hpp"
#include "base/blocks.hpp"

namespace tether {

/// A level's matrix and how it is swept: slab by slab of rows, each so long that its rows couple with none beyond the
/// slabs next to it. All slabs of even number, by as many threads as there are, come before all of odd number.
struct MultigridLevel {
  explicit MultigridLevel(SymmetricRows matrix)
      : A(std::move(matrix)), inverse(static_cast<std::size_t>(A.n)), slab(inverse.size()) {
    for (std::size_t i = 0; i < inverse.size(); ++i) inverse[i] = A.positive(i) ? 1 / A.diagonal[i] : 0;
  }

  /// Joins it with the next level, and makes its slabs.
  void join(Aggregates with);
  /// Room for what the cycles of a coarser level need.
  void prepare_iterations() {
    for (auto* room : {&r, &z, &p, &Ap, &q, &Aq}) room->resize(inverse.size());
  }
  /// z = (D + L)^-1 r, L the couplings with rows that have been swept before.
  void sweep_forward(Team& team, std::span<const double> right, std::span<double> x) const {
    each_slab(team, {0, 1}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double sum = right[i];
        for (auto k = at(A.start[i]); k < at(A.middle[i]); ++k) sum -= A.value[k] * x[at(A.column[k])];
        x[i] = sum * inverse[i];
      }
    });
  }
  /// x becomes x + (D + U)^-1 (r - A x). The entry that was computed last is taken last, so that none waits for it.
  void sweep_backward(Team& team, std::span<const double> right, std::span<double> x) const {
    each_slab(team, {1, 0}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = end; i-- > begin;) {
        double sum = right[i];
        for (auto k = at(A.start[i]); k < at(A.middle[i]); ++k) sum -= A.value[k] * x[at(A.column[k])];
        for (auto k = at(A.start[i + 1]); k-- > at(A.middle[i]);) sum -= A.value[k] * x[at(A.column[k])];
        x[i] = sum * inverse[i];
      }
    });
  }
  /// The residual after a forward sweep from 0, which is -U x, summed over aggregates.
  void restrict_residual(Team& team, std::span<const double> x, std::vector<double>& to) {
    each_block(team, inverse.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double sum = 0;
        for (auto k = at(A.middle[i]); k < at(A.start[i + 1]); ++k) sum += A.value[k] * x[at(A.column[k])];
        Ux[i] = sum;
      }
    });
    each_block(team, to.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t I = begin; I < end; ++I) {
        to[I] = 0;
        for (const int member : members[I]) to[I] -= Ux[at(member)];
      }
    });
  }
  void add_coarse(Team& team, std::span<const double> coarse, std::span<double> x) const {
    each_block(team, x.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (aggregates.of[i] >= 0) x[i] += coarse[at(aggregates.of[i])];
      }
    });
  }

  SymmetricRows A;                   // the part of a row after `middle` is what is swept after it
  std::vector<double> inverse;       // of the diagonal
  std::size_t slab;                  // rows; the last one may have more
  Aggregates aggregates;             // none on the coarsest level
  Lists members;                     // of each aggregate
  std::vector<double> Ux;            // of the residual after a forward sweep
  std::vector<double> r, z;          // of a coarser level its right side and solution
  std::vector<double> p, Ap, q, Aq;  // directions of its two iterations

 private:
  static std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }
  void make_slabs();
  void order_row(std::size_t i);
  std::size_t round_of(std::size_t i) const { return std::min(i / slab, inverse.size() / slab - 1) % 2; }

  template <class Sweep>
  void each_slab(Team& team, std::array<std::size_t, 2> rounds, const Sweep& sweep) const {
    const std::size_t n = inverse.size(), slabs = n / std::max<std::size_t>(slab, 1);
    for (const std::size_t first : rounds) {
      team.each(0, (slabs + 1 - first) / 2, [&](std::size_t k) {
        const std::size_t number = 2 * k + first;
        sweep(number * slab, number + 1 < slabs ? (number + 1) * slab : n);
      });
    }
  }
};

}  // namespace tether
