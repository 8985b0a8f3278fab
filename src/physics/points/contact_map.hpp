// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "loops/points.hpp"
#include "physics/points/passes.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

// What the points of each body give to the nodes that bodies share: passes of their own, so that the others know
// nothing of it.

/// Finds the shared nodes.
template <class S>
inline void find_shared_nodes(const PassWork& work, State& state) {
  Contact& contact = state.contact;
  const auto nx = static_cast<std::size_t>(work.grid.frame.shape.nx);
  contact.begin();
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const int group = contact.group_of(b);
    for_points(work.P, state.ranges[b], [&](std::size_t p) {
      const auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
      const std::size_t cell = static_cast<std::size_t>(at.j) * nx + static_cast<std::size_t>(at.i);
      if ((work.P.pinned[p] && state.pins_hold_loads) || contact.stamp(cell, group)) return;
      for (const std::size_t n : S::Kernel::nodes(work.locator, at)) contact.touch(group, work.grid.frame.image[n]);
    });
  }
  contact.open(work.grid.frame);
}

/// Calls visit(b, p, place, nodes) for every point that gives to a shared node.
template <class S, class Visit>
inline void each_near_shared(const PassWork& work, const State& state, const Visit& visit) {
  const auto nx = static_cast<std::size_t>(work.grid.frame.shape.nx);
  if (state.contact.shared_nodes() == 0) return;
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    for_points(work.P, state.ranges[b], [&](std::size_t p) {
      const auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
      const std::size_t cell = static_cast<std::size_t>(at.j) * nx + static_cast<std::size_t>(at.i);
      if ((work.P.pinned[p] && state.pins_hold_loads) || !state.contact.near_shared(cell)) return;
      visit(b, p, at, S::Kernel::nodes(work.locator, at));
    });
  }
}

/// Mass and momentum of each body there (9.6).
template <class S>
inline void map_shared_momentum(const PassWork& work, State& state) {
  Contact& contact = state.contact;
  const Frame& frame = work.grid.frame;
  each_near_shared<S>(work, state, [&](std::size_t b, std::size_t p, const auto& at, const auto& nodes) {
    const int group = contact.group_of(b);
    each_momentum<S>(work.P, p, work.locator, at, nodes, [&](std::size_t n, double m, Pair momentum) {
      const int slot = contact.slot(frame.image[n]);
      if (slot < 0) return;
      NodeSums& sums = contact.sums(slot, group);
      sums.m += m;
      sums.momentum += frame.sign[n] * momentum;
      contact.add_point(slot, group, p, frame.before_walls(n, pair(work.P.x[p], work.P.y[p])), m);
    });
  });
}

/// Internal force of each body there (9.4).
template <class S>
inline void map_shared_force(const PassWork& work, State& state, const Scene& scene) {
  Contact& contact = state.contact;
  const Frame& frame = work.grid.frame;
  contact.clear_forces();
  each_near_shared<S>(work, state, [&](std::size_t b, std::size_t p, const auto& at, const auto& nodes) {
    const auto add = [&](std::size_t n, Pair force) {
      const int slot = contact.slot(frame.image[n]);
      if (slot >= 0) contact.sums(slot, contact.group_of(b)).force += frame.sign[n] * force;
    };
    const auto spread = [&](const std::optional<Elements>& elements) {
      const auto N = S::Kernel::values(at);
      for (std::size_t k = 0; elements && k < S::Kernel::size; ++k) add(nodes[k], N[k] * elements->force(p));
    };
    spread(state.elements_of[b]);
    spread(state.ambient_of[b]);
    if (state.elements_of[b]) return;
    std::visit(
        [&](const auto& law) { each_force<S>(work.P, p, law_volume(law, work.P, p), work.locator, at, nodes, add); },
        scene.bodies[b].material);
  });
}

/// While it lives, the fields of a body's group stand at the shared nodes in the place of the common ones.
class OwnField {
 public:
  OwnField(State& state, std::size_t b) : state_(state), group_(state.contact.group_of(b)) {
    if (state_.contact.on()) state_.contact.exchange(state_.grid, group_);
  }
  ~OwnField() {
    if (state_.contact.on()) state_.contact.exchange(state_.grid, group_);
  }
  OwnField(const OwnField&) = delete;
  OwnField& operator=(const OwnField&) = delete;

 private:
  State& state_;
  int group_;
};

}  // namespace tether::mpm
