// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "deck/variable_groups.hpp"

namespace tether {
namespace {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

constexpr int most_decks = 20, most_axes = 20, most_sets = 50, most_quantities = 30;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
constexpr std::array rows{
    Variable{study_group, "mode", text, 0, 1, 1, "", -none, none, "grid|ensemble|bisect", "'grid'",
             "All combinations of the axes; or several runs of each with a value varied about its own; or the largest "
             "value of each for which a criterion holds."},
    Variable{study_group, "decks", text, 1, most_decks, 1, "", -none, none, "", "",
             "Base decks, each a path from the study deck's folder, at most one folder up."},
    Variable{study_group, "axis", text, 1, most_axes, 1, "", -none, none, "", "",
             "A deck value and the values it takes: 'group.name=v1,v2,...'; axis 1 changes fastest, decks slowest."},
    Variable{study_group, "linked", integer, 1, most_axes, 1, "", 0, most_axes, "", "0",
             "Axis that this axis moves along with, value by value; 0 for none."},
    Variable{study_group, "set", text, 1, most_sets, 1, "", -none, none, "", "",
             "A value that all runs share: 'group.name=value', as with --set."},
    Variable{study_group, "quantities", text, 1, most_quantities, 1, "", -none, none, "", "",
             "Columns of the table: keys of summary.txt, or last, max, min, time_of_max or time_of_min of a column of "
             "history.txt, 'last(body_vx_1)'."},
    Variable{study_group, "order", text, 0, 1, 1, "", -none, none, "", "''",
             "Column against which the observed order of each error_ quantity is told, along axis 1 (grid)."},
    Variable{study_group, "vary", text, 0, 1, 1, "", -none, none, "", "''",
             "Real deck value, 'group.name', that an ensemble or a bisection varies."},
    Variable{study_group, "fraction", real, 0, 1, 1, "", above_zero, none, "", "",
             "Ensemble: the value is varied evenly from 1 - fraction to 1 + fraction times its own."},
    Variable{study_group, "runs", integer, 0, 1, 1, "", 2, 100000, "", "", "Ensemble: number of runs."},
    Variable{study_group, "low", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: a value at which the criterion holds."},
    Variable{study_group, "high", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: a larger value, at which it does not hold."},
    Variable{study_group, "tolerance", real, 0, 1, 1, "", 1e-12, 1, "", "1e-3",
             "Bisection: length of the last interval over the larger of low and high in size."},
    Variable{
        study_group, "criterion", text, 0, 1, 1, "", -none, none, "", "''",
        "Bisection: exit_code (0 holds, without a bound), or what quantities can be (a run that fails then does not "
        "hold)."},
    Variable{study_group, "at_least", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: the criterion holds from this value on."},
    Variable{study_group, "at_most", real, 0, 1, 1, "", -none, none, "", "",
             "Bisection: the criterion holds up to this value."},
};

}  // namespace

std::span<const Variable> study_variables() { return rows; }

}  // namespace tether
