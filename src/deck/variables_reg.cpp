// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "deck/variable_groups.hpp"
#include "deck/words.hpp"

namespace tether {
namespace {

using bounds::above_zero;
using bounds::largest_integer;
using bounds::none;
using bounds::smallest_integer;
using enum ValueType;

constexpr int nr = region_count;
constexpr int nv = vertex_count;

// group, name, type, rank, n1, n2, unit, low, high, choices, default, meaning[, effect]
constexpr std::array rows{
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
    Variable{"reg", "matr", real, 2, nr, nr, "", -none, none, "", "0.0",
             "Constants of region r: matr(1,r) is E, or beta of a linear fluid [stress]; matr(2,r) is nu; matr(3..7,r) "
             "are read and have no effect."},
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

}  // namespace

std::span<const Variable> region_variables() { return rows; }

}  // namespace tether
