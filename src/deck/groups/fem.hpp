// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "laws/hyperelastic.hpp"
#include "model/solids.hpp"

namespace tether::fem_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;
inline constexpr int nr = region_count, nl = load_count, nt = table_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array fem_rows{
    Variable{"mesh", "element", text, 0, 1, 1, "", -none, none, body_elements, "'q2'",
             "Elements of all regions but a fluid's: quadrilaterals or hexahedra (q), triangles or tetrahedra (p), of "
             "order 1 or 2."},
    Variable{
        "mesh", "file", text, 0, 1, 1, "", -none, none, "", "''",
        "ASCII mesh file of Gmsh (version 2.2 or 4.1), as a path from the deck's folder, at most one folder up; in "
        "place of blocks."},
    Variable{"mesh", "file_sha256", text, 0, 1, 1, "", -none, none, "", "''",
             "SHA-256 of that file as deck.effective has it: another content is an error."},
    Variable{"mesh", "physical", text, 1, nr, 1, "", -none, none, "", "''",
             "Name of the physical group of that file that is region r; without a name it is the one of tag r."},
    Variable{"mesh", "cells", integer, 2, 3, nr, "", 1, 100000, "", "1",
             "Cells of region r along its first edge (vertex 1 to 2), its second (2 to 3) and z."},
    Variable{"mesh", "grading", real, 2, 3, nr, "", above_zero, none, "", "1.0",
             "Last cell over first along the same; sizes grow by a constant ratio."},
    Variable{
        "mesh", "grading_middle", real, 2, 3, nr, "", above_zero, none, "", "1.0",
        "Middle cells over those at both ends along the same, in place of grading: above 1 cells are finest at both "
        "ends, below 1 in the middle; sizes are symmetric and grow by a constant ratio."},
    Variable{"mesh", "z", real, 2, 2, nr, "length", -none, none, "", "",
             "Lowest and highest z of region r; with them the mesh is three-dimensional."},
    Variable{"mesh", "edge", text, 2, 4, nr, "", -none, none, choices<MeshEdge>, "'line'",
             "Shape of edge k of region r, from vertex k to the next: an arc about a centre goes the shorter way."},
    Variable{"mesh", "edge_xc", real, 2, 4, nr, "length", -none, none, "", "0.0", "x of the centre of a curved edge."},
    Variable{"mesh", "edge_yc", real, 2, 4, nr, "length", -none, none, "", "0.0", "y of the centre of a curved edge."},
    Variable{"mesh", "edge_a", real, 2, 4, nr, "length", above_zero, none, "", "", "Half axis in x of an ellipse."},
    Variable{"mesh", "edge_b", real, 2, 4, nr, "length", above_zero, none, "", "", "Half axis in y of an ellipse."},
    Variable{"mesh", "side", text, 2, 6, nr, "", -none, none, "", "''",
             "Names of region r's sides on edges 1 to 4, at the lowest and at the highest z. Several sides may share a "
             "name; each is also '<r>.bottom', '.right', '.top', '.left', '.back', '.front' in that order."},
    Variable{"mesh", "tracked_z", real, 1, tracked_at_count, 1, "length", -none, none, "", "0.0",
             "z of the place tracked_at(:,k) of $points."},
    Variable{"fem", "integrator", text, 0, 1, 1, "", -none, none, choices<Integrator>, "'energy'",
             "Time step of solids: the discrete gradient, which keeps energy and momenta at any step, the mid-point "
             "rule, Newmark's trapezoidal rule, or central differences (explicit, lumped masses)."},
    Variable{"fem", "static", logical, 0, 1, 1, "", -none, none, "", ".false.",
             "Whether each step is an equilibrium with the loads of its end, without inertia; loads and prescribed "
             "displacements without a table then grow in proportion to time, to their full size at tmax."},
    Variable{
        "fem", "dilatation", text, 0, 1, 1, "", -none, none, choices<Dilatation>, "'auto'",
        "What laws take for the change of volume: that at each point, or its mean over an element, which does not "
        "lock where nu is near 0.5; auto: the mean, with p2 from nu = 1/3 on (0.35 in space). Plane stress, fibres "
        "and p1 have that at each point."},
    Variable{"fem", "law", text, 1, nr, 1, "", -none, none, mesh_laws, "'svk'",
             "Law of region r: small strains, St Venant-Kirchhoff, compressible neo-Hookean, all by matr(1,r) = E and "
             "matr(2,r) = nu in plane strain (ipath(4,r) = 0), plane stress (2) or space; a hoop fibre of modulus "
             "matr(1,r); or an incompressible fluid of viscosity matr(1,r), in which the other regions are immersed."},
    Variable{"fem", "volumetric", text, 1, nr, 1, "", -none, none, choices<Volumetric>, "'log'",
             "What a neo-Hookean body's change of volume costs: lambda/2 ln(J)^2, lambda/2 (J-1)^2 or lambda/4 (J^2 - "
             "1 - 2 ln J)."},
    Variable{"fem", "fibre_x", real, 1, nr, 1, "length", -none, none, "", "0.0",
             "x of the axis that the fibres of region r go around."},
    Variable{"fem", "fibre_y", real, 1, nr, 1, "length", -none, none, "", "0.0", "y of that axis."},
    Variable{"fem", "vrz", real, 1, nr, 1, "velocity", -none, none, "", "0.0",
             "Velocity of region r in z at the start; vrx and vry of $reg are those in x and y."},
    Variable{"fem", "spin", real, 2, 3, nr, "1/time", -none, none, "", "0.0",
             "Angular velocity of region r about its centre of mass at the start; in the plane the third counts."},
    Variable{"fem", "settle", logical, 0, 1, 1, "", -none, none, "", ".false.",
             "Whether the run starts in equilibrium with the loads of t = 0."},
    Variable{
        "fem", "load_on", text, 1, nl, 1, "", -none, none, "", "",
        "What load k acts on: a side, force per area of the shape at the start; 'region r', force per volume; or a "
        "set of nodes of the mesh file, force at each node (in the plane per depth)."},
    Variable{"fem", "load", real, 2, 3, nl, "stress", -none, none, "", "0.0",
             "Components of load k, which keep their direction."},
    Variable{"fem", "pressure", real, 1, nl, 1, "stress", -none, none, "", "0.0",
             "Pressure of load k, that pushes against its side as the side lies at the time; it pulls where it is "
             "below 0. Its factor over time is that of load k."},
    Variable{"fem", "load_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of load k's table; between them the factor is linear, outside constant."},
    Variable{"fem", "load_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of load k at these times."},
    Variable{"fem", "load_expression", text, 1, nl, 1, "", -none, none, "", "",
             "Factor of load k as an expression in t, in place of a table."},
    Variable{"fem", "fix_on", text, 1, nl, 1, "", -none, none, "", "",
             "Side, or set of nodes of the mesh file, whose nodes support k holds or moves."},
    Variable{"fem", "fix", real, 2, 3, nl, "length", -none, none, "", "",
             "Displacement that support k prescribes in x, y, z; a direction that is not given stays free."},
    Variable{"fem", "fix_time", real, 2, nt, nl, "time", -none, none, "", "",
             "Ascending times of support k's table, as load_time."},
    Variable{"fem", "fix_factor", real, 2, nt, nl, "", -none, none, "", "", "Factors of its displacement."},
    Variable{"fem", "fix_expression", text, 1, nl, 1, "", -none, none, "", "",
             "Factor of support k as an expression in t, in place of a table."},
    Variable{"fem", "alpha", real, 0, 1, 1, "1/time", 0, none, "", "0.0", "Damping in proportion to the mass."},
    Variable{"fem", "beta", real, 0, 1, 1, "time", 0, none, "", "0.0",
             "Damping in proportion to the stiffness of the shape at the start."},
    Variable{"fem", "tolerance", real, 0, 1, 1, "", 1e-14, 1e-3, "", "1e-11",
             "Of Newton's method: the forces' residual over the largest of them."},
    Variable{"fem", "cfl", real, 0, 1, 1, "", 0, none, "", "0.9",
             "Factor of the step limit of explicit steps, 2 over the highest frequency; 0 takes the deck's step as it "
             "is."},
};

inline constexpr std::array rigid_rows{
    Variable{"rigid", "form", text, 0, 1, 1, "", -none, none, choices<RigidForm>, "'reduced'",
             "How a step of the rigid body is solved: in the null space of the constraints (6 unknowns, 3 with a pin), "
             "or with 12 coordinates and a multiplier for each constraint (18, 21). Both give one motion."},
    Variable{"rigid", "point", real, 1, 3, 1, "length", -none, none, "", "",
             "Reference point of the body's coordinates, anywhere; its centre of mass where it is not given."},
    Variable{"rigid", "directors", real, 2, 3, 3, "length", -none, none, "", "",
             "Components of the three directors; they must be independent, not orthogonal. One that is not given is "
             "the unit vector of its axis."},
    Variable{"rigid", "pin", real, 1, 3, 1, "length", -none, none, "", "",
             "A place in the body, or next to it, that is held; the body turns about it without friction."},
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

}  // namespace tether::fem_table
