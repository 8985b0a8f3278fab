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

// The laws: strain rates of a layer in, its stresses out. Slots without a point have no volume or mass, and their
// stress is 0.

/// Stress of a layer; about an axis zz is the hoop's.
template <class D>
struct Stresses {
  V<D> xx, yy, xy, zz;
};

/// What gas may take from the nodes at a layer: density, and heat for the ledger [energy/mass].
template <class D>
struct AtNodes {
  V<D> density, warmth;
};
template <class D>
HWY_INLINE AtNodes<D> not_from_nodes() {
  return {hn::Zero(D()), hn::Zero(D())};
}

/// What a law finds for a layer: the stresses and the volumes in which they pull; of gas these are masses, and the
/// stresses are over the density.
template <class D>
struct Stressed {
  V<D> volume;
  Stresses<D> stress;
};
template <class D, bool axis>
HWY_INLINE Pull<D> pull_of(const Stressed<D>& of, V<D> radius) {
  const V<D> zero = hn::Zero(D());
  Pull<D> pull{of.volume * of.stress.xx, of.volume * of.stress.xy, of.volume * of.stress.yy, zero};
  if constexpr (axis)
    pull.hoop = hn::Neg(of.volume * of.stress.zz / hn::IfThenElse(of.volume > zero, radius, all<D>(1)));
  return pull;
}

template <class D, bool axis>
HWY_INLINE void store_stress(const LanePoints& P, std::size_t p, const Stresses<D>& s) {
  store<D>(s.xx, P.sxx + p), store<D>(s.yy, P.syy + p), store<D>(s.xy, P.sxy + p);
  if constexpr (axis) store<D>(s.zz, P.szz + p);
}

/// Notes the first slot of those for which `sound` does not hold.
template <class D, class M>
HWY_INLINE void note_unsound(std::size_t p, M sound, LaneFindings& found) {
  constexpr D d;
  if (HWY_LIKELY(hn::AllTrue(d, sound)) || found.unsound != LaneFindings::none) return;
  found.unsound = p + static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Not(sound)));
}

/// Hooke's law in the plane and about an axis (3.2).
template <class D, bool axis>
class Elastic {
 public:
  static constexpr bool is_gas = false, by_nodes = false, about_axis = axis;

  HWY_INLINE explicit Elastic(const LaneWork& work)
      : own_(all<D>(work.dt * work.body.own)),
        other_(all<D>(work.dt * work.body.other)),
        shear_(all<D>(0.5 * work.dt * work.body.shear)) {}

  HWY_INLINE Stressed<D> stress(const LanePoints& P, std::size_t p, const AtNodes<D>&, const Rates<D>& rate,
                                LaneFindings& found) const {
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
    note_unsound<D>(p, hn::Abs((s.xx + s.yy) + s.xy) < hn::Inf(D()), found);
    return {volume, s};
  }

 private:
  V<D> own_, other_, shear_;
};

/// A law that is asked point by point, with rates from the lanes.
template <class D, bool axis>
class OneByOne {
 public:
  static constexpr bool is_gas = false, by_nodes = false, about_axis = axis;

  HWY_INLINE explicit OneByOne(const LaneWork& work) : law_(work.body.each) {}

  HWY_INLINE Stressed<D> stress(const LanePoints& P, std::size_t p, const AtNodes<D>&, const Rates<D>& rate,
                                LaneFindings& found) const {
    double xx[width<D>], yy[width<D>], xy[width<D>], zz[width<D>], spin[width<D>], volume[width<D>];
    const V<D> half = all<D>(0.5);
    store<D>(rate.xx, xx), store<D>(rate.yy, yy), store<D>(half * rate.xy, xy), store<D>(rate.zz, zz);
    store<D>(half * rate.turn, spin);
    for (std::size_t l = 0; l < width<D>; ++l) {
      const bool there = P.mass[p + l] > 0;
      volume[l] = there ? law_.update(law_.law, p + l, {xx[l], yy[l], xy[l], zz[l], spin[l]}, found) : 0;
    }
    return {load<D>(volume),
            {load<D>(P.sxx + p), load<D>(P.syy + p), load<D>(P.sxy + p), axis ? load<D>(P.szz + p) : hn::Zero(D())}};
  }

 private:
  LawOfPoints law_;
};

/// sigma : eps'.
template <class D, bool axis>
HWY_INLINE V<D> power(const Stresses<D>& s, const Rates<D>& of) {
  const V<D> in_plane = (s.xx * of.xx + s.yy * of.yy) + s.xy * of.xy;
  return axis ? in_plane + s.zz * of.zz : in_plane;
}

/// sigma / rho of a gas (4.1), (4.4) with artificial viscosity (4.11), (4.12), and where it is heated by the rate that
/// makes it, the energy (4.10). Its density comes from the nodes, as does the heat of the ledger, or from continuity
/// (4.7), or it stands in its array. The points' arrays hold sigma / rho within a step, so that nothing is divided by
/// rho twice; record_stress() ends that, unless contact reads the stress between the passes.
template <class D, bool axis, LaneLaw law_of>
class Gas {
 public:
  static constexpr bool is_gas = true, about_axis = axis;
  static constexpr bool by_nodes = law_of == LaneLaw::gas_of_nodes;

  HWY_INLINE explicit Gas(const LaneWork& work)
      : law_(work.body),
        warmed_(by_nodes && work.N.heat),
        records_(!by_nodes || work.records),
        reads_stress_(work.reads_stress),
        dt_(all<D>(work.dt)),
        gm1_(all<D>(work.body.gm1)),
        c_of_e_(all<D>(work.body.gamma * work.body.gm1)),
        linear_(all<D>(work.body.linear)),
        square_(all<D>(work.body.square)) {}

  HWY_INLINE Stressed<D> stress(const LanePoints& P, std::size_t p, const AtNodes<D>& nodes, const Rates<D>& of,
                                LaneFindings& found) const {
    const LaneBody& law = law_;
    const V<D> zero = hn::Zero(D()), infinite = hn::Inf(D()), mass = load<D>(P.mass + p);
    const auto there = mass > zero;
    V<D> energy = load<D>(P.energy + p);
    if (warmed_) energy = hn::IfThenElseZero(there, energy + (nodes.warmth + all<D>(law.heat)));
    const V<D> rate = axis ? of.xx + of.yy + of.zz : of.xx + of.yy;
    const V<D> rho = hn::IfThenElse(there, density(P, p, rate, nodes), all<D>(1));
    const V<D> c = law.local_speed ? hn::Sqrt(hn::Max(zero, c_of_e_ * energy)) : all<D>(law.c_max);
    const V<D> q = hn::IfThenElseZero(rate < zero, (square_ * rate - linear_ * c) * rate);
    const Stresses<D> s = over_density(gm1_ * energy + q, rate, rho, of);
    if (law.heats) energy = hn::IfThenElseZero(there, energy + dt_ * power<D, axis>(s, of));
    if (law.heats || warmed_) store<D>(energy, P.energy + p);
    if (records_) store<D>(rho, P.rho + p);
    const V<D> times = reads_stress_ ? rho : all<D>(1);
    store_stress<D, axis>(P, p, {times * s.xx, times * s.yy, times * s.xy, axis ? times * s.zz : zero});
    note_unsound<D>(p, hn::And(rho > zero, hn::And(rho < infinite, hn::Abs(energy) < infinite)), found);
    return {mass, s};
  }

 private:
  HWY_INLINE V<D> density(const LanePoints& P, std::size_t p, V<D> rate, const AtNodes<D>& nodes) const {
    if constexpr (by_nodes) return nodes.density;
    const V<D> rho = load<D>(P.rho + p);
    return law_of == LaneLaw::gas_of_continuity ? rho / (all<D>(1) + dt_ * rate) : rho;
  }
  HWY_INLINE Stresses<D> over_density(V<D> pressure, V<D> rate, V<D> rho, const Rates<D>& of) const {
    const V<D> mu = all<D>(2 * law_.mu), zero = hn::Zero(D()), normal = hn::Neg(pressure);
    if (law_.mu == 0) return {normal, normal, zero, normal};
    const V<D> two_nu = mu / rho, mean = all<D>(1.0 / 3) * rate;
    return {two_nu * (of.xx - mean) - pressure, two_nu * (of.yy - mean) - pressure, all<D>(0.5) * two_nu * of.xy,
            axis ? two_nu * (of.zz - mean) - pressure : zero};
  }

  LaneBody law_;
  bool warmed_, records_, reads_stress_;
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
template <class D, bool affine>
HWY_INLINE void note_waves(const LaneWork& work, const Tile& tile, LaneFindings& found) {
  constexpr D d;
  const V<D> c_of_e = all<D>(work.body.gamma * work.body.gm1), zero = hn::Zero(d);
  V<D> c_squared = zero, v_squared = zero, wave = zero;
  const auto each = [&](const auto& visit) HWY_ATTR {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
        const auto [vx, vy] = velocities_of<D, affine>(work.P, tile, k, sub);
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
