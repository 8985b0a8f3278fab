// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/blocks.hpp"

namespace tether {

/// Calls for each k below `count` first compute(k, value), by whoever is free, then add(k, value), by one thread in the
/// order of k: what is added has the same bits for any number of threads, and needs no place of its own but for a
/// batch.
template <class Value, class Compute, class Add>
void compute_then_add(Team& team, std::size_t count, const Compute& compute, const Add& add) {
  constexpr std::size_t at_a_time = 8, batch = 256;
  if (team.threads() == 1) {
    Value value;
    for (std::size_t k = 0; k < count; ++k) compute(k, value), add(k, value);
    return;
  }
  std::vector<Value> values(std::min(count, batch));
  for (std::size_t first = 0; first < count; first += batch) {
    const std::size_t here = std::min(batch, count - first);
    each_block(
        team, here,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) compute(first + k, values[k]);
        },
        at_a_time);
    for (std::size_t k = 0; k < here; ++k) add(first + k, values[k]);
  }
}

}  // namespace tether
