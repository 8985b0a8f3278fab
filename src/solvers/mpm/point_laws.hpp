// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "laws/materials/material.hpp"
#include "solvers/mpm/arrays.hpp"

// What each material does to the arrays of a point: the bridge between the pure laws and the kernels.
//   law_update  strain rate in, stress (and energy, density, strain) of the point out
//   law_volume  V_p in the nodal force (3.16): the stored one, for gas m_p / rho_p
//   sound       whether the point's numbers are numbers still, and its density positive
// A law with needs_neighbours = true is updated only after all points of the body have moved (tangents, densities).

namespace tether::mpm {

/// What is the same for all points in a step.
struct StepContext {
  double dt = 0;     // [time]
  double c_max = 0;  // largest sound speed of the gas at the end of the step before [velocity]
  double g = 0;      // length of the mesh in the artificial viscosity, sqrt(dx dy) [length]
};

/// What the step tells of all points: waves for the next step limit, and whether the numbers are still sound.
struct StepFindings {
  double wave_max = 0;       // largest c + |v| of the gas [velocity]
  double c_squared_max = 0;  // of the gas
  long long crossings = 0;   // points that changed cell
};

inline bool sound(const PlaneElastic&, const Points& P, std::size_t p) {
  return std::abs(P.sxx[p]) + std::abs(P.syy[p]) + std::abs(P.sxy[p]) < std::numeric_limits<double>::infinity();
}
inline bool sound(const LinearFluid&, const Points& P, std::size_t p) { return std::isfinite(P.sxx[p]); }
inline bool sound(const Uniaxial&, const Points& P, std::size_t p) { return std::isfinite(P.strain[p]); }
inline bool sound(const IdealGas&, const Points& P, std::size_t p) {
  return P.rho[p] > 0 && P.rho[p] < std::numeric_limits<double>::infinity() && std::isfinite(P.energy[p]);
}

constexpr bool needs_neighbours(const PlaneElastic&) { return false; }
constexpr bool needs_neighbours(const LinearFluid&) { return false; }
constexpr bool needs_neighbours(const Uniaxial&) { return true; }
inline bool needs_neighbours(const IdealGas& gas) { return gas.rule != DensityRule::continuity; }

inline void law_update(const PlaneElastic& law, Points& P, std::size_t p, const StrainRate& d, const StepContext& step,
                       StepFindings&) {
  const Stress s = law.updated({P.sxx[p], P.syy[p], P.sxy[p]}, d, step.dt);  // (3.2)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
}

inline void law_update(const LinearFluid& law, Points& P, std::size_t p, const StrainRate& d, const StepContext& step,
                       StepFindings&) {
  const double pressure = law.updated_pressure(-P.sxx[p], d.xx + d.yy, step.dt);  // (6.1)
  P.sxx[p] = P.syy[p] = -pressure;
}

/// The strain has been brought up to date with the tangents.
inline void law_update(const Uniaxial& law, Points& P, std::size_t p, const StrainRate&, const StepContext&,
                       StepFindings&) {
  const Stress s = Uniaxial::turned(law.stress(P.strain[p]), {P.tx[p], P.ty[p]});  // (5.5)-(5.9)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
}

/// The source's order: first the constitutive equation with the new density and the energy so far, then the energy
/// with that stress. By cell or quadratic interpolation the density stands in P.rho already.
inline void law_update(const IdealGas& law, Points& P, std::size_t p, const StrainRate& d, const StepContext& step,
                       StepFindings& found) {
  const double D = d.xx + d.yy;
  if (law.rule == DensityRule::continuity) P.rho[p] = IdealGas::continued_density(P.rho[p], step.dt, D);  // (4.7)
  const double rho = P.rho[p];
  const double q = law.artificial_viscosity(rho, step.c_max, step.g, D);  // (4.11), (4.12)
  const Stress s = law.stress(law.pressure(rho, P.energy[p]) + q, d);     // (4.1), (4.4)
  P.energy[p] = IdealGas::heated(P.energy[p], step.dt, s, d, rho);        // (4.10)
  P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy;
  const double c_squared = law.sound_speed_squared(P.energy[p]);
  const double speed = std::sqrt(P.vx[p] * P.vx[p] + P.vy[p] * P.vy[p]);
  found.c_squared_max = std::max(found.c_squared_max, c_squared);
  found.wave_max = std::max(found.wave_max, std::sqrt(c_squared) + speed);
}

template <class Law>
inline double law_volume(const Law&, const Points& P, std::size_t p) {
  return P.volume[p];
}
inline double law_volume(const IdealGas&, const Points& P, std::size_t p) { return P.mass[p] / P.rho[p]; }

}  // namespace tether::mpm
