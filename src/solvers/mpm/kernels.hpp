// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdlib>

#include "grid/shape_functions.hpp"
#include "solvers/mpm/arrays.hpp"
#include "solvers/mpm/point_laws.hpp"
#include "solvers/mpm/range.hpp"
#include "solvers/mpm/trouble.hpp"

// The passes over the points of one body. Every loop body is made of the same small pieces, in the order of the step.

namespace tether::mpm {

/// Node numbers of a cell's corners, counter-clockwise from the lower left.
inline std::array<std::size_t, 4> corners(const Locator& locator, const CellPlace& at) {
  const std::size_t n = locator.lower_left_node(at), nx = static_cast<std::size_t>(locator.nx);
  return {n, n + 1, n + nx + 1, n + nx};
}

/// grad v_p = sum_i v_i (x) G_ip, and its symmetric part (3.23), (4.2).
inline StrainRate strain_rate(const std::array<Pair, 4>& v, const LinearGradient& G) {
  const Pair by_x = G.by_x(v), by_y = G.by_y(v);
  return symmetric_part({by_x[0], by_y[0], by_x[1], by_y[1]});
}

/// Adds the point's mass and momentum to its nodes (3.15).
inline void map_momentum(const Points& P, std::size_t p, std::vector<NodeSums>& sums,
                         const std::array<std::size_t, 4>& nodes, const LinearShape& shape) {
  const double mass = P.mass[p];
  const Pair momentum = mass * pair(P.vx[p], P.vy[p]);
  for (std::size_t k = 0; k < 4; ++k) {
    NodeSums& node = sums[nodes[k]];
    node.m += shape.N[k] * mass;
    node.momentum += shape.N[k] * momentum;
  }
}

/// Adds the internal force, f_i -= V_p sigma_p G_ip (3.16).
inline void map_force(const Points& P, std::size_t p, double volume, std::vector<NodeSums>& sums,
                      const std::array<std::size_t, 4>& nodes, const LinearGradient& G) {
  const double xy = volume * P.sxy[p];
  const auto forces = G.minus_divergence(pair(volume * P.sxx[p], xy), pair(xy, volume * P.syy[p]));
  for (std::size_t k = 0; k < 4; ++k) sums[nodes[k]].force += forces[k];
}

/// v_p += dt sum N_i f_i / m_i (3.22).
inline Pair accelerate(Points& P, std::size_t p, double dt, const std::vector<NodeMotion>& motion,
                       const std::array<std::size_t, 4>& nodes, const LinearShape& shape) {
  Pair a{};
  for (std::size_t k = 0; k < 4; ++k) a += shape.N[k] * motion[nodes[k]].a;
  const Pair v = pair(P.vx[p], P.vy[p]) + dt * a;
  P.vx[p] = v[0], P.vy[p] = v[1];
  return v;
}

/// x_p += dt sum N_i (mv)_i^L / m_i (3.21).
inline void move(Points& P, std::size_t p, double dt, const std::vector<NodeMotion>& motion,
                 const std::array<std::size_t, 4>& nodes, const LinearShape& shape) {
  Pair u{};
  for (std::size_t k = 0; k < 4; ++k) u += shape.N[k] * motion[nodes[k]].u;
  P.x[p] += dt * u[0], P.y[p] += dt * u[1];
}

/// Velocities of the points, and their momenta back on the nodes, sum m_p v_p N_i (3.22), (3.24).
inline void accelerate_and_convect(Range range, Points& P, Grid& grid, double dt) {
  const Locator locator(grid.shape);
  for (std::size_t p = range.begin; p < range.end; ++p) {
    const CellPlace at = locator.locate(P.x[p], P.y[p]);
    const auto nodes = corners(locator, at);
    const LinearShape shape(at);
    const Pair momentum = P.mass[p] * accelerate(P, p, dt, grid.motion, nodes, shape);
    for (std::size_t k = 0; k < 4; ++k) grid.convected[nodes[k]] += shape.N[k] * momentum;
  }
}

/// What a pass over the points does beside the strain rate. The three orders of a step differ in nothing else.
struct MuslPass {  // strain rate from the convected velocity (3.24), then move
  static constexpr bool accelerates = false, moves = true;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.convected[n]; }
};
struct UslPass {  // strain rate from the solution of the momentum equation, then accelerate and move
  static constexpr bool accelerates = true, moves = true;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.motion[n].u; }
};
struct UsfPass {  // strain rate from the mapped velocity; the points stay
  static constexpr bool accelerates = false, moves = false;
  static Pair velocity(const Grid& grid, std::size_t n) { return grid.convected[n]; }
};

/// Takes `at` from the point's old cell to its new one: false, and noted in `trouble`, where the point left the grid or
/// jumped over a cell.
inline bool accept_place(const Points& P, std::size_t p, const Locator& locator, const BackgroundGrid& shape,
                         CellPlace& at, StepFindings& found, Trouble& trouble) {
  if (!shape.contains(P.x[p], P.y[p])) return trouble.note(TroubleKind::left_grid, p);
  const CellPlace before = at;
  at = locator.locate(P.x[p], P.y[p]);
  const int di = at.i - before.i, dj = at.j - before.j;
  if ((di | dj) == 0) return true;
  ++found.crossings;
  return (std::abs(di) <= 1 && std::abs(dj) <= 1) || trouble.note(TroubleKind::jumped, p);
}

/// Strain rate at the old place, and what else the pass does there; `at` is the place's cell before and after. False
/// where the point came into trouble.
template <class Pass>
inline bool strain_and_move(const Locator& locator, Points& P, std::size_t p, const Grid& grid, double dt,
                            CellPlace& at, StrainRate& rate, StepFindings& found, Trouble& trouble) {
  const auto nodes = corners(locator, at);
  rate = strain_rate({Pass::velocity(grid, nodes[0]), Pass::velocity(grid, nodes[1]), Pass::velocity(grid, nodes[2]),
                      Pass::velocity(grid, nodes[3])},
                     LinearGradient(at, locator.per_dx, locator.per_dy));
  const LinearShape shape(at);
  if constexpr (Pass::accelerates) accelerate(P, p, dt, grid.motion, nodes, shape);
  if constexpr (!Pass::moves) return true;
  move(P, p, dt, grid.motion, nodes, shape);
  return accept_place(P, p, locator, grid.shape, at, found, trouble);
}

/// Stress of the point by its law, then its mass, momentum and force to the nodes of its present place (only the force
/// where the points have not moved: mass and momentum stand there already).
template <class Pass, class Law>
inline void stress_and_map(const Law& law, const Locator& locator, Points& P, std::size_t p, Grid& grid,
                           const CellPlace& at, const StrainRate& rate, const StepContext& step, StepFindings& found,
                           Trouble& trouble) {
  law_update(law, P, p, rate, step, found);
  if (!sound(law, P, p)) {
    trouble.note(TroubleKind::unsound, p);
    return;
  }
  const auto nodes = corners(locator, at);
  if constexpr (Pass::moves) map_momentum(P, p, grid.sums, nodes, LinearShape(at));
  map_force(P, p, law_volume(law, P, p), grid.sums, nodes, LinearGradient(at, locator.per_dx, locator.per_dy));
}

/// For laws that look at the point alone: both halves in one pass.
template <class Pass, class Law>
inline void strain_stress_and_map(const Law& law, Range range, Points& P, Grid& grid, const StepContext& step,
                                  StepFindings& found, Trouble& trouble) {
  const Locator locator(grid.shape);
  for (std::size_t p = range.begin; p < range.end; ++p) {
    CellPlace at = locator.locate(P.x[p], P.y[p]);
    StrainRate rate;
    if (!strain_and_move<Pass>(locator, P, p, grid, step.dt, at, rate, found, trouble)) continue;
    stress_and_map<Pass>(law, locator, P, p, grid, at, rate, step, found, trouble);
  }
}

/// First half for laws that need the new places of neighbours: the strain rates are kept.
template <class Pass>
inline void strain_and_move_all(Range range, Points& P, const Grid& grid, double dt, StepFindings& found,
                                Trouble& trouble) {
  const Locator locator(grid.shape);
  for (std::size_t p = range.begin; p < range.end; ++p) {
    CellPlace at = locator.locate(P.x[p], P.y[p]);
    StrainRate rate;
    strain_and_move<Pass>(locator, P, p, grid, dt, at, rate, found, trouble);
    P.dxx[p] = rate.xx, P.dyy[p] = rate.yy, P.dxy[p] = rate.xy;
  }
}

/// Second half of it.
template <class Pass, class Law>
inline void stress_and_map_all(const Law& law, Range range, Points& P, Grid& grid, const StepContext& step,
                               StepFindings& found, Trouble& trouble) {
  const Locator locator(grid.shape);
  for (std::size_t p = range.begin; p < range.end; ++p) {
    const CellPlace at = locator.locate(P.x[p], P.y[p]);
    stress_and_map<Pass>(law, locator, P, p, grid, at, {P.dxx[p], P.dyy[p], P.dxy[p]}, step, found, trouble);
  }
}

/// New velocities and places from the momentum equation, mass and momentum to the new places' nodes: what remains of a
/// step that updated stress first.
inline void accelerate_move_and_map(Range range, Points& P, Grid& grid, double dt, StepFindings& found,
                                    Trouble& trouble) {
  const Locator locator(grid.shape);
  for (std::size_t p = range.begin; p < range.end; ++p) {
    CellPlace at = locator.locate(P.x[p], P.y[p]);
    const auto nodes = corners(locator, at);
    const LinearShape shape(at);
    accelerate(P, p, dt, grid.motion, nodes, shape);
    move(P, p, dt, grid.motion, nodes, shape);
    if (!accept_place(P, p, locator, grid.shape, at, found, trouble)) continue;
    map_momentum(P, p, grid.sums, corners(locator, at), LinearShape(at));
  }
}

}  // namespace tether::mpm
