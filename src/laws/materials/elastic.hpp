// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "laws/tensors.hpp"

namespace tether {

/// Isotropic linear elasticity in the plane, in rate form (3.2): sigma += dt C : sym(grad v), small strains, no
/// rotation of the stress. `lambda` and `G` are the plane's two constants; they alone tell plane strain from plane
/// stress.
struct PlaneElastic {
  enum class Plane { strain, stress };
  Plane plane = Plane::strain;
  double E = 0, nu = 0;      // [stress], number
  double lambda = 0, G = 0;  // [stress]: sigma_xx = lambda tr(eps) + 2 G eps_xx

  Stress updated(const Stress& s, const StrainRate& d, double dt) const {
    const double trace = lambda * (d.xx + d.yy + d.zz);
    return {s.xx + dt * (trace + 2 * G * d.xx), s.yy + dt * (trace + 2 * G * d.yy), s.xy + dt * 2 * G * d.xy,
            s.zz + dt * (trace + 2 * G * d.zz)};
  }
  /// The elastic strain of a stress, C^-1 : sigma (xy the tensor component).
  Strain strain(const Stress& s) const {
    const double trace = lambda / (2 * (lambda + G)) * (s.xx + s.yy);
    return {(s.xx - trace) / (2 * G), (s.yy - trace) / (2 * G), s.xy / (2 * G)};
  }
  /// The same about an axis, where the hoop's stress is one of its own: eps = ((1 + nu) sigma - nu tr(sigma)) / E.
  Strain strain_about_axis(const Stress& s) const {
    const double trace = nu / (1 + nu) * (s.xx + s.yy + s.zz);
    return {(s.xx - trace) / (2 * G), (s.yy - trace) / (2 * G), s.xy / (2 * G), (s.zz - trace) / (2 * G)};
  }
  /// Energy stored per volume, 1/2 sigma : C^-1 : sigma [stress].
  double energy_density(const Stress& s) const {
    const double trace = s.xx + s.yy;
    const double squares = s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy;
    return (squares - lambda / (2 * (lambda + G)) * trace * trace) / (4 * G);
  }
  /// The same about an axis, where the hoop's stress is one of its own.
  double energy_density_about_axis(const Stress& s) const {
    const double trace = s.xx + s.yy + s.zz;
    const double squares = s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2 * s.xy * s.xy;
    return (squares - nu / (1 + nu) * trace * trace) / (4 * G);
  }
  /// In the plane it follows from the others at any time, as no stress is rotated [stress].
  double out_of_plane_stress(const Stress& s) const { return plane == Plane::strain ? nu * (s.xx + s.yy) : 0; }
  /// The thesis' speed for the step limit, sqrt(E / rho) [velocity].
  double sound_speed(double density) const { return std::sqrt(E / density); }
};

/// ipath 0: eps_zz = 0.
inline PlaneElastic plane_strain(double E, double nu) {
  return {PlaneElastic::Plane::strain, E, nu, E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

/// ipath 2: sigma_zz = 0, E / (1 - nu^2) [1, nu; nu, 1].
inline PlaneElastic plane_stress(double E, double nu) {
  return {PlaneElastic::Plane::stress, E, nu, E * nu / (1 - nu * nu), E / (2 * (1 + nu))};
}

}  // namespace tether
