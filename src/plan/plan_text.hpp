// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "plan/plan.hpp"

namespace tether {

/// The plan for people: terms, step, cost (`tether plan`).
std::string to_text(const Plan& plan);

}  // namespace tether
