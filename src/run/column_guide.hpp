// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fields/column_text.hpp"

namespace tether {

/// The columns that histories may have, physics by physics.
std::vector<PhysicsColumns> columns_of_all_physics();

}  // namespace tether
