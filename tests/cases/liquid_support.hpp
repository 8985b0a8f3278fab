// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

namespace tether::cases {

/// The group $in of a box of square cells, with gravity of 1 and a record a step.
inline std::string box(int nx, int ny, double cell, double step, double tmax) {
  return fmt::format(
      "$in nx={}, ny={}, xleft=0., xright={:.17g}, ybot=0., ytop={:.17g}, tstep={:.17g}, tmax={:.17g}, gravc=-1., "
      "iout(33)=1, tiout(33)={:.17g} $\n",
      nx + 1, ny + 1, nx * cell, ny * cell, step, tmax, step);
}

/// The group $coupled of a liquid of density 1.
inline std::string liquid(const std::string& more) { return "$coupled density=1., liquid=.true., " + more + " $\n"; }

}  // namespace tether::cases
