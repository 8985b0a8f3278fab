// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solvers/mpm/point_laws.hpp"
#include "solvers/mpm/state.hpp"
#include "solvers/mpm/trouble.hpp"

namespace tether::mpm {

/// A step's workplace: the state it changes and what it found on the way.
struct StepWork {
  State& state;
  const Scene& scene;
  StepFindings found;
  Trouble trouble;
};

/// One step of length dt in the three orders of stress update. Each begins and ends with mass and momentum (and, but
/// for Usf, force) mapped to the nodes. After trouble the state is for reading only.
struct Musl {
  static void step(StepWork& work, double dt);
};
struct Usl {
  static void step(StepWork& work, double dt);
};
struct Usf {
  static void step(StepWork& work, double dt);
};

/// Adds mass, momentum and internal force of all points at their present places to `sums` (3.15), (3.16).
void map_all(const State& state, const Scene& scene, std::vector<NodeSums>& sums);

}  // namespace tether::mpm
