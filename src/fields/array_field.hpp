// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "base/units.hpp"

// The arrays of a state, described once: a tuple of rows, from which sizes, sorting, checkpoint and memory derive.

namespace tether {

/// How long a number stands: from step to step, so that a checkpoint has it and it moves with its point; the same, but
/// the array is empty unless something in the scene asks for it; or only within a step.
enum class Kept { always, where_asked, within_step };

/// One array of a state, a number for each point or node.
template <class Owner, class Number>
struct ArrayField {
  const char* name;  ///< in a checkpoint
  std::vector<Number> Owner::*array;
  Dimension dimension;
  const char* meaning;
  Kept kept = Kept::always;

  constexpr bool remembered() const { return kept != Kept::within_step; }
  bool carried_by(const Owner& owner) const { return kept != Kept::where_asked || !(owner.*array).empty(); }
};

/// Calls visit(row) for each row.
template <class Rows, class Visit>
constexpr void each_row(const Rows& rows, const Visit& visit) {
  std::apply([&](const auto&... row) { (visit(row), ...); }, rows);
}

/// The type of a row's numbers.
template <class Row, class Owner>
using NumberOf =
    typename std::remove_reference_t<decltype(std::declval<Owner&>().*std::declval<const Row&>().array)>::value_type;

/// Memory that all arrays take for one point [bytes].
template <class Owner, class Rows>
constexpr std::size_t bytes_of_arrays(const Rows& rows) {
  std::size_t bytes = 0;
  each_row(rows, [&](const auto& row) { bytes += sizeof(NumberOf<decltype(row), Owner>); });
  return bytes;
}

/// What a checkpoint takes for one point [bytes]: all its numbers are doubles.
template <class Rows>
constexpr std::size_t bytes_of_saved_arrays(const Rows& rows) {
  std::size_t bytes = 0;
  each_row(rows, [&](const auto& row) { bytes += row.remembered() ? sizeof(double) : 0; });
  return bytes;
}

/// Whether two rows are of one array, or have one name.
template <class One, class Other>
constexpr bool same_array(const One& one, const Other& other) {
  if constexpr (std::is_same_v<One, Other>) {
    if (one.array == other.array) return true;
  }
  return std::string_view(one.name) == other.name;
}

/// Whether `Owner`, which consists of arrays alone, has one row for each of them.
template <class Owner, class Rows>
constexpr bool lists_each_array_once(const Rows& rows) {
  std::size_t bytes = 0, pairs = 0, same = 0;
  each_row(rows, [&](const auto& one) {
    bytes += sizeof(std::vector<NumberOf<decltype(one), Owner>>);
    each_row(rows, [&](const auto& other) { ++pairs, same += same_array(one, other) ? 1 : 0; });
  });
  return bytes == sizeof(Owner) && same * same == pairs;  // each row is the same as itself alone
}

}  // namespace tether
