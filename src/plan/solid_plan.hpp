// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/solids.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Of elastic bodies on a mesh: the step, which is the deck's but for central differences; what is modelled; the cost;
/// and path, mesh and materials for people.
StepRule solid_step_rule(const Scene& scene);
std::vector<Term> solid_terms(const Solids& solids, double gravity);
Cost solid_cost(const Scene& scene, const StepRule& rule);
std::string solid_head(const Solids& solids);
/// Each region with its density and law, a line each.
std::string regions_text(const Solids& solids);
/// Each support and wall with the nodes that it holds or moves.
std::string supports_text(const Solids& solids);

}  // namespace tether
