// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physics/box/outside.hpp"

namespace tether::coupled {

/// Blends the fluid about cut faces, as it passes in a step.
///
/// A pressure moves the fluid of a face as fast, however little a solid leaves there. No path leads to such a face but
/// from itself, so that it would be faster step by step; and what is carried to whole faces beside it takes its
/// velocity for theirs, which multiplies its energy. In truth little fluid is swept along by much: in the time in which
/// the fastest of them crosses a cell, a face takes, for the part that it lacks, the mean of its own velocity and those
/// of the faces beside it that fluid joins it to, by their volumes. A difference of pressure dp then makes a jet of
/// sqrt(dp/rho), at steps of any length. Whole faces keep their velocities, and none leaves the bounds of those that
/// were.
void blend_cut_faces(const FlowDomain& domain, double h, FaceValues& v);
/// Does the same where `room` has how solids cut the faces, and `domain` what of it flows.
void blend_cut_faces(const FlowDomain& domain, const FlowDomain& room, double h, FaceValues& v);

/// Gives the faces that solids close velocities of the fluid around, so that a face that opens has one: layer after
/// layer, the mean of the neighbours, on the lattice of the same axis, that have one already. Open and prescribed faces
/// keep theirs; what no layer reaches becomes 0. A layer's faces are independent of each other.
void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers);

/// Does the same for pressures, a number a cell: cells of solids and obstacles get those of the fluid around, so that a
/// cell that fluid comes into has one.
void extend_pressure(const FlowDomain& domain, std::vector<double>& p, int layers);

/// Does the same for the values of any lattice of a grid, some of which are known. Where two known ones are in a row,
/// their line goes on beyond them, but by no more than `most_change`. Returns which are known then.
std::vector<std::uint8_t> extend_known(int dim, const std::array<int, 3>& size, std::vector<std::uint8_t> known,
                                       int layers, std::vector<double>& values, double most_change = 0);

}  // namespace tether::coupled
