// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tether::contact {

/// How bodies touch at the end of a step.
struct ContactNumbers {
  double energy = 0;     ///< stored between surfaces [energy]
  double rubbed = 0;     ///< that friction took in the step [energy]
  double least_gap = 0;  ///< between surfaces that press each other; 0 where none do [length]
  double pressing = 0;   ///< sum of the sizes of the forces across surfaces [force]
  double slid = 0;       ///< farthest that damped surfaces which press slid past each other in the step [length]
  double sides = 0;      ///< how many of the bodies' sides are nearer to a surface than the gap
  // A number a node: means of what the points of quadrature near it feel.
  std::vector<double> pressure, friction;  ///< per area of the shape at the start [stress]
  std::vector<double> distance;            ///< least one from another surface, at most the gap [length]
};

}  // namespace tether::contact
