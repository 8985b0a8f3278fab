// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace tether {

/// The plan for people: terms, step, cost (`tether plan`).
std::string to_text(const Plan& plan);

/// Lists what the scene needs of the method, and what it does not.
std::vector<Term> terms_of(const Scene& scene);

/// Lists that a strip of points runs as one row, or could; nothing of other scenes.
std::vector<Term> strip_terms(const Scene& scene);

std::string material_name(const Material& material, Geometry geometry);

}  // namespace tether
