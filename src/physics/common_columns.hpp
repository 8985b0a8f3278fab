// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "fields/columns.hpp"

namespace tether {

// Columns that the physics share, and what of a record they are read from. Vectors have three components, of which a
// plane scene uses two.

using Components = std::array<double, 3>;

/// Sums over a body.
struct BodySums {
  double mass = 0;
  Components place{}, velocity{};  ///< of its centre of mass
};

struct TrackedSums {
  Components place{}, velocity{};
};

/// What all records have. A physics derives its own from it.
struct CommonSums {
  double time = 0, dt = 0;                                                 ///< dt: of the last step [time]
  double kinetic = 0, strain = 0, internal = 0, potential = 0, total = 0;  ///< [energy]
  double mass = 0;
  Components momentum{}, angular{};  ///< angular: about the origin
  std::vector<BodySums> bodies;
  std::vector<TrackedSums> tracked;
};

using CommonGroup = ColumnGroup<ColumnSetting, CommonSums>;

/// Returns the angle of the line from the first to the last tracked point, from the downward vertical [degrees].
double tracked_angle(const CommonSums& sums);

/// Time, dt and the energies up to their sum.
CommonGroup energy_columns();
/// Mass and momentum.
CommonGroup momentum_columns();
/// Angular momentum, which has one component in the plane.
CommonGroup plane_spin_column();
CommonGroup spin_columns();
/// Centre of mass, its velocity and the mass of each body.
CommonGroup body_columns();
/// Place and velocity of each tracked point.
CommonGroup tracked_columns();
/// Angle of the line from the first to the last tracked point from the downward vertical, where the setting asks for
/// it.
template <class Setting, class Sums>
ColumnGroup<Setting, Sums> angle_column(typename When<Setting>::Count asked) {
  return {{"with `iout(38)`", std::move(asked)},
          {{"tracked_angle", Dimension::angle,
            "angle from the downward vertical of the line from the first to the last tracked point", &tracked_angle}}};
}

const When<ColumnSetting>& in_space();
const When<ColumnSetting>& in_plane();

}  // namespace tether
