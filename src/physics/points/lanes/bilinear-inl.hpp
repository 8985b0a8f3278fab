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
      : x_(slopes(grid, sides<D, mean>(field.x + sub, field.other_x + sub, grid.nx))),
        y_(slopes(grid, sides<D, mean>(field.y + sub, field.other_y + sub, grid.nx))) {}
  HWY_INLINE Rates<D> at(const Weights<D>& w) const {
    const V<D> xy = by_y(x_, w), yx = by_x(y_, w);
    return {by_x(x_, w), by_y(y_, w), xy + yx, hn::Zero(D()), xy - yx};
  }

 private:
  static HWY_INLINE Sides<D> slopes(const LaneGrid& grid, const Sides<D>& v) {
    const V<D> per_dx = all<D>(grid.per_dx), per_dy = all<D>(grid.per_dy);
    return {per_dx * v.low, per_dx * v.high, per_dy * v.left, per_dy * v.right};
  }
  Sides<D> x_, y_;
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

/// Sums of mass and momentum at a cell's nodes, row by row, over the layers of a tile.
template <class D, bool affine>
class Momenta {
 public:
  /// Leaves a layer's masses m and motion in the tile.
  HWY_INLINE void add(Tile& tile, std::size_t k, std::size_t sub, V<D> m, Places<D> at, const Motion<D>& of) const {
    store<D>(m, tile.m1[k] + sub), store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
    if constexpr (affine) {
      store_motion<D>(of, tile, k, sub);
      store<D>(of.vx - (at.r * of.gxx + at.s * of.gxy), tile.middle_x[k] + sub);
      store<D>(of.vy - (at.r * of.gyx + at.s * of.gyy), tile.middle_y[k] + sub);
    }
  }
  template <class Put>
  HWY_NOINLINE void put(const LanePoints& P, const Tile& tile, std::size_t sub, Put& putting) const {
    const V<D> one = all<D>(1), zero = hn::Zero(D());
    V<D> M[4] = {zero, zero, zero, zero}, X[4] = {zero, zero, zero, zero}, Y[4] = {zero, zero, zero, zero};
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const V<D> r = load<D>(tile.r[k] + sub), s = load<D>(tile.s[k] + sub), mass = load<D>(tile.m1[k] + sub);
      const V<D> low = (one - s) * mass, high = s * mass, left = one - r;
      const V<D> m[4] = {left * low, r * low, left * high, r * high};
      V<D> x[4], y[4];
      velocities(P, tile, k, sub, x, y);
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) M[i] += m[i], X[i] += m[i] * x[i], Y[i] += m[i] * y[i];
    }
    const auto to = putting.lines(sub);
#pragma GCC unroll 2
    for (std::size_t l = 0; l < 2; ++l) {
      putting.put(row_of_x, l, to, X[2 * l], X[2 * l + 1]), putting.put(row_of_y, l, to, Y[2 * l], Y[2 * l + 1]);
      if constexpr (Put::most > row_of_m) {
        putting.put(row_of_m, l, to, M[2 * l], M[2 * l + 1]);
        if (putting.used > row_of_gas) putting.put(row_of_gas, l, to, M[2 * l], M[2 * l + 1]);
      }
    }
  }

 private:
  /// Finds what a layer's points have at their four nodes, row by row.
  static HWY_INLINE void velocities(const LanePoints& P, const Tile& tile, std::size_t k, std::size_t sub, V<D>* x,
                                    V<D>* y) {
    if constexpr (affine) {
      const V<D> gxx = load<D>(tile.gxx[k] + sub), gyx = load<D>(tile.gyx[k] + sub);
      x[0] = load<D>(tile.middle_x[k] + sub), y[0] = load<D>(tile.middle_y[k] + sub);
      x[2] = x[0] + load<D>(tile.gxy[k] + sub), y[2] = y[0] + load<D>(tile.gyy[k] + sub);
      x[1] = x[0] + gxx, x[3] = x[2] + gxx, y[1] = y[0] + gyx, y[3] = y[2] + gyx;
    } else {
      const auto [vx, vy] = velocities_of<D, false>(P, tile, k, sub);
      x[0] = x[1] = x[2] = x[3] = vx, y[0] = y[1] = y[2] = y[3] = vy;
    }
  }
};

/// Sums of forces at a cell's nodes, of each component two that belong to slopes along x and two along y.
template <class D>
class Forces {
 public:
  HWY_INLINE Forces() {
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) X_[i] = Y_[i] = hn::Zero(D());
  }
  /// The sums over a tile whose places and pulls are known.
  static HWY_INLINE Forces of(Tile& tile, std::size_t sub) {
    Forces sums;
    for (std::size_t k = 0; k < tile.layers; ++k)
      sums.add(tile, k, sub, {load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)},
               {load<D>(tile.pull_xx[k] + sub), load<D>(tile.pull_xy[k] + sub), load<D>(tile.pull_yy[k] + sub),
                hn::Zero(D())});
    return sums;
  }
  HWY_INLINE void add(Tile&, std::size_t, std::size_t, Places<D> at, const Pull<D>& of) {
    const V<D> one = all<D>(1), low = one - at.s, left = one - at.r;
    X_[0] += low * of.xx, X_[1] += at.s * of.xx, X_[2] += left * of.xy, X_[3] += at.r * of.xy;
    Y_[0] += low * of.xy, Y_[1] += at.s * of.xy, Y_[2] += left * of.yy, Y_[3] += at.r * of.yy;
  }
  template <class Put>
  HWY_INLINE void put(const Tile&, const LaneGrid& grid, std::size_t sub, Put& putting) const {
    put(putting, 0, sub, grid, X_), put(putting, 1, sub, grid, Y_);
  }

 private:
  template <class Put>
  static HWY_INLINE void put(Put& putting, std::size_t q, std::size_t sub, const LaneGrid& grid, const V<D>* F) {
    const V<D> per_dx = all<D>(grid.per_dx), per_dy = all<D>(grid.per_dy);
    const V<D> low = per_dx * F[0], high = per_dx * F[1], left = per_dy * F[2], right = per_dy * F[3];
    const auto to = putting.lines(sub);
    putting.put(q, 0, to, low + left, right - low);
    putting.put(q, 1, to, high - left, hn::Neg(high + right));
  }
  V<D> X_[4], Y_[4];
};

}  // namespace bilinear

/// Bilinear functions of a cell's four nodes.
struct Bilinear {
  static constexpr std::ptrdiff_t first = 0;
  static constexpr std::size_t lines = 2;
  static constexpr double lowest = 0, highest = 1;  // places in a cell

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
  template <class D, bool affine>
  using Momenta = bilinear::Momenta<D, affine>;
  template <class D>
  using Forces = bilinear::Forces<D>;

  template <class D>
  static HWY_INLINE Weights<D> weights(Places<D> at) {
    return {at.r, at.s, all<D>(1) - at.r, all<D>(1) - at.s};
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
      const auto to = putting.lines(sub);
#pragma GCC unroll 2
      for (std::size_t l = 0; l < lines; ++l) putting.put(q, l, to, S[2 * l], S[2 * l + 1]);
    }
  }
};

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
