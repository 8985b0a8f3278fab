// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/state.hpp"

namespace tether::coupled {

/// What friction did.
struct Rubbed {
  int iterations = 0;           ///< -1: they did not converge, and nothing has changed
  double taken = 0;             ///< of the fluid's kinetic energy, also by the nodes and by what drives it [energy]
  double heat = 0;              ///< h times the power that friction takes [energy]
  std::vector<double> impulse;  ///< that the fluid gave the nodes, also those whose velocity is held [momentum]
  std::vector<double> nodes;    ///< their velocities by it and by their drive [velocity]

  /// Books what it did in a time h; the nodes get it as a force that acts all the time. Throws RunError where it did
  /// not converge.
  void book(double h, CoupledState& state, std::span<double> drag) const;
};

}  // namespace tether::coupled
