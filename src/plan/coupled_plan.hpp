// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/coupled.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Of a fluid in a box and the solids in it: what is modelled and by which mode; the cost; path, grid and solids for
/// people.
std::vector<Term> coupled_terms(const Scene& scene);
Cost coupled_cost(const Scene& scene, const StepRule& rule);
std::string coupled_head(const Scene& scene);

}  // namespace tether
