// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/flow.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Of a flow on a mesh, and of solids immersed in it.
std::vector<Term> flow_terms(const Scene& scene);
Cost flow_cost(const Scene& scene, const StepRule& rule);
std::string flow_head(const Scene& scene);

}  // namespace tether
