// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_LANE_LAWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_LANE_LAWS_INL
#undef TETHER_POINTS_LANE_LAWS_INL
#else
#define TETHER_POINTS_LANE_LAWS_INL
#endif

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// The laws' stages: strain rates of a tile in, stresses of its points out, and what they pull with. Slots without a
// point have no volume or mass, and their stress is 0.

/// What a stress pulls with in `volume`, for scatter_forces().
template <class D>
HWY_INLINE void leave_pull(const LaneWork& work, Tile& tile, std::size_t k, std::size_t sub, V<D> volume, V<D> sxx,
                           V<D> syy, V<D> sxy) {
  const V<D> by_x = volume * all<D>(-0.5 * work.grid.per_dx), by_y = volume * all<D>(-0.5 * work.grid.per_dy);
  store<D>(by_x * sxx, tile.xx_by_x[k] + sub), store<D>(by_x * sxy, tile.xy_by_x[k] + sub);
  store<D>(by_y * sxy, tile.xy_by_y[k] + sub), store<D>(by_y * syy, tile.yy_by_y[k] + sub);
}

/// Notes the first slot of those for which `sound` does not hold.
template <class D, class M>
HWY_INLINE void note_unsound(std::size_t p, M sound, LaneFindings& found) {
  constexpr D d;
  if (hn::AllTrue(d, sound) || found.unsound != LaneFindings::none) return;
  found.unsound = p + static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Not(sound)));
}

/// (3.2)
template <class D>
HWY_INLINE void elastic(const LaneWork& work, Tile& tile, LaneFindings& found) {
  const V<D> own = all<D>(work.dt * work.body.own), other = all<D>(work.dt * work.body.other),
             shear = all<D>(0.5 * work.dt * work.body.shear), infinite = hn::Inf(D());
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> volume = load<D>(work.P.volume + p), dxx = load<D>(tile.xx[k] + sub), dyy = load<D>(tile.yy[k] + sub);
      const auto there = volume > hn::Zero(D());
      const V<D> sxx = hn::IfThenElseZero(there, load<D>(work.P.sxx + p) + (own * dxx + other * dyy));
      const V<D> syy = hn::IfThenElseZero(there, load<D>(work.P.syy + p) + (other * dxx + own * dyy));
      const V<D> sxy = hn::IfThenElseZero(
          there, load<D>(work.P.sxy + p) + shear * (load<D>(tile.xy[k] + sub) + load<D>(tile.yx[k] + sub)));
      store<D>(sxx, work.P.sxx + p), store<D>(syy, work.P.syy + p), store<D>(sxy, work.P.sxy + p);
      note_unsound<D>(p, (hn::Abs(sxx) + hn::Abs(syy)) + hn::Abs(sxy) < infinite, found);
      leave_pull<D>(work, tile, k, sub, volume, sxx, syy, sxy);
    }
  }
}

/// Stress of a gas (4.1), (4.4) with artificial viscosity (4.11), (4.12), and where it is heated by the rate that makes
/// it, the energy (4.10). Its density at the points stands in the tile.
template <class D>
HWY_INLINE void gas(const LaneWork& work, Tile& tile, LaneFindings& found) {
  const LaneBody& law = work.body;
  const V<D> zero = hn::Zero(D()), one = all<D>(1), two_mu = all<D>(2 * law.mu), third = all<D>(1.0 / 3),
             gm1 = all<D>(law.gm1), c_of_e = all<D>(law.gamma * law.gm1), linear = all<D>(law.linear),
             square = all<D>(law.square), dt = all<D>(work.dt), c_max = all<D>(law.c_max), infinite = hn::Inf(D());
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(work.P.mass + p), at_place = load<D>(tile.rho[k] + sub);
      const auto there = mass > zero;
      const V<D> rho = hn::IfThenElse(there, at_place, one);
      V<D> energy = load<D>(work.P.energy + p);
      if (work.N.heat) energy = hn::IfThenElseZero(there, energy + (load<D>(tile.heat[k] + sub) + all<D>(law.heat)));
      const V<D> xx = load<D>(tile.xx[k] + sub), yy = load<D>(tile.yy[k] + sub);
      const V<D> xy = all<D>(0.5) * (load<D>(tile.xy[k] + sub) + load<D>(tile.yx[k] + sub));
      const V<D> rate = xx + yy, mean = third * rate;
      const V<D> c = law.local_speed ? hn::Sqrt(hn::Max(zero, c_of_e * energy)) : c_max;
      const V<D> q = hn::IfThenElseZero(rate < zero, rho * (square * rate * rate - linear * c * rate));
      const V<D> pressure = gm1 * rho * energy + q;
      const V<D> sxx = two_mu * (xx - mean) - pressure, syy = two_mu * (yy - mean) - pressure, sxy = two_mu * xy;
      if (law.heats) {
        energy = energy + dt * ((sxx * xx + syy * yy) + (sxy + sxy) * xy) / rho;
        energy = hn::IfThenElseZero(there, energy);
      }
      store<D>(energy, work.P.energy + p), store<D>(rho, work.P.rho + p);
      store<D>(sxx, work.P.sxx + p), store<D>(syy, work.P.syy + p), store<D>(sxy, work.P.sxy + p);
      note_unsound<D>(p, hn::And(rho > zero, hn::And(rho < infinite, hn::Abs(energy) < infinite)), found);
      leave_pull<D>(work, tile, k, sub, mass / rho, sxx, syy, sxy);
    }
  }
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
