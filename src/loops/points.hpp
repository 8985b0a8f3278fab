// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>

// The loops over points. Whoever has something to do at each point hands it over as a body; which slots are visited, in
// which order, and how what they find is put together is said here alone.

namespace tether {

struct Slots;

/// Slots of some points, the end excluded; each holds a point.
struct Range {
  std::size_t begin = 0, end = 0;

  operator Slots() const;
};

/// The same where some may hold no point: a loop over them asks who holds the points.
struct Slots {
  std::size_t begin = 0, end = 0;
  bool gaps = false;

  std::size_t size() const { return end - begin; }
  /// Returns the range of a body that leaves no slot empty.
  Range full() const {
    assert(!gaps);
    return {begin, end};
  }
};
inline Range::operator Slots() const { return {begin, end}; }

/// Calls body(p) for each slot, in their order.
template <class Body>
inline void for_points(Range range, const Body& body) {
  for (std::size_t p = range.begin; p < range.end; ++p) body(p);
}

/// Does the same for slots of which some hold no point: only for those where points.holds(p).
template <class Points, class Body>
inline void for_points(const Points& points, Slots slots, const Body& body) {
  for (std::size_t p = slots.begin; p < slots.end; ++p) {
    if (points.holds(p)) body(p);
  }
}

/// Does the same for a body that finds something: body(p, found) adds to what it is handed, in the order of slots, and
/// the loop returns it. Sums have the same bits whoever adds them, and no body has hold of what others find.
template <class Found, class Body>
[[nodiscard]] inline Found find_at_points(Range range, Found found, const Body& body) {
  for (std::size_t p = range.begin; p < range.end; ++p) body(p, found);
  return found;
}

}  // namespace tether
