// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// Memory that a node of the background grid and a material point take while a scene runs [bytes]; the solver asserts
/// that its arrays fit in. What the program takes before there is one is added [MB].
constexpr double bytes_per_node = 160;
constexpr double bytes_per_point = 300;
constexpr double megabytes_of_program = 25;
/// What contact, strips beyond open edges and a checkpoint that is written take once more [bytes].
constexpr double more_bytes_per_node = 200;
constexpr double more_bytes_per_point = 320;
/// The least that a cell of the coupled path takes: velocities on its faces, pressure, smoke, and a row of the system
/// without its factors [bytes].
constexpr double bytes_per_cell = 600;

}  // namespace tether
