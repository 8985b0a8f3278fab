// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_MOVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_MOVE_INL
#undef TETHER_POINTS_MOVE_INL
#else
#define TETHER_POINTS_MOVE_INL
#endif

#include "physics/points/lanes/books-inl.hpp"
#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// Stages that every kernel shares: velocities, places, what is written of them, and who leaves.

/// FLIP: v_p += dt sum N_i f_i / m_i (3.22), and m_p |a_p|^2 for the balance of energy.
template <class D, class Kernel>
HWY_NOINLINE void accelerate_by_increments(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  const V<D> dt = all<D>(work.dt);
  Kernel::template gather_value<D>(work.N.a_x + n, work.grid.nx, tile, tile.ux);
  Kernel::template gather_value<D>(work.N.a_y + n, work.grid.nx, tile, tile.uy);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(P.mass + p), ax = load<D>(tile.ux[k] + sub), ay = load<D>(tile.uy[k] + sub);
      const auto there = mass > hn::Zero(D());
      const V<D> vx = hn::IfThenElseZero(there, load<D>(P.vx + p) + dt * ax),
                 vy = hn::IfThenElseZero(there, load<D>(P.vy + p) + dt * ay);
      squares = squares + mass * (ax * ax + ay * ay);
      store<D>(vx, P.vx + p), store<D>(vy, P.vy + p);
      store<D>(vx, tile.vx[k] + sub), store<D>(vy, tile.vy[k] + sub);
    }
    store<D>(squares, found.squares + sub);
  }
}

/// What points move with: sum N_i (mv)_i^L / m_i (3.21), by APIC their own velocity.
template <class D, class Kernel, bool affine>
HWY_INLINE void find_way(const LaneWork& work, std::ptrdiff_t n, Tile& tile) {
  if constexpr (affine) {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
        store<D>(load<D>(tile.vx[k] + sub), tile.ux[k] + sub), store<D>(load<D>(tile.vy[k] + sub), tile.uy[k] + sub);
      }
    }
  } else {
    Kernel::template gather_value<D>(work.N.new_x + n, work.grid.nx, tile, tile.ux);
    Kernel::template gather_value<D>(work.N.new_y + n, work.grid.nx, tile, tile.uy);
  }
}

/// What the scatter needs of a layer's points at `at`, where `stays` holds.
template <class D, class Kernel, bool affine, class M>
HWY_INLINE void leave_momenta(Tile& tile, std::size_t k, std::size_t sub, V<D> mass, M stays, Places<D> at) {
  const V<D> m = hn::IfThenElseZero(stays, mass);
  const V<D> r = Kernel::template inside<D>(hn::IfThenElseZero(stays, at.r)),
             s = Kernel::template inside<D>(hn::IfThenElseZero(stays, at.s));
  store<D>(m, tile.m[k] + sub), store<D>(r, tile.r[k] + sub), store<D>(s, tile.s[k] + sub);
  Kernel::template leave_mass<D>(m, r, tile, k, sub);
  if constexpr (affine) {
    const V<D> vx = load<D>(tile.vx[k] + sub), vy = load<D>(tile.vy[k] + sub);
    const V<D> gxx = load<D>(tile.gxx[k] + sub), gyx = load<D>(tile.gyx[k] + sub);
    const V<D> gxy = load<D>(tile.gxy[k] + sub), gyy = load<D>(tile.gyy[k] + sub);
    store<D>(vx - (r * gxx + s * gxy), tile.middle_x[k] + sub);
    store<D>(vy - (r * gyx + s * gyy), tile.middle_y[k] + sub);
  }
}
/// The same of points that stay where they are.
template <class D, class Kernel, bool affine>
HWY_NOINLINE void leave_momenta(const LaneWork& work, Tile& tile) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const V<D> mass = load<D>(work.P.mass + tile.slot[k] + sub);
      const Places<D> at{load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)};
      leave_momenta<D, Kernel, affine>(tile, k, sub, mass, mass > hn::Zero(D()), at);
    }
  }
}

/// New places (3.21), and what the scatter needs of them. Returns whether all points stay in their cells; those that do
/// not have no mass in the tile.
template <class D, class Kernel, bool affine>
HWY_NOINLINE bool move(const LaneWork& work, Tile& tile, LaneFindings& found) {
  constexpr D d;
  const LanePoints P = work.P;
  const V<D> dt = all<D>(work.dt), lowest = all<D>(Kernel::lowest), highest = all<D>(Kernel::highest);
  bool all_stay = true;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D> locate(work.grid, tile, sub);
    V<D> lifted = load<D>(found.lifted + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(P.mass + p), up = dt * load<D>(tile.uy[k] + sub);
      const auto there = mass > hn::Zero(d);
      lifted = lifted + mass * up;
      const V<D> x = load<D>(P.x + p) + hn::IfThenElseZero(there, dt * load<D>(tile.ux[k] + sub)),
                 y = load<D>(P.y + p) + hn::IfThenElseZero(there, up);
      store<D>(x, P.x + p), store<D>(y, P.y + p);
      const Places<D> at = locate(x, y);
      const auto stays = hn::And(hn::And(at.r >= lowest, at.r < highest), hn::And(at.s >= lowest, at.s < highest));
      all_stay &= hn::AllTrue(d, stays);
      leave_momenta<D, Kernel, affine>(tile, k, sub, mass, stays, at);
    }
    store<D>(lifted, found.lifted + sub);
  }
  return all_stay;
}

/// The tile's velocities and fields to the points' arrays, and back.
template <class D>
HWY_INLINE void record_motion(const LaneWork& work, const Tile& tile, std::size_t k, std::size_t sub) {
  const std::size_t p = tile.slot[k] + sub;
  const V<D> per_dx = all<D>(work.grid.per_dx), per_dy = all<D>(work.grid.per_dy);
  store<D>(load<D>(tile.vx[k] + sub), work.P.vx + p), store<D>(load<D>(tile.vy[k] + sub), work.P.vy + p);
  store<D>(per_dx * load<D>(tile.gxx[k] + sub), work.P.vxx + p);
  store<D>(per_dx * load<D>(tile.gyx[k] + sub), work.P.vyx + p);
  store<D>(per_dy * load<D>(tile.gxy[k] + sub), work.P.vxy + p);
  store<D>(per_dy * load<D>(tile.gyy[k] + sub), work.P.vyy + p);
}
template <class D>
HWY_NOINLINE void record_motion(const LaneWork& work, const Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) record_motion<D>(work, tile, k, sub);
  }
}
template <class D, bool affine>
HWY_NOINLINE void recall_motion(const LaneWork& work, Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      store<D>(load<D>(work.P.vx + p), tile.vx[k] + sub), store<D>(load<D>(work.P.vy + p), tile.vy[k] + sub);
      if constexpr (affine) {
        V<D> own[6];
        own_field<D>(work, p, own);
        store<D>(own[2], tile.gxx[k] + sub), store<D>(own[3], tile.gyx[k] + sub);
        store<D>(own[4], tile.gxy[k] + sub), store<D>(own[5], tile.gyy[k] + sub);
      }
    }
  }
}

/// Of gas the stress, and not what it is over the density.
template <class D>
HWY_NOINLINE void record_stress(const LaneWork& work, const Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> rho = load<D>(work.P.rho + p);
      for (double* stress : {work.P.sxx, work.P.syy, work.P.sxy}) store<D>(rho * load<D>(stress + p), stress + p);
    }
  }
}

/// Points that have left their cells: they are noted and give nothing here, and by APIC without records the fields
/// about them are written. What they have lost belongs to where they are now.
template <bool affine>
HWY_NOINLINE void take_out(const LaneWork& work, Tile& tile, LaneFindings& found) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::size_t p = tile.slot[k] + l;
      if (tile.m[k][l] > 0 || !(work.P.mass[p] > 0)) continue;
      if (affine && !work.records) record_motion<One>(work, tile, k, l);
      const Blocks::Cell cell{static_cast<int>(tile.y0), static_cast<int>(tile.x0) + static_cast<int>(l)};
      found.moved.push_back({p, cell, tile.lost[k][l]});
      tile.lost[k][l] = 0;
      tile.xx_by_x[k][l] = tile.xy_by_x[k][l] = tile.xy_by_y[k][l] = tile.yy_by_y[k][l] = 0;
    }
  }
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
