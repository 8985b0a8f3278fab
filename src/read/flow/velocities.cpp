// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/diagnostics.hpp"
#include "base/vec.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/shapes.hpp"
#include "read/flow/checks.hpp"
#include "read/mesh/solids.hpp"

namespace tether {
namespace {

constexpr double straight = 1e-9;  // part of a wall's velocity that rounding may turn
constexpr int times = 20;          // at which walls and the balance are looked at

/// Of the fluid's vectors as the deck writes them.
class VelocityChecks {
 public:
  VelocityChecks(const Deck& deck, const Clock& clock, const Flow& flow, Diagnostics& diagnostics)
      : deck_(deck), flow_(flow), t_(first_time(flow, clock)), tmax_(clock.tmax), diagnostics_(diagnostics) {}

  /// Returns whether all have finite values.
  bool finite() {
    std::vector<int> all(flow_.mesh.node_count());
    std::iota(all.begin(), all.end(), 0);
    bool finite = is_finite(flow_.start, {"flow.u0", "flow.v0"}, 1, all, 0);
    finite &= is_finite(flow_.acceleration, {"flow.bx", "flow.by"}, 1, all, t_);
    for (const FlowSide& side : flow_.sides)
      finite &= is_finite(side.velocity, {"flow.boundary_u", "flow.boundary_v"}, side.number, side.sides, t_);
    return finite;
  }
  void walls() {
    const std::vector<Holder> holders = holders_of(flow_);
    for (std::size_t s = 0; s < flow_.sides.size(); ++s) {
      if (flow_.sides[s].boundary != Boundary::moving) continue;
      if (flow_.mesh.kind == ElementKind::quad4) {
        check_wall<1>(static_cast<int>(s), holders);
      } else {
        check_wall<2>(static_cast<int>(s), holders);
      }
    }
  }

 private:
  Vec<2> place(int node) const {
    const auto n = 2 * static_cast<std::size_t>(node);
    return {flow_.mesh.x[n], flow_.mesh.x[n + 1]};
  }
  bool is_finite(const FlowVector& vector, const std::array<AnyVariable, 2>& names, int k,
                 const std::vector<int>& nodes, double t) {
    bool all = true;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!vector.component[i]) continue;
      for (const int node : nodes) {
        const Vec<2> x = place(node);
        const double value = (*vector.component[i])(std::array{x[0], x[1], t});
        if (std::isfinite(value)) continue;
        diagnostics_.add(
            deck_.remark(Severity::error, names[i], {k, 1},
                         fmt::format("'{}' gives {} at {}, t = {:.6g}", vector.component[i]->text(), value,
                                     place_text(flow_.mesh, node), t),
                         "it must have a finite value wherever it is asked: at each node of its side, or of the mesh"));
        all = false;
        break;
      }
    }
    return all;
  }
  /// Unit vectors along an element side at its nodes.
  template <int p>
  std::array<Vec<2>, std::size_t{p + 1}> tangents(const int* side) const {
    std::array<Vec<2>, std::size_t{p + 1}> tangents{};
    for (std::size_t b = 0; b <= p; ++b) {
      const auto slopes = Line<p>::slopes(2.0 * static_cast<double>(b) / p - 1);
      Vec<2>& t = tangents[b];
      for (std::size_t a = 0; a <= p; ++a) {
        const Vec<2> x = place(side[a]);
        t[0] += slopes[a] * x[0], t[1] += slopes[a] * x[1];
      }
      const double length = std::hypot(t[0], t[1]);
      t = {t[0] / length, t[1] / length};
    }
    return tangents;
  }
  static double sine(const Vec<2>& a, const Vec<2>& b) { return std::abs(a[0] * b[1] - a[1] * b[0]); }

  /// How much the direction of a wall at each of its nodes is in doubt, as the sine of an angle: a curved wall, or one
  /// with a corner, turns from element to element, and at its ends as much as at the other nodes of the last one; a
  /// straight one does not.
  template <int p>
  std::vector<double> doubts(const FlowSide& side) const {
    std::vector<Vec<2>> first(flow_.mesh.node_count(), Vec<2>{});
    std::vector<double> doubt(flow_.mesh.node_count(), 0);
    std::vector<int> elements(flow_.mesh.node_count(), 0);
    const auto at = [&](std::size_t s) { return static_cast<std::size_t>(side.sides[s]); };
    for (std::size_t s = 0; s < side.sides.size(); s += p + 1) {
      const auto along = tangents<p>(&side.sides[s]);
      for (std::size_t a = 0; a <= p; ++a) {
        if (elements[at(s + a)]++ == 0) first[at(s + a)] = along[a];
        doubt[at(s + a)] = std::max({doubt[at(s + a)], sine(first[at(s + a)], along[a]), sine(along[0], along[p])});
      }
    }
    for (std::size_t s = 0; s < side.sides.size(); s += p + 1) {
      const std::size_t low = at(s), high = at(s + p);
      if (elements[low] == 1) doubt[low] = std::max(doubt[low], doubt[high]);
      if (elements[high] == 1) doubt[high] = std::max(doubt[high], doubt[low]);
    }
    return doubt;
  }
  /// At the start and later on: a table often begins at zero, which goes through nothing.
  template <int p>
  void check_wall(int number, const std::vector<Holder>& holders) {
    const std::vector<double> doubt = doubts<p>(flow_.sides[static_cast<std::size_t>(number)]);
    for (int k = 0; k <= (t_ > 0 ? 0 : times); ++k) {
      try {
        if (!is_along<p>(number, holders, doubt, t_ + k * tmax_ / times)) return;
      } catch (const RunError&) {
        // An expression without a value at a time that no step may ever ask for: the run reports it if one does.
      }
    }
  }
  double fastest(const FlowSide& side, double time) const {
    double most = 0;
    for (const int node : side.sides) {
      const Vec<2> x = place(node), v = side.velocity.at(x[0], x[1], time);
      most = std::max(most, std::hypot(v[0], v[1]));
    }
    return most;
  }
  /// Returns whether a wall moves along itself at a time; reports where it does not.
  template <int p>
  bool is_along(int number, const std::vector<Holder>& holders, const std::vector<double>& doubt, double time) {
    const FlowSide& side = flow_.sides[static_cast<std::size_t>(number)];
    const double rounding = 1e-12 * fastest(side, time);
    for (std::size_t s = 0; s < side.sides.size(); s += p + 1) {
      const auto along = tangents<p>(&side.sides[s]);
      for (std::size_t a = 0; a <= p; ++a) {
        const int node = side.sides[s + a];
        if (holders[static_cast<std::size_t>(node)].side != number) continue;
        const Vec<2> x = place(node), v = side.velocity.at(x[0], x[1], time);
        const double through = sine(v, along[a]);
        const double may = straight + doubt[static_cast<std::size_t>(node)];
        if (through <= may * std::hypot(v[0], v[1]) + rounding) continue;
        diagnostics_.add(
            deck_.remark(Severity::error, "flow.boundary", {side.number, 1},
                         fmt::format("at t = {:.6g} the velocity ({:.6g}, {:.6g}) of '{}' at {} goes through the wall "
                                     "by {:.6g}",
                                     time, v[0], v[1], side.name, place_text(flow_.mesh, node), through),
                         "a moving wall moves along itself; write 'inflow' where fluid goes through"));
        return false;
      }
    }
    return true;
  }

  const Deck& deck_;
  const Flow& flow_;
  double t_, tmax_;  // the first time that matters and the last one [time]
  Diagnostics& diagnostics_;
};

}  // namespace

void check_flow_velocities(const Deck& deck, const Clock& clock, const Flow& flow, Diagnostics& diagnostics) {
  VelocityChecks checks(deck, clock, flow, diagnostics);
  if (!checks.finite()) return;
  checks.walls();
  if (!diagnostics.has_errors()) check_flow_balance(deck, clock, flow, diagnostics);
}

namespace {

constexpr double most = 1e-6;       // net over gross flux of a fluid that cannot leave
constexpr double rounding = 1e-12;  // of speed times length of the boundary

/// What a prescribed velocity brings through the boundary [area/time].
struct Flux {
  double in = 0, out = 0;
  double gross = 0;  ///< of the parts that go in and out
  double speed = 0;  ///< integral of the speed
  bool balanced() const { return std::abs(in - out) <= std::max(most * gross, rounding * speed); }
};

/// Returns whether a node's velocity along the normal is prescribed on all such sides: by the deck, or zero on slip.
bool is_closed(const FlowSide& side) { return side.boundary != Boundary::open && side.boundary != Boundary::periodic; }

/// The velocity at the nodes as the discrete system has it: none where it is not prescribed, which on closed sides is
/// along slip walls alone, where it has no part in the flux.
std::vector<Vec<2>> nodal_velocities(const Flow& flow, const std::vector<Holder>& holders, double t) {
  std::vector<Vec<2>> v(holders.size(), Vec<2>{});
  for (std::size_t n = 0; n < v.size(); ++n) {
    if (holders[n].side < 0) continue;
    const std::size_t at = 2 * static_cast<std::size_t>(holders[n].node);
    v[n] = flow.sides[static_cast<std::size_t>(holders[n].side)].velocity.at(flow.mesh.x[at], flow.mesh.x[at + 1], t);
  }
  return v;
}

/// Adds the integrals of v . n and |v| over an element side whose nodes go round the fluid counter-clockwise.
template <int p>
void add_side(const Mesh& mesh, const int* side, const std::vector<Vec<2>>& v, Flux& flux) {
  double net = 0;
  for (std::size_t q = 0; q <= p; ++q) {
    const double s = Line<p>::gauss_places()[q], weight = Line<p>::gauss_weights()[q];
    const auto N = Line<p>::values(s), dN = Line<p>::slopes(s);
    Vec<2> at{}, along{};
    for (std::size_t a = 0; a <= p; ++a) {
      const auto node = static_cast<std::size_t>(side[a]);
      for (std::size_t i = 0; i < 2; ++i) at[i] += N[a] * v[node][i], along[i] += dN[a] * mesh.x[2 * node + i];
    }
    const double through = weight * (at[0] * along[1] - at[1] * along[0]);
    net += through, flux.gross += std::abs(through);
    flux.speed += weight * std::hypot(at[0], at[1]) * std::hypot(along[0], along[1]);
  }
  (net < 0 ? flux.in : flux.out) += std::abs(net);
}

Flux flux_at(const Flow& flow, const std::vector<Holder>& holders, double t) {
  const std::vector<Vec<2>> v = nodal_velocities(flow, holders, t);
  const auto per_side = static_cast<std::size_t>(side_node_count_of(flow.mesh.kind));
  Flux flux;
  for (const FlowSide& side : flow.sides) {
    for (std::size_t s = 0; s < side.sides.size() && is_closed(side); s += per_side) {
      if (per_side == 2) {
        add_side<1>(flow.mesh, &side.sides[s], v, flux);
      } else {
        add_side<2>(flow.mesh, &side.sides[s], v, flux);
      }
    }
  }
  return flux;
}

}  // namespace

double first_time(const Flow& flow, const Clock& clock) {
  return flow.integrator == FlowIntegrator::steady ? clock.tmax : 0;
}

void check_flow_balance(const Deck& deck, const Clock& clock, const Flow& flow, Diagnostics& diagnostics) {
  const auto is = [&](Boundary boundary) {
    return std::find_if(flow.sides.begin(), flow.sides.end(),
                        [&](const FlowSide& side) { return side.boundary == boundary; });
  };
  if (is(Boundary::open) != flow.sides.end()) return;
  const auto inflow = is(Boundary::inflow), moving = is(Boundary::moving);
  const auto blamed = inflow != flow.sides.end() ? inflow : moving;
  if (blamed == flow.sides.end()) return;
  const std::vector<Holder> holders = holders_of(flow);
  const double first = first_time(flow, clock);
  for (int k = 0; k <= (first > 0 ? 0 : times); ++k) {
    const double t = first + k * clock.tmax / times;
    try {
      const Flux flux = flux_at(flow, holders, t);
      if (flux.balanced()) continue;
      return diagnostics.add(deck.remark(
          Severity::error, "flow.boundary_on", {blamed->number, 1},
          fmt::format(
              "at t = {:.6g} the prescribed velocities bring {:.6g} into the fluid and {:.6g} out of it, and no "
              "side is open",
              t, flux.in, flux.out),
          "a fluid keeps its volume: make a side 'open', or balance what comes in and goes out (area per time)"));
    } catch (const RunError&) {
      // An expression without a value at a time that no step may ever ask for: the run reports it if one does.
    }
  }
}

}  // namespace tether
