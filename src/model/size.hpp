// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// Memory that a node of the background grid and a material point take while a scene runs [bytes]; the solver asserts
/// that its arrays fit in. What the program takes before there is one is added [MB].
constexpr double bytes_per_node = 104;
constexpr double bytes_per_point = 120;
/// What some points have more than others: the fields about them by APIC, what laws of gas, of the deformation gradient
/// and of membranes keep; and the nodes where there is gas [bytes].
constexpr double bytes_of_field = 36, bytes_of_gas = 24, bytes_of_deformation = 88, bytes_of_membrane = 60;
constexpr double bytes_of_gas_node = 40;
constexpr double megabytes_of_program = 30;
/// What contact, strips beyond open edges and a checkpoint that is written take once more [bytes].
constexpr double more_bytes_per_node = 200;
constexpr double more_bytes_per_point = 320;
/// What a point takes for which another one runs: where it began, and where it is written [bytes].
constexpr double bytes_of_strip_point = 100;
/// The least that a cell of the coupled path takes: velocities on its faces, pressure, smoke, and a row of the system
/// without its factors [bytes].
constexpr double bytes_per_cell = 600;

}  // namespace tether
