// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan/plan.hpp"

namespace tether {

/// The plan with its cost as the scene's own first steps show it: they are made on trial, for a tenth of a second or at
/// least a few, and what they take is carried on to the end, outputs included. Nothing is written. Where a step alone
/// would take long, or the scene much memory, the plan's own estimate stays. Where the first steps fail, the plan says
/// so in a warning.
Plan rehearsed(Plan plan);

}  // namespace tether
