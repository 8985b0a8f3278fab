// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_LANE_LAWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_LANE_LAWS_INL
#undef TETHER_POINTS_LANE_LAWS_INL
#else
#define TETHER_POINTS_LANE_LAWS_INL
#endif

#include <algorithm>

#include "physics/points/lanes/straining-inl.hpp"
#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// The laws' stages: strain rates of a tile in, stresses of its points and what they pull with out. Slots without a
// point have no volume or mass, and their stress is 0.

/// Stress of a layer; about an axis zz is the hoop's.
template <class D>
struct Stresses {
  V<D> xx, yy, xy, zz;
};

template <class D, bool axis>
HWY_INLINE void store_stress(const LanePoints& P, std::size_t p, const Stresses<D>& s) {
  store<D>(s.xx, P.sxx + p), store<D>(s.yy, P.syy + p), store<D>(s.xy, P.sxy + p);
  if constexpr (axis) store<D>(s.zz, P.szz + p);
}

/// What a stress pulls with in `volume`, for the scatters; of gas it is the stress over the density, in a mass.
template <class D, class Kernel, bool axis>
HWY_INLINE void leave_pull(const LaneWork& work, Tile& tile, std::size_t k, std::size_t sub, V<D> volume,
                           const Stresses<D>& s) {
  const V<D> by_x = volume * all<D>(Kernel::pull * work.grid.per_dx),
             by_y = volume * all<D>(Kernel::pull * work.grid.per_dy);
  store<D>(by_x * s.xx, tile.xx_by_x[k] + sub), store<D>(by_x * s.xy, tile.xy_by_x[k] + sub);
  store<D>(by_y * s.xy, tile.xy_by_y[k] + sub), store<D>(by_y * s.yy, tile.yy_by_y[k] + sub);
  if constexpr (axis) {
    const V<D> radius = load<D>(work.P.x + tile.slot[k] + sub), zero = hn::Zero(D());
    const V<D> hoop = volume * s.zz / hn::IfThenElse(volume > zero, radius, all<D>(1));
    store<D>(hn::Neg(hoop), tile.hoop[k] + sub);
  }
}

/// Notes the first slot of those for which `sound` does not hold.
template <class D, class M>
HWY_INLINE void note_unsound(std::size_t p, M sound, LaneFindings& found) {
  constexpr D d;
  if (HWY_LIKELY(hn::AllTrue(d, sound)) || found.unsound != LaneFindings::none) return;
  found.unsound = p + static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Not(sound)));
}

/// Hooke's law in the plane and about an axis (3.2).
template <class D, class Kernel, bool axis>
class Elastic {
 public:
  static constexpr bool is_gas = false, about_axis = axis;

  HWY_INLINE Elastic(const LaneWork& work, std::ptrdiff_t, std::size_t)
      : work_(work),
        own_(all<D>(work.dt * work.body.own)),
        other_(all<D>(work.dt * work.body.other)),
        shear_(all<D>(0.5 * work.dt * work.body.shear)) {}

  HWY_INLINE void stress(Tile& tile, std::size_t k, std::size_t sub, const typename Kernel::template Weights<D>&,
                         const Rates<D>& rate, LaneFindings& found) const {
    const LanePoints& P = work_.P;
    const std::size_t p = tile.slot[k] + sub;
    const V<D> volume = load<D>(P.volume + p);
    const auto there = volume > hn::Zero(D());
    const V<D> across_x = axis ? rate.yy + rate.zz : rate.yy, across_y = axis ? rate.xx + rate.zz : rate.xx;
    Stresses<D> s;
    s.xx = hn::IfThenElseZero(there, load<D>(P.sxx + p) + (own_ * rate.xx + other_ * across_x));
    s.yy = hn::IfThenElseZero(there, load<D>(P.syy + p) + (other_ * across_y + own_ * rate.yy));
    s.xy = hn::IfThenElseZero(there, load<D>(P.sxy + p) + shear_ * rate.xy);
    if constexpr (axis)
      s.zz = hn::IfThenElseZero(there, load<D>(P.szz + p) + (own_ * rate.zz + other_ * (rate.xx + rate.yy)));
    store_stress<D, axis>(P, p, s);
    note_unsound<D>(p, (hn::Abs(s.xx) + hn::Abs(s.yy)) + hn::Abs(s.xy) < hn::Inf(D()), found);
    leave_pull<D, Kernel, axis>(work_, tile, k, sub, volume, s);
  }

 private:
  LaneWork work_;
  V<D> own_, other_, shear_;
};

/// sigma : eps'.
template <class D, bool axis>
HWY_INLINE V<D> power(const Stresses<D>& s, const Rates<D>& of) {
  const V<D> in_plane = (s.xx * of.xx + s.yy * of.yy) + s.xy * of.xy;
  return axis ? in_plane + s.zz * of.zz : in_plane;
}

/// sigma / rho of a gas (4.1), (4.4) with artificial viscosity (4.11), (4.12), and where it is heated by the rate that
/// makes it, the energy (4.10). Its density comes from the nodes, as does the heat of the ledger, which stands in the
/// tile, or from continuity (4.7), or it stands in its array. The points' arrays hold sigma / rho within a step, so
/// that nothing is divided by rho twice; record_stress() ends that, unless contact reads the stress between the passes.
template <class D, class Kernel, bool axis, LaneLaw law_of>
class Gas {
 public:
  static constexpr bool is_gas = true, about_axis = axis;
  static constexpr bool by_nodes = law_of == LaneLaw::gas_of_nodes;

  HWY_INLINE Gas(const LaneWork& work, std::ptrdiff_t n, std::size_t sub)
      : work_(work),
        warmed_(by_nodes && work.N.heat),
        records_(!by_nodes || work.records),
        density_(work.N.rho + n, work.grid.nx, sub),
        dt_(all<D>(work.dt)),
        gm1_(all<D>(work.body.gm1)),
        c_of_e_(all<D>(work.body.gamma * work.body.gm1)),
        linear_(all<D>(work.body.linear)),
        square_(all<D>(work.body.square)) {}

  HWY_INLINE void stress(Tile& tile, std::size_t k, std::size_t sub, const typename Kernel::template Weights<D>& w,
                         const Rates<D>& of, LaneFindings& found) const {
    const LanePoints& P = work_.P;
    const LaneBody& law = work_.body;
    const std::size_t p = tile.slot[k] + sub;
    const V<D> zero = hn::Zero(D()), infinite = hn::Inf(D()), mass = load<D>(P.mass + p);
    const auto there = mass > zero;
    V<D> energy = load<D>(P.energy + p);
    if (warmed_) energy = hn::IfThenElseZero(there, energy + (load<D>(tile.at_place[k] + sub) + all<D>(law.heat)));
    const V<D> rate = axis ? of.xx + of.yy + of.zz : of.xx + of.yy;
    const V<D> rho = hn::IfThenElse(there, density(p, rate, w), all<D>(1));
    const V<D> c = law.local_speed ? hn::Sqrt(hn::Max(zero, c_of_e_ * energy)) : all<D>(law.c_max);
    const V<D> q = hn::IfThenElseZero(rate < zero, (square_ * rate - linear_ * c) * rate);
    const Stresses<D> s = over_density(gm1_ * energy + q, rate, rho, of);
    if (law.heats) energy = hn::IfThenElseZero(there, energy + dt_ * power<D, axis>(s, of));
    if (law.heats || warmed_) store<D>(energy, P.energy + p);
    if (records_) store<D>(rho, P.rho + p);
    const V<D> times = work_.reads_stress ? rho : all<D>(1);
    store_stress<D, axis>(P, p, {times * s.xx, times * s.yy, times * s.xy, axis ? times * s.zz : zero});
    note_unsound<D>(p, hn::And(rho > zero, hn::And(rho < infinite, hn::Abs(energy) < infinite)), found);
    leave_pull<D, Kernel, axis>(work_, tile, k, sub, mass, s);
  }

 private:
  HWY_INLINE V<D> density(std::size_t p, V<D> rate, const typename Kernel::template Weights<D>& w) const {
    if constexpr (by_nodes) return density_.at(w);
    const V<D> rho = load<D>(work_.P.rho + p);
    return law_of == LaneLaw::gas_of_continuity ? rho / (all<D>(1) + dt_ * rate) : rho;
  }
  HWY_INLINE Stresses<D> over_density(V<D> pressure, V<D> rate, V<D> rho, const Rates<D>& of) const {
    const V<D> mu = all<D>(2 * work_.body.mu), zero = hn::Zero(D()), normal = hn::Neg(pressure);
    if (work_.body.mu == 0) return {normal, normal, zero, normal};
    const V<D> two_nu = mu / rho, mean = all<D>(1.0 / 3) * rate;
    return {two_nu * (of.xx - mean) - pressure, two_nu * (of.yy - mean) - pressure, all<D>(0.5) * two_nu * of.xy,
            axis ? two_nu * (of.zz - mean) - pressure : zero};
  }

  LaneWork work_;
  bool warmed_, records_;
  FromNodes<D, Kernel, by_nodes> density_;
  V<D> dt_, gm1_, c_of_e_, linear_, square_;
};

/// i += dt (sigma : eps') / rho (4.10) of a layer, with the strain rate of (v_old + v_new) / 2; `divides`: its stress
/// is not yet over rho.
template <class D, bool axis>
HWY_INLINE void heat_centred(const LanePoints& P, std::size_t p, V<D> dt, bool divides, const Rates<D>& of) {
  const V<D> zero = hn::Zero(D());
  const Stresses<D> s{load<D>(P.sxx + p), load<D>(P.syy + p), load<D>(P.sxy + p), axis ? load<D>(P.szz + p) : zero};
  const V<D> all_power = power<D, axis>(s, of), own = divides ? all_power / load<D>(P.rho + p) : all_power;
  const V<D> energy = load<D>(P.energy + p) + dt * own;
  store<D>(hn::IfThenElseZero(load<D>(P.mass + p) > zero, energy), P.energy + p);
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
