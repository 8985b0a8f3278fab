// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/groups/coupled.hpp"
#include "deck/variable.hpp"
#include "model/contact.hpp"

namespace tether::contact_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;
inline constexpr int nl = load_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array contact_rows{
    Variable{"contact", "on", text, 1, nl, 1, "", -none, none, "", "",
             "Side of the mesh, or 'region r', that can meet something; without any the whole surface of all bodies "
             "can. The group turns contact on by being there."},
    Variable{"contact", "gap", real, 0, 1, 1, "length", above_zero, none, "", "",
             "Distance at which sides begin to press each other; a tenth of the shortest side of the surface where it "
             "is not given, or how far moving bodies are apart at the start where that is less."},
    Variable{"contact", "stiffness", real, 0, 1, 1, "stress", above_zero, none, "", "",
             "Stiffness of the pressure between sides; a tenth of the modulus E of the softer body where it is not "
             "given."},
    Variable{"contact", "friction", real, 0, 1, 1, "", 0, none, "", "0.0", "Coulomb's coefficient."},
    Variable{"contact", "stick", real, 0, 1, 1, "velocity", above_zero, none, "", "",
             "Speed of sliding below which friction is in proportion to it; it is found from the scene where it is not "
             "given."},
    Variable{"contact", "step", text, 0, 1, 1, "", -none, none, choices<ContactStep>, "'auto'",
             "How contact enters a step: energy gives back all the energy that it takes, damped gives back less; auto: "
             "damped where there is friction."},
    Variable{"contact", "parts", integer, 0, 1, 1, "", 1, 16, "", "1",
             "Parts that each line of a side is cut into, with points of quadrature of their own: more parts pass "
             "pressures more evenly between meshes that do not match, and cost as much more."},
    Variable{"contact", "bodies", logical, 0, 1, 1, "", -none, none, "", ".true.", "Whether bodies meet each other."},
    Variable{"contact", "itself", logical, 0, 1, 1, "", -none, none, "", ".true.", "Whether a body meets itself."},
    Variable{"contact", "wall", text, 1, 6, 1, "", -none, none, coupled_table::sides, "",
             "Side of the box of $in that bodies do not go beyond. That box has no ends along z: plane says where a "
             "back or a front is."},
    Variable{"contact", "plane", real, 2, 6, nl, "", -none, none, "", "",
             "Plane k that bodies do not go beyond: x, y and, in space, z of a place in it, then as many components of "
             "its normal, which points to where the bodies are and may have any length."},
    Variable{"contact", "obstacle", real, 2, 6, nl, "length", -none, none, "", "",
             "Obstacle k at rest, which bodies do not enter: its lowest and highest x, y and, in space, z."},
};

}  // namespace tether::contact_table
