// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "results/results.hpp"
#include "solvers/fem/bars.hpp"

namespace tether::fem {

/// What bars can write: the history's columns, a record of them, and fields of the points. Columns that the paths share
/// have the same names on all of them.
///
/// Central differences with steps of one length keep, of linear bars, K + U - dt^2 sum f^2 / (8 m) to the last digits,
/// the work of gravity within U: it is the product of the velocities half a step before and after in K. What velocity
/// and place alone say swings about it by the square of dt omega. The third part has its own column, and the total is
/// the sum of all, in which a real loss then shows.
HistoryLayout history_layout(const Scene& scene);
/// `dt` is the length of the steps around the present time.
Record record(const BarState& state, const BarArrays& bars, const Scene& scene, double dt);
Snapshot point_fields(const BarState& state, const BarArrays& bars, const Scene& scene);

/// sum f^2 / m over all that moves [force2/mass].
double squared_forces_per_mass(const BarState& state, const Scene& scene);

}  // namespace tether::fem
