// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/numbers.hpp"

namespace tether {

// The arrays of a state, described once: a tuple of rows, from which sizes, sorting, checkpoint and memory derive.

/// How long a number stands: from step to step, so that a checkpoint has it and it moves with its point; the same, but
/// the array is empty unless something in the scene asks for it; or only within a step, where something asks for it.
enum class Kept { always, where_asked, within_step };

/// One array of a state, a number for each point or node.
template <class Owner, class Array>
struct ArrayField {
  const char* name;  ///< in a checkpoint
  Array Owner::*array;
  Dimension dimension;
  const char* meaning;
  Kept kept = Kept::always;

  constexpr bool remembered() const { return kept != Kept::within_step; }
  bool carried_by(const Owner& owner) const { return kept == Kept::always || !(owner.*array).empty(); }
};

/// Calls visit(row) for each row.
template <class Rows, class Visit>
constexpr void each_row(const Rows& rows, const Visit& visit) {
  std::apply([&](const auto&... row) { (visit(row), ...); }, rows);
}

/// The types of a row's array and of its numbers.
template <class Row, class Owner>
using ArrayOf = std::remove_reference_t<decltype(std::declval<Owner&>().*std::declval<const Row&>().array)>;
template <class Row, class Owner>
using NumberOf = typename ArrayOf<Row, Owner>::value_type;

/// Memory that arrays take for one point [bytes]: those that are always there, and those that a scene may ask for.
struct ArrayBytes {
  std::size_t always = 0, asked = 0;
};
template <class Owner, class Rows>
constexpr ArrayBytes bytes_of_arrays(const Rows& rows) {
  ArrayBytes bytes;
  each_row(rows, [&](const auto& row) {
    (row.kept == Kept::always ? bytes.always : bytes.asked) += sizeof(NumberOf<decltype(row), Owner>);
  });
  return bytes;
}

/// Counts what a checkpoint takes for one point [bytes]: all its numbers are doubles.
template <class Rows>
constexpr std::size_t bytes_of_saved_arrays(const Rows& rows) {
  std::size_t bytes = 0;
  each_row(rows, [&](const auto& row) { bytes += row.remembered() ? sizeof(double) : 0; });
  return bytes;
}

/// Returns whether two rows are of one array, or have one name.
template <class One, class Other>
constexpr bool same_array(const One& one, const Other& other) {
  if constexpr (std::is_same_v<One, Other>) {
    if (one.array == other.array) return true;
  }
  return std::string_view(one.name) == other.name;
}

/// Returns whether `Owner`, which consists of arrays alone, has one row for each of them.
template <class Owner, class Rows>
constexpr bool lists_each_array_once(const Rows& rows) {
  std::size_t bytes = 0, pairs = 0, same = 0;
  each_row(rows, [&](const auto& one) {
    bytes += sizeof(ArrayOf<decltype(one), Owner>);
    each_row(rows, [&](const auto& other) { ++pairs, same += same_array(one, other) ? 1U : 0U; });
  });
  return bytes == sizeof(Owner) && same * same == pairs;  // each row is the same as itself alone
}

// Single numbers of a state, described once: a tuple of rows next to the members, from which the checkpoint derives.

/// A number that a state remembers from one step to the next.
template <class Owner, class Number>
struct NumberField {
  const char* name;  ///< in a checkpoint
  Number Owner::*number;
};

/// with(name, number) for each number of an owner: of a checkpoint, either way.
template <class Exchange, class Owner>
constexpr void exchange_numbers(Exchange& with, Owner& owner) {
  std::apply([&](const auto&... row) { (with(row.name, owner.*row.number), ...); }, Owner::rows());
}

namespace detail {
struct Anything {
  template <class T>
  constexpr operator T() const;  // NOLINT: a stand-in for any member, never called
};
template <class Owner, std::size_t... k>
constexpr bool begins_with(std::index_sequence<k...>) {
  return requires { Owner{(static_cast<void>(k), Anything{})...}; };
}
}  // namespace detail

/// How many members an aggregate has that holds numbers alone.
template <class Owner, std::size_t n = 0>
constexpr std::size_t count_members() {
  if constexpr (detail::begins_with<Owner>(std::make_index_sequence<n + 1>{}))
    return count_members<Owner, n + 1>();
  else
    return n;
}

/// Returns whether two rows are of one member, or have one name.
template <class One, class Other>
constexpr bool same_number(const One& one, const Other& other) {
  if constexpr (std::is_same_v<One, Other>) {
    if (one.number == other.number) return true;
  }
  return std::string_view(one.name) == other.name;
}

/// Returns whether `Owner`, an aggregate of numbers alone, has one row for each of them.
template <class Owner, class... Row>
constexpr bool lists_each_number_once(const std::tuple<Row...>& rows) {
  std::size_t same = 0;
  std::apply(
      [&](const auto&... one) {
        const auto count = [&](const auto& of) { same += ((same_number(of, one) ? 1U : 0U) + ...); };
        (count(one), ...);
      },
      rows);
  return sizeof...(Row) == count_members<Owner>() && same == sizeof...(Row);  // each is the same as itself alone
}

}  // namespace tether
