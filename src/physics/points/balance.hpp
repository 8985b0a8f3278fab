// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "fields/rows.hpp"
#include "grid/boxes.hpp"
#include "laws/walls.hpp"
#include "physics/points/arrays.hpp"

namespace tether::mpm {

/// Walls: the held components are zero in the momentum AND in the force; a wall that changes only the momentum lets
/// the points take up the force (3.22) and blows up.
inline void hold(std::uint8_t held, Pair& v) {
  if (held & holds_x) v[0] = 0;
  if (held & holds_y) v[1] = 0;
}

/// Returns the inverse of a node's mass. With linear functions an active node has some mass (Locator::edge); a spline
/// ends smoothly, so that a node may have none, and then nothing reads it.
inline double inverse(double m) { return m > 0 ? 1 / m : 0; }

inline double dot(Pair a, Pair b) {
  a *= b;
  return a[0] + a[1];
}

inline double squared(Pair v) { return dot(v, v); }

// Where the energy of a step goes. With a = f / m + g after walls and contact, u = v + dt a, the middle of the step
// w = u - dt a / 2 and P = sum_i f_i . w_i dt, the work of all forces but gravity's:
//   FLIP  dK = P + g dt sum_i m_i w_i,y + J . w - T,  T = dt^2 / 2 (sum_i m_i |a_i|^2 - sum_p m_p |a_p|^2)
//   APIC  the same, T = K_points - K_nodes before the solve, and K_nodes - K_points after it
// since a point's a_p is the mean sum N_i a_i, and both are sums of squares of what differs from a mean. J are the
// impulses of contact, whose -J . w the contact books. The potential energy changes by -g sum_p m_p dt u_p,y, and what
// the points stored of -P shows in their strain and internal energy dU. Then
//   -dE = T + (-J . w) + (-P - dU) + g dt (sum_p m_p u_p,y - sum_i m_i w_i,y).
// The last is w's half step, and what pins keep from falling and images beyond walls have too much.
//
// A point on a line of the grid gives the nodes across the cell next to nothing of its mass (Locator::edge), but by
// bilinear functions its whole force: a of such a node is 1e12 times too large, and dt^2 / 2 m |a|^2 in T and in P,
// which cancel, would be all that there is in either. Of a node lighter than any that motion knows, both go without:
// with its velocity before the solve for w, as m |a|^2 = (f + m g) . a where a wall holds nothing.

/// Sums over the nodes after the solve.
struct NodeTotals {
  double light = 0;    // nodes of no more mass than this count without m |a|^2 [mass]
  double power = 0;    // sum f . w [power]
  double squares = 0;  // FLIP: sum m |a|^2
  double gained = 0;   // APIC: sum m a . w, kinetic energy after the solve less before it, over dt [power]
  double upward = 0;   // sum m w_y [momentum]
  double held = 0;     // sum of 0.5 m |v|^2 that walls took [energy]

  void add(const NodeSums& sum, const NodeMotion& motion, std::uint8_t walls, double dt) {
    const bool counts = sum.m > light;
    const Pair middle = motion.u - (counts ? 0.5 * dt : dt) * motion.a;
    power += dot(sum.force, middle);
    if (counts) squares += sum.m * squared(motion.a);
    gained += sum.m * dot(motion.a, middle);
    upward += sum.m * middle[1];
    add_held(sum, walls);
  }
  /// Adds what walls take of a node's energy.
  void add_held(const NodeSums& sum, std::uint8_t walls) {
    if (walls == holds_none) return;
    Pair v = sum.momentum * inverse(sum.m);
    if (!(walls & holds_x)) v[0] = 0;
    if (!(walls & holds_y)) v[1] = 0;
    held += 0.5 * sum.m * squared(v);
  }
};

/// Since the start [energy].
struct Balance {
  double transfer = 0;  // T, without what walls took
  double walls = 0;     // APIC: of what points gave to nodes that walls hold; FLIP gives them increments alone
  double work = 0;      // sum of P
  double fall = 0;      // what gravity gave to the nodes less what the points' falling gave
  double stored = 0;    // strain and internal energy at the start, and that of the pressure outside

  /// Name in a checkpoint, and member.
  static constexpr auto rows() {
    return std::tuple{NumberField{"balance_transfer", &Balance::transfer},
                      NumberField{"balance_walls", &Balance::walls}, NumberField{"balance_work", &Balance::work},
                      NumberField{"balance_fall", &Balance::fall}, NumberField{"balance_stored", &Balance::stored}};
  }
  /// `points` of a step: FLIP: sum_p m_p |a_p|^2; APIC: twice the points' kinetic energy before less after it.
  /// `lifted`: sum_p m_p dt u_p,y.
  void add(const NodeTotals& nodes, double points, double lifted, bool affine, double gravity, double dt) {
    work += dt * nodes.power;
    fall += gravity * (dt * nodes.upward - lifted);
    if (affine) {
      walls += nodes.held;
      transfer += dt * nodes.gained + 0.5 * points - nodes.held;
    } else {
      transfer += 0.5 * dt * dt * (nodes.squares - points);
    }
  }
  /// Returns what steps of finite length make of the work, with this energy stored now [energy].
  double integration(double stored_now) const { return stored - stored_now - work - fall; }
};
}  // namespace tether::mpm
