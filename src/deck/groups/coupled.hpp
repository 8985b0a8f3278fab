// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "model/coupled.hpp"
#include "model/flow.hpp"

namespace tether::coupled_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;
inline constexpr int nl = load_count, nt = table_count;
inline constexpr std::string_view sides = "left|right|bottom|top|back|front";

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array coupled_rows{
    Variable{"coupled", "mode", text, 0, 1, 1, "", -none, none, choices<CouplingMode>, "'cut-cell'",
             "How fluid and solids are solved: simultaneously by one map and its transpose, with the open parts of "
             "faces; the same with cells that are wholly fluid or solid; one after the other; or simultaneously by two "
             "maps as in the paper."},
    Variable{"coupled", "flow", text, 0, 1, 1, "", -none, none, choices<FlowCells>, "'grid'",
             "What the fluid's cells are: those of the grid; or triangles, in space tetrahedra, that fit bodies and "
             "obstacles and are made anew as bodies move."},
    Variable{"coupled", "size", real, 0, 1, 1, "length", above_zero, none, "", "",
             "Edges of the cells of flow='mesh' far from bodies, obstacles and jets; the shorter of a cell's sides "
             "where it is not given."},
    Variable{"coupled", "size_near", real, 0, 1, 1, "length", above_zero, none, "", "",
             "Their most at bodies, obstacles and jets; size where it is not given. Sides of a body that are shorter "
             "are edges as they are."},
    Variable{"coupled", "growth", real, 0, 1, 1, "", 0.05, 1, "", "0.3",
             "By how much edges of flow='mesh' may grow from the surface on, over the way."},
    Variable{"coupled", "step", text, 0, 1, 1, "", -none, none, choices<SolidsStep>, "'auto'",
             "How a step finds where solids go: by one linear solution, as the paper's; by Newton's method with forces "
             "that keep the energy, which bodies that meet by $contact need, and stiff ones that turn; or auto: linear "
             "unless bodies meet or would gain by turning at the start."},
    Variable{"coupled", "integrator", text, 0, 1, 1, "", -none, none, choices<CoupledIntegrator>, "'paper'",
             "Linear step of the solids: the paper's, of order 1 in the velocity, or the trapezoidal rule."},
    Variable{"coupled", "advection", text, 0, 1, 1, "", -none, none, choices<Advection>, "'maccormack'",
             "How the fluid carries its velocity along: of order 1, or corrected to order 2 and limited."},
    Variable{"coupled", "solver", text, 0, 1, 1, "", -none, none, choices<Systems>, "'auto'",
             "How the linear systems are solved: by factors, by conjugate gradients, or auto: as dimension and size "
             "ask."},
    Variable{"coupled", "tolerance", real, 0, 1, 1, "", 1e-15, 1e-2, "", "1e-12",
             "Of conjugate gradients and BiCGSTAB: residual over the right side. Powers of fluid and solids agree to "
             "about a thousand times as much."},
    Variable{"coupled", "density", real, 0, 1, 1, "mass/length3", above_zero, none, "", "",
             "Density of the fluid, which $coupled must give."},
    Variable{"coupled", "viscosity", real, 0, 1, 1, "stress time", 0, none, "", "0.0", "Viscosity mu of the fluid."},
    Variable{
        "coupled", "bodies_slip", logical, 0, 1, 1, "", -none, none, "", ".true.",
        "Whether a fluid with viscosity slips along bodies; else it sticks to them, as to walls and obstacles, and "
        "drags them along."},
    Variable{"coupled", "nz", integer, 0, 1, 1, "", 2, 1e9, "", "",
             "Nodes of the grid in z; with it the problem is three-dimensional, and so is $mesh. Cells along x and y "
             "are nx - 1 and ny - 1 of $in."},
    Variable{"coupled", "zback", real, 0, 1, 1, "length", -none, none, "", "", "Lowest z of the box."},
    Variable{"coupled", "zfront", real, 0, 1, 1, "length", -none, none, "", "", "Highest z of the box."},
    Variable{"coupled", "side", text, 1, 6, 1, "", -none, none, choices<BoxSide>, "'wall'",
             "What the box's left, right, bottom, top, back and front are: walls, which a fluid with viscosity sticks "
             "to; walls that it slips along; open to fluid at rest, whose pressure grows with the depth where gravc "
             "acts; or open with "
             "nothing beyond, at a pressure of zero."},
    Variable{"coupled", "level", real, 0, 1, 1, "length", -none, none, "", "",
             "Height at which the fluid beyond open sides has a pressure of zero, as voids have it; ytop where it is "
             "not given."},
    Variable{"coupled", "open_on", text, 1, nl, 1, "", -none, none, sides, "",
             "Side of the box that opening k is in: a part of it that is open as a whole side is. Bodies are stopped "
             "there as by the rest of the side."},
    Variable{"coupled", "open", real, 2, 4, nl, "length", -none, none, "", "",
             "Its part of that side, given as that of a jet and with parts of faces likewise."},
    Variable{"coupled", "jet_on", text, 1, nl, 1, "", -none, none, sides, "",
             "Side of the box through which jet k comes in. Of two jets through a face the later one has it."},
    Variable{"coupled", "jet", real, 2, 4, nl, "length", -none, none, "", "",
             "Its part of that side: lowest and highest place along the side's first axis, and in space along its "
             "second, in the order x, y, z; the whole side where they are not given. A face of the grid that it has "
             "but a part of takes that part of its speed, so that its flux is the deck's."},
    Variable{"coupled", "jet_speed", real, 1, nl, 1, "velocity", -none, none, "", "", "Speed of jet k into the box."},
    Variable{"coupled", "jet_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of a table that the speed is multiplied by, as load_time of $fem."},
    Variable{"coupled", "jet_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of it at these times."},
    Variable{"coupled", "jet_expression", text, 1, nl, 1, "", -none, none, "", "",
             "Factor of the speed as an expression in t, in place of a table."},
    Variable{"coupled", "jet_smoke", real, 1, nl, 1, "", 0, none, "", "0.0", "Density of the smoke that jet k brings."},
    Variable{"coupled", "jet_temperature", real, 1, nl, 1, "", -none, none, "", "0.0",
             "Temperature that it brings, above that of the surroundings."},
    Variable{"coupled", "smoke_box", real, 2, 6, nl, "length", -none, none, "", "",
             "Box k that holds smoke at the start: its lowest and highest x, y and, in space, z. A cell that lies in "
             "it in part has that part of the smoke; boxes that overlap add up."},
    Variable{"coupled", "box_smoke", real, 1, nl, 1, "", 0, none, "", "0.0", "Density of the smoke in it."},
    Variable{"coupled", "box_temperature", real, 1, nl, 1, "", -none, none, "", "0.0",
             "Temperature in it, above that of the surroundings."},
    Variable{"coupled", "obstacle", real, 2, 6, nl, "length", -none, none, "", "",
             "Obstacle k at rest, which neither fluid nor solids enter: its lowest and highest x, y and, in space, z. "
             "For the fluid of a grid it is made of the cells whose middles lie in it; solids, and the cells of "
             "flow='mesh', stop at the box as it is given."},
    Variable{"coupled", "obstacle_ellipse", real, 2, 6, nl, "length", -none, none, "", "",
             "Obstacle k as an ellipse or ellipsoid along the axes, by the box about it, given likewise. As those that "
             "follow it cuts the cells at its surface."},
    Variable{"coupled", "obstacle_polygon", real, 2, 2 * nt, nl, "length", -none, none, "", "",
             "Obstacle k as a polygon: x and y of its corners in turn; in space a prism along all of z."},
    Variable{"coupled", "obstacle_plane", real, 2, 6, nl, "", -none, none, "", "",
             "Obstacle k as all on one side of a line or plane: a place on it, and the direction from there into the "
             "fluid; x and y of each in the plane, x, y and z in space."},
    Variable{"coupled", "void", real, 2, 6, nl, "length", -none, none, "", "",
             "Box k without fluid, of pressure zero, given and made likewise."},
    Variable{"coupled", "fluid_in", text, 0, 1, 1, "", -none, none, choices<FluidIn>, "'box'",
             "Where the fluid is: in all of the box, or only where solids enclose it, with nothing around them."},
    Variable{
        "coupled", "gravity_x", real, 0, 1, 1, "acceleration", -none, none, "", "0.0",
        "Acceleration along x of fluid and bodies, together with gravc of $in along y: of a box that leans. Sides that "
        "are open to fluid at rest have none."},
    Variable{"coupled", "liquid", logical, 0, 1, 1, "", -none, none, "", ".false.",
             "Whether the fluid is a liquid with a surface: it fills the regions given for it at the start and what "
             "jets bring, and air has the rest of the box."},
    Variable{"coupled", "liquid_box", real, 2, 6, nl, "length", -none, none, "", "",
             "Region k of liquid at the start as a box: its lowest and highest x, y and, in space, z. Of regions that "
             "overlap the first has a place; bodies and obstacles have it before them."},
    Variable{"coupled", "liquid_ellipse", real, 2, 6, nl, "length", -none, none, "", "",
             "Region k as an ellipse or ellipsoid along the axes, by the box about it, given likewise."},
    Variable{"coupled", "liquid_polygon", real, 2, 2 * nt, nl, "length", -none, none, "", "",
             "Region k as a polygon: x and y of its corners in turn; in space a prism along all of z."},
    Variable{"coupled", "liquid_below", text, 1, nl, 1, "", -none, none, "", "",
             "Region k as all that lies below a height: an expression in x and, in space, z."},
    Variable{"coupled", "liquid_where", text, 1, nl, 1, "", -none, none, "", "",
             "Region k as all places where an expression in x, y and, in space, z holds: 'x^2+y^2<1 && y<0.5'."},
    Variable{"coupled", "liquid_velocity", real, 2, 3, nl, "velocity", -none, none, "", "0.0",
             "Velocity of region k at the start, along x, y and z, in place of u0, v0 and w0."},
    Variable{"coupled", "liquid_particles", integer, 0, 1, 1, "", 2, 6, "", "",
             "Particles along each axis of a cell that liquid fills; 3 in the plane and 2 in space where it is not "
             "given."},
    Variable{
        "coupled", "liquid_jitter", real, 0, 1, 1, "", 0, 1, "", "0.0",
        "How far particles stand off their lattice at the start: at 1 each is anywhere in its own part of a cell."},
    Variable{"coupled", "air", text, 0, 1, 1, "", -none, none, choices<Air>, "'void'",
             "What air is to the liquid: nothing, at a pressure of zero, so that bubbles collapse; or a volume that "
             "stays wherever liquid, bodies and walls close it in."},
    Variable{"coupled", "u0", real, 0, 1, 1, "velocity", -none, none, "", "0.0",
             "Velocity of the fluid in x at the start."},
    Variable{"coupled", "v0", real, 0, 1, 1, "velocity", -none, none, "", "0.0", "The same in y."},
    Variable{"coupled", "w0", real, 0, 1, 1, "velocity", -none, none, "", "0.0", "The same in z."},
    Variable{"coupled", "smoke_weight", real, 0, 1, 1, "acceleration", 0, none, "", "0.0",
             "Acceleration downwards by a smoke density of 1. Smoke is there when a jet brings density or "
             "temperature, or a box holds it at the start."},
    Variable{"coupled", "smoke_lift", real, 0, 1, 1, "acceleration", 0, none, "", "0.0",
             "Acceleration upwards by a temperature of 1."},
    Variable{
        "coupled", "contact", logical, 0, 1, 1, "", -none, none, "", ".true.",
        "Whether walls and obstacles stop solids. Steps that keep the energy stop them, and each other, by $contact."},
    Variable{"coupled", "friction", real, 0, 1, 1, "", 0, none, "", "0.0", "Coulomb's coefficient of that contact."},
    Variable{"coupled", "volume_term", logical, 0, 1, 1, "", -none, none, "", ".true.",
             "Whether the volumes of regions that solids and walls enclose are held."},
    Variable{"coupled", "area_repair", logical, 0, 1, 1, "", -none, none, "", ".true.",
             "Whether mode='splitting' balances the velocities of the walls of enclosed regions."},
    Variable{"coupled", "convex", logical, 0, 1, 1, "", -none, none, "", ".true.",
             "Whether the elements' stiffness is made positive semi-definite."},
    Variable{"coupled", "spring_on", text, 1, nl, 1, "", -none, none, "", "",
             "Side of the mesh, or 'region r', whose nodes spring k pulls back to where they were at the start."},
    Variable{"coupled", "spring", real, 2, 3, nl, "force/length", 0, none, "", "0.0",
             "Its stiffness in x, y and z, of all these nodes together."},
    Variable{"coupled", "hinge", real, 2, 3, nl, "length", -none, none, "", "",
             "x and y of hinge k: the solids' nearest node does not move; in space that goes for all nodes of the same "
             "x and y, about which a body can turn, and z does not count."},
};

}  // namespace tether::coupled_table
