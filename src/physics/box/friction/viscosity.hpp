// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physics/box/friction/rubbed.hpp"
#include "physics/box/friction/strain_rates.hpp"
#include "physics/box/friction/ties.hpp"

namespace tether::coupled {

/// A fluid that rubs, in a domain whose faces have velocities. What it refers to must outlive it.
struct RubbingFluid {
  const FlowDomain& domain;
  double density = 1, mu = 0;  ///< [mass/volume], [stress time]
  const CellParts& parts;      ///< of the cells that are fluid: those of a liquid with a surface
  Beyond beyond = Beyond::fluid;
  const SolidsNearFaces* solids = nullptr;  ///< null: none cuts the cells
};

/// What friction in the fluid does to the velocities of the open faces in a time h. They become, with those of the
/// solids' nodes u, the ones of which
///     1/2 sum m (v - v*)^2 + h (half the power that friction takes)
/// is least: (13) of C. Batty, R. Bridson, Proc. SCA (2008) 219-228, implicit and stable for any h. Here the nodes are
/// not prescribed but found with the fluid, so that momentum is kept.
///
/// Walls, obstacles and jets (prescribed faces) hold what flows along them, at half a cell's distance, but for sides of
/// the box that slip; bodies do where the fluid sticks to them, else it slips along them. No stress acts at a liquid's
/// surface, and nothing is exchanged through a solid.
class Friction {
 public:
  /// The solids' nodes have dim numbers each; `mobility` is 1 / mass of each number, 0 where its velocity is held
  /// [1/mass].
  Friction(const RubbingFluid& fluid, std::span<const double> mobility, double h);
  Friction(const Friction&) = delete;
  Friction& operator=(const Friction&) = delete;

  /// Lets friction act on the velocities v of the faces and u of the nodes, to a tolerance of conjugate gradients.
  /// `driven` is the acceleration by pressures and forces. It acts meanwhile, and at the end h times it is taken back,
  /// for the pressure to find anew: what stays is what friction does to a velocity that is driven as it goes. So are
  /// the nodes; what friction does to them is the impulse.
  Rubbed act(Team& team, std::span<const double> u, std::span<const double> driven_nodes, double tolerance,
             const FaceValues& driven, FaceValues& v);

 private:
  template <class Function>
  void each_open_face(const Function& f) const;
  double mass(int axis, std::size_t f) const;
  std::vector<double> first_guess(std::span<const double> driven_to, std::span<const double> undriven);
  int solve(Team& team, std::span<const double> driven_to, double tolerance);

  RubbingFluid fluid_;
  FrictionUnknowns unknowns_;
  Slopes slopes_;
  StrainRates rates_;
  double h_;
  bool begun_ = false;
  std::vector<double> mass_, x_;   // of each unknown; no mass: it is known
  std::vector<std::size_t> free_;  // unknowns that friction changes
  std::optional<Ties> ties_;       // of their equations
};

}  // namespace tether::coupled
