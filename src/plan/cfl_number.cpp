// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/cfl_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "model/coupled.hpp"
#include "model/solids.hpp"

namespace tether {
namespace {

/// The largest size of a factor at times of the run; an expression without a value at one of them has none there.
double largest_factor(const Amplitude& amplitude, double tmax) {
  constexpr int times = 100;
  std::vector<double> all = amplitude.time;
  for (int k = 0; k <= times; ++k) all.push_back(k * tmax / times);
  double largest = 0;
  for (const double t : all) {
    if (t < 0 || t > tmax) continue;
    try {
      largest = std::max(largest, std::abs(amplitude.at(t)));
    } catch (const RunError&) {
      continue;
    }
  }
  return largest;
}

}  // namespace

CflNumber cfl_number(const Scene& scene) {
  const Coupled& coupled = *scene.coupled();
  CflNumber worst;
  const auto consider = [&](int axis, double speed, const std::string& of) {
    const double number = std::abs(speed) * scene.clock.tstep / coupled.grid.d[static_cast<std::size_t>(axis)];
    if (number > worst.number) worst = {number, std::abs(speed), of};
  };
  for (const Jet& jet : coupled.jets)
    consider(axis_of_side(jet.side), jet.speed * largest_factor(jet.amplitude, scene.clock.tmax),
             fmt::format("jet {}", jet.number));
  for (int axis = 0; axis < coupled.grid.dim; ++axis) {
    consider(axis, coupled.start[static_cast<std::size_t>(axis)], "the fluid at the start");
    if (!scene.solids()) continue;
    for (const SolidRegion& region : scene.solids()->regions)
      consider(axis, region.velocity[static_cast<std::size_t>(axis)], region.name + " at the start");
  }
  return worst;
}

}  // namespace tether
