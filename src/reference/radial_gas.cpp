// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/radial_gas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/numbers.hpp"

namespace tether {
namespace {

using std::numbers::pi;

/// Part of the time a signal takes through a shell.
constexpr double courant = 0.4;
/// Linear and quadratic coefficient of the artificial viscosity.
constexpr double c1 = 1, c2 = 1;

double sound_speed(const GasShells& shells, std::size_t k) {
  return std::sqrt((shells.gm1 + 1) * shells.gm1 * std::max(0.0, shells.specific_energy[k]));
}

/// How much faster the outer face of a shell moves than its inner one.
double opening(const GasShells& shells, std::size_t k) { return shells.velocity[k + 1] - shells.velocity[k]; }

double viscous_pressure(const GasShells& shells, std::size_t k) {
  const double closing = std::max(0.0, -opening(shells, k));
  return shells.mass[k] / shells.area(k) * closing * (c1 * sound_speed(shells, k) + c2 * closing);
}

/// Mass that moves with a face: half of the shells beside it.
double face_mass(const GasShells& shells, std::size_t face) {
  const double inside = face > 0 ? shells.mass[face - 1] : 0;
  const double outside = face < shells.size() ? shells.mass[face] : 0;
  return (inside + outside) / 2;
}

double stable_step(const GasShells& shells) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const double signal = sound_speed(shells, k) + std::abs(opening(shells, k));
    step = std::min(step, (shells.radius[k + 1] - shells.radius[k]) / signal);
  }
  return courant * step;
}

/// Advances shells step by step; keeps the arrays that a step needs.
class RadialSolver {
 public:
  explicit RadialSolver(const GasShells& shells)
      : now_(shells), trial_(shells), P_(shells.size()), face_mass_(shells.size() + 1), swept_(shells.size() + 1) {
    for (std::size_t face = 0; face <= shells.size(); ++face) face_mass_[face] = face_mass(shells, face);
  }

  /// Advances with the pressures of the step's middle, the mean of those at its start and at its predicted end.
  void advance(double dt) {
    for (std::size_t k = 0; k < P_.size(); ++k) P_[k] = now_.pressure(k) + viscous_pressure(now_, k);
    move(dt, trial_);
    for (std::size_t k = 0; k < P_.size(); ++k) {
      P_[k] = (P_[k] + trial_.pressure(k) + viscous_pressure(trial_, k)) / 2;
    }
    move(dt, now_);
  }

  const GasShells& now() const { return now_; }

 private:
  /// From now_ over dt under the pressures P_.
  void move(double dt, GasShells& to) {
    for (std::size_t face = 1; face <= P_.size(); ++face) move_face(face, dt, to);
    for (std::size_t k = 0; k < P_.size(); ++k) {
      to.specific_energy[k] = now_.specific_energy[k] - P_[k] * (swept_[k + 1] - swept_[k]) / now_.mass[k];
    }
  }

  /// The force of the pressures acts at the radius r + dt u_mean / 2, with which the area swept is exactly
  /// 2 pi r_mean u_mean dt: so the work on the faces is what the shells lose. That radius depends on the force,
  /// linearly.
  void move_face(std::size_t face, double dt, GasShells& to) {
    const double outside = face < P_.size() ? P_[face] : 0;
    const double push = 2 * pi * (P_[face - 1] - outside);  // force over radius
    const double m = face_mass_[face], u = now_.velocity[face], r = now_.radius[face];
    const double r_mean = (r + dt * u / 2) / (1 - push * dt * dt / (4 * m));
    const double u_new = u + dt * push * r_mean / m;
    const double path = dt * (u + u_new) / 2;
    swept_[face] = 2 * pi * r_mean * path;
    to.velocity[face] = u_new;
    to.radius[face] = r + path;
  }

  GasShells now_, trial_;
  std::vector<double> P_;          // pressure and artificial viscosity of the shells
  std::vector<double> face_mass_;  // constant
  std::vector<double> swept_;      // area swept by a face in a step
};

}  // namespace

double GasShells::area(std::size_t k) const { return pi * (radius[k + 1] - radius[k]) * (radius[k + 1] + radius[k]); }

double GasShells::pressure(std::size_t k) const { return gm1 * specific_energy[k] * mass[k] / area(k); }

double GasShells::kinetic_energy() const {
  double sum = 0;
  for (std::size_t face = 0; face < velocity.size(); ++face) {
    sum += face_mass(*this, face) * velocity[face] * velocity[face] / 2;
  }
  return sum;
}

double GasShells::internal_energy() const {
  return std::inner_product(mass.begin(), mass.end(), specific_energy.begin(), 0.0);
}

double GasShells::rms_radius() const {
  double moment = 0, total = 0;
  for (std::size_t k = 0; k < size(); ++k) {
    moment += mass[k] * (radius[k] * radius[k] + radius[k + 1] * radius[k + 1]) / 2;
    total += mass[k];
  }
  return std::sqrt(moment / total);
}

double GasShells::radius_of_share(double share) const {
  double missing = share * std::accumulate(mass.begin(), mass.end(), 0.0);
  for (std::size_t k = 0; k < size(); ++k) {
    if (missing <= mass[k]) return std::sqrt(radius[k] * radius[k] + missing / mass[k] * area(k) / pi);
    missing -= mass[k];
  }
  return radius.back();
}

GasShells shells_of(const GasCylinder& cylinder, int count) {
  const auto& [R, density, specific_energy, gm1] = cylinder;
  if (!is_positive(R) || !is_positive(density) || !is_positive(specific_energy) || !is_positive(gm1) || count < 1) {
    throw std::domain_error("gas expansion: radius, density, energy and gamma - 1 must be positive");
  }
  GasShells shells;
  shells.gm1 = gm1;
  for (int face = 0; face <= count; ++face) shells.radius.push_back(R * face / count);
  shells.velocity.assign(shells.radius.size(), 0);
  shells.mass.resize(static_cast<std::size_t>(count));
  shells.specific_energy.assign(shells.mass.size(), specific_energy);
  for (std::size_t k = 0; k < shells.size(); ++k) shells.mass[k] = density * shells.area(k);
  return shells;
}

GasShells expanded(const GasShells& shells, double duration) {
  if (!(duration >= 0)) throw std::domain_error("gas expansion: the solution begins at t = 0");
  RadialSolver solver(shells);
  double left = duration;
  while (left > 0) {
    const double dt = std::min(left, stable_step(solver.now()));
    solver.advance(dt);
    left -= dt;
  }
  return solver.now();
}

RadialProfile profile_of(const GasShells& shells) {
  RadialProfile profile;
  const double total = std::accumulate(shells.mass.begin(), shells.mass.end(), 0.0);
  double inside = 0;
  for (std::size_t k = 0; k < shells.size(); ++k) {
    profile.radius.push_back((shells.radius[k] + shells.radius[k + 1]) / 2);
    profile.density.push_back(shells.mass[k] / shells.area(k));
    profile.velocity.push_back((shells.velocity[k] + shells.velocity[k + 1]) / 2);
    profile.pressure.push_back(shells.pressure(k));
    profile.specific_energy.push_back(shells.specific_energy[k]);
    const double r = profile.radius.back();
    const double share_inside = pi * (r - shells.radius[k]) * (r + shells.radius[k]) / shells.area(k);
    profile.mass_inside.push_back((inside + share_inside * shells.mass[k]) / total);
    inside += shells.mass[k];
  }
  return profile;
}

}  // namespace tether
