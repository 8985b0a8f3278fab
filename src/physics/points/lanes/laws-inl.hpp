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
template <class D, class Kernel>
class Elastic {
 public:
  static constexpr bool is_gas = false;

  HWY_INLINE Elastic(const LaneWork& work, std::ptrdiff_t, std::size_t)
      : P_(work.P),
        grid_(work.grid),
        own_(all<D>(work.dt * work.body.own)),
        other_(all<D>(work.dt * work.body.other)),
        shear_(all<D>(0.5 * work.dt * work.body.shear)) {}

  HWY_INLINE void stress(Tile& tile, std::size_t k, std::size_t sub, const typename Kernel::template Weights<D>&,
                         const Rates<D>& rate, LaneFindings& found) const {
    const std::size_t p = tile.slot[k] + sub;
    const V<D> volume = load<D>(P_.volume + p);
    const auto there = volume > hn::Zero(D());
    const V<D> sxx = hn::IfThenElseZero(there, load<D>(P_.sxx + p) + (own_ * rate.xx + other_ * rate.yy));
    const V<D> syy = hn::IfThenElseZero(there, load<D>(P_.syy + p) + (other_ * rate.xx + own_ * rate.yy));
    const V<D> sxy = hn::IfThenElseZero(there, load<D>(P_.sxy + p) + shear_ * rate.xy);
    store<D>(sxx, P_.sxx + p), store<D>(syy, P_.syy + p), store<D>(sxy, P_.sxy + p);
    note_unsound<D>(p, (hn::Abs(sxx) + hn::Abs(syy)) + hn::Abs(sxy) < hn::Inf(D()), found);
    leave_pull<D, Kernel>(grid_, tile, k, sub, volume, sxx, syy, sxy);
  }

 private:
  LanePoints P_;
  LaneGrid grid_;
  V<D> own_, other_, shear_;
};

/// A number of the nodes for a gas by nodes; nothing for others.
template <class D, class Kernel, bool by_nodes>
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
};

/// sigma / rho of a gas (4.1), (4.4) with artificial viscosity (4.11), (4.12), and where it is heated by the rate that
/// makes it, the energy (4.10). Its density comes from the nodes, as does the heat of the ledger, which stands in the
/// tile, or from continuity (4.7). The points' arrays hold sigma / rho within a step, so that nothing is divided by rho
/// twice; record_stress() ends that, unless contact reads the stress between the passes.
template <class D, class Kernel, bool by_nodes>
class Gas {
 public:
  static constexpr bool is_gas = true;

  HWY_INLINE Gas(const LaneWork& work, std::ptrdiff_t n, std::size_t sub)
      : P_(work.P),
        grid_(work.grid),
        law_(work.body),
        warmed_(by_nodes && work.N.heat),
        records_(!by_nodes || work.records),
        reads_(work.reads_stress),
        density_(work.N.rho + n, work.grid.nx, sub),
        dt_(all<D>(work.dt)),
        gm1_(all<D>(work.body.gm1)),
        c_of_e_(all<D>(work.body.gamma * work.body.gm1)),
        linear_(all<D>(work.body.linear)),
        square_(all<D>(work.body.square)) {}

  HWY_INLINE void stress(Tile& tile, std::size_t k, std::size_t sub, const typename Kernel::template Weights<D>& w,
                         const Rates<D>& of, LaneFindings& found) const {
    const std::size_t p = tile.slot[k] + sub;
    const V<D> zero = hn::Zero(D()), infinite = hn::Inf(D()), mass = load<D>(P_.mass + p);
    const auto there = mass > zero;
    V<D> energy = load<D>(P_.energy + p);
    if (warmed_) energy = hn::IfThenElseZero(there, energy + (load<D>(tile.at_place[k] + sub) + all<D>(law_.heat)));
    const V<D> rate = of.xx + of.yy, rho = hn::IfThenElse(there, density(p, rate, w), all<D>(1));
    const V<D> c = law_.local_speed ? hn::Sqrt(hn::Max(zero, c_of_e_ * energy)) : all<D>(law_.c_max);
    const V<D> q = hn::IfThenElseZero(rate < zero, (square_ * rate - linear_ * c) * rate);
    const V<D> pressure = gm1_ * energy + q, xy = all<D>(0.5) * of.xy;
    V<D> sxx = hn::Neg(pressure), syy = sxx, sxy = zero;
    if (law_.mu != 0) {
      const V<D> two_nu = all<D>(2 * law_.mu) / rho, mean = all<D>(1.0 / 3) * rate;
      sxx = two_nu * (of.xx - mean) - pressure, syy = two_nu * (of.yy - mean) - pressure, sxy = two_nu * xy;
    }
    if (law_.heats) energy = hn::IfThenElseZero(there, energy + dt_ * ((sxx * of.xx + syy * of.yy) + (sxy + sxy) * xy));
    if (law_.heats || warmed_) store<D>(energy, P_.energy + p);
    if (records_) store<D>(rho, P_.rho + p);
    const V<D> times = reads_ ? rho : all<D>(1);
    store<D>(times * sxx, P_.sxx + p), store<D>(times * syy, P_.syy + p), store<D>(times * sxy, P_.sxy + p);
    note_unsound<D>(p, hn::And(rho > zero, hn::And(rho < infinite, hn::Abs(energy) < infinite)), found);
    leave_pull<D, Kernel>(grid_, tile, k, sub, mass, sxx, syy, sxy);
  }

 private:
  HWY_INLINE V<D> density(std::size_t p, V<D> rate, const typename Kernel::template Weights<D>& w) const {
    if constexpr (by_nodes)
      return density_.at(w);
    else
      return load<D>(P_.rho + p) / (all<D>(1) + dt_ * rate);
  }

  LanePoints P_;
  LaneGrid grid_;
  LaneBody law_;
  bool warmed_, records_, reads_;
  FromNodes<D, Kernel, by_nodes> density_;
  V<D> dt_, gm1_, c_of_e_, linear_, square_;
};

/// i += dt (sigma : eps') / rho (4.10) of a layer, with the strain rate of (v_old + v_new) / 2; `divides`: its stress is
/// not yet over rho.
template <class D>
HWY_INLINE void heat_centred(const LanePoints& P, std::size_t p, V<D> dt, bool divides, const Rates<D>& of) {
  V<D> power = (load<D>(P.sxx + p) * of.xx + load<D>(P.syy + p) * of.yy) + load<D>(P.sxy + p) * of.xy;
  if (divides) power = power / load<D>(P.rho + p);
  const V<D> energy = load<D>(P.energy + p) + dt * power;
  store<D>(hn::IfThenElseZero(load<D>(P.mass + p) > hn::Zero(D()), energy), P.energy + p);
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
