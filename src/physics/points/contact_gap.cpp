// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/points/balance.hpp"
#include "physics/points/contact.hpp"

namespace tether::mpm {

// The gap rule: an impulse where points of two bodies touch.

namespace {

void push(NodeMotion& motion, Pair change, double dt, std::uint8_t held) {
  motion.u += change;
  motion.a += change * (1 / dt);
  hold(held, motion.u), hold(held, motion.a);
}

}  // namespace

Pair Contact::centroid(int slot, int group) const {
  Pair sum{};
  double weight = 0;
  for (const Near& near : near_[index(slot, group)]) {
    sum += near.N * near.place;
    weight += near.N;
  }
  return sum * inverse(weight);
}

/// Outermost reach of a body along the normal from a place: sense 1 the largest (x - x_i) . n + r, -1 the smallest
/// (x - x_i) . n - r, over points within half a cell sideways. False where there is none.
bool Contact::edge(const Points& P, int slot, int group, Pair from, Pair normal, double sense, double& edge) const {
  edge = -std::numeric_limits<double>::infinity();
  for (const Near& near : near_[index(slot, group)]) {
    const Pair d = near.place - from;
    if (std::abs(d[0] * normal[1] - d[1] * normal[0]) > half_cell_) continue;
    edge =
        std::max(edge, sense * (d[0] * normal[0] + d[1] * normal[1]) + radius_[static_cast<std::size_t>(P.id[near.p])]);
  }
  return edge > -std::numeric_limits<double>::infinity();
}

/// Takes the approach away where points of a and b touch and approach each other; there is no friction.
void Contact::push_apart(const Points& P, const Frame& frame, int slot, int a, int b, double dt) {
  const NodeSums &A = sums_[index(slot, a)], &B = sums_[index(slot, b)];
  if (A.m <= 0 || B.m <= 0) return;
  const auto n = static_cast<std::size_t>(nodes_[static_cast<std::size_t>(slot)]);
  const auto nx = static_cast<std::size_t>(frame.shape.nx);
  const std::size_t column = n % nx, row = n / nx;
  const Pair at = pair(frame.shape.x0 + static_cast<double>(column) * frame.shape.dx,
                       frame.shape.y0 + static_cast<double>(row) * frame.shape.dy);
  Pair normal = centroid(slot, b) - centroid(slot, a);
  hold(frame.held[n], normal);  // the images behind a wall make it lie along it
  const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1]);
  if (!(length > 0)) return;
  normal *= 1 / length;
  double of_a = 0, of_b = 0;
  if (!edge(P, slot, a, at, normal, 1, of_a) || !edge(P, slot, b, at, normal, -1, of_b)) return;
  if (of_a + of_b < 0) return;  // gap = -of_b - of_a > 0
  NodeMotion &of_a_body = motion_[index(slot, a)], &of_b_body = motion_[index(slot, b)];
  const double approach = dot(of_a_body.u - of_b_body.u, normal);
  if (approach <= 0) return;
  const Pair impulse = (approach * A.m * B.m / (A.m + B.m)) * normal;
  push(of_a_body, impulse * (-1 / A.m), dt, frame.held[n]);
  push(of_b_body, impulse * (1 / B.m), dt, frame.held[n]);
  pushed_[static_cast<std::size_t>(a)] -= impulse, pushed_[static_cast<std::size_t>(b)] += impulse;
}

/// A body between two others is pushed by both: a few rounds over the pairs settle it.
void Contact::impulses(const Points& P, const Frame& frame, int slot, double dt) {
  const int rounds = groups_ > 2 ? 4 : 1;
  std::fill(pushed_.begin(), pushed_.end(), Pair{});
  for (int round = 0; round < rounds; ++round) {
    for (int a = 0; a < groups_; ++a) {
      for (int b = a + 1; b < groups_; ++b) push_apart(P, frame, slot, a, b, dt);
    }
  }
  // What they take from the bodies: the impulses times the velocities half way between before and after the solve.
  for (int g = 0; g < groups_; ++g) {
    const Pair middle = 0.5 * (convected_[index(slot, g)] + motion_[index(slot, g)].u);
    lost_ -= dot(pushed_[static_cast<std::size_t>(g)], middle);
  }
}

}  // namespace tether::mpm
