// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "physics/box/outside.hpp"

namespace tether::liquid {

/// Gives the faces about the liquid velocities, so that particles there have one: two layers of faces by lines through
/// those nearer the liquid (a constant extension is of order 1 and costs a wave ten times the error); beyond them faces
/// that particles reached keep what these gave them, which fall freely; then `layers` more of the mean of those next to
/// them. Walls keep theirs and give none away. `room` is the domain without the surface, `liquid` that with it,
/// `reached` the volume of particles at each face.
void extend_about_liquid(const coupled::FlowDomain& room, const coupled::FlowDomain& liquid,
                         std::span<const double> distance, const coupled::FaceValues& reached, int layers,
                         coupled::FaceValues& v);

}  // namespace tether::liquid
