// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "deck/variable_groups.hpp"

namespace tether {
namespace {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
constexpr std::array rows{
    Variable{"points", "heavy", real, 1, point_count, 1, "mass", above_zero, none, "", "",
             "Mass of the point of row i of the particle file, instead of its own; its volume and density stay."},
    Variable{"points", "tracked", logical, 1, point_count, 1, "", -none, none, "", ".false.",
             "Whether position and velocity of row i of the particle file go into the history."},
    Variable{"points", "tracked_at", real, 2, 2, tracked_at_count, "length", -none, none, "", "",
             "x, y of a place: the point nearest to it at the start, of any origin, goes into the history."},
    Variable{"membrane", "law", text, 0, 1, 1, "", -none, none, "uniaxial", "'uniaxial'",
             "Law of the points of strings and membranes: stress along the tangent only."},
    Variable{"membrane", "wrinkle", logical, 0, 1, 1, "", -none, none, "", ".true.",
             "One-way law: compression carries no force, its strain goes on accumulating."},
    Variable{"mpm", "order", text, 0, 1, 1, "", -none, none, "musl|usf|usl", "'musl'",
             "When a step updates the stress: with velocities mapped back from the points, first, or last."},
    Variable{"mpm", "density", text, 0, 1, 1, "", -none, none, "cell|quadratic|continuity", "",
             "How a gas point finds its density; where it is given it wins over ipath(4,r)."},
    Variable{"mpm", "cfl", real, 0, 1, 1, "", 0, none, "", "1.0",
             "Factor of the step limit dx/c; 0 takes the deck's step as it is."},
    Variable{"reference", "solution", text, 0, 1, 1, "", -none, none, "riemann|spring|string|pendulum|piston", "''",
             "Exact solution that the results are compared with."},
};

}  // namespace

std::span<const Variable> added_variables() { return rows; }

}  // namespace tether
