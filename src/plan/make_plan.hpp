// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan/plan.hpp"

namespace tether {

/// Throws InputError where the steps would be too short to get on.
Plan make_plan(Scene scene);

}  // namespace tether
