// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "loops/points.hpp"
#include "physics/points/kernels.hpp"

namespace tether::mpm {

// The heat ledger: what a transfer between points and nodes loses of the kinetic energy. With the field C about a point
// its kinetic energy is m/2 sum_i N_i |v_p + C (x_i - x_p)|^2 = m/2 (|v_p|^2 + |C|^2 D), D = h^2/4 an axis for
// quadratic splines. What the nodes then have is less by the scatter of what the points gave them, m/2 sum N |v_p + C
// dx - v_old|^2, and what the points take back is less by the scatter of the nodes' velocities about the field, m/2 sum
// N |v_new - v_p' - C' dx|^2. Both are sums of squares: the transfer only ever loses.

/// accelerate() for APIC by splines; returns the kinetic energy per mass that the point's transfers of this step lose,
/// to the nodes and back [velocity^2].
template <class S>
inline double accelerate_and_book(Points& P, std::size_t p, const Grid& grid, const Locator& locator,
                                  const typename S::Kernel::Place& at, const typename S::Kernel::Nodes& nodes,
                                  double& squares_of_points) {
  const LinearField given = field_about(P, p);
  const LinearField old = S::Kernel::affine(locator, at, nodes, [&](std::size_t n) { return grid.convected[n]; });
  accelerate<S>(P, p, 0, grid.motion, locator, at, nodes, squares_of_points);
  const LinearField taken = field_about(P, p);
  const auto N = S::Kernel::values(at);
  double squares = 0;
  for (std::size_t k = 0; k < S::Kernel::size; ++k) squares += N[k] * grid.squares[nodes[k]];
  return 0.5 * (product<S>(locator, given, given) - 2 * product<S>(locator, given, old) -
                product<S>(locator, taken, taken) + squares);
}

// The passes over the points of one body. A pass whose template argument `pins` is true leaves pinned points where they
// are, at rest. Where elements make the forces they give nothing to their nodes, and the pin takes the load; else their
// mass and stress stand on the nodes as other points' do, and the nodes are not held. A pass takes what the step found
// before and returns it with what it found at its points.

/// What the passes of a step work on.
struct PassWork {
  Points& P;
  Grid& grid;
  Locator locator;
  StepContext step;
};

/// What a pass over the points does beside the strain rate. The three orders of a step differ in nothing else.
struct MuslPass {  // strain rate from the convected velocity (3.24), then move
  static constexpr bool accelerates = false, moves = true;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.convected[n]; }
};
struct UslPass {  // strain rate from the solution of the momentum equation, then accelerate and move
  static constexpr bool accelerates = true, moves = true;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.motion.u[n]; }
};
struct UsfPass {  // strain rate from the mapped velocity; the points stay
  static constexpr bool accelerates = false, moves = false;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.convected[n]; }
};

/// Velocities of the points, and their momenta back on the nodes, sum m_p v_p N_i (3.22), (3.24).
template <class S, bool pins>
inline StepFindings accelerate_and_convect(const PassWork& work, Range range, const StepFindings& before) {
  Points& P = work.P;
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    if (pins && P.pinned[p]) return;
    const auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(work.locator, at);
    accelerate<S>(P, p, work.step.dt, work.grid.motion, work.locator, at, nodes, found.squares);
    each_momentum<S>(P, p, work.locator, at, nodes,
                     [&](std::size_t n, double, Pair momentum) { work.grid.convected[n] += momentum; });
  });
}

/// Strain rate at the old place, and what else the pass does there; `at` is the place's cell before and after. False
/// where the point came into trouble.
template <class S, class Pass>
inline bool strain_and_move(const PassWork& work, std::size_t p, typename S::Kernel::Place& at, Rate& rate,
                            StepFindings& found) {
  const auto nodes = S::Kernel::nodes(work.locator, at);
  rate = rate_at<S>(
      work.locator, at, nodes, [&](std::size_t n) { return Pass::velocity(work.grid, n); }, work.P.x[p]);
  if constexpr (Pass::accelerates) {
    accelerate<S>(work.P, p, work.step.dt, work.grid.motion, work.locator, at, nodes, found.squares);
  }
  if constexpr (!Pass::moves) return true;
  move<S>(work.P, p, work.step.dt, work.grid.motion, at, nodes, found.lifted);
  return accept_place<typename S::Kernel>(work.P, p, work.locator, work.grid.frame, at, found);
}

/// Returns whether the gas finds its density, and its heat, at the nodes.
template <class Law>
constexpr bool from_nodes(const Law&) {
  return false;
}
inline bool from_nodes(const IdealGas& gas) { return gas.rule == DensityRule::grid; }

/// Stress of the point by its law, then its mass, momentum and force to the nodes of its present place (only the force
/// where the points have not moved: mass and momentum stand there already).
template <class S, class Pass, class Law>
inline void stress_and_map(const Law& law, const PassWork& work, std::size_t p, const typename S::Kernel::Place& at,
                           const Rate& rate, StepFindings& found) {
  Points& P = work.P;
  const auto nodes = S::Kernel::nodes(work.locator, at);
  if (from_nodes(law)) read_gas<typename S::Kernel>(P, p, work.grid.gas, work.step.heat, at, nodes);
  law_update<S::about_axis>(law, P, p, rate, work.step, found);
  if (!sound(law, P, p)) {
    found.trouble.note(TroubleKind::unsound, p);
    return;
  }
  if constexpr (Pass::moves) map_momentum<S>(P, p, work.grid.sums, work.locator, at, nodes);
  map_force<S>(P, p, law_volume(law, P, p), work.grid.sums, work.locator, at, nodes);
}

/// Does both halves in one pass, for laws that look at the point alone.
template <class S, class Pass, class Law>
inline StepFindings strain_stress_and_map(const Law& law, const PassWork& work, Range range,
                                          const StepFindings& before) {
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
    Rate rate;
    if (strain_and_move<S, Pass>(work, p, at, rate, found)) stress_and_map<S, Pass>(law, work, p, at, rate, found);
  });
}

/// First half for laws that need the new places of neighbours: the strain rates are kept.
template <class S, class Pass, bool pins>
inline StepFindings strain_and_move_all(const PassWork& work, Range range, const StepFindings& before) {
  Points& P = work.P;
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    Rate rate;
    if (pins && P.pinned[p]) {
      const auto velocity = [&](std::size_t n) { return Pass::velocity(work.grid, n); };
      rate = rate_at<S>(work.locator, at, S::Kernel::nodes(work.locator, at), velocity, P.x[p]);
    } else {
      strain_and_move<S, Pass>(work, p, at, rate, found);
    }
    P.dxx[p] = rate.d.xx, P.dyy[p] = rate.d.yy, P.dxy[p] = rate.d.xy, P.dzz[p] = rate.d.zz;
  });
}

/// Second half of it.
template <class S, class Pass, class Law>
inline StepFindings stress_and_map_all(const Law& law, const PassWork& work, Range range, const StepFindings& before) {
  const Points& P = work.P;
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    const auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    stress_and_map<S, Pass>(law, work, p, at, {{P.dxx[p], P.dyy[p], P.dxy[p], P.dzz[p]}, 0}, found);
  });
}

/// Mass and momentum of points that take their forces elsewhere.
template <class S>
inline void map_momentum_all(const PassWork& work, Range range) {
  for_points(range, [&](std::size_t p) {
    if (work.P.pinned[p]) return;
    const auto at = S::Kernel::locate(work.locator, work.P.x[p], work.P.y[p]);
    map_momentum<S>(work.P, p, work.grid.sums, work.locator, at, S::Kernel::nodes(work.locator, at));
  });
}

/// New velocities and places from the momentum equation, mass and momentum to the new places' nodes: what remains of a
/// step that updated stress first. Where the ledger is kept, `heat` is what the transfers lost [energy].
template <class S, bool pins>
inline StepFindings accelerate_move_and_map(const PassWork& work, Range range, bool ledger,
                                            const StepFindings& before) {
  Points& P = work.P;
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(work.locator, at);
    if (!pins || !P.pinned[p]) {
      if (ledger)
        found.heat += P.mass[p] * accelerate_and_book<S>(P, p, work.grid, work.locator, at, nodes, found.squares);
      else
        accelerate<S>(P, p, work.step.dt, work.grid.motion, work.locator, at, nodes, found.squares);
      move<S>(P, p, work.step.dt, work.grid.motion, at, nodes, found.lifted);
    }
    if (accept_place<typename S::Kernel>(P, p, work.locator, work.grid.frame, at, found)) {
      map_momentum<S>(P, p, work.grid.sums, work.locator, at, S::Kernel::nodes(work.locator, at));
    }
  });
}

/// i += dt (sigma : eps') / rho (4.10) with the strain rate of (v_old + v_new) / 2.
template <class S>
inline void heat_centred(const PassWork& work, std::size_t p, const typename S::Kernel::Place& at,
                         const typename S::Kernel::Nodes& nodes) {
  Points& P = work.P;
  const auto middle = [&](std::size_t n) { return 0.5 * (Pair(work.grid.convected[n]) + Pair(work.grid.motion.u[n])); };
  const Rate rate = rate_at<S>(work.locator, at, nodes, middle, P.x[p]);
  const Stress s{P.sxx[p], P.syy[p], P.sxy[p], S::about_axis ? P.szz[p] : 0};
  P.energy[p] = IdealGas::heated(P.energy[p], work.step.dt, s, rate.d, P.rho[p]);
}

/// Does the same for gas. Centred, it is heated by the velocity gradient half way between the velocities before and
/// after the solve, which gives it exactly what its forces took from the nodes; the ledger adds what the transfer
/// loses.
template <class S>
inline StepFindings accelerate_move_and_map_gas(const IdealGas& law, const PassWork& work, Range range, bool ledger,
                                                const StepFindings& before) {
  Points& P = work.P;
  const Grid& grid = work.grid;
  return find_at_points(range, before, [&](std::size_t p, StepFindings& found) {
    auto at = S::Kernel::locate(work.locator, P.x[p], P.y[p]);
    const auto nodes = S::Kernel::nodes(work.locator, at);
    if (!work.step.heats) heat_centred<S>(work, p, at, nodes);
    double lost = 0;
    if (ledger) {
      lost = accelerate_and_book<S>(P, p, grid, work.locator, at, nodes, found.squares);
      found.heat += P.mass[p] * lost;
    } else {
      accelerate<S>(P, p, work.step.dt, grid.motion, work.locator, at, nodes, found.squares);
    }
    note_waves(law, P, p, found);
    move<S>(P, p, work.step.dt, grid.motion, at, nodes, found.lifted);
    if (!accept_place<typename S::Kernel>(P, p, work.locator, grid.frame, at, found)) return;
    const auto there = S::Kernel::nodes(work.locator, at);
    if (ledger) {
      map_gas_momentum_and_loss<S>(P, p, lost, work.grid, work.locator, at, there);
    } else if (from_nodes(law)) {
      map_gas_momentum<S>(P, p, work.grid.sums, work.locator, at, there);
    } else {
      map_momentum<S>(P, p, work.grid.sums, work.locator, at, there);
    }
  });
}

}  // namespace tether::mpm
