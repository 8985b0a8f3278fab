// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// Memory that a node of the background grid and a material point take while a scene runs and a checkpoint of it is
/// written [bytes]. The solver asserts that these hold.
constexpr double bytes_per_node = 360;
constexpr double bytes_per_point = 600;
/// The least that a cell of the coupled path takes: velocities on its faces, pressure, smoke, and a row of the system
/// without its factors [bytes].
constexpr double bytes_per_cell = 600;

}  // namespace tether
