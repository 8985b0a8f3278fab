// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"

namespace tether::liquid {

/// Returns for each cell the largest speed of the faces of it and of the cells about it, by the largest of each axis.
std::vector<double> fastest_about(const StaggeredGrid& grid, const coupled::FaceValues& v);

/// Slows down particles of pieces thinner than two cells to what a step can have made of speeds about them: `fastest`
/// before pressures acted, `more` by forces and bodies. A face between liquid and air moves but a part of its box, and
/// what presses there makes it as fast as the flux asks; in such a piece particles of the whole box take that speed,
/// and drops that hit a wall would gain many times their energy.
void limit_thin_pieces(Team& team, const StaggeredGrid& grid, std::span<const double> distance,
                       std::span<const double> fastest, double more, Particles& particles);

}  // namespace tether::liquid
