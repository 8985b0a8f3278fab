// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

#include "base/team.hpp"

// Loops over numbers that stand one after the other, in blocks that do not depend on how many threads there are: sums
// are then the same to the last bit for any number of them.

namespace tether {

/// Long enough that a thread is worth waking for one, short enough that many threads have one.
constexpr std::size_t numbers_of_a_block = 2048;

/// Calls body(begin, end) for blocks that make up 0 to `count`, the end excluded.
template <class Body>
void each_block(Team& team, std::size_t count, const Body& body, std::size_t size = numbers_of_a_block) {
  team.each(0, (count + size - 1) / size, [&](std::size_t b) { body(b * size, std::min(count, (b + 1) * size)); });
}

/// Returns what part(begin, end) returns for blocks of `least` numbers or more, joined to 0 by join(sum, part) in their
/// order.
template <class Part, class Join>
double join_blocks(Team& team, std::size_t count, const Part& part, const Join& join, std::size_t least) {
  std::array<double, 1024> parts;
  const std::size_t size = std::max(least, (count + parts.size() - 1) / parts.size());
  each_block(
      team, count, [&](std::size_t begin, std::size_t end) { parts[begin / size] = part(begin, end); }, size);
  double joined = 0;
  for (std::size_t b = 0; b * size < count; ++b) joined = join(joined, parts[b]);
  return joined;
}

/// Their sum.
template <class Part>
double sum_of_blocks(Team& team, std::size_t count, const Part& part, std::size_t least = numbers_of_a_block) {
  return join_blocks(team, count, part, std::plus<>(), least);
}

/// The largest of what value(k) returns for each k below `count`, or 0.
template <class Value>
double largest_of(Team& team, std::size_t count, const Value& value, std::size_t least = numbers_of_a_block) {
  const auto larger = [](double a, double b) { return std::max(a, b); };
  const auto part = [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t k = begin; k < end; ++k) largest = std::max(largest, value(k));
    return largest;
  };
  return join_blocks(team, count, part, larger, least);
}

}  // namespace tether
