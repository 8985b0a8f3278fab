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

template <class D>
struct Weights {
  V<D> a, b, c, d;
  V<D> w0, w2, e0, e1, e2;  // twice the weights of the nodes at the sides, along x and along y; e1 that of the middle
};

template <class D>
HWY_INLINE Weights<D> weights(V<D> r, V<D> s) {
  const V<D> half = all<D>(0.5);
  Weights<D> w;
  w.a = half - r, w.b = half + r, w.c = half - s, w.d = half + s;
  w.w0 = w.a * w.a, w.w2 = w.b * w.b, w.e0 = w.c * w.c, w.e2 = w.d * w.d;
  w.e1 = (all<D>(2) - w.e0) - w.e2;
  return w;
}

/// Differences along x of a field at nine nodes, and twice its middle ones.
template <class D>
struct Differences {
  V<D> p[3], q[3], twice[3];
};

template <class D>
HWY_INLINE Differences<D> differences(const double* row, std::ptrdiff_t nx) {
  Differences<D> n;
#pragma GCC unroll 3
  for (int l = 0; l < 3; ++l) {
    const double* at = row + (l - 1) * nx - 1;
    const V<D> before = load<D>(at), own = load<D>(at + 1), behind = load<D>(at + 2);
    n.p[l] = own - before, n.q[l] = behind - own, n.twice[l] = own + own;
  }
  return n;
}
/// Those of the mean of two fields.
template <class D>
HWY_INLINE Differences<D> mean_differences(const double* one, const double* other, std::ptrdiff_t nx) {
  Differences<D> n;
  const V<D> half = all<D>(0.5);
#pragma GCC unroll 3
  for (int l = 0; l < 3; ++l) {
    const std::ptrdiff_t at = (l - 1) * nx - 1;
    const V<D> before = half * (load<D>(one + at) + load<D>(other + at)),
               own = half * (load<D>(one + at + 1) + load<D>(other + at + 1)),
               behind = half * (load<D>(one + at + 2) + load<D>(other + at + 2));
    n.p[l] = own - before, n.q[l] = behind - own, n.twice[l] = own + own;
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

/// Places of the points in their cells.
template <class D>
HWY_INLINE void locate(const LaneWork& work, Tile& tile) {
  const V<D> x0 = all<D>(work.grid.x0), y0 = all<D>(work.grid.y0), per_dx = all<D>(work.grid.per_dx),
             per_dy = all<D>(work.grid.per_dy), row = all<D>(tile.y0);
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> cell = counting<D>(tile.x0 + static_cast<double>(sub));
      store<D>((load<D>(work.P.x + p) - x0) * per_dx - cell, tile.r[k] + sub);
      store<D>((load<D>(work.P.y + p) - y0) * per_dy - row, tile.s[k] + sub);
    }
  }
}

/// Velocities at the nodes, from the group's first one on: of one field, or the mean of two.
struct Field {
  const double *x, *y;
  const double *other_x = nullptr, *other_y = nullptr;
};

/// grad v of a field.
template <class D, bool mean>
HWY_INLINE void gather_gradient(const LaneGrid& grid, const Field& field, Tile& tile) {
  const V<D> per_x = all<D>(0.5 * grid.per_dx), per_y = all<D>(0.5 * grid.per_dy);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    Differences<D> nx, ny;
    if constexpr (mean) {
      nx = mean_differences<D>(field.x + sub, field.other_x + sub, grid.nx);
      ny = mean_differences<D>(field.y + sub, field.other_y + sub, grid.nx);
    } else {
      nx = differences<D>(field.x + sub, grid.nx), ny = differences<D>(field.y + sub, grid.nx);
    }
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Weights<D> w = weights<D>(load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub));
      V<D> xx, xy, yx, yy;
      twice_gradient<D>(nx, w, xx, xy), twice_gradient<D>(ny, w, yx, yy);
      store<D>(per_x * xx, tile.xx[k] + sub), store<D>(per_y * xy, tile.xy[k] + sub);
      store<D>(per_x * yx, tile.yx[k] + sub), store<D>(per_y * yy, tile.yy[k] + sub);
    }
  }
}

/// sum N_i q_i of a number at the nodes.
template <class D>
HWY_INLINE void gather_value(const double* row, std::ptrdiff_t nx, const Tile& tile, TileRows& values) {
  const V<D> quarter = all<D>(0.25), two = all<D>(2);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> n[9];
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) n[i] = load<D>(row + static_cast<std::ptrdiff_t>(sub) + (i / 3 - 1) * nx + i % 3 - 1);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Weights<D> w = weights<D>(load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub));
      const V<D> w1 = (two - w.w0) - w.w2;
      const V<D> low = (w.w0 * n[0] + w.w2 * n[2]) + w1 * n[1], middle = (w.w0 * n[3] + w.w2 * n[5]) + w1 * n[4],
                 high = (w.w0 * n[6] + w.w2 * n[8]) + w1 * n[7];
      store<D>(quarter * ((w.e0 * low + w.e2 * high) + w.e1 * middle), values[k] + sub);
    }
  }
}

/// Forces of stresses on the nodes around. One component: t belongs to slopes along x, u along y.
template <class D>
HWY_INLINE void pull(V<D>* F, const Weights<D>& w, V<D> t, V<D> u) {
  const V<D> at = w.a * t, bt = w.b * t, h0 = w.c * u, h2 = w.d * u;
  F[0] += w.e0 * at + w.w0 * h0, F[1] += w.e0 * bt - w.w2 * h0;
  F[2] += w.w0 * h2 - w.e2 * at, F[3] += w.e2 * bt + w.w2 * h2;
  F[4] += h0, F[5] += h2, F[6] += at, F[7] += bt;
}
/// The nine forces from the four at the corners and the sums of rows and columns.
template <class D>
HWY_INLINE void nine_forces_of(const V<D>* F, NineSums& sums, std::size_t sub) {
  const V<D> minus_two = all<D>(-2), two = all<D>(2);
  const V<D> f0 = hn::Neg(F[0]), f2 = F[1], f6 = F[2], f8 = F[3];
  const V<D> f1 = minus_two * F[4] - (f0 + f2), f7 = two * F[5] - (f6 + f8);
  const V<D> f3 = minus_two * F[6] - (f0 + f6), f5 = two * F[7] - (f2 + f8);
  const V<D> f4 = hn::Neg(((f1 + f7) + (f3 + f5)) + ((f0 + f2) + (f6 + f8)));
  const V<D> f[9] = {f0, f1, f2, f3, f4, f5, f6, f7, f8};
#pragma GCC unroll 9
  for (int i = 0; i < 9; ++i) store<D>(f[i], sums[i] + sub);
}

/// Sums of a group, as pull() has them: of each component and lane.
using PullSums = double[2][8][lanes];

template <class D>
HWY_INLINE void scatter_forces(const Tile& tile, PullSums& sums) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> F[8], G[8];
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) F[i] = load<D>(sums[0][i] + sub), G[i] = load<D>(sums[1][i] + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Weights<D> w = weights<D>(load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub));
      pull<D>(F, w, load<D>(tile.xx_by_x[k] + sub), load<D>(tile.xy_by_y[k] + sub));
      pull<D>(G, w, load<D>(tile.xy_by_x[k] + sub), load<D>(tile.yy_by_y[k] + sub));
    }
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) store<D>(F[i], sums[0][i] + sub), store<D>(G[i], sums[1][i] + sub);
  }
}

template <class D>
HWY_INLINE void nine_forces(const double (&sums)[8][lanes], NineSums& nine) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> F[8];
#pragma GCC unroll 8
    for (int i = 0; i < 8; ++i) F[i] = load<D>(sums[i] + sub);
    nine_forces_of<D>(F, nine, sub);
  }
}

/// Velocity and APIC's field about the point, by the difference that it makes from node to node.
template <class D>
HWY_INLINE void affine(const V<D>* n, const Weights<D>& w, V<D> r, V<D> s, V<D>& v, V<D>& by_x, V<D>& by_y) {
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
  by_x = four * (((across[0] + across[1]) + across[2]) - r * v);
  by_y = four * ((mean[2] - mean[0]) - s * v);
}

/// The same of both components of a field, into the tile.
template <class D>
HWY_INLINE void gather_affine(const double* row_x, const double* row_y, std::ptrdiff_t nx, Tile& tile) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> x[9], y[9];
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(sub) + (i / 3 - 1) * nx + i % 3 - 1;
      x[i] = load<D>(row_x + at), y[i] = load<D>(row_y + at);
    }
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const V<D> r = load<D>(tile.r[k] + sub), s = load<D>(tile.s[k] + sub);
      const Weights<D> w = weights<D>(r, s);
      V<D> v, by_x, by_y;
      affine<D>(x, w, r, s, v, by_x, by_y);
      store<D>(v, tile.vx[k] + sub), store<D>(by_x, tile.gxx[k] + sub), store<D>(by_y, tile.gxy[k] + sub);
      affine<D>(y, w, r, s, v, by_x, by_y);
      store<D>(v, tile.vy[k] + sub), store<D>(by_x, tile.gyx[k] + sub), store<D>(by_y, tile.gyy[k] + sub);
    }
  }
}

/// A number of each point to the nodes around.
template <class D>
HWY_INLINE void scatter_value(const Tile& tile, const TileRows& values, NineSums& sums) {
  const V<D> quarter = all<D>(0.25), two = all<D>(2);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> S[9];
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) S[i] = load<D>(sums[i] + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Weights<D> w = weights<D>(load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub));
      const V<D> q = quarter * load<D>(values[k] + sub), w1 = (two - w.w0) - w.w2;
      const V<D> low = w.e0 * q, middle = w.e1 * q, high = w.e2 * q;
      S[0] += w.w0 * low, S[1] += w1 * low, S[2] += w.w2 * low;
      S[3] += w.w0 * middle, S[4] += w1 * middle, S[5] += w.w2 * middle;
      S[6] += w.w0 * high, S[7] += w1 * high, S[8] += w.w2 * high;
    }
#pragma GCC unroll 9
    for (int i = 0; i < 9; ++i) store<D>(S[i], sums[i] + sub);
  }
}

/// Mass and momentum of the points, with the fields about them, to the nodes around.
template <class D>
HWY_INLINE void scatter_momenta(const Tile& tile, NineSums& m, NineSums& px, NineSums& py) {
  const V<D> half = all<D>(0.5), three_quarters = all<D>(0.75);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
#pragma GCC unroll 3
    for (int l = 0; l < 3; ++l) {
      V<D> M[3], X[3], Y[3];
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
        M[i] = load<D>(m[3 * l + i] + sub), X[i] = load<D>(px[3 * l + i] + sub), Y[i] = load<D>(py[3 * l + i] + sub);
      }
      for (std::size_t k = 0; k < tile.layers; ++k) {
        const V<D> r = load<D>(tile.r[k] + sub), s = load<D>(tile.s[k] + sub);
        const V<D> a = half - r, b = half + r, e = l == 0 ? half - s : half + s;
        const V<D> wy = l == 1 ? three_quarters - s * s : half * e * e;
        const V<D> mass = wy * load<D>(tile.m[k] + sub);
        const V<D> gxx = load<D>(tile.gxx[k] + sub), gyx = load<D>(tile.gyx[k] + sub);
        V<D> ux = load<D>(tile.middle_x[k] + sub), uy = load<D>(tile.middle_y[k] + sub);
        if (l == 0) ux -= load<D>(tile.gxy[k] + sub), uy -= load<D>(tile.gyy[k] + sub);
        if (l == 2) ux += load<D>(tile.gxy[k] + sub), uy += load<D>(tile.gyy[k] + sub);
        const V<D> m0 = mass * (half * a * a), m1 = mass * (three_quarters - r * r), m2 = mass * (half * b * b);
        M[0] += m0, M[1] += m1, M[2] += m2;
        X[0] += m0 * (ux - gxx), X[1] += m1 * ux, X[2] += m2 * (ux + gxx);
        Y[0] += m0 * (uy - gyx), Y[1] += m1 * uy, Y[2] += m2 * (uy + gyx);
      }
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
        store<D>(M[i], m[3 * l + i] + sub), store<D>(X[i], px[3 * l + i] + sub), store<D>(Y[i], py[3 * l + i] + sub);
      }
    }
  }
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
