// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studies/reproduce/formula.hpp"

namespace tether::published {

std::span<const ReadingFunction> reading_functions();

/// The one of this name, or null.
const ReadingFunction* find_reading_function(const std::string& name);

}  // namespace tether::published
