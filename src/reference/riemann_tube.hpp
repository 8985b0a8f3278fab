// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene.hpp"
#include "reference/riemann.hpp"

namespace tether {

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
  /// Where the solution holds at a time. After a shock from a wall has met another wave, nowhere.
  TubePart valid_part(double t) const;
};

/// The tube of a scene that has what its solution 'riemann' needs: the left body is the left state, the diaphragm
/// stands in the middle of the gap between the two. Throws std::domain_error where the problem has no solution.
RiemannTube riemann_tube(const Scene& scene);

/// The part that is compared at a time: the deck's window, or the whole that is valid. Throws std::domain_error where
/// the solution does not hold there.
TubePart compared_part(const Scene& scene, const RiemannTube& tube, double t);

}  // namespace tether
