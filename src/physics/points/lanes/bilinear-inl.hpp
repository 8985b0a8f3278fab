// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_BILINEAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_BILINEAR_INL
#undef TETHER_POINTS_BILINEAR_INL
#else
#define TETHER_POINTS_BILINEAR_INL
#endif

#include "grid/boxes.hpp"
#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// Stages of passes by bilinear functions. With r and s from 0 to 1 the weights along x are 1 - r and r, along y 1 - s
// and s (A.3.1).

namespace bilinear {

template <class D>
struct Weights {
  V<D> r, s, left, low;  // the last two 1 - r and 1 - s
};

/// Differences of a field along the sides of a cell.
template <class D>
struct Sides {
  V<D> low, high, left, right;  // along x below and above, along y on the left and on the right
};
template <class D, bool mean>
HWY_INLINE Sides<D> sides(const double* one, const double* other, std::ptrdiff_t nx) {
  const V<D> v0 = at_node<D, mean>(one, other, 0), v1 = at_node<D, mean>(one, other, 1),
             v2 = at_node<D, mean>(one, other, nx + 1), v3 = at_node<D, mean>(one, other, nx);
  return {v1 - v0, v2 - v3, v3 - v0, v2 - v1};
}
template <class D>
HWY_INLINE V<D> by_x(const Sides<D>& v, const Weights<D>& w) {
  return w.low * v.low + w.s * v.high;
}
template <class D>
HWY_INLINE V<D> by_y(const Sides<D>& v, const Weights<D>& w) {
  return w.left * v.left + w.r * v.right;
}

/// sum N_i q_i of a number at the nodes, whose row begins with the group's first one.
template <class D>
class Value {
 public:
  HWY_INLINE Value(const double* row, std::ptrdiff_t nx, std::size_t sub)
      : v0_(load<D>(row + sub)),
        v1_(load<D>(row + sub + 1)),
        v2_(load<D>(row + sub + nx + 1)),
        v3_(load<D>(row + sub + nx)) {}
  HWY_INLINE V<D> at(const Weights<D>& w) const {
    return w.low * (w.left * v0_ + w.r * v1_) + w.s * (w.left * v3_ + w.r * v2_);
  }

 private:
  V<D> v0_, v1_, v2_, v3_;
};

/// Strain rates of a field.
template <class D, bool mean>
class Strain {
 public:
  HWY_INLINE Strain(const LaneGrid& grid, const Field& field, std::size_t sub)
      : x_(sides<D, mean>(field.x + sub, field.other_x + sub, grid.nx)),
        y_(sides<D, mean>(field.y + sub, field.other_y + sub, grid.nx)),
        per_x_(all<D>(grid.per_dx)),
        per_y_(all<D>(grid.per_dy)) {}
  HWY_INLINE Rates<D> at(const Weights<D>& w) const {
    return {per_x_ * by_x(x_, w), per_y_ * by_y(y_, w), per_y_ * by_y(x_, w) + per_x_ * by_x(y_, w), hn::Zero(D())};
  }

 private:
  Sides<D> x_, y_;
  V<D> per_x_, per_y_;
};

/// Velocities and the fields about points: value and gradient.
template <class D>
class Fields {
 public:
  HWY_INLINE Fields(const double* row_x, const double* row_y, std::ptrdiff_t nx, std::size_t sub)
      : x_(row_x, nx, sub),
        y_(row_y, nx, sub),
        of_x_(sides<D, false>(row_x + sub, nullptr, nx)),
        of_y_(sides<D, false>(row_y + sub, nullptr, nx)) {}
  HWY_INLINE Motion<D> at(const Weights<D>& w) const {
    return {x_.at(w), y_.at(w), by_x(of_x_, w), by_x(of_y_, w), by_y(of_x_, w), by_y(of_y_, w)};
  }

 private:
  Value<D> x_, y_;
  Sides<D> of_x_, of_y_;
};

}  // namespace bilinear

/// Bilinear functions of a cell's four nodes.
struct Bilinear {
  static constexpr std::ptrdiff_t first = 0;
  static constexpr std::size_t lines = 2;
  static constexpr double lowest = 0, highest = 1;  // places in a cell
  static constexpr double pull = -1;                // what a stress pulls with, over a cell's side

  /// As Locator::inside.
  template <class D>
  static HWY_INLINE V<D> inside(V<D> r) {
    return hn::Min(hn::Max(r, all<D>(Locator::edge)), all<D>(1 - Locator::edge));
  }

  template <class D>
  using Weights = bilinear::Weights<D>;
  template <class D>
  using Value = bilinear::Value<D>;
  template <class D, bool mean>
  using Strain = bilinear::Strain<D, mean>;
  template <class D>
  using Fields = bilinear::Fields<D>;

  template <class D>
  static HWY_INLINE Weights<D> weights(Places<D> at) {
    return {at.r, at.s, all<D>(1) - at.r, all<D>(1) - at.s};
  }

  /// Mass by the weights along x.
  template <class D>
  static HWY_INLINE void leave_mass(V<D> m, V<D> r, Tile& tile, std::size_t k, std::size_t sub) {
    store<D>(m * (all<D>(1) - r), tile.m0[k] + sub), store<D>(m * r, tile.m1[k] + sub);
  }

  /// Mass and momentum of a tile's points, with the fields about them.
  template <class D, bool affine, class Put>
  static HWY_NOINLINE void scatter_momenta(const Tile& tile, Put& putting) {
    const V<D> one = all<D>(1), zero = hn::Zero(D());
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> M[4] = {zero, zero, zero, zero}, X[4] = {zero, zero, zero, zero}, Y[4] = {zero, zero, zero, zero};
      for (std::size_t k = 0; k < tile.layers; ++k) {
        const V<D> s = load<D>(tile.s[k] + sub), low = one - s;
        const V<D> m0 = load<D>(tile.m0[k] + sub), m1 = load<D>(tile.m1[k] + sub);
        const V<D> m[4] = {low * m0, low * m1, s * m0, s * m1};
        V<D> x[4], y[4];
        velocities<D, affine>(tile, k, sub, x, y);
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) M[i] += m[i], X[i] += m[i] * x[i], Y[i] += m[i] * y[i];
      }
      for (std::size_t l = 0; l < lines; ++l) {
        putting.put(row_of_x, l, sub, X[2 * l], X[2 * l + 1]), putting.put(row_of_y, l, sub, Y[2 * l], Y[2 * l + 1]);
        if (putting.used > row_of_m) putting.put(row_of_m, l, sub, M[2 * l], M[2 * l + 1]);
        if (putting.used > row_of_gas) putting.put(row_of_gas, l, sub, M[2 * l], M[2 * l + 1]);
      }
    }
  }
  /// What a layer's points have at their four nodes, row by row.
  template <class D, bool affine>
  static HWY_INLINE void velocities(const Tile& tile, std::size_t k, std::size_t sub, V<D>* x, V<D>* y) {
    if constexpr (affine) {
      const V<D> gxx = load<D>(tile.gxx[k] + sub), gyx = load<D>(tile.gyx[k] + sub);
      x[0] = load<D>(tile.middle_x[k] + sub), y[0] = load<D>(tile.middle_y[k] + sub);
      x[2] = x[0] + load<D>(tile.gxy[k] + sub), y[2] = y[0] + load<D>(tile.gyy[k] + sub);
      x[1] = x[0] + gxx, x[3] = x[2] + gxx, y[1] = y[0] + gyx, y[3] = y[2] + gyx;
    } else {
      x[0] = x[1] = x[2] = x[3] = load<D>(tile.vx[k] + sub), y[0] = y[1] = y[2] = y[3] = load<D>(tile.vy[k] + sub);
    }
  }

  /// A number of each point.
  template <class D, class Put>
  static HWY_NOINLINE void scatter_value(const Tile& tile, const TileRows& values, Put& putting, std::size_t q) {
    const V<D> zero = hn::Zero(D());
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> S[4] = {zero, zero, zero, zero};
      for (std::size_t k = 0; k < tile.layers; ++k) {
        const auto w = weights<D>({load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)});
        const V<D> value = load<D>(values[k] + sub), low = w.low * value, high = w.s * value;
        S[0] += w.left * low, S[1] += w.r * low, S[2] += w.left * high, S[3] += w.r * high;
      }
      for (std::size_t l = 0; l < lines; ++l) putting.put(q, l, sub, S[2 * l], S[2 * l + 1]);
    }
  }

  /// Forces of stresses: of a component `by_x` belongs to slopes along x, `by_y` along y.
  template <class D, class Put>
  static HWY_NOINLINE void scatter_forces(const Tile& tile, Put& putting) {
    const V<D> one = all<D>(1), zero = hn::Zero(D());
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> X[4] = {zero, zero, zero, zero}, Y[4] = {zero, zero, zero, zero};
      for (std::size_t k = 0; k < tile.layers; ++k) {
        const V<D> r = load<D>(tile.r[k] + sub), s = load<D>(tile.s[k] + sub), left = one - r, low = one - s;
        const auto pull = [&](V<D>* F, V<D> by_x, V<D> by_y)
                              HWY_ATTR { F[0] += low * by_x, F[1] += s * by_x, F[2] += left * by_y, F[3] += r * by_y; };
        pull(X, load<D>(tile.xx_by_x[k] + sub), load<D>(tile.xy_by_y[k] + sub));
        pull(Y, load<D>(tile.xy_by_x[k] + sub), load<D>(tile.yy_by_y[k] + sub));
      }
      put_forces<D>(putting, 0, sub, X), put_forces<D>(putting, 1, sub, Y);
    }
  }
  template <class D, class Put>
  static HWY_INLINE void put_forces(Put& putting, std::size_t q, std::size_t sub, const V<D>* F) {
    putting.put(q, 0, sub, hn::Neg(F[0] + F[2]), F[0] - F[3]);
    putting.put(q, 1, sub, F[2] - F[1], F[1] + F[3]);
  }
};

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
