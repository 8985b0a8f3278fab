// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multigrid_level.hpp"

#include <utility>

namespace tether {

void MultigridLevel::join(Aggregates with) {
  aggregates = std::move(with);
  members = members_of(aggregates);
  Ux.resize(inverse.size());
  make_slabs();
}

/// None where there would be less than `fewest`.
void MultigridLevel::make_slabs() {
  constexpr std::size_t shortest = 1024, fewest = 4;
  std::size_t reach = shortest;
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    if (A.start[i] == A.start[i + 1]) continue;
    const std::size_t first = at(A.column[at(A.start[i])]), last = at(A.column[at(A.start[i + 1]) - 1]);
    reach = std::max({reach, i - std::min(i, first), std::max(i, last) - i});
  }
  if (inverse.size() / reach < fewest) return;
  slab = reach;
  for (std::size_t i = 0; i < inverse.size(); ++i) order_row(i);
}

/// Orders row i. What is swept before row i comes first in it, and what is swept after it comes next.
void MultigridLevel::order_row(std::size_t i) {
  const auto before = [&](std::int32_t j) {
    const std::size_t round = round_of(i), its = round_of(at(j));
    return its != round ? its < round : at(j) < i;
  };
  const std::size_t begin = at(A.start[i]), end = at(A.start[i + 1]);
  std::size_t next = begin;
  for (std::size_t k = begin; k < end; ++k) {
    if (!before(A.column[k])) continue;
    std::rotate(A.column.begin() + std::ptrdiff_t(next), A.column.begin() + std::ptrdiff_t(k),
                A.column.begin() + std::ptrdiff_t(k + 1));
    std::rotate(A.value.begin() + std::ptrdiff_t(next), A.value.begin() + std::ptrdiff_t(k),
                A.value.begin() + std::ptrdiff_t(k + 1));
    ++next;
  }
  A.middle[i] = static_cast<std::int64_t>(next);
}

}  // namespace tether
