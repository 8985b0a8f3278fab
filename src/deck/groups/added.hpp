// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "laws/fluids.hpp"
#include "model/method.hpp"
#include "model/scene.hpp"

namespace tether::added_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array added_rows{
    Variable{"points", "heavy", real, 1, point_count, 1, "mass", above_zero, none, "", "",
             "Mass of the point of row i of the particle file, instead of its own; its volume and density stay."},
    Variable{"points", "tracked", logical, 1, point_count, 1, "", -none, none, "", ".false.",
             "Whether position and velocity of row i of the particle file go into the history."},
    Variable{
        "points", "tracked_at", real, 2, 2, tracked_at_count, "length", -none, none, "", "",
        "x, y of a place at the start whose path goes into the history: of material points and bars the nearest point "
        "has it, of bodies on a mesh the place within its element; one that lies in no body is an error."},
    Variable{"points", "pinned", logical, 1, point_count, 1, "", -none, none, "", ".false.",
             "Whether a pin holds the point of row i of the particle file where it is."},
    Variable{"mpm", "method", text, 0, 1, 1, "", -none, none, choices<MpmSet>, "'thesis'",
             "Set of parts that a run is made of; each part that is given below wins over it."},
    Variable{"mpm", "kernel", text, 0, 1, 1, "", -none, none, choices<Kernel>, "",
             "Shape functions between points and nodes: bilinear (thesis), or quadratic B-splines (robust)."},
    Variable{"mpm", "transfer", text, 0, 1, 1, "", -none, none, choices<Transfer>, "",
             "What a point takes from the nodes: an increment of its velocity (thesis), or a velocity field that is "
             "linear about it (robust)."},
    Variable{"mpm", "order", text, 0, 1, 1, "", -none, none, choices<StressOrder>, "",
             "When a step updates the stress: with velocities mapped back from the points (thesis), first (robust), or "
             "last."},
    Variable{"mpm", "density", text, 0, 1, 1, "", -none, none, choices<DensityRule>, "",
             "How a gas point finds its density; where it is given it wins over ipath(4,r). The robust method takes "
             "it from the gas at the nodes."},
    Variable{"mpm", "energy", text, 0, 1, 1, "", -none, none, choices<GasEnergy>, "",
             "Velocity gradient that heats the gas: the one of its stress (thesis), or that of the mean of old and new "
             "velocity after the solve (robust)."},
    Variable{"mpm", "viscosity", text, 0, 1, 1, "", -none, none, choices<ViscosityOf>, "",
             "Artificial viscosity: by lambda, coef1, coef2 of $fluid and the largest sound speed (thesis), or with "
             "both coefficients 1 and the local sound speed (robust)."},
    Variable{"mpm", "contact", text, 0, 1, 1, "", -none, none, choices<ContactRule>, "",
             "Bodies at a node: one velocity field (thesis), release by the criteria of A.1.3, or an impulse where "
             "their points touch (robust). Fluids and membranes always share one field."},
    Variable{"mpm", "criterion", integer, 0, 1, 1, "", 1, 3, "1|2|3", "1",
             "Criterion of release: 1 (9.7), 2 (9.8), which say the same of two bodies, 3 (9.9)."},
    Variable{"mpm", "ledger", logical, 0, 1, 1, "", -none, none, "", "",
             "Whether what transfer and membrane elements lose heats the gas, so that the total energy is kept; the "
             "robust method does."},
    Variable{"mpm", "jaumann", logical, 0, 1, 1, "", -none, none, "", ".false.",
             "Whether the stress of elastic solids turns with their spin; the thesis turns none."},
    Variable{"mpm", "cfl", real, 0, 1, 1, "", 0, none, "", "",
             "Factor of the step limit dx/c, 1 by the thesis' method and 0.65 by the robust one; 0 takes the deck's "
             "step as it is."},
    Variable{"mpm", "reduce", logical, 0, 1, 1, "", -none, none, "", ".false.",
             "Whether a strip that is uniform across, one cell between walls that slip, runs as one row of points; "
             "outputs list all of its points."},
    Variable{"mpm", "edge", text, 1, 4, 1, "", -none, none, choices<EdgeKind>, "'wall'",
             "What the left, right, bottom and top edge of the grid do with gas: 'wall' is what wl, wr, wb, wt say; "
             "through the others it passes, out, or in with the state given below, and the wall code gives way."},
    Variable{"mpm", "edge_density", real, 1, 4, 1, "mass/length3", above_zero, none, "", "",
             "Density of the gas outside edge k; needed at an inflow, at an outflow it goes with edge_energy."},
    Variable{"mpm", "edge_energy", real, 1, 4, 1, "length2/time2", above_zero, none, "", "",
             "Its specific internal energy. At an outflow both say the pressure outside and what comes in should the "
             "flow turn round; without them gas leaves as if the grid went on."},
    Variable{"mpm", "edge_u", real, 1, 4, 1, "length/time", -none, none, "", "0.0",
             "Its velocity in x, at an inflow; needed at the left and right edge."},
    Variable{"mpm", "edge_v", real, 1, 4, 1, "length/time", -none, none, "", "0.0",
             "Its velocity in y, at an inflow; needed at the bottom and top edge."},
    Variable{"mpm", "edge_region", integer, 1, 4, 1, "", 1, region_count, "", "",
             "The region whose gas comes in at edge k, an inflow; else the gas that stands there at the start."},
    Variable{"reference", "solution", text, 0, 1, 1, "", -none, none, choices<ReferenceKind>, "''",
             "Exact solution that the results are compared with."},
    Variable{"reference", "window", real, 1, 2, 1, "length", -none, none, "", "",
             "Part of the tube in which 'riemann' is compared, from x to x. Without it, all that no wave from the ends "
             "has reached when the run ends."},
    Variable{
        "limits", "quality", real, 1, 2, 1, "", 0, none, "", "",
        "Least volume of an element of a body over that at the start, below which a run warns (1) and is stopped "
        "(2). 0.1 and 0.001 where not given, and 1e-9 in place of 0.001 where all bodies are neo-Hookean, whose energy "
        "has no bound there. As in all of this group 0 switches off."},
    Variable{
        "limits", "volume", real, 1, 2, 1, "", 0, none, "", "",
        "Volume of a body against that at the start, the smaller over the larger: warning, stop below. 0.5 and 0.05."},
    Variable{
        "limits", "energy_step", real, 1, 2, 1, "", 0, none, "", "",
        "Rise of the energy in one step (from one record to the next of material points, bars, flows on a mesh and "
        "explicit steps) that no exchange explains, over the largest energy before or exchanged in it: warning, stop "
        "above. 0.5 and 100."},
    Variable{"limits", "energy_growth", real, 1, 2, 1, "", 0, none, "", "",
             "The same rise since the start: warning at the end of the run where it is above this part of the largest "
             "energy exchanged, stop above this multiple of the energy at the start, or of what was booked since. 0.05 "
             "and 100."},
    Variable{"limits", "splitting", real, 1, 2, 1, "", 0, none, "", "",
             "Size of interface_mismatch of a fluid in a box: warning, stop above. 1 and 100."},
    Variable{"limits", "cfl", real, 1, 2, 1, "", 0, none, "", "",
             "Cells that a fluid in a box crosses in a step: warning, stop above. 4 and 0."},
};

}  // namespace tether::added_table
