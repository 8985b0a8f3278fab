// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/run_deck.hpp"

namespace tether::cases {

/// A box far away about bodies that meet, with all steps and the end in the outputs.
inline std::string frame(double end, double step, const char* more = "") {
  return fmt::format(
      "bodies that meet\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,wl=1,wr=1,wb=1,wt=1,tmax={0},tstep={1},"
      "iout(33)=1,tiout(33)={1},iout(39)=1,tiout(39)={0}{2} $\n",
      end, step, more);
}

/// The largest change of energy, with all that friction, contact and damping took, over the largest motion's.
inline double energy_off(const DeckRun& run) {
  double most = 0, size = 0;
  for (const double one : run.history.column("energy_kinetic")) size = std::max(size, one);
  const auto total = run.history.column("energy_total"), rubbed = run.history.column("energy_friction"),
             contact = run.history.column("energy_contact_damped"), damped = run.history.column("energy_damped");
  for (std::size_t k = 0; k < total.size(); ++k)
    most = std::max(most, std::abs(total[k] + rubbed[k] + contact[k] + damped[k] - total[0]));
  return most / size;
}

}  // namespace tether::cases
