// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/liquid/hats.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"

namespace tether::liquid {

// Particles and faces exchange velocities by hats of one cell: an affine particle-in-cell method, C. Jiang et al., ACM
// Trans. Graph. 34 (2015) 51, with the affine part that a staggered grid has. Momentum and angular momentum are kept
// both ways.

/// Gives faces the velocities of the particles about them, and returns the volume that reached each face, 0 where none
/// did; there the velocity is 0.
coupled::FaceValues to_faces(Team& team, const StaggeredGrid& grid, const Particles& particles,
                             const CellParticles& cells, coupled::FaceValues& v);

/// Gives particles the velocities of the faces about them, and the slopes of these. All faces about a particle must
/// have a velocity. Between the last faces and a side of the box the velocity is theirs, or goes to 0 where the side
/// holds it; either way these faces get their own velocity back.
void from_faces(Team& team, const StaggeredGrid& grid, const coupled::FaceValues& v, const HeldSides& held,
                Particles& particles);

/// Returns how much of each cell particles fill, by hats of one cell about its middle that walls of the box mirror:
/// 1 where as much volume is as the cell has.
std::vector<double> filling(Team& team, const StaggeredGrid& grid, const Particles& particles,
                            const CellParticles& cells);

}  // namespace tether::liquid
