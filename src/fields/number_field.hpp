// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

// Single numbers of a state, described once: a tuple of rows next to the members, from which the checkpoint derives.

namespace tether {

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

/// Whether two rows are of one member, or have one name.
template <class One, class Other>
constexpr bool same_number(const One& one, const Other& other) {
  if constexpr (std::is_same_v<One, Other>) {
    if (one.number == other.number) return true;
  }
  return std::string_view(one.name) == other.name;
}

/// Whether `Owner`, an aggregate of numbers alone, has one row for each of them.
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
