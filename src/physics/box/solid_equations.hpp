// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "model/coupled.hpp"
#include "physics/solids/system.hpp"

namespace tether::coupled {

/// How a step finds the solids. The fluid sees the velocity of a linear step's end, of others the mean w = (q1 - q0)/h.
/// One that keeps energy ends with u1 = 2 w - u0; a calm one, and backward Euler, with w.
enum class SolidRule { linear, energy, calm, euler };

/// The solids' side of the coupled equations (4): A u1 - B^T p = b [force], with the stiffness linearised at the step's
/// start. Vectors have dim numbers a node.
class SolidEquations {
 public:
  /// Both must outlive the equations.
  SolidEquations(const Coupled& scene, const Solids& solids, const Vec<3>& gravity, Team& team);

  /// Makes A and b of the step of length h from places q and velocities u at `time`.
  void assemble(std::span<const double> q, std::span<const double> u, double time, double h);
  /// Adds to a right side what the solids' stiffness does when the step takes them farther than (5) by `lifts`
  /// [length].
  void add_lifts(std::span<const double> lifts, std::span<double> right) const;
  /// What the solids' own forces take on the way of a step from velocities u0 to u1, as its equations have them: of K
  /// with springs and lifts, and of damping.
  struct Taken {
    double inside = 0, damping = 0;  ///< [energy]
  };
  Taken taken(std::span<const double> u0, std::span<const double> u1, std::span<const double> lifts, double h);
  /// Returns what resists an acceleration that changes its sign every step of h: M + C h/2 by the paper's step, M by
  /// the trapezoidal rule; rows of velocities that are held, too [mass].
  SparseMatrix resistance(std::span<const double> q, double h) const;
  /// Returns what resists impulses on the nodes in a step of h from places q, by the velocity that the fluid sees of
  /// them, with a stiffness that is nowhere negative [mass].
  SparseMatrix inertia(SolidRule rule, std::span<const double> q, double h) const;
  /// Adds the forces of springs in the middle of the way from q0 to q1 [force].
  void add_spring_forces(std::span<const double> q0, std::span<const double> q1, std::span<double> f) const;
  /// Adds `factor` times the springs' stiffness to a matrix.
  void add_spring_stiffness(double factor, SparseMatrix& K) const;
  /// Energy that springs store at q [energy].
  double spring_energy(std::span<const double> q) const;

  const fem::SolidSystem system;
  SparseMatrix A;                  ///< [mass/time]
  std::vector<double> b;           ///< [force]
  std::vector<double> external;    ///< loads and gravity of the step, part of b [force]
  std::vector<std::uint8_t> held;  ///< velocities that supports prescribe

 private:
  SparseMatrix sum_of(std::span<const double> q, bool convex, double masses, double stiffnesses) const;
  void add_springs(std::span<const double> q, double factor, std::span<double> internal);

  const Coupled& scene_;
  SparseMatrix stiffness_;        // K'
  std::vector<double> internal_;  // K(d0) with springs [force]
  std::vector<double> spring_;    // stiffness of each unknown [force/length]
  std::vector<double> work_;
};

}  // namespace tether::coupled
