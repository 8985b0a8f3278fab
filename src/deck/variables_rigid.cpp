// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "deck/variable_groups.hpp"
#include "model/rigid.hpp"

namespace tether {
namespace {

using bounds::none;
using enum ValueType;
constexpr int nl = load_count, nt = table_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
constexpr std::array rows{
    Variable{"rigid", "form", text, 0, 1, 1, "", -none, none, choices<RigidForm>, "'reduced'",
             "How a step of the rigid body is solved: in the null space of the constraints (6 unknowns, 3 with a pin), "
             "or with 12 coordinates and a multiplier for each constraint (18, 21). Both give one motion."},
    Variable{"rigid", "point", real, 1, 3, 1, "length", -none, none, "", "",
             "Reference point of the body's coordinates, anywhere; its centre of mass where it is not given."},
    Variable{"rigid", "directors", real, 2, 3, 3, "length", -none, none, "", "",
             "Components of the three directors; they must be independent, not orthogonal. One that is not given is "
             "the unit vector of its axis."},
    Variable{"rigid", "pin", real, 1, 3, 1, "length", -none, none, "", "",
             "A place of the body, or beside it, that is held; the body turns about it without friction."},
    Variable{"rigid", "omega", real, 1, 3, 1, "1/time", -none, none, "", "0.0",
             "Angular velocity at the start. The centre of mass has vrx, vry of $reg and vrz of $fem, which all "
             "regions share; with a pin it goes round that."},
    Variable{"rigid", "torque", real, 2, 3, nl, "force length", -none, none, "", "0.0",
             "Components of torque k, which keeps its direction."},
    Variable{"rigid", "torque_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of torque k's table, as load_time of $fem."},
    Variable{"rigid", "torque_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of torque k at these times."},
    Variable{"rigid", "torque_expression", text, 1, nl, 1, "", -none, none, "", "",
             "Factor of torque k as an expression in t, in place of a table."},
    Variable{"rigid", "force", real, 2, 3, nl, "force", -none, none, "", "0.0",
             "Components of force k at a point of the body."},
    Variable{"rigid", "force_at", real, 2, 3, nl, "length", -none, none, "", "",
             "Where force k acts, by the shape at the start; the point goes with the body."},
    Variable{"rigid", "force_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of force k's table, as load_time of $fem."},
    Variable{"rigid", "force_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of force k at these times."},
    Variable{"rigid", "force_expression", text, 1, nl, 1, "", -none, none, "", "",
             "Factor of force k as an expression in t, in place of a table."},
    Variable{"rigid", "turning", logical, 1, nl, 1, "", -none, none, "", ".false.",
             "Whether force k turns with the body; else it keeps its direction."},
};

}  // namespace

std::span<const Variable> rigid_variables() { return rows; }

}  // namespace tether
