// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "base/units.hpp"
#include "deck/variable_groups.hpp"
#include "laws/walls/walls.hpp"

namespace tether {
namespace {

using bounds::above_zero;
using bounds::largest_integer;
using bounds::none;
using bounds::smallest_integer;
using enum ValueType;

constexpr std::string_view wall_kinds = choices<Wall>;

constexpr std::string_view iout_meaning =
    "1 writes output i every tiout(i): 13 point snapshots; 30 grid velocity; 31 grid mass; 32 membrane points and "
    "stress; 33 histories of points and bodies; 34 energies; 35 strain of points; 36 pressure; 37 density on the grid; "
    "38 tracked angle and ends; 39 grid fields (pressure, velocity, energy, density); 40 normals; 41 checkpoint. Any "
    "of "
    "13, 32, 35, 36, 40 writes all fields of the points, any of 30, 31, 37, 39 all of the grid's nodes. The thesis "
    "does "
    "not print these meanings: they are tether's own.";

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect[, required]]
constexpr std::array rows{
    Variable{"in", "nx", integer, 0, 1, 1, "", 2, 1e9, "", "", "Nodes of the background grid in x.", Effect::used,
             true},
    Variable{"in", "ny", integer, 0, 1, 1, "", 2, 1e9, "", "", "Nodes of the background grid in y.", Effect::used,
             true},
    Variable{"in", "iprint", integer, 0, 1, 1, "", smallest_integer, largest_integer, "", "",
             "Print switch of the old code.", Effect::none},
    Variable{"in", "igen", integer, 0, 1, 1, "", 0, 3, "0|1|3", "1",
             "Where points come from: 0 the particle file only, 1 the regions of $reg only, 3 both."},
    Variable{"in", "gravc", real, 0, 1, 1, "length/time2", -none, none, "", "0.0", "Acceleration in y."},
    Variable{"in", "xleft", real, 0, 1, 1, "length", -none, none, "", "", "Left edge of the grid.", Effect::used, true},
    Variable{"in", "xright", real, 0, 1, 1, "length", -none, none, "", "", "Right edge of the grid.", Effect::used,
             true},
    Variable{"in", "ybot", real, 0, 1, 1, "length", -none, none, "", "", "Bottom edge of the grid.", Effect::used,
             true},
    Variable{"in", "ytop", real, 0, 1, 1, "length", -none, none, "", "", "Top edge of the grid.", Effect::used, true},
    Variable{"in", "cntr", real, 0, 1, 1, "", 0, 1, "", "1.0",
             "Time-centring theta of the FLIP lineage; the material point method works with 1.0.", Effect::none},
    Variable{"in", "tmax", real, 0, 1, 1, "time", above_zero, none, "", "", "End of the run.", Effect::used, true},
    Variable{"in", "tstep", real, 0, 1, 1, "time", above_zero, none, "", "", "Time step.", Effect::used, true},
    Variable{"in", "dtmax", real, 0, 1, 1, "time", above_zero, none, "", "",
             "Largest time step; tstep where it is not given."},
    Variable{"in", "tplt", real, 0, 1, 1, "time", -none, none, "", "", "Plot interval of the old code.", Effect::none},
    Variable{"in", "tol", real, 0, 1, 1, "", -none, none, "", "", "Tolerance of the old code's iteration.",
             Effect::none},
    Variable{"in", "miter", integer, 0, 1, 1, "", smallest_integer, largest_integer, "", "",
             "Largest number of iterations of the old code.", Effect::none},
    Variable{"in", "large", logical, 0, 1, 1, "", -none, none, "", "", "Switch of the old code for large strains.",
             Effect::none},
    Variable{"in", "methd", integer, 0, 1, 1, "", smallest_integer, largest_integer, "", "",
             "Method switch of the old code.", Effect::none},
    Variable{"in", "wl", integer, 0, 1, 1, "", 0, 6, wall_kinds, "6",
             "Left wall: 0 holds all components, 1 is open, 4 symmetry, 5 axis, 6 free slip."},
    Variable{"in", "wr", integer, 0, 1, 1, "", 0, 6, wall_kinds, "6", "Right wall, as wl."},
    Variable{"in", "wb", integer, 0, 1, 1, "", 0, 6, wall_kinds, "6", "Bottom wall, as wl."},
    Variable{"in", "wt", integer, 0, 1, 1, "", 0, 6, wall_kinds, "6", "Top wall, as wl."},
    Variable{"in", "iout", integer, 1, output_count, 1, "", 0, 1, "0|1", "0", iout_meaning},
    Variable{"in", "tiout", real, 1, output_count, 1, "time", above_zero, none, "", "", "Interval of output i."},
    Variable{"in", "cyl", real, 0, 1, 1, "", 0, 1, "0|1", "0.0",
             "1 for an axisymmetric problem (x is the radius), 0 for a plane one."},
    Variable{"in", "units", text, 0, 1, 1, "", -none, none, choices<Units>, "'none'",
             "Unit system that labels the outputs; nothing is converted."},
    Variable{"in", "particles", text, 0, 1, 1, "", -none, none, "", "''",
             "Particle file, relative to the deck, at most one folder up."},
};

}  // namespace

std::span<const Variable> in_variables() { return rows; }

}  // namespace tether
