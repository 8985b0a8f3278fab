// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "loops/points.hpp"
#include "physics/points/balance.hpp"
#include "physics/points/kernels.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

// The fields that APIC's points carry at the start of a scene about an axis. A point that knows its velocity alone
// gives it to all its nodes unchanged, and a node takes the velocity of the mean place of its points. In the plane that
// place is the node's own; about an axis rings further out weigh more, and it lies h^2 / (4 r) beyond the node: gas
// that falls towards the axis would begin to fall faster by the part h^2 / (4 r^2), which is 0.25 at the first node of
// every grid. With C = grad v a linear field is mapped exactly.

/// Rounds of fitting. Of a linear field they leave 0.005 of a gradient at the axis. What a free edge does to it comes
/// one cell further in with each, and with one point a cell it does not fade.
constexpr int rounds_of_fitting = 3;

/// Returns whether the points of the scene, not those beyond open edges, have more than one velocity.
inline bool velocities_differ(const State& state, Slots range) {
  const Points& P = state.points;
  const auto is_here = [&](std::size_t p) {
    return P.holds(p) && (!state.strips.on() || !state.strips.holds(P.x[p], P.y[p]));
  };
  std::size_t first = range.begin;
  while (first < range.end && !is_here(first)) ++first;
  for (std::size_t p = first; p < range.end; ++p) {
    if (is_here(p) && (P.vx[p] != P.vx[first] || P.vy[p] != P.vy[first])) return true;
  }
  return false;
}

/// The velocities that a body's points give to its nodes.
template <class S>
inline std::vector<Pair> velocities_of(const State& state, Slots range) {
  const Frame& frame = state.grid.frame;
  const Points& P = state.points;
  const Locator locator(frame.shape);
  NodeSumsRow sums(frame.shape.nodes());
  for_points(P, range, [&](std::size_t p) {
    if (P.pinned[p] && state.pins_hold_loads) return;
    const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
    map_momentum<S>(P, p, sums, locator, at, S::Kernel::nodes(locator, at));
  });
  fold_sums(frame.ghosts, sums);
  std::vector<Pair> velocities(sums.size());
  for (std::size_t n = 0; n < sums.size(); ++n) {
    velocities[n] = inverse(sums.m[n]) * Pair(sums.momentum[n]);
    hold(frame.held[n], velocities[n]);
  }
  for (const Ghost& ghost : frame.ghosts) {
    velocities[static_cast<std::size_t>(ghost.node)] = ghost.sign * velocities[static_cast<std::size_t>(ghost.image)];
  }
  return velocities;
}

/// Gives the points of bodies that do not move as one the gradients of their velocities, which they keep.
template <class S>
inline void fit_fields(State& state) {
  if constexpr (!S::affine || !S::about_axis) return;
  Points& P = state.points;
  const Locator locator(state.grid.frame.shape);
  for (const Slots range : state.ranges) {
    if (!velocities_differ(state, range)) continue;
    for (int round = 0; round < rounds_of_fitting; ++round) {
      const auto velocities = velocities_of<S>(state, range);
      for_points(P, range, [&](std::size_t p) {
        if (P.pinned[p]) return;
        const auto at = S::Kernel::locate(locator, P.x[p], P.y[p]);
        const LinearField field =
            S::Kernel::affine(locator, at, S::Kernel::nodes(locator, at), [&](std::size_t n) { return velocities[n]; });
        P.vxx[p] = field.by_x[0], P.vyx[p] = field.by_x[1], P.vxy[p] = field.by_y[0], P.vyy[p] = field.by_y[1];
      });
    }
  }
}

}  // namespace tether::mpm
