// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "loops/points.hpp"
#include "physics/points/passes.hpp"
#include "physics/points/steps.hpp"

namespace tether::mpm {

// What the points of each body give to the nodes that bodies share: passes of their own, so that the others know
// nothing of it.

/// Calls visit(at, each_slot) for the cells of a body that hold points, with a loop over their slots. A body that does
/// not run by lanes has a cell as often as points in it.
template <class S, class Visit>
inline void each_cell(const PassWork& work, const State& state, std::size_t b, const Visit& visit) {
  if (!state.blocks[b]) {
    for_points(state.ranges[b].full(), [&](std::size_t p) {
      if (work.P.pinned[p] && state.pins_hold_loads) return;
      visit(S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]), [&](const auto& body) { body(p); });
    });
    return;
  }
  const Blocks& blocks = *state.blocks[b];
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::size_t l = 0; l < Blocks::lanes; ++l) {
      if (group.points[l] == 0) continue;
      visit(typename S::Kernel::Place{group.cell + static_cast<int>(l), group.row}, [&](const auto& body) {
        blocks.each_slot(group, l, [&](std::size_t slot) { body(state.ranges[b].begin + slot); });
      });
    }
  }
}

template <class Place>
inline std::size_t cell_number(const PassWork& work, const Place& at) {
  return static_cast<std::size_t>(at.j) * static_cast<std::size_t>(work.grid.frame.shape.nx) +
         static_cast<std::size_t>(at.i);
}

/// Finds the shared nodes.
template <class S>
inline void find_shared_nodes(const PassWork& work, State& state) {
  Contact& contact = state.contact;
  contact.begin();
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    const int group = contact.group_of(b);
    each_cell<S>(work, state, b, [&](const auto& at, const auto&) {
      if (contact.stamp(cell_number(work, at), group)) return;
      for (const std::size_t n : S::Kernel::nodes(work.locator, at)) contact.touch(group, work.grid.frame.image[n]);
    });
  }
  contact.open(work.grid.frame);
}

/// Lists the points near them.
template <class S>
inline void list_near_points(const PassWork& work, State& state) {
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    std::vector<std::size_t>& near = state.contact.near_points(b);
    near.clear();
    if (state.contact.shared_nodes() == 0) continue;
    each_cell<S>(work, state, b, [&](const auto& at, const auto& each_slot) {
      if (state.contact.near_shared(cell_number(work, at))) each_slot([&](std::size_t p) { near.push_back(p); });
    });
    std::sort(near.begin(), near.end());
  }
}

/// Calls visit(b, p, place, nodes) for every point near a shared node.
template <class S, class Visit>
inline void each_near_shared(const PassWork& work, State& state, const Visit& visit) {
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    for (const std::size_t p : state.contact.near_points(b)) {
      const auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
      visit(b, p, at, S::Kernel::nodes(work.locator, at));
    }
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
