// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace tether {

/// The exact solution that the scene is compared with, and what it takes the scene for; no term where there is none.
std::vector<Term> reference_terms(const Scene& scene);

/// Where the solution does not hold to the end of the run, or leaves out what the scene has.
std::vector<std::string> reference_warnings(const Scene& scene);

}  // namespace tether
