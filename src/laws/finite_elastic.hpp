// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laws/hyperelastic.hpp"
#include "laws/tensors.hpp"

namespace tether {

/// F = dx / dX in the plane, and the stretch across it: about an axis r / R, in plane stress that of the thickness.
struct DeformationGradient {
  double xx = 1, xy = 0, yx = 0, yy = 1;  // first index of x, second of X
  double zz = 1;

  /// Volume over that of the start.
  double volume_ratio() const { return (xx * yy - xy * yx) * zz; }
};

/// F after its material moved for dt by a field of the gradient L and the hoop's rate v_r / r, both at the place before
/// the move: (1 + dt L) F. Points that move by v dt have just that new F.
inline DeformationGradient after_move(const DeformationGradient& F, const VelocityGradient& L, double hoop, double dt) {
  const double a = 1 + dt * L.xx, b = dt * L.xy, c = dt * L.yx, d = 1 + dt * L.yy;
  return {a * F.xx + b * F.yx, a * F.xy + b * F.yy, c * F.xx + d * F.yx, c * F.xy + d * F.yy, F.zz * (1 + dt * hoop)};
}

/// Returns the same where L and v_r / r are those at the place after the move: (1 - dt L)^-1 F. Of a field that turns
/// at a rate w, L there is W (1 + dt W)^-1, and both are 1 + dt W; with (1 + dt L) F each step would add (w dt)^2 to
/// the stretch.
inline DeformationGradient after_arrival(const DeformationGradient& F, const VelocityGradient& L, double hoop,
                                         double dt) {
  const double a = 1 - dt * L.xx, b = -dt * L.xy, c = -dt * L.yx, d = 1 - dt * L.yy, det = a * d - b * c;
  return {(d * F.xx - b * F.yx) / det, (d * F.xy - b * F.yy) / det, (a * F.yx - c * F.xx) / det,
          (a * F.yy - c * F.xy) / det, F.zz / (1 - dt * hoop)};
}

/// What a law answers to F at a point.
struct FiniteResponse {
  Stress stress;       // sigma = F S F^T / J [stress]
  double across = 1;   // stretch across the plane, which in plane stress follows from the law
  double energy = 0;   // Psi, per volume of the start [energy/volume]
  double modulus = 0;  // rho_0 c^2 of the fastest wave of the plane, or a little more [stress]
};

/// An elastic law of finite strains at a point that carries F.
struct FiniteElastic {
  PointLaw law;
  double E = 0, nu = 0;  // of small strains [stress], number

  /// In the plane, where the law says what holds the third direction; F.zz is not read.
  FiniteResponse respond(const DeformationGradient& F) const;
  /// About an axis, where F.zz is the hoop's stretch.
  FiniteResponse respond_about_axis(const DeformationGradient& F) const;
  /// Speed of the fastest wave at rest [velocity].
  double sound_speed(double density) const;
};

/// Green's strain (F^T F - 1) / 2 in the axes of the start; zz the hoop's.
inline Strain green_strain(const DeformationGradient& F) {
  return {0.5 * (F.xx * F.xx + F.yx * F.yx - 1), 0.5 * (F.xy * F.xy + F.yy * F.yy - 1),
          0.5 * (F.xx * F.xy + F.yx * F.yy), 0.5 * (F.zz * F.zz - 1)};
}

}  // namespace tether
