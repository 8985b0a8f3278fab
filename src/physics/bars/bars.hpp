// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/bars.hpp"
#include "model/scene.hpp"
#include "physics/step_clock.hpp"
#include "results/results.hpp"

namespace tether::fem {

/// Bars as flat arrays, constant while a scene runs. Nodes are the scene's points in their order, then the anchors.
struct BarArrays {
  std::vector<std::uint32_t> a, b;             // nodes of each bar
  std::vector<double> per_rest;                // 1 / length at the start [1/length]
  std::vector<double> strain;                  // at the start, number
  std::vector<double> section_modulus;         // E A [force]
  std::vector<double> least;                   // strain below which it carries no more: 0, or -infinity
  std::vector<double> per_mass_x, per_mass_y;  // of each node; 0 where it is held [1/mass]
  std::vector<double> fall;                    // gravity of each node in y; 0 where it is held [length/time2]
  std::vector<Anchor> sliding;
  std::vector<std::uint32_t> sliding_node;  // nodes of these

  BarArrays(const Scene& scene, const BarMesh& mesh);
  std::size_t bars() const { return a.size(); }
};

/// All that changes while bars run.
struct BarState : StepClock {
  std::vector<double> x, y, vx, vy, ax, ay;  // of each node, at the present time
  double carried_over = 0;     // energy by which steps of another length would count from elsewhere [energy]
  bool behind_warned = false;  // whether the run has warned of a node behind a wall
};

/// The state at time 0, with the accelerations of its places.
BarState start(const Scene& scene, const BarMesh& mesh, const BarArrays& arrays);

/// Strain of bar e at this length: the change of its length over the length at the start, whose section its stress
/// counts. The exact solutions are of linear strings; by ln(l / L_0), which the elements of the mpm path measure, the
/// spring of thesis 5.5 softens: its period is 1.3 % above the exact one (by this strain 0.02 %), and the slack string
/// of 5.6 falls 8 % too deep (0.2 %). A swinging string stretches too little to show it.
inline double strain_of(const BarArrays& bars, std::size_t e, double length) {
  return length * bars.per_rest[e] - 1 + bars.strain[e];
}

/// Returns the part of a strain that carries: none of a compression in a one-way bar.
inline double carried(const BarArrays& bars, std::size_t e, double strain) { return std::max(strain, bars.least[e]); }

/// Accelerations of the present places. False where a bar's length is no number.
bool accelerate(const BarArrays& bars, BarState& state);

/// One step of central differences: v at the middle of the step from the accelerations before it, the places from
/// these, v at its end from the accelerations there. False where a bar's length is no number at the end.
bool central_difference_step(const BarArrays& bars, BarState& state, double dt);

SavedState save(const BarState& state);
/// Throws FileError where the saved state is not of bars, or of another scene.
void restore(BarState& state, const SavedState& saved);

}  // namespace tether::fem
