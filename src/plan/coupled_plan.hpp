// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/coupled.hpp"
#include "model/scene.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Describes a fluid in a box and the solids in it: what is modelled and by which mode; the cost; path, grid and solids
/// for people.
std::vector<Term> coupled_terms(const Scene& scene);
Cost coupled_cost(const Scene& scene, const StepRule& rule);
std::string coupled_head(const Scene& scene);

/// How many cells a fluid in a box crosses in a step, by the largest of the velocities that the deck gives: of jets, of
/// the fluid and of bodies at the start. What forces make of it only the run knows.
struct CflNumber {
  double number = 0;
  double speed = 0;     ///< that it is of [velocity]
  std::string of = "";  ///< what has it
};
CflNumber cfl_number(const Scene& scene);

}  // namespace tether
