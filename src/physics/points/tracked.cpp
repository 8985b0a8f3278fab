// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/tracked.hpp"

#include <algorithm>
#include <limits>

namespace tether::mpm {
namespace {

/// Of a point that has left the grid.
constexpr double gone = std::numeric_limits<double>::quiet_NaN();

/// Slots of the tracked points; past the last slot for one that has left the grid.
std::vector<std::size_t> tracked_slots(const State& state, const Scene& scene, const Order& order) {
  const auto& id = state.points.id;
  const Unfolding unfolding(scene.strip.get());
  std::vector<std::size_t> tracked;
  for (const std::size_t number : scene.tracked) {
    if (!state.strips.on()) {  // all are there
      tracked.push_back(order.slots[unfolding.runs_as(number)]);
      continue;
    }
    const auto found = std::find_if(order.slots.begin(), order.slots.end(),
                                    [&](std::size_t p) { return static_cast<std::size_t>(id[p]) == number; });
    tracked.push_back(found == order.slots.end() ? id.size() : *found);
  }
  return tracked;
}

}  // namespace

std::vector<TrackedSums> tracked_sums(const State& state, const Scene& scene, const Order& order) {
  const Points& P = state.points;
  const Unfolding unfolding(scene.strip.get());
  const std::vector<std::size_t> slots = tracked_slots(state, scene, order);
  std::vector<TrackedSums> tracked(slots.size(), {{gone, gone}, {gone, gone}});
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::size_t p = slots[k];
    if (p >= P.size()) continue;
    const Vec<2> place = unfolding.place(scene.tracked[k], {P.x[p], P.y[p]});
    tracked[k] = {{place[0], place[1]}, {P.vx[p], P.vy[p]}};
  }
  return tracked;
}

}  // namespace tether::mpm
