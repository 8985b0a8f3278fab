// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_LOOPS_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_LOOPS_LANES_INL
#undef TETHER_LOOPS_LANES_INL
#else
#define TETHER_LOOPS_LANES_INL
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace tether::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Lanes of the processor: as many numbers as one instruction works on. Every function here does in each lane what it
// would do alone, one rounding an operation, so that results do not depend on how many lanes there are.

/// Eight lanes or as many as the processor has, but no more; One has a single one.
using All = hn::CappedTag<double, 8>;
using One = hn::CappedTag<double, 1>;

template <class D>
constexpr std::size_t width = hn::MaxLanes(D());

template <class D>
using V = hn::Vec<D>;

template <class D>
HWY_INLINE V<D> load(const double* from) {
  return hn::LoadU(D(), from);
}
template <class D>
HWY_INLINE void store(V<D> v, double* to) {
  hn::StoreU(v, D(), to);
}
template <class D>
HWY_INLINE V<D> all(double a) {
  return hn::Set(D(), a);
}
/// first, first + 1, ...
template <class D>
HWY_INLINE V<D> counting(double first) {
  return hn::Iota(D(), first);
}

/// What stood in the two lanes before a vector: of one lane these are two vectors.
template <class D>
struct Before {
  V<D> last{}, last_but_one{};
  HWY_INLINE void follow(V<D> v) { last_but_one = last, last = v; }
};

/// `v` moved up by some lanes, fewer than it has, with the last lanes of `before` ahead.
template <class D, std::size_t by>
HWY_INLINE V<D> up_by(V<D> v, V<D> before) {
  constexpr D d;
  alignas(64) std::int64_t from[width<D>];
  for (std::size_t l = 0; l < width<D>; ++l) from[l] = static_cast<std::int64_t>((l + width<D> - by) % width<D>);
  const auto lanes = hn::SetTableIndices(d, from);
  return hn::IfThenElse(hn::FirstN(d, by), hn::TableLookupLanes(before, lanes), hn::TableLookupLanes(v, lanes));
}

/// `v` moved up by one lane, the lane before it from `before`.
template <class D>
HWY_INLINE V<D> up_by_one(V<D> v, const Before<D>& before) {
  if constexpr (width<D> == 1) {
    return before.last;
  } else {
    return up_by<D, 1>(v, before.last);
  }
}
/// The same by two lanes.
template <class D>
HWY_INLINE V<D> up_by_two(V<D> v, const Before<D>& before) {
  if constexpr (width<D> == 1) {
    return before.last_but_one;
  } else if constexpr (width<D> == 2) {
    return before.last;
  } else {
    return up_by<D, 2>(v, before.last);
  }
}

/// to += v.
template <class D>
HWY_INLINE void add_to(double* to, V<D> v) {
  store<D>(load<D>(to) + v, to);
}

}  // namespace tether::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
