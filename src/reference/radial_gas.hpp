// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace tether {

/// A cylinder of ideal gas, uniform and at rest, with vacuum around it: thesis 4.2.
struct GasCylinder {
  double radius = 0;           // [length]
  double density = 0;          // [mass/length3]
  double specific_energy = 0;  // internal energy/mass
  double gm1 = 0;              // gamma - 1
};

/// Concentric shells of ideal gas about an axis, whole cylinders of unit depth, in vacuum. Shell k lies between radius
/// k and radius k + 1, of which there is one more; radius 0 is the axis, 0.
struct GasShells {
  double gm1 = 0;
  std::vector<double> radius, velocity;       // of the shells' faces
  std::vector<double> mass, specific_energy;  // of the shells

  std::size_t size() const { return mass.size(); }
  double area(std::size_t k) const;      ///< of the cross-section, the volume per unit depth
  double pressure(std::size_t k) const;  ///< (gamma - 1) rho i
  double kinetic_energy() const;         ///< half of a shell's mass moves with either face
  double internal_energy() const;
  double rms_radius() const;  ///< sqrt(sum m r^2 / sum m), uniform density within a shell
  /// The radius of the circle that holds this share of the mass, 0 to 1.
  double radius_of_share(double share) const;
};

/// What stands at the middle of each shell.
struct RadialProfile {
  std::vector<double> radius, density, velocity, pressure, specific_energy;
  std::vector<double> mass_inside;  ///< share of the mass nearer to the axis
};

/// `count` shells of equal width. Throws std::domain_error for numbers that are not positive and finite.
GasShells shells_of(const GasCylinder& cylinder, int count = 1600);

/// The shells after a time of free expansion, by the Euler equations in Lagrangian form: pressures in the shells,
/// velocities at their faces, artificial viscosity where a shell is compressed. Second order in space and time where
/// the flow is smooth. Kinetic and internal energy exchange the same work, so that their sum is kept to rounding.
/// Source: E. J. Caramana, D. E. Burton, M. J. Shashkov and P. P. Whalen, J. Comput. Phys. 146 (1998) 227-262, in one
/// dimension. Throws std::domain_error for a negative duration.
GasShells expanded(const GasShells& shells, double duration);

RadialProfile profile_of(const GasShells& shells);

}  // namespace tether
