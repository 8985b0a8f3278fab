// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model/scene.hpp"

namespace tether {

/// How many cells a fluid in a box crosses in a step, by the largest of the velocities that the deck gives: of jets, of
/// the fluid and of bodies at the start. What forces make of it only the run knows.
struct CflNumber {
  double number = 0;
  double speed = 0;     ///< that it is of [velocity]
  std::string of = "";  ///< what has it
};
CflNumber cfl_number(const Scene& scene);

}  // namespace tether
