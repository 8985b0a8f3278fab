// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_STRAINING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_STRAINING_INL
#undef TETHER_POINTS_STRAINING_INL
#else
#define TETHER_POINTS_STRAINING_INL
#endif

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

/// A number of the nodes, where a law or a geometry asks for it.
template <class D, class Kernel, bool asked>
class FromNodes {
 public:
  HWY_INLINE FromNodes(const double* row, std::ptrdiff_t nx, std::size_t sub) : value_(row, nx, sub) {}
  HWY_INLINE V<D> at(const typename Kernel::template Weights<D>& w) const { return value_.at(w); }

 private:
  typename Kernel::template Value<D> value_;
};
template <class D, class Kernel>
class FromNodes<D, Kernel, false> {
 public:
  HWY_INLINE FromNodes(const double*, std::ptrdiff_t, std::size_t) {}
  HWY_INLINE V<D> at(const typename Kernel::template Weights<D>&) const { return hn::Zero(D()); }
};

/// Strain rates (3.23), about an axis with eps_theta' = v_r / r.
template <class D, class Kernel, bool axis, bool mean>
class Straining {
 public:
  HWY_INLINE Straining(const LaneGrid& grid, const Field& field, std::size_t sub)
      : in_plane_(grid, field, sub), radial_(field.x, grid.nx, sub), other_(field.other_x, grid.nx, sub) {}

  /// Returns the rates of a layer at radius x; slots without a point have no mass.
  HWY_INLINE Rates<D> at(const typename Kernel::template Weights<D>& w, V<D> x, V<D> mass) const {
    Rates<D> rate = in_plane_.at(w);
    if constexpr (axis) rate.zz = radial(w) / hn::IfThenElse(mass > hn::Zero(D()), x, all<D>(1));
    return rate;
  }

 private:
  HWY_INLINE V<D> radial(const typename Kernel::template Weights<D>& w) const {
    if constexpr (mean) return all<D>(0.5) * (radial_.at(w) + other_.at(w));
    return radial_.at(w);
  }
  typename Kernel::template Strain<D, mean> in_plane_;
  FromNodes<D, Kernel, axis> radial_;
  FromNodes<D, Kernel, axis && mean> other_;
};

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
