// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace tether {

/// Of a scene whose bodies on a mesh are one rigid body, stepped as the deck says: what is modelled, the cost, and
/// path, mesh and unknowns for people.
std::vector<Term> rigid_terms(const Scene& scene);
Cost rigid_cost(const Scene& scene, const StepRule& rule);
std::string rigid_head(const Scene& scene);

}  // namespace tether
