// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

// A run warns of each doubt once. What it has warned of is a number of a bit for each enumerator of an enumeration of
// doubts, which checkpoints keep.

template <class Doubt>
constexpr bool is_warned(long long warned, Doubt of) {
  return ((warned >> static_cast<int>(of)) & 1) != 0;
}

/// Notes the doubt. True the first time, when there is to be a warning.
template <class Doubt>
constexpr bool note_warning(long long& warned, Doubt of) {
  const bool first = !is_warned(warned, of);
  warned |= 1LL << static_cast<int>(of);
  return first;
}

}  // namespace tether
