// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "deck/variable_groups.hpp"

namespace tether {
namespace {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect]
constexpr std::array rows{
    Variable{"fluid", "mu", real, 0, 1, 1, "stress*time", 0, none, "", "0.0", "Shear viscosity of the gas."},
    Variable{"fluid", "gm1", real, 0, 1, 1, "", above_zero, none, "", "0.4",
             "gamma - 1 of the gas, gamma the ratio of its specific heats."},
    Variable{"fluid", "siep", real, 1, region_count, 1, "energy/mass", 0, none, "", "0.0",
             "Specific internal energy of the gas of region i at the start."},
    Variable{"fluid", "lambda", real, 0, 1, 1, "", 0, none, "", "0.0", "Factor of the artificial viscosity."},
    Variable{"fluid", "coef1", real, 0, 1, 1, "", 0, none, "", "0.0",
             "Coefficient of the artificial viscosity's linear term."},
    Variable{"fluid", "coef2", real, 0, 1, 1, "", 0, none, "", "0.0",
             "Coefficient of the artificial viscosity's quadratic term."},
    Variable{"fluid", "pambient", real, 0, 1, 1, "stress", -none, none, "", "0.0",
             "Pressure outside a membrane that encloses gas."},
};

}  // namespace

std::span<const Variable> fluid_variables() { return rows; }

}  // namespace tether
