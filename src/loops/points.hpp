// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

// The loops over points. Whoever has something to do at each point hands it over as a body; which slots are visited, in
// which order, and how what they find is put together is said here alone.

namespace tether {

/// Slots of some points, the end excluded.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Calls body(p) for each slot, in their order.
template <class Body>
inline void for_points(Range range, const Body& body) {
  for (std::size_t p = range.begin; p < range.end; ++p) body(p);
}

/// The same for slots of which some hold no point: only for those where slots.holds(p).
template <class Slots, class Body>
inline void for_points(const Slots& slots, Range range, const Body& body) {
  for (std::size_t p = range.begin; p < range.end; ++p) {
    if (slots.holds(p)) body(p);
  }
}

/// The same for a body that finds something: body(p, found) adds to what it is handed, in the order of slots, and the
/// loop returns it. Sums have the same bits whoever adds them, and no body has hold of what others find.
template <class Found, class Body>
[[nodiscard]] inline Found find_at_points(Range range, Found found, const Body& body) {
  for (std::size_t p = range.begin; p < range.end; ++p) body(p, found);
  return found;
}

}  // namespace tether
