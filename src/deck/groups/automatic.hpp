// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"

namespace tether::automatic_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array auto_rows{
    Variable{auto_group, "quantity", text, 0, 1, 1, "", -none, none, "", "",
             "What --auto is to be true to: a key of summary.txt, or an expression as those of $published, "
             "'max(body_y_3)'. Without it the first number of $published that is read off a history; else the way of "
             "the first tracked point, the last value of the first probe, the way of the first body, or the largest "
             "kinetic energy."},
    Variable{auto_group, "budget", real, 0, 1, 1, "", above_zero, none, "", "3600",
             "Seconds of the processor that the runs of --auto may take together."},
    Variable{auto_group, "simplify", logical, 0, 1, 1, "", -none, none, "", ".true.",
             "Whether --auto leaves out parts of the model that the number does not need."},
};

}  // namespace tether::automatic_table
