// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "model/flow.hpp"

namespace tether::flow_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;
inline constexpr int nr = region_count, nl = load_count, nt = table_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array flow_rows{
    Variable{"flow", "element", text, 0, 1, 1, "", -none, none, choices<FlowElement>, "'q2q1'",
             "Elements of the fluid: bilinear velocity and pressure, stabilised, or biquadratic velocity and bilinear "
             "pressure. Those of immersed bodies are element of $mesh."},
    Variable{
        "flow", "stabilisation", real, 0, 1, 1, "", 0, none, "", "1.0",
        "Factor of what stabilises q1q1, of which 1 is published; with 0 nothing does, and pressures may swing from "
        "node to node."},
    Variable{"flow", "integrator", text, 0, 1, 1, "", -none, none, choices<FlowIntegrator>, "'midpoint'",
             "Time step of the fluid: the mid-point rule or backward Euler."},
    Variable{
        "flow", "steady", logical, 0, 1, 1, "", -none, none, "", ".false.",
        "Whether each step is a steady flow, of the deck's Reynolds number, or with bodies of its loads and prescribed "
        "velocities, times t/tmax: tmax/tstep steps lead up to it."},
    Variable{"flow", "linearisation", text, 0, 1, 1, "", -none, none, choices<Linearisation>, "'newton'",
             "What a correction takes of the convective term's derivative: all of it, or the part that carries the "
             "velocity along."},
    Variable{"flow", "tolerance", real, 0, 1, 1, "", 1e-14, 1e-2, "", "1e-6",
             "Of Newton's or Picard's method: the forces' residual over the largest of them."},
    Variable{
        "flow", "solver", text, 0, 1, 1, "", -none, none, choices<Systems>, "'auto'",
        "How the corrections' linear systems are solved: by factors, by GMRES, or auto: by GMRES where a flow that "
        "is not steady and has no bodies has more than 200,000 unknowns."},
    Variable{"flow", "speed", real, 0, 1, 1, "velocity", above_zero, none, "", "",
             "Speed of the Reynolds number and of the coefficients of drag and lift."},
    Variable{"flow", "length", real, 0, 1, 1, "length", above_zero, none, "", "", "Length of the same."},
    Variable{"flow", "boundary_on", text, 1, nl, 1, "", -none, none, "", "",
             "Side of the fluid's boundary that condition k holds on; what none names is a wall at rest."},
    Variable{"flow", "boundary", text, 1, nl, 1, "", -none, none, choices<Boundary>, "",
             "What side k is: a wall at rest, a wall along x or y without friction, a wall that moves along itself, a "
             "prescribed velocity, an outflow, or the image of another side."},
    Variable{"flow", "outside", text, 0, 1, 1, "", -none, none, choices<FlowOutside>, "'fluid'",
             "What is beyond open sides: fluid at rest, whose pressure grows with the depth where gravc acts, or "
             "nothing, of a pressure of zero."},
    Variable{"flow", "level", real, 0, 1, 1, "length", -none, none, "", "",
             "Height at which that fluid has a pressure of zero; the highest y of the fluid's mesh where it is not "
             "given."},
    Variable{"flow", "boundary_u", text, 1, nl, 1, "velocity", -none, none, "", "",
             "Velocity in x on side k, a moving wall or an inflow, as an expression in x, y, t; 0 where boundary_v "
             "alone is given."},
    Variable{"flow", "boundary_v", text, 1, nl, 1, "velocity", -none, none, "", "", "The same in y."},
    Variable{"flow", "boundary_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of a table that the velocity on side k is multiplied by, as load_time of $fem."},
    Variable{"flow", "boundary_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of it at these times."},
    Variable{"flow", "boundary_with", text, 1, nl, 1, "", -none, none, "", "",
             "The side that the periodic side k is joined with, moved in parallel, node by node."},
    Variable{"flow", "u0", text, 0, 1, 1, "velocity", -none, none, "", "",
             "Velocity in x at the start as an expression in x, y, t = 0; vrx of the fluid's first region where it is "
             "not given."},
    Variable{"flow", "v0", text, 0, 1, 1, "velocity", -none, none, "", "", "The same in y, or vry."},
    Variable{"flow", "bx", text, 0, 1, 1, "acceleration", -none, none, "", "",
             "Acceleration in x by a body force as an expression in x, y, t, which is added to gravc of $in."},
    Variable{"flow", "by", text, 0, 1, 1, "acceleration", -none, none, "", "", "The same in y."},
    Variable{
        "flow", "force_on", text, 1, 10, 1, "", -none, none, "", "",
        "What force k is recorded on: a side of the fluid's boundary, with what bodies' clamps give it, 'body 1' or a "
        "side of a body, or several of these joined by +, taken as one."},
    Variable{"flow", "force_x", real, 1, 10, 1, "length", -none, none, "", "0.0",
             "x of the place about which its torque is taken."},
    Variable{"flow", "force_y", real, 1, 10, 1, "length", -none, none, "", "0.0", "y of that place."},
    Variable{"flow", "probe", real, 2, 2, 100, "length", -none, none, "", "",
             "x and y of place k, at which velocity and pressure are recorded."},
    Variable{"flow", "difference", integer, 2, 2, 20, "", 1, 100, "", "",
             "Numbers of two probes: the pressure of the first less the second's is recorded."},
    Variable{"flow", "tracers", integer, 1, 2, 1, "", 1, 1000, "", "",
             "Numbers of tracers along x and y, at the middles of equal parts of a box, which go with the fluid."},
    Variable{"flow", "tracer_box", real, 1, 4, 1, "length", -none, none, "", "",
             "That box, xleft, xright, ybot, ytop; the fluid's extent where it is not given."},
    Variable{
        "flow", "volume", text, 1, nr, 1, "", -none, none, choices<VolumeOf>, "'own'",
        "What holds the volume of the immersed region r: its own law, or the fluid's pressure, as of bodies that do "
        "not change it; that of fibres always."},
    Variable{"flow", "penalty", real, 1, nr, 1, "stress", 0, none, "", "0.0",
             "Volumetric penalty of the immersed region r, which holds its area together."},
};

}  // namespace tether::flow_table
