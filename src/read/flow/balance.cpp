// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "grid/lagrange.hpp"
#include "read/flow/checks.hpp"

namespace tether {
namespace {

using Vector = std::array<double, 2>;

constexpr double most = 1e-6;       // net over gross flux of a fluid that cannot leave
constexpr double rounding = 1e-12;  // of speed times length of the boundary
constexpr int times = 20;           // at which the balance is looked at

/// What a prescribed velocity brings through the boundary [area/time].
struct Flux {
  double in = 0, out = 0;
  double gross = 0;  ///< of the parts that go in and out
  double speed = 0;  ///< integral of the speed
  bool balanced() const { return std::abs(in - out) <= std::max(most * gross, rounding * speed); }
};

/// Whether a node's velocity along the normal is prescribed on all such sides: by the deck, or zero on slip.
bool is_closed(const FlowSide& side) { return side.boundary != Boundary::open && side.boundary != Boundary::periodic; }

/// The velocity at the nodes as the discrete system has it: none where it is not prescribed, which on closed sides is
/// along slip walls alone, where it has no part in the flux.
std::vector<Vector> nodal_velocities(const Flow& flow, const std::vector<Holder>& holders, double t) {
  std::vector<Vector> v(holders.size(), Vector{});
  for (std::size_t n = 0; n < v.size(); ++n) {
    if (holders[n].side < 0) continue;
    const std::size_t at = 2 * static_cast<std::size_t>(holders[n].node);
    v[n] = flow.sides[static_cast<std::size_t>(holders[n].side)].velocity.at(flow.mesh.x[at], flow.mesh.x[at + 1], t);
  }
  return v;
}

/// Adds the integrals of v . n and |v| over an element side whose nodes go round the fluid counter-clockwise.
template <int p>
void add_side(const Mesh& mesh, const int* side, const std::vector<Vector>& v, Flux& flux) {
  double net = 0;
  for (std::size_t q = 0; q <= p; ++q) {
    const double s = Line<p>::gauss_places()[q], weight = Line<p>::gauss_weights()[q];
    const auto N = Line<p>::values(s), dN = Line<p>::slopes(s);
    Vector at{}, along{};
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
  const std::vector<Vector> v = nodal_velocities(flow, holders, t);
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
          Severity::error, "flow", "boundary_on", {blamed->number, 1},
          fmt::format(
              "at t = {:.6g} the prescribed velocities bring {:.6g} into the fluid and {:.6g} out of it, and no "
              "side is open",
              t, flux.in, flux.out),
          "a fluid keeps its volume: make a side 'open', or balance what comes in and goes out (area per time)"));
    } catch (const RunError&) {
      // An expression without a value at a time that no step may ever ask for: the run tells of it if one does.
    }
  }
}

}  // namespace tether
