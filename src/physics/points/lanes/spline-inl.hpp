// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_SPLINE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_SPLINE_INL
#undef TETHER_POINTS_SPLINE_INL
#else
#define TETHER_POINTS_SPLINE_INL
#endif

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// Stages of passes by quadratic splines. With a = 1/2 - r and b = 1/2 + r the weights along x are a^2/2, 3/4 - r^2 and
// b^2/2, their slopes -a, -2r and b; c and d are the same along y. Weights add up to 1 and slopes to 0, which saves
// half of the products: of slopes only differences between nodes count, and of nine forces four and the sums of rows
// and columns are enough. The forces so found by subtraction are those of nodes with a weight of 1/2 at least along an
// axis.

namespace spline {

template <class D>
struct Weights {
  V<D> r, s, a, b, c, d;
  V<D> w0, w2, e0, e1, e2;  // twice the weights of the nodes at the sides, along x and along y; e1 that of the middle
};

template <class D>
HWY_INLINE Weights<D> weights(Places<D> at) {
  const V<D> half = all<D>(0.5);
  Weights<D> w;
  w.r = at.r, w.s = at.s;
  w.a = half - at.r, w.b = half + at.r, w.c = half - at.s, w.d = half + at.s;
  w.w0 = w.a * w.a, w.w2 = w.b * w.b, w.e0 = w.c * w.c, w.e2 = w.d * w.d;
  w.e1 = (all<D>(2) - w.e0) - w.e2;
  return w;
}

/// Differences along x of a field at nine nodes, and twice its middle ones.
template <class D>
struct Differences {
  V<D> p[3], q[3], twice[3];
};

template <class D, bool mean>
HWY_INLINE Differences<D> differences(const double* one, const double* other, std::ptrdiff_t nx) {
  Differences<D> n;
#pragma GCC unroll 3
  for (int l = 0; l < 3; ++l) {
    const std::ptrdiff_t at = (l - 1) * nx;
    const V<D> before = at_node<D, mean>(one, other, at - 1), own = at_node<D, mean>(one, other, at),
               after = at_node<D, mean>(one, other, at + 1);
    n.p[l] = own - before, n.q[l] = after - own, n.twice[l] = own + own;
  }
  return n;
}

/// Twice the gradient, in differences from node to node.
template <class D>
HWY_INLINE void twice_gradient(const Differences<D>& n, const Weights<D>& w, V<D>& by_x, V<D>& by_y) {
  V<D> A[3], B[3];
#pragma GCC unroll 3
  for (int l = 0; l < 3; ++l) {
    const V<D> p = w.a * n.p[l], q = w.b * n.q[l];
    A[l] = p + q, B[l] = n.twice[l] + (w.b * q - w.a * p);
  }
  by_x = (w.e0 * A[0] + w.e2 * A[2]) + w.e1 * A[1];
  by_y = w.c * (B[1] - B[0]) + w.d * (B[2] - B[1]);
}

/// sum N_i q_i of a number at the nodes, whose row begins with the group's first one.
template <class D>
struct Value {
  V<D> n[9];

  HWY_INLINE Value(const double* row, std::ptrdiff_t nx, std::size_t sub) {
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) n[i] = load<D>(row + static_cast<std::ptrdiff_t>(sub) + (i / 3 - 1) * nx + i % 3 - 1);
  }
  HWY_INLINE V<D> at(const Weights<D>& w) const {
    const V<D> w1 = (all<D>(2) - w.w0) - w.w2;
    const V<D> low = (w.w0 * n[0] + w.w2 * n[2]) + w1 * n[1], middle = (w.w0 * n[3] + w.w2 * n[5]) + w1 * n[4],
               high = (w.w0 * n[6] + w.w2 * n[8]) + w1 * n[7];
    return all<D>(0.25) * ((w.e0 * low + w.e2 * high) + w.e1 * middle);
  }
};

/// Velocity and APIC's field about the point, by the difference that it makes from node to node.
template <class D>
HWY_INLINE void affine(const V<D>* n, const Weights<D>& w, V<D>& v, V<D>& by_x, V<D>& by_y) {
  const V<D> half = all<D>(0.5), four = all<D>(4);
  const V<D> x0 = half * w.w0, x2 = half * w.w2, x1 = (all<D>(1) - x0) - x2;
  V<D> mean[3], across[3];
  const V<D> y[3] = {half * w.e0, half * w.e1, half * w.e2};
#pragma GCC unroll 3
  for (int l = 0; l < 3; ++l) {
    const V<D> low = x0 * n[3 * l], high = x2 * n[3 * l + 2];
    mean[l] = y[l] * ((low + high) + x1 * n[3 * l + 1]), across[l] = y[l] * (high - low);
  }
  v = (mean[0] + mean[1]) + mean[2];
  by_x = four * (((across[0] + across[1]) + across[2]) - w.r * v);
  by_y = four * ((mean[2] - mean[0]) - w.s * v);
}

/// Strain rates of a field.
template <class D, bool mean>
class Strain {
 public:
  HWY_INLINE Strain(const LaneGrid& grid, const Field& field, std::size_t sub)
      : x_(differences<D, mean>(field.x + sub, field.other_x + sub, grid.nx)),
        y_(differences<D, mean>(field.y + sub, field.other_y + sub, grid.nx)),
        per_x_(all<D>(0.5 * grid.per_dx)),
        per_y_(all<D>(0.5 * grid.per_dy)) {}
  HWY_INLINE Rates<D> at(const Weights<D>& w) const {
    V<D> xx, xy, yx, yy;
    twice_gradient<D>(x_, w, xx, xy), twice_gradient<D>(y_, w, yx, yy);
    xy = per_y_ * xy, yx = per_x_ * yx;
    return {per_x_ * xx, per_y_ * yy, xy + yx, hn::Zero(D()), xy - yx};
  }

 private:
  Differences<D> x_, y_;
  V<D> per_x_, per_y_;
};

/// Velocities and the fields about points.
template <class D>
class Fields {
 public:
  HWY_INLINE Fields(const double* row_x, const double* row_y, std::ptrdiff_t nx, std::size_t sub)
      : x_(row_x, nx, sub), y_(row_y, nx, sub) {}
  HWY_INLINE Motion<D> at(const Weights<D>& w) const {
    Motion<D> of;
    affine<D>(x_.n, w, of.vx, of.gxx, of.gxy), affine<D>(y_.n, w, of.vy, of.gyx, of.gyy);
    return of;
  }

 private:
  Value<D> x_, y_;
};

/// Forces of stresses on the nodes around. One component: t belongs to slopes along x, u along y.
template <class D>
HWY_INLINE void pull(V<D>* F, const Weights<D>& w, V<D> t, V<D> u) {
  const V<D> at = w.a * t, bt = w.b * t, h0 = w.c * u, h2 = w.d * u;
  F[0] += w.e0 * at + w.w0 * h0, F[1] += w.e0 * bt - w.w2 * h0;
  F[2] += w.w0 * h2 - w.e2 * at, F[3] += w.e2 * bt + w.w2 * h2;
  F[4] += h0, F[5] += h2, F[6] += at, F[7] += bt;
}
/// Puts the nine forces, from the four at the corners and the sums of rows and columns.
template <class D, class Put>
HWY_INLINE void put_nine_forces(Put& put, std::size_t q, std::size_t sub, const V<D>* F) {
  const V<D> minus_two = all<D>(-2), two = all<D>(2);
  const V<D> f0 = hn::Neg(F[0]), f2 = F[1], f6 = F[2], f8 = F[3];
  const V<D> f1 = minus_two * F[4] - (f0 + f2), f7 = two * F[5] - (f6 + f8);
  const V<D> f3 = minus_two * F[6] - (f0 + f6), f5 = two * F[7] - (f2 + f8);
  const V<D> f4 = hn::Neg(((f1 + f7) + (f3 + f5)) + ((f0 + f2) + (f6 + f8)));
  const auto to = put.lines(sub);
  put.put(q, 0, to, f0, f1, f2), put.put(q, 1, to, f3, f4, f5), put.put(q, 2, to, f6, f7, f8);
}

/// Sums of mass and momentum at the nodes around cells, line by line over the layers of a tile: all at once they would
/// not find room in registers.
template <class D, bool affine>
class Momenta {
 public:
  /// Leaves a layer's masses m, by their weights along x, and motion in the tile.
  HWY_INLINE void add(Tile& tile, std::size_t k, std::size_t sub, V<D> m, Places<D> at, const Motion<D>& of) const {
    const V<D> half = all<D>(0.5), half_m = half * m, a = half - at.r, b = half + at.r;
    const V<D> m0 = half_m * (a * a), m2 = half_m * (b * b);
    store<D>(m0, tile.m0[k] + sub), store<D>((m - m0) - m2, tile.m1[k] + sub), store<D>(m2, tile.m2[k] + sub);
    store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
    if constexpr (affine) {
      store_motion<D>(of, tile, k, sub);
      store<D>(of.vx - (at.r * of.gxx + at.s * of.gxy), tile.middle_x[k] + sub);
      store<D>(of.vy - (at.r * of.gyx + at.s * of.gyy), tile.middle_y[k] + sub);
    }
  }
  template <class Put>
  HWY_NOINLINE void put(const LanePoints& P, const Tile& tile, std::size_t sub, Put& putting) const {
    put_line<0>(P, tile, sub, putting), put_line<1>(P, tile, sub, putting), put_line<2>(P, tile, sub, putting);
  }

 private:
  template <int l, class Put>
  static HWY_INLINE void put_line(const LanePoints& P, const Tile& tile, std::size_t sub, Put& putting) {
    const V<D> half = all<D>(0.5), three_quarters = all<D>(0.75), zero = hn::Zero(D());
    V<D> M[3] = {zero, zero, zero}, X[3] = {zero, zero, zero}, Y[3] = {zero, zero, zero};
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const V<D> s = load<D>(tile.s[k] + sub), e = l == 0 ? half - s : half + s;
      const V<D> wy = l == 1 ? three_quarters - s * s : half * (e * e);
      const V<D> m0 = wy * load<D>(tile.m0[k] + sub), m1 = wy * load<D>(tile.m1[k] + sub),
                 m2 = wy * load<D>(tile.m2[k] + sub);
      M[0] += m0, M[1] += m1, M[2] += m2;
      if constexpr (affine) {
        const V<D> gxx = load<D>(tile.gxx[k] + sub), gyx = load<D>(tile.gyx[k] + sub);
        V<D> ux = load<D>(tile.middle_x[k] + sub), uy = load<D>(tile.middle_y[k] + sub);
        if constexpr (l == 0) ux -= load<D>(tile.gxy[k] + sub), uy -= load<D>(tile.gyy[k] + sub);
        if constexpr (l == 2) ux += load<D>(tile.gxy[k] + sub), uy += load<D>(tile.gyy[k] + sub);
        X[0] += m0 * (ux - gxx), X[1] += m1 * ux, X[2] += m2 * (ux + gxx);
        Y[0] += m0 * (uy - gyx), Y[1] += m1 * uy, Y[2] += m2 * (uy + gyx);
      } else {
        const auto [vx, vy] = velocities_of<D, false>(P, tile, k, sub);
        X[0] += m0 * vx, X[1] += m1 * vx, X[2] += m2 * vx;
        Y[0] += m0 * vy, Y[1] += m1 * vy, Y[2] += m2 * vy;
      }
    }
    const auto to = putting.lines(sub);
    putting.put(row_of_x, l, to, X[0], X[1], X[2]), putting.put(row_of_y, l, to, Y[0], Y[1], Y[2]);
    if constexpr (Put::most > row_of_m) {
      putting.put(row_of_m, l, to, M[0], M[1], M[2]);
      if (putting.used > row_of_gas) putting.put(row_of_gas, l, to, M[0], M[1], M[2]);
    }
  }
};

/// Sums of forces at the nodes around cells: of each component four and the sums of rows and columns.
template <class D>
class Forces {
 public:
  static HWY_INLINE Forces of(const Tile&, std::size_t) { return {}; }  // put() reads the tile
  HWY_INLINE void add(Tile& tile, std::size_t k, std::size_t sub, Places<D> at, const Pull<D>& of) const {
    store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
    store_pull<D, false>(of, tile, k, sub);
  }
  template <class Put>
  HWY_NOINLINE void put(const Tile& tile, const LaneGrid& grid, std::size_t sub, Put& putting) const {
    const V<D> dx_per_dy = all<D>(grid.per_dy / grid.per_dx), minus_half_per_dx = all<D>(-0.5 * grid.per_dx);
    V<D> F[8], G[8];
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) F[i] = G[i] = hn::Zero(D());
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const auto w = weights<D>({load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)});
      const V<D> xy = load<D>(tile.pull_xy[k] + sub);
      pull<D>(F, w, load<D>(tile.pull_xx[k] + sub), dx_per_dy * xy);
      pull<D>(G, w, xy, dx_per_dy * load<D>(tile.pull_yy[k] + sub));
    }
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) F[i] *= minus_half_per_dx, G[i] *= minus_half_per_dx;
    put_nine_forces<D>(putting, 0, sub, F), put_nine_forces<D>(putting, 1, sub, G);
  }
};

}  // namespace spline

/// Quadratic splines about the nearest node.
struct Spline {
  static constexpr std::ptrdiff_t first = -1;
  static constexpr std::size_t lines = 3;
  static constexpr double lowest = -0.5, highest = 0.5;  // places in a cell

  template <class D>
  static HWY_INLINE V<D> inside(V<D> r) {
    return r;
  }

  template <class D>
  using Weights = spline::Weights<D>;
  template <class D>
  using Value = spline::Value<D>;
  template <class D, bool mean>
  using Strain = spline::Strain<D, mean>;
  template <class D>
  using Fields = spline::Fields<D>;
  template <class D, bool affine>
  using Momenta = spline::Momenta<D, affine>;
  template <class D>
  using Forces = spline::Forces<D>;

  template <class D>
  static HWY_INLINE Weights<D> weights(Places<D> at) {
    return spline::weights<D>(at);
  }

  /// A number of each point.
  template <class D, class Put>
  static HWY_NOINLINE void scatter_value(const Tile& tile, const TileRows& values, Put& putting, std::size_t q) {
    const V<D> quarter = all<D>(0.25), two = all<D>(2), zero = hn::Zero(D());
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> S[9] = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
      for (std::size_t k = 0; k < tile.layers; ++k) {
        const auto w = weights<D>({load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)});
        const V<D> value = quarter * load<D>(values[k] + sub), w1 = (two - w.w0) - w.w2;
        const V<D> low = w.e0 * value, middle = w.e1 * value, high = w.e2 * value;
        S[0] += w.w0 * low, S[1] += w1 * low, S[2] += w.w2 * low;
        S[3] += w.w0 * middle, S[4] += w1 * middle, S[5] += w.w2 * middle;
        S[6] += w.w0 * high, S[7] += w1 * high, S[8] += w.w2 * high;
      }
      const auto to = putting.lines(sub);
#pragma GCC unroll 3
      for (std::size_t l = 0; l < lines; ++l) putting.put(q, l, to, S[3 * l], S[3 * l + 1], S[3 * l + 2]);
    }
  }
};

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
