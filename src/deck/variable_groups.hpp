// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>

#include "deck/variable.hpp"

namespace tether {

// The parts of THE table; variables() joins them.
std::span<const Variable> in_variables();
std::span<const Variable> fluid_variables();
std::span<const Variable> region_variables();  ///< $regrig and $reg
std::span<const Variable> membrane_variables();
std::span<const Variable> added_variables();  ///< the other groups that the old code did not have
std::span<const Variable> fem_variables();    ///< $mesh and $fem
std::span<const Variable> rigid_variables();
std::span<const Variable> flow_variables();
std::span<const Variable> coupled_variables();
std::span<const Variable> study_variables();
std::span<const Variable> published_variables();

namespace bounds {
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double above_zero = std::numeric_limits<double>::denorm_min();  ///< stands for "> 0"
constexpr double largest_integer = 2147483647;
constexpr double smallest_integer = -2147483648.0;
}  // namespace bounds

}  // namespace tether
