// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene.hpp"

namespace tether {

/// State of an ideal gas on one side of a wave.
struct GasState {
  double density = 0;   ///< mass/volume
  double velocity = 0;  ///< towards +x
  double pressure = 0;
};

/// Two uniform states, parted by a diaphragm that is taken away at t = 0.
struct RiemannProblem {
  GasState left, right;
  double gamma = 1.4;    ///< ratio of specific heats
  double diaphragm = 0;  ///< its place x0
};

/// Between the two outer waves: one pressure, one velocity, a density on either side of the contact.
struct StarRegion {
  double pressure = 0, velocity = 0, density_left = 0, density_right = 0;
};

struct RiemannSolution {
  RiemannProblem problem;
  StarRegion star;
};

/// The gas at one place and time.
struct GasSample {
  double density = 0, velocity = 0, pressure = 0;
  double specific_energy = 0;  ///< internal energy/mass, p / ((gamma - 1) rho)
};

/// Exact solution of the Riemann problem for the one-dimensional Euler equations of an ideal gas.
/// Throws std::domain_error for a density or pressure that is not positive, gamma <= 1, a number that is not finite,
/// and states that part so fast that a vacuum opens between them.
/// Source: E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., chapter 4. Thesis 4.1 uses
/// G. A. Sod's problem, J. Comput. Phys. 27 (1978) 1-31.
RiemannSolution solve_riemann(const RiemannProblem& problem);

/// Speed of the foremost part of the wave to the left: of a shock, or of the head of a rarefaction.
double left_wave_speed(const RiemannSolution& solution);

/// Returns the same problem seen in a mirror at x = 0.
RiemannSolution mirror_image(const RiemannSolution& solution);

/// Speed of the shock that a wall at rest sends to the right into gas that runs into it (velocity <= 0): the sound's
/// where the gas is at rest.
double speed_of_shock_from_wall(const GasState& gas, double gamma);

/// The solution at x and t >= 0; t = 0 gives the two initial states. At a jump the state on its right is returned.
/// Throws std::domain_error for a negative t.
GasSample sample(const RiemannSolution& solution, double x, double t);

/// What is at an end of a tube of gas.
enum class EndKind {
  wall,    ///< gas stops there
  vacuum,  ///< gas leaves into nothing
  edge     ///< gas passes, with the state that it has at the start
};
struct TubeEnd {
  double x = 0;  ///< where the gas ends at t = 0
  EndKind kind = EndKind::wall;
};

/// A part of the tube; empty where `from` is not below `to`.
struct TubePart {
  double from = 0, to = 0;
  bool empty() const { return !(from < to); }
};

/// The Riemann problem in a tube that ends. Its solution is that of an endless tube and holds where nothing of the ends
/// has come: at a wall that gas runs into or away from, and where gas ends, that begins at once; else it begins when
/// the first wave is there. From then on what the end sends runs along the characteristic dx/dt = u + a of the
/// solution, a shock from a wall faster (derived here; E. F. Toro, Riemann Solvers, chapter 4, for the waves).
struct RiemannTube {
  RiemannSolution solution;
  TubeEnd left, right;

  /// When the left or the right end begins to send waves; infinite where it never does.
  double left_begins() const;
  double right_begins() const;
  /// Returns where the solution holds at a time. After a shock from a wall has met another wave, it holds nowhere.
  TubePart valid_part(double t) const;
};

/// The tube of a scene that has what its solution 'riemann' needs: the left body is the left state, the diaphragm
/// stands in the middle of the gap between the two. Throws std::domain_error where the problem has no solution.
RiemannTube riemann_tube(const Scene& scene);

/// The part that is compared at a time: the deck's window, or the whole that is valid. Throws std::domain_error where
/// the solution does not hold there.
TubePart compared_part(const Scene& scene, const RiemannTube& tube, double t);

}  // namespace tether
