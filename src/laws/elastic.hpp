// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/vec.hpp"
#include "base/words.hpp"
#include "laws/elastic_response.hpp"
#include "laws/tensors.hpp"

namespace tether {

/// Isotropic linear elasticity in the plane, in rate form (3.2): sigma += dt C : sym(grad v), small strains, no
/// rotation of the stress. `lambda` and `G` are the plane's two constants; they alone distinguish plane strain from
/// plane stress.
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
  /// Returns the same about an axis, where the hoop's stress is one of its own: eps = ((1 + nu) sigma - nu tr(sigma)) /
  /// E.
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
  /// Returns the same about an axis, where the hoop's stress is one of its own.
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

/// A fibre along e = the circles about `centre` (in the plane, or about an axis along z): P = mu F e (x) e. [stress]
struct HoopFibre {
  double mu = 0;
  double centre_x = 0, centre_y = 0;  // [length]

  static constexpr std::string_view word = "fibre", name = "hoop fibre";
  static constexpr bool small_strains = false;
  static HoopFibre of(const ElasticConstants& given) { return {given.E, given.centre_x, given.centre_y}; }
  std::array<NamedNumber, 3> numbers() const { return {{{"mu", mu}, {"about x", centre_x}, {"y", centre_y}}}; }
  std::string_view note() const { return ""; }
  bool plane_stress() const { return false; }
  std::optional<Lame> in_plane() const { return std::nullopt; }
  double stiffness() const { return mu; }

  template <int dim>
  Response<dim> respond(const Symmetric<dim>& C, ReferencePlace at) const {
    const double dx = at.X - centre_x, dy = at.Y - centre_y, r2 = dx * dx + dy * dy;
    Response<dim> r;
    Symmetric<dim> ee = Symmetric<dim>::Zero();
    ee[0] = dy * dy / r2, ee[1] = dx * dx / r2, ee[dim == 2 ? 2 : 3] = -dx * dy / r2;
    r.energy = 0.5 * mu * (contract<dim>(C, ee) - 1);
    r.S = mu * ee;
    r.D.setZero();
    return r;
  }
  /// Nothing acts across the plane in which the fibres lie.
  template <int dim>
  Across across(const Symmetric<dim>&) const {
    return {};
  }
};

/// Stresses or strains of a membrane along its tangent 1' (the meridian) and out of the plane 2' (the hoop).
struct MembraneStress {
  double tangent = 0, hoop = 0;  // [stress]
};

/// A string, spring or membrane of one layer of points. Membrane: stress along the tangent only (5.5)-(5.9). Plane
/// stress: both directions of the surface carry, the thickness none (5.12)-(5.15); in the plane eps_2' = 0, about an
/// axis eps_2' is the hoop strain. With `wrinkle` the one-way law (5.2, Fig. 21): a direction that would be compressed
/// carries nothing and the other one alone, while strains go on accumulating.
struct Membrane {
  enum class Kind { uniaxial, plane_stress };
  double E = 0, nu = 0;  // [stress], number
  bool wrinkle = true;
  Kind kind = Kind::uniaxial;

  /// sigma_1', sigma_2' of the strains eps_1', eps_2'.
  MembraneStress stress(double tangent, double hoop) const {
    if (kind == Kind::uniaxial) return {wrinkle && tangent < 0 ? 0 : E * tangent, 0};  // (5.5)
    const double plane = E / (1 - nu * nu);
    const MembraneStress both{plane * (tangent + nu * hoop), plane * (hoop + nu * tangent)};  // (5.15)
    if (!wrinkle || (both.tangent >= 0 && both.hoop >= 0)) return both;
    // Slack one way, the other is uniaxial; which is also right where both would be compressed.
    if (tangent >= hoop) return {tangent > 0 ? E * tangent : 0, 0};
    return {0, hoop > 0 ? E * hoop : 0};
  }
  /// sigma_1' in the plane, where eps_2' = 0.
  double stress(double tangent) const { return stress(tangent, 0).tangent; }
  /// Energy stored per volume, of which the stresses are the derivatives [stress].
  double energy_density(double tangent, double hoop = 0) const {
    const MembraneStress s = stress(tangent, hoop);
    return 0.5 * (s.tangent * tangent + s.hoop * hoop);
  }
  double sound_speed(double density) const { return std::sqrt(E / density); }

  /// sigma_1' t (x) t in global axes.
  static Stress turned(double tangent_stress, const Vec<2>& t) {
    return {tangent_stress * t[0] * t[0], tangent_stress * t[1] * t[1], tangent_stress * t[0] * t[1]};
  }
};

template <>
inline constexpr std::array<Word<Membrane::Kind>, 2> words<Membrane::Kind>{
    {{Membrane::Kind::uniaxial, "uniaxial"}, {Membrane::Kind::plane_stress, "plane-stress"}}};

}  // namespace tether
