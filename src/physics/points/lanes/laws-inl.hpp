// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_LANE_LAWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_LANE_LAWS_INL
#undef TETHER_POINTS_LANE_LAWS_INL
#else
#define TETHER_POINTS_LANE_LAWS_INL
#endif

#include <algorithm>

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// The laws' stages: strain rates of a tile in, stresses of its points and what they pull with out. Slots without a
// point have no volume or mass, and their stress is 0.

/// What a stress pulls with in `volume`, for scatter_forces(); of gas it is the stress over the density, in a mass.
template <class D, class Kernel>
HWY_INLINE void leave_pull(const LaneGrid& grid, Tile& tile, std::size_t k, std::size_t sub, V<D> volume, V<D> sxx,
                           V<D> syy, V<D> sxy) {
  const V<D> by_x = volume * all<D>(Kernel::pull * grid.per_dx), by_y = volume * all<D>(Kernel::pull * grid.per_dy);
  store<D>(by_x * sxx, tile.xx_by_x[k] + sub), store<D>(by_x * sxy, tile.xy_by_x[k] + sub);
  store<D>(by_y * sxy, tile.xy_by_y[k] + sub), store<D>(by_y * syy, tile.yy_by_y[k] + sub);
}

/// Notes the first slot of those for which `sound` does not hold.
template <class D, class M>
HWY_INLINE void note_unsound(std::size_t p, M sound, LaneFindings& found) {
  constexpr D d;
  if (HWY_LIKELY(hn::AllTrue(d, sound)) || found.unsound != LaneFindings::none) return;
  found.unsound = p + static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Not(sound)));
}

/// Hooke's law in the plane (3.2).
template <class D>
struct Elastic {
  static constexpr bool is_gas = false, by_nodes = false;

  template <class Kernel>
  static HWY_INLINE void stress(const LaneWork& work, Tile& tile, std::size_t sub, LaneFindings& found) {
    const LanePoints P = work.P;
    const LaneGrid grid = work.grid;
    const V<D> own = all<D>(work.dt * work.body.own), other = all<D>(work.dt * work.body.other),
               shear = all<D>(0.5 * work.dt * work.body.shear);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> volume = load<D>(P.volume + p), xx = load<D>(tile.xx[k] + sub), yy = load<D>(tile.yy[k] + sub);
      const auto there = volume > hn::Zero(D());
      const V<D> sxx = hn::IfThenElseZero(there, load<D>(P.sxx + p) + (own * xx + other * yy));
      const V<D> syy = hn::IfThenElseZero(there, load<D>(P.syy + p) + (other * xx + own * yy));
      const V<D> sxy = hn::IfThenElseZero(there, load<D>(P.sxy + p) + shear * load<D>(tile.xy[k] + sub));
      store<D>(sxx, P.sxx + p), store<D>(syy, P.syy + p), store<D>(sxy, P.sxy + p);
      note_unsound<D>(p, (hn::Abs(sxx) + hn::Abs(syy)) + hn::Abs(sxy) < hn::Inf(D()), found);
      leave_pull<D, Kernel>(grid, tile, k, sub, volume, sxx, syy, sxy);
    }
  }
};

/// sigma / rho of a gas (4.1), (4.4) with artificial viscosity (4.11), (4.12), and where it is heated by the rate that
/// makes it, the energy (4.10). Its density comes from the nodes, as does the heat of the ledger, or from continuity
/// (4.7). The points' arrays hold sigma / rho within a step, so that nothing is divided by rho twice; record_stress()
/// ends that.
template <class D, bool density_by_nodes>
struct Gas {
  static constexpr bool is_gas = true, by_nodes = density_by_nodes;

  template <class Kernel>
  static HWY_INLINE void stress(const LaneWork& work, Tile& tile, std::size_t sub, LaneFindings& found) {
    const LanePoints P = work.P;
    const LaneGrid grid = work.grid;
    const LaneBody law = work.body;
    const bool warmed = by_nodes && work.N.heat, records = work.records;
    const V<D> zero = hn::Zero(D()), infinite = hn::Inf(D()), dt = all<D>(work.dt), gm1 = all<D>(law.gm1),
               c_of_e = all<D>(law.gamma * law.gm1), linear = all<D>(law.linear), square = all<D>(law.square);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(P.mass + p);
      const auto there = mass > zero;
      V<D> energy = load<D>(P.energy + p);
      if (warmed) energy = hn::IfThenElseZero(there, energy + (load<D>(tile.at_place[k] + sub) + all<D>(law.heat)));
      const V<D> xx = load<D>(tile.xx[k] + sub), yy = load<D>(tile.yy[k] + sub),
                 xy = all<D>(0.5) * load<D>(tile.xy[k] + sub), rate = xx + yy;
      const V<D> now = by_nodes ? load<D>(tile.rho[k] + sub) : load<D>(P.rho + p) / (all<D>(1) + dt * rate);
      const V<D> rho = hn::IfThenElse(there, now, all<D>(1));
      const V<D> c = law.local_speed ? hn::Sqrt(hn::Max(zero, c_of_e * energy)) : all<D>(law.c_max);
      const V<D> q = hn::IfThenElseZero(rate < zero, (square * rate - linear * c) * rate);
      const V<D> pressure = gm1 * energy + q;
      V<D> sxx = hn::Neg(pressure), syy = sxx, sxy = zero;
      if (law.mu != 0) {
        const V<D> two_nu = all<D>(2 * law.mu) / rho, mean = all<D>(1.0 / 3) * rate;
        sxx = two_nu * (xx - mean) - pressure, syy = two_nu * (yy - mean) - pressure, sxy = two_nu * xy;
      }
      if (law.heats) energy = hn::IfThenElseZero(there, energy + dt * ((sxx * xx + syy * yy) + (sxy + sxy) * xy));
      if (law.heats || warmed) store<D>(energy, P.energy + p);
      if (records || !by_nodes) store<D>(rho, P.rho + p);
      store<D>(sxx, P.sxx + p), store<D>(syy, P.syy + p), store<D>(sxy, P.sxy + p);
      note_unsound<D>(p, hn::And(rho > zero, hn::And(rho < infinite, hn::Abs(energy) < infinite)), found);
      leave_pull<D, Kernel>(grid, tile, k, sub, mass, sxx, syy, sxy);
    }
  }
};

template <class D, class Kernel, class Law>
HWY_NOINLINE void stress(const LaneWork& work, Tile& tile, LaneFindings& found) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) Law::template stress<Kernel>(work, tile, sub, found);
}

/// What a law reads at the nodes.
template <class D, class Kernel, class Law>
HWY_INLINE void find_at_nodes(const LaneWork& work, std::ptrdiff_t n, Tile& tile) {
  if constexpr (Law::by_nodes) {
    Kernel::template gather_value<D>(work.N.rho + n, work.grid.nx, tile, tile.rho);
    if (work.N.heat) Kernel::template gather_value<D>(work.N.heat + n, work.grid.nx, tile, tile.at_place);
  }
}

/// i += dt (sigma : eps') / rho (4.10) with the strain rate of (v_old + v_new) / 2.
template <class D>
HWY_NOINLINE void heat_centred(const LaneWork& work, const Tile& tile) {
  const LanePoints P = work.P;
  const V<D> dt = all<D>(work.dt);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> power =
          (load<D>(P.sxx + p) * load<D>(tile.xx[k] + sub) + load<D>(P.syy + p) * load<D>(tile.yy[k] + sub)) +
          load<D>(P.sxy + p) * load<D>(tile.xy[k] + sub);
      const V<D> energy = load<D>(P.energy + p) + dt * power;
      store<D>(hn::IfThenElseZero(load<D>(P.mass + p) > hn::Zero(D()), energy), P.energy + p);
    }
  }
}

/// Largest sound speed of the gas and largest wave. Waves are looked at one by one only where the tile's largest sound
/// speed and velocity together would be more than the largest wave so far.
template <class D>
HWY_INLINE void note_waves(const LaneWork& work, const Tile& tile, LaneFindings& found) {
  constexpr D d;
  const V<D> c_of_e = all<D>(work.body.gamma * work.body.gm1), zero = hn::Zero(d);
  V<D> c_squared = zero, v_squared = zero, wave = zero;
  const auto each = [&](const auto& visit) HWY_ATTR {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
        const V<D> vx = load<D>(tile.vx[k] + sub), vy = load<D>(tile.vy[k] + sub);
        const V<D> there = hn::VecFromMask(d, load<D>(work.P.mass + tile.slot[k] + sub) > zero);
        visit(hn::And(there, c_of_e * load<D>(work.P.energy + tile.slot[k] + sub)), hn::And(there, vx * vx + vy * vy));
      }
    }
  };
  each([&](V<D> c, V<D> v) HWY_ATTR { c_squared = hn::Max(c_squared, c), v_squared = hn::Max(v_squared, v); });
  const V<D> most_c = hn::MaxOfLanes(d, c_squared), most_v = hn::MaxOfLanes(d, v_squared);
  found.c_squared = std::max(found.c_squared, hn::GetLane(most_c));
  if (hn::GetLane(hn::Sqrt(most_c) + hn::Sqrt(most_v)) <= found.wave) return;
  each([&](V<D> c, V<D> v) HWY_ATTR { wave = hn::Max(wave, hn::Sqrt(hn::Max(zero, c)) + hn::Sqrt(v)); });
  found.wave = std::max(found.wave, hn::GetLane(hn::MaxOfLanes(d, wave)));
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
