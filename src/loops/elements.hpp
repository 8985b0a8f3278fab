// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/blocks.hpp"

namespace tether {

/// Calls for each k below `count` first compute(k, value), by whoever is free, then add(k, value), by one thread in the
/// order of k: what is added has the same bits for any number of threads, and needs no place of its own but for a
/// batch: the `values`, of which one is enough for one thread.
template <class Value, class Compute, class Add>
void compute_then_add(Team& team, std::size_t count, const Compute& compute, const Add& add,
                      std::vector<Value> values) {
  if (values.size() == 1) {
    for (std::size_t k = 0; k < count; ++k) {
      compute(k, values[0]);
      add(k, values[0]);
    }
    return;
  }
  constexpr std::size_t at_a_time = 8;
  for (std::size_t first = 0; first < count; first += values.size()) {
    const std::size_t here = std::min(values.size(), count - first);
    each_block(
        team, here,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) compute(first + k, values[k]);
        },
        at_a_time);
    for (std::size_t k = 0; k < here; ++k) add(first + k, values[k]);
  }
}

/// Returns how many of `count` values a team has at a time.
inline std::size_t batch_of(const Team& team, std::size_t count) {
  constexpr std::size_t batch = 256;
  return team.threads() == 1 ? 1 : std::min(count, batch);
}

/// The same with values as their type makes them.
template <class Value, class Compute, class Add>
void compute_then_add(Team& team, std::size_t count, const Compute& compute, const Add& add) {
  compute_then_add(team, count, compute, add, std::vector<Value>(batch_of(team, count)));
}

/// The same with `size` numbers each, where it is known at run time.
template <class Compute, class Add>
void compute_numbers_then_add(Team& team, std::size_t count, std::size_t size, const Compute& compute, const Add& add) {
  compute_then_add(team, count, compute, add, std::vector(batch_of(team, count), std::vector<double>(size)));
}

}  // namespace tether
