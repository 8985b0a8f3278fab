// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/box/state.hpp"
#include "physics/solids/system.hpp"

namespace tether::coupled {

/// Swings of bodies in a viscous fluid. A step that keeps their energy has u1 = 2 w - u0. Where the fluid rules the
/// mean velocity w, what u0 differed from it by comes back with the other sign, step after step, and does no work that
/// friction could take. A calm step ends with u1 = w, and the swing is gone.
class Swings {
 public:
  /// The system must outlive it.
  explicit Swings(const fem::SolidSystem& system);

  /// A step as it was found.
  struct Step {
    std::span<const double> w;     ///< its mean velocities
    std::span<const double> drag;  ///< of the fluid's friction on the nodes [force]
    double heat = 0;               ///< that friction made of motion [energy]
    double h = 0;                  ///< its length [time]
  };
  /// Returns a body, counted from 0, that swings in a step from `state`, or -1. Its nodes turn back from what they last
  /// had more than the mean, by more than a part of their speed and less than friction takes; or friction takes more
  /// than all of their momentum.
  int found(const CoupledState& state, const Step& step) const;
  /// Keeps what the next step is looked at by, after a step with the mean velocities w. Where one swung, and was found
  /// again as a calm one, some that come are calm, too.
  static void keep(bool swung, std::span<const double> w, CoupledState& state);
  /// Says what a user is to know of it.
  static std::string text(const CoupledState& state, int body);

 private:
  const fem::SolidSystem& system_;
  std::vector<int> body_;  // of each node; -1: none
  int bodies_;
};

}  // namespace tether::coupled
