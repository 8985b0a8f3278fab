// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "laws/elastic.hpp"
#include "laws/material.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/waits.hpp"

namespace tether::mpm {

enum class TroubleKind { none, left_grid, jumped, unsound, at_open_edge };

/// The first point of a step whose numbers are no longer sound. Found inside the passes, reported after them.
struct Trouble {
  TroubleKind kind = TroubleKind::none;
  std::size_t slot = 0;

  /// Always false, so that a check can end with it.
  bool note(TroubleKind what, std::size_t p) {
    if (kind == TroubleKind::none) kind = what, slot = p;
    return false;
  }
  void join(const Trouble& later) {
    if (kind == TroubleKind::none) *this = later;
  }
};

// What each material does to the arrays of a point: the bridge between the pure laws and the kernels.
//   law_update  strain rate in, stress (and energy, density, strain) of the point out
//   law_volume  V_p in the nodal force (3.16): the stored one, for gas m_p / rho_p, of
//               laws that carry F det F times it
//   sound       whether the point's numbers are numbers still, and its density positive

/// What is the same for all points in a step.
struct StepContext {
  double dt = 0;         // [time]
  double c_max = 0;      // largest sound speed of the gas at the end of the step before [velocity]
  double g = 0;          // length of the mesh in the artificial viscosity, sqrt(dx dy) [length]
  bool heats = true;     // the gas is heated by the strain rate that makes its stress, not by the centred one
  bool jaumann = false;  // the stress of solids turns with their spin
  double heat = 0;       // of the ledger for all gas [energy/mass]
  bool arrived = false;  // the velocity gradient is that at the place after the move that it describes, and the point
                         // gets its new velocity after its stress
};

/// What a step finds at a point, or at all that were joined: waves for the next step limit, what the balances want, and
/// whether the numbers are still sound.
struct StepFindings {
  double wave_max = 0;       // largest c + |v| of the gas, or c of solids that carry F [velocity]
  double c_squared_max = 0;  // of the gas
  long long crossings = 0;   // points that changed cell
  double squares = 0;        // of the points, for the balance of energy: balance.hpp
  double lifted = 0;         // sum of m_p times the way up [mass length]
  double heat = 0;           // that the ledger gave to the gas for its own transfers [energy]
  Trouble trouble;

  /// Adds what was found later.
  void join(const StepFindings& later) {
    wave_max = std::max(wave_max, later.wave_max);
    c_squared_max = std::max(c_squared_max, later.c_squared_max);
    crossings += later.crossings;
    squares += later.squares, lifted += later.lifted, heat += later.heat;
    trouble.join(later.trouble);
  }
};

/// Strain rate of a point, and the spin (d v_x / d y - d v_y / d x) / 2 [1/time].
struct Rate {
  StrainRate d;
  double spin = 0;
};

inline bool sound(const PlaneElastic&, const Points& P, std::size_t p) {
  return std::abs(P.sxx[p]) + std::abs(P.syy[p]) + std::abs(P.sxy[p]) < std::numeric_limits<double>::infinity();
}
inline DeformationGradient deformation(const Points& P, std::size_t p) {
  return {P.fxx[p], P.fxy[p], P.fyx[p], P.fyy[p], P.fzz[p]};
}
inline bool sound(const FiniteElastic&, const Points& P, std::size_t p) {
  return deformation(P, p).volume_ratio() > 0 &&
         std::abs(P.sxx[p]) + std::abs(P.syy[p]) + std::abs(P.sxy[p]) < std::numeric_limits<double>::infinity();
}
inline bool sound(const LinearFluid&, const Points& P, std::size_t p) {
  return std::isfinite(P.sxx[p] + P.syy[p] + P.sxy[p]);
}
inline bool sound(const Membrane&, const Points& P, std::size_t p) { return std::isfinite(P.strain[p]); }
inline bool sound(const IdealGas&, const Points& P, std::size_t p) {
  return P.rho[p] > 0 && P.rho[p] < std::numeric_limits<double>::infinity() && std::isfinite(P.energy[p]);
}

/// `about_axis`: the hoop's strain rate and stress count.
template <bool about_axis>
inline void law_update(const PlaneElastic& law, Points& P, std::size_t p, const Rate& rate, const StepContext& step,
                       StepFindings&) {
  Stress old{P.sxx[p], P.syy[p], P.sxy[p], 0};
  if constexpr (about_axis) old.zz = P.szz[p];
  if (step.jaumann) old = turned(old, step.dt * rate.spin);
  const Stress s = law.updated(old, rate.d, step.dt);  // (3.2)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
  if constexpr (about_axis) P.szz[p] = s.zz;
}

/// F by the velocity's gradient, and the stress of it; an F whose volume is gone is left to sound().
template <bool about_axis>
inline void law_update(const FiniteElastic& law, Points& P, std::size_t p, const Rate& rate, const StepContext& step,
                       StepFindings& found) {
  const VelocityGradient L{rate.d.xx, rate.d.xy + rate.spin, rate.d.xy - rate.spin, rate.d.yy};
  const DeformationGradient before = deformation(P, p);
  const DeformationGradient F =
      step.arrived ? after_arrival(before, L, rate.d.zz, step.dt) : after_move(before, L, rate.d.zz, step.dt);
  P.fxx[p] = F.xx, P.fxy[p] = F.xy, P.fyx[p] = F.yx, P.fyy[p] = F.yy, P.fzz[p] = F.zz;
  if (!(F.volume_ratio() > 0)) return;
  const FiniteResponse answer = about_axis ? law.respond_about_axis(F) : law.respond(F);
  P.fzz[p] = answer.across;
  const Stress& s = answer.stress;
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy, P.szz[p] = s.zz;
  found.wave_max = std::max(found.wave_max, std::sqrt(answer.modulus * P.volume[p] / P.mass[p]));
}

/// The mean of its stresses, which friction leaves alone; without any they all are -p.
inline double fluid_pressure(const LinearFluid& law, const Points& P, std::size_t p) {
  return law.mu == 0 ? -P.sxx[p] : -(P.sxx[p] + P.syy[p] + P.szz[p]) / 3;
}

template <bool about_axis>
inline void law_update(const LinearFluid& law, Points& P, std::size_t p, const Rate& rate, const StepContext& step,
                       StepFindings&) {
  const StrainRate& d = rate.d;
  const double pressure = law.updated_pressure(fluid_pressure(law, P, p), d.xx + d.yy + d.zz, step.dt);  // (6.1)
  const Stress s = friction_stress(law.mu, d);
  P.sxx[p] = s.xx - pressure, P.syy[p] = s.yy - pressure;
  if constexpr (about_axis) P.szz[p] = s.zz - pressure;
  if (law.mu == 0) return;
  P.sxy[p] = s.xy, P.szz[p] = s.zz - pressure;
  P.energy[p] += step.dt * power(s, d) * P.volume[p] / P.mass[p];  // its friction's heat
}

/// The strains have been brought up to date with the tangents.
template <bool about_axis>
inline void law_update(const Membrane& law, Points& P, std::size_t p, const Rate&, const StepContext&, StepFindings&) {
  const MembraneStress stress = law.stress(P.strain[p], P.hoop[p]);       // (5.5), (5.15)
  const Stress s = Membrane::turned(stress.tangent, {P.tx[p], P.ty[p]});  // (5.9)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
  P.szz[p] = stress.hoop;
}

/// Sound speed and wave of a gas with the energy and the velocity that it has now.
inline void note_waves(const IdealGas& law, const Points& P, std::size_t p, StepFindings& found) {
  const double c_squared = law.sound_speed_squared(P.energy[p]);
  const double speed = std::sqrt(P.vx[p] * P.vx[p] + P.vy[p] * P.vy[p]);
  found.c_squared_max = std::max(found.c_squared_max, c_squared);
  found.wave_max = std::max(found.wave_max, std::sqrt(c_squared) + speed);
}

/// The source's order: first the constitutive equation with the new density and the energy so far, then the energy
/// with that stress. Unless by continuity, the density stands in P.rho already.
template <bool about_axis>
inline void law_update(const IdealGas& law, Points& P, std::size_t p, const Rate& rate, const StepContext& step,
                       StepFindings& found) {
  const StrainRate& d = rate.d;
  const double D = d.xx + d.yy + d.zz;
  if (law.rule == DensityRule::continuity) P.rho[p] = IdealGas::continued_density(P.rho[p], step.dt, D);  // (4.7)
  const double rho = P.rho[p];
  const double own_c_squared = law.sound_speed_squared(P.energy[p]);
  const double c = law.local_speed ? std::sqrt(own_c_squared) : step.c_max;
  const double q = law.artificial_viscosity(rho, c, step.g, D);                     // (4.11), (4.12)
  const Stress s = law.stress(law.pressure(rho, P.energy[p]) + q, d);               // (4.1), (4.4)
  if (step.heats) P.energy[p] = IdealGas::heated(P.energy[p], step.dt, s, d, rho);  // (4.10)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
  if constexpr (about_axis) P.szz[p] = s.zz;
  if (!step.arrived) note_waves(law, P, p, found);
}

template <class Law>
inline double law_volume(const Law&, const Points& P, std::size_t p) {
  return P.volume[p];
}
inline double law_volume(const FiniteElastic&, const Points& P, std::size_t p) {
  return P.volume[p] * deformation(P, p).volume_ratio();
}
inline double law_volume(const IdealGas&, const Points& P, std::size_t p) { return P.mass[p] / P.rho[p]; }

}  // namespace tether::mpm
