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

/// `v` turned by some lanes, fewer than it has, so that lane 0 stands in lane `by`.
template <class D, std::size_t by>
HWY_INLINE V<D> turned(V<D> v) {
  alignas(64) std::int64_t from[width<D>];
  for (std::size_t l = 0; l < width<D>; ++l) from[l] = static_cast<std::int64_t>((l + width<D> - by) % width<D>);
  return hn::TableLookupLanes(v, hn::SetTableIndices(D(), from));
}

/// Vectors that follow each other, moved up by some lanes: what stands in the last lanes of one comes into the first
/// ones of the next. Zeros come first.
template <class D, std::size_t by>
class UpBy {
 public:
  HWY_INLINE V<D> follow(V<D> v) {
    if constexpr (width<D> <= by) {
      const V<D> up = before_[by / width<D> - 1];
      for (std::size_t k = by / width<D> - 1; k > 0; --k) before_[k] = before_[k - 1];
      before_[0] = v;
      return up;
    } else {
      const V<D> now = turned<D, by>(v), up = hn::IfThenElse(hn::FirstN(D(), by), before_[0], now);
      before_[0] = now;
      return up;
    }
  }

 private:
  static constexpr std::size_t vectors = by > width<D> ? by / width<D> : 1;
  V<D> before_[vectors] = {};
};

/// to += v.
template <class D>
HWY_INLINE void add_to(double* to, V<D> v) {
  store<D>(load<D>(to) + v, to);
}

}  // namespace tether::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
