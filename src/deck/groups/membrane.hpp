// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "deck/variable.hpp"
#include "deck/words.hpp"
#include "laws/elastic.hpp"
#include "model/method.hpp"

namespace tether::membrane_table {

using bounds::above_zero;
using bounds::none;
using enum ValueType;

inline constexpr int nb = membrane_count;
inline constexpr int nc = curve_count;
inline constexpr int nv = curve_vertex_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning
inline constexpr std::array membrane_rows{
    Variable{"membrane", "law", text, 1, nb, 1, "", -none, none, choices<Membrane::Kind>, "'uniaxial'",
             "Law of membrane b (1 is the particle file's, too): stress along the tangent only, or in the whole "
             "surface."},
    Variable{"membrane", "wrinkle", logical, 1, nb, 1, "", -none, none, "", ".true.",
             "One-way law of membrane b: compression carries no force, its strain goes on accumulating."},
    Variable{"membrane", "strain", text, 0, 1, 1, "", -none, none, choices<MembraneStrain>, "",
             "Where strain is measured: by the strain rate at each point (5.2), or by the distance between consecutive "
             "points; the method's choice where it is not given."},
    Variable{"membrane", "normals", text, 0, 1, 1, "", -none, none, choices<NormalRule>, "'connectivity'",
             "Where the normals come from (chapter 7)."},
    Variable{"membrane", "matrix", text, 0, 1, 1, "", -none, none, choices<MatrixScope>, "'cell'",
             "Points that share a mass matrix (7.12): those of a cell, or of the whole membrane."},
    Variable{"membrane", "alone", text, 0, 1, 1, "", -none, none, choices<LonePoint>, "'ghost'",
             "Normal of a point that is alone in its cell: from a ghost cell of four cells (Fig. 88), or the one of "
             "the step before."},
    Variable{
        "membrane", "curve", text, 1, nc, 1, "", -none, none, choices<CurveKind>, "",
        "Kind of curve k. Curves of one membrane are joined in the order of their numbers and seeded with points "
        "at equal distances, each in the middle of its piece, whatever igen is; with them igen=3 needs no particle "
        "file."},
    Variable{"membrane", "body", integer, 1, nc, 1, "", 1, nb, "", "1", "Membrane that curve k belongs to."},
    Variable{"membrane", "x", real, 2, nv, nc, "length", -none, none, "", "",
             "x of vertex v of curve k: 2 for a line, 2 or more for a polyline or a natural cubic spline through them, "
             "which "
             "closes smoothly where its last vertex is its first."},
    Variable{"membrane", "y", real, 2, nv, nc, "length", -none, none, "", "", "y of vertex v of curve k."},
    Variable{"membrane", "xc", real, 1, nc, 1, "length", -none, none, "", "0.0",
             "x of the centre of an arc or ellipse."},
    Variable{"membrane", "yc", real, 1, nc, 1, "length", -none, none, "", "0.0",
             "y of the centre of an arc or ellipse."},
    Variable{"membrane", "a", real, 1, nc, 1, "length", above_zero, none, "", "",
             "Radius of an arc, half axis in x of an ellipse."},
    Variable{"membrane", "b", real, 1, nc, 1, "length", above_zero, none, "", "", "Half axis in y of an ellipse."},
    Variable{"membrane", "from", real, 1, nc, 1, "degrees", -none, none, "", "0.0",
             "Where an arc or ellipse begins, counter-clockwise from x (of an ellipse the parameter's angle)."},
    Variable{"membrane", "to", real, 1, nc, 1, "degrees", -none, none, "", "360.0",
             "Where it ends, a whole turn off at most; below `from` it runs clockwise."},
    Variable{"membrane", "count", integer, 1, nb, 1, "", 2, point_count, "", "", "Points of membrane b."},
    Variable{"membrane", "spacing", real, 1, nb, 1, "length", above_zero, none, "", "",
             "Distance of its points instead, rounded so that a whole number fits."},
    Variable{"membrane", "thickness", real, 1, nb, 1, "length", above_zero, none, "", "",
             "Thickness of membrane b; a point's volume is thickness times distance, about an axis times 2 pi r."},
    Variable{"membrane", "density", real, 1, nb, 1, "mass/length3", above_zero, none, "", "", "Density of membrane b."},
    Variable{"membrane", "young", real, 1, nb, 1, "stress", above_zero, none, "", "", "Young's modulus."},
    Variable{"membrane", "poisson", real, 1, nb, 1, "", -1, 0.5, "", "0.0", "Poisson's ratio."},
    Variable{"membrane", "heavy", real, 2, 2, nb, "mass", above_zero, none, "", "",
             "Mass of the first (1,b) and of the last point (2,b) of membrane b, instead of their own; volume and "
             "density stay."},
    Variable{"membrane", "pinned", text, 1, nb, 1, "", -none, none, choices<PinnedEnds>, "'none'",
             "Ends of membrane b that a pin holds; they are points at the very ends of its curves."},
};

}  // namespace tether::membrane_table
