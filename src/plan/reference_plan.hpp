// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/bars.hpp"
#include "plan/plan.hpp"

namespace tether {

/// The step rule of a scene that runs by bars, 2 over their highest frequency; what of the method it needs and what it
/// does not; and what it is expected to cost.
StepRule bar_step_rule(const Scene& scene, const BarMesh& mesh);
std::vector<Term> bar_terms(const Scene& scene, const BarMesh& mesh);
Cost bar_cost(const Scene& scene, const BarMesh& mesh, const StepRule& rule);

/// The exact solution that the scene is compared with, and what it takes the scene for; no term where there is none.
std::vector<Term> reference_terms(const Scene& scene);

/// Warns where the solution does not hold to the end of the run, or leaves out what the scene has.
std::vector<std::string> reference_warnings(const Scene& scene);

}  // namespace tether
