// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "physics/bars/bars.hpp"
#include "physics/common_columns.hpp"
#include "results/results.hpp"

namespace tether::fem {

struct BarSetting : ColumnSetting {
  bool tracked_angle = false;
};

/// What a record of bars is made from.
struct BarSums : CommonSums {
  double of_step = 0;  ///< -dt^2 sum f^2 / (8 m) [energy]
};

/// Lists what bars can write: the history's columns, those of a scene and what a record of them is made from, and
/// fields of the points.
///
/// Central differences with steps of one length keep, of linear bars, K + U - dt^2 sum f^2 / (8 m) to the last digits,
/// the work of gravity within U: it is the product of the velocities half a step before and after in K. What velocity
/// and place alone say swings about it by the square of dt omega. The third part has its own column, and the total is
/// the sum of all, in which a real loss then shows.
const ColumnTable<BarSetting, BarSums>& bar_table();
Columns<BarSums> bar_columns(const Scene& scene);
/// `dt` is the length of the steps around the present time.
BarSums sums_of(const BarState& state, const BarArrays& bars, const Scene& scene, double dt);
Snapshot point_fields(const BarState& state, const BarArrays& bars, const Scene& scene);

/// sum f^2 / m over all that moves [force2/mass].
double squared_forces_per_mass(const BarState& state, const Scene& scene);

}  // namespace tether::fem
