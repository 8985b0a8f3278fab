// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/numbers.hpp"
#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "laws/walls.hpp"

namespace tether::thesis_table {

using bounds::above_zero;
using bounds::largest_integer;
using bounds::none;
using bounds::smallest_integer;
using enum ValueType;

inline constexpr std::string_view wall_kinds = choices<Wall>;

inline constexpr std::string_view iout_meaning =
    "1 writes output i every tiout(i): 13 point snapshots; 30 grid velocity; 31 grid mass; 32 membrane points and "
    "stress; 33 histories of points and bodies; 34 energies; 35 strain of points; 36 pressure; 37 density on the grid; "
    "38 tracked angle and ends; 39 grid fields (pressure, velocity, energy, density); 40 normals; 41 checkpoint. Any "
    "of "
    "13, 32, 35, 36, 40 writes all fields of the points, any of 30, 31, 37, 39 all of the grid's nodes. The thesis "
    "does "
    "not print these meanings: they are tether's own.";

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect[, required]]
inline constexpr std::array in_rows{
    Variable{"in", "nx", integer, 0, 1, 1, "", 2, 1e9, "", "", "Nodes of the background grid in x.", Effect::used,
             true},
    Variable{"in", "ny", integer, 0, 1, 1, "", 2, 1e9, "", "", "Nodes of the background grid in y.", Effect::used,
             true},
    Variable{"in", "iprint", integer, 0, 1, 1, "", smallest_integer, largest_integer, "", "",
             "Print switch of the old code.", Effect::none},
    Variable{"in", "igen", integer, 0, 1, 1, "", 0, 3, "0|1|3", "1",
             "Where points come from: 0 the particle file only, 1 the regions of $reg only, 3 both."},
    Variable{"in", "gravc", real, 0, 1, 1, "length/time2", -none, none, "", "0.0",
             "Acceleration in y; that of gravity downwards is negative."},
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
    Variable{"in", "vtk", text, 0, 1, 1, "", -none, none, choices<VtkFiles>, "'auto'",
             "Whether snapshots are written as VTK files for ParaView, too: yes, no, or auto: where they have 200,000 "
             "points, "
             "nodes or cells at the most."},
    Variable{"in", "path", text, 0, 1, 1, "", -none, none, "mpm|fem|bars|coupled", "",
             "Path that runs the scene: material points, finite elements, strings as bars (which fem makes of them "
             "where nothing else is there), or a fluid in a box coupled with elements. "
             "What only other paths have a use for is left out, with a remark. Where it is not given, the deck's "
             "groups say it: $coupled, or $fem, $mesh, $rigid or $flow, else material points."},
    Variable{"in", "particles", text, 0, 1, 1, "", -none, none, "", "''",
             "Particle file, relative to the deck, at most one folder up."},
};

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect]
inline constexpr std::array fluid_rows{
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

inline constexpr int nr = region_count;
inline constexpr int nv = vertex_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect]
inline constexpr std::array reg_rows{
    Variable{"regrig", "nregrig", integer, 0, 1, 1, "", 0, largest_integer, "", "0",
             "Number of rigid regions of the old code.", Effect::none},
    Variable{"reg", "nreg", integer, 0, 1, 1, "", 0, nr, "", "0", "Number of regions that are filled with points."},
    Variable{"reg", "nvi", integer, 1, nr, 1, "", 0, nv, "", "0", "Vertices of region r, at least 3."},
    Variable{"reg", "xvi", real, 2, nv, nr, "length", -none, none, "", "", "x of vertex v of region r."},
    Variable{"reg", "yvi", real, 2, nv, nr, "length", -none, none, "", "", "y of vertex v of region r."},
    Variable{"reg", "xcenter", real, 1, nr, 1, "length", -none, none, "", "0.0",
             "x of the centre of region r's two ellipses; without a subscript it sets region 1 only."},
    Variable{"reg", "ycenter", real, 1, nr, 1, "length", -none, none, "", "0.0",
             "y of the centre of region r's two ellipses."},
    Variable{"reg", "rix", real, 1, nr, 1, "length", 0, none, "", "0.0",
             "Half axis in x of the inner ellipse of region r; points are put outside it."},
    Variable{"reg", "rex", real, 1, nr, 1, "length", 0, none, "", "1e30",
             "Half axis in x of the outer ellipse of region r; points are put inside it."},
    Variable{"reg", "riy", real, 1, nr, 1, "length", 0, none, "", "0.0",
             "Half axis in y of the inner ellipse of region r."},
    Variable{"reg", "rey", real, 1, nr, 1, "length", 0, none, "", "1e30",
             "Half axis in y of the outer ellipse of region r."},
    Variable{"reg", "nprg", integer, 1, nr, 1, "points/cell", 1, largest_integer, "", "4",
             "Points that fill a cell of region r, the square of a whole number."},
    Variable{"reg", "densir", real, 1, nr, 1, "mass/length3", above_zero, none, "", "", "Density of region r."},
    Variable{
        "reg", "matr", real, 2, nr, nr, "", -none, none, "", "0.0",
        "Constants of region r: matr(1,r) is E, or beta of a linear fluid [stress]; matr(2,r) is nu, or the viscosity "
        "of a linear fluid [stress time]; matr(3..7,r) "
        "are read and have no effect."},
    Variable{
        "reg", "paths", text, 1, nr, 1, "", -none, none, "", "",
        "Paths that have region r, of those that path of $in may name, such as 'mpm fem'; others leave it out. All "
        "have it where this is not given."},
    Variable{"reg", "law", text, 1, nr, 1, "", -none, none, point_laws, "",
             "Law of the elastic region r, with E and nu of matr(1..2,r): small strains, St Venant-Kirchhoff or "
             "compressible neo-Hookean. Where it is not given, points follow their rate of strain (linear), and a mesh "
             "has law(r) of $fem. With svk and neo-hookean points carry their deformation gradient."},
    Variable{"reg", "volumetric", text, 1, nr, 1, "", -none, none, choices<Volumetric>, "",
             "What a neo-Hookean region's change of volume costs: lambda/2 ln(J)^2, lambda/2 (J-1)^2 or lambda/4 (J^2 "
             "- 1 - 2 ln J); log, or of a mesh volumetric(r) of $fem, where it is not given."},
    Variable{"reg", "ipath", integer, 2, 4, nr, "", smallest_integer, largest_integer, "", "",
             "ipath(4,r) is the law of region r, which has none by default, but for regions of meshes, with 0: 0 "
             "elastic in plane strain, 2 elastic in plane stress, 7 gas with "
             "density by continuity, 9 gas with density by quadratic interpolation, 8 "
             "linear fluid; ipath(1..3,r) are read and have no effect."},
    Variable{"reg", "vrx", real, 1, nr, 1, "length/time", -none, none, "", "0.0",
             "Velocity of region r in x at the start."},
    Variable{"reg", "vry", real, 1, nr, 1, "length/time", -none, none, "", "0.0",
             "Velocity of region r in y at the start."},
};

}  // namespace tether::thesis_table
