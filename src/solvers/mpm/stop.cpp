// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/stop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "solvers/mpm/point_laws.hpp"

namespace tether::mpm {
namespace {

std::size_t body_of(const State& state, std::size_t slot) {
  std::size_t b = 0;
  while (slot < state.ranges[b].begin || slot >= state.ranges[b].end) ++b;  // gas may stand after others
  return b;
}

/// Cell that a place would lie in, counted from 1 at the lower left, also outside the grid.
std::string cell_text(const BackgroundGrid& grid, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return "no cell";
  return fmt::format("cell ({:.6g}, {:.6g})", std::floor((x - grid.x0) / grid.dx) + 1,
                     std::floor((y - grid.y0) / grid.dy) + 1);
}

std::string step_text(const Plan& plan, const State& state, double dt) {
  const double ratio = dt / plan.step.limit(state.wave_max);
  if (ratio > 1 + 1e-9)
    return fmt::format("; the step is {:#.3g} times the limit dx/c: likely cause, a step too long", ratio);
  if (dt > plan.step.sharp_limit) {
    return fmt::format(
        "; the step is {:#.3g} times what pressure waves or viscosity allow: likely cause, a step too long",
        dt / plan.step.sharp_limit);
  }
  return fmt::format("; the step is {:#.3g} of the limit dx/c", ratio);
}

/// The edge a place lies beyond, and what follows from its kind.
std::string beyond(const BackgroundGrid& grid, const Walls& walls, double x, double y) {
  const auto [name, wall] = x < grid.x0   ? std::pair("left", walls.left)
                            : x > grid.x1 ? std::pair("right", walls.right)
                            : y < grid.y0 ? std::pair("bottom", walls.bottom)
                                          : std::pair("top", walls.top);
  const char* cause = wall == Wall::open
                          ? "an open edge too near, which holds nothing that comes to it, as gas outside a "
                            "membrane does (walls of 4 or 6 hold it); or a run that diverged"
                          : "a run that diverged";
  return fmt::format("left the grid by the {} edge (wall {}): likely cause, {}", name, static_cast<int>(wall), cause);
}

std::string what_happened(const State& state, const Walls& walls, const Trouble& trouble, double dt) {
  const Points& P = state.points;
  const std::size_t p = trouble.slot;
  const BackgroundGrid& grid = state.grid.frame.deck;
  const double cells = std::hypot(P.vx[p] / grid.dx, P.vy[p] / grid.dy) * dt;
  switch (trouble.kind) {
    case TroubleKind::left_grid:
      if (!std::isfinite(P.x[p]) || !std::isfinite(P.y[p])) return "has no finite place: its numbers overflowed";
      return beyond(grid, walls, P.x[p], P.y[p]);
    case TroubleKind::jumped:
      return fmt::format("jumped over a cell ({:.3g} cells in one step): likely cause, a run that diverges", cells);
    case TroubleKind::unsound:
      if (P.rho[p] < 0)
        return fmt::format("has the negative density {:.4g}: likely cause, dt div v below -1", P.rho[p]);
      if (!P.fxx.empty() && !(deformation(P, p).volume_ratio() > 0))
        return fmt::format(
            "is turned inside out (J = {:.4g}): likely cause, a step too long, or a squeeze beyond what "
            "the law or the grid carries (law='neo-hookean' resists it, 'svk' softens)",
            deformation(P, p).volume_ratio());
      return "has a stress that is no number: likely cause, a run that diverged";
    case TroubleKind::at_open_edge:
      return "is beyond an open edge, through which only gas passes: make the grid larger, or stop what moves there";
    case TroubleKind::none:
      break;
  }
  return "";
}

}  // namespace

void stop_on_trouble(const State& state, const Plan& plan, const Trouble& trouble, double dt) {
  const std::size_t p = trouble.slot;
  const std::size_t b = body_of(state, p);
  const double x = state.points.x[p], y = state.points.y[p];
  throw RunError(fmt::format("t = {:.9g}, step {}: point {} (body {}, {}) at ({:.6g}, {:.6g}) in {} {}{}",
                             state.time + dt, state.steps + 1, state.points.id[p] + 1, b + 1, plan.scene.bodies[b].name,
                             x, y, cell_text(state.grid.frame.deck, x, y),
                             what_happened(state, plan.scene.walls, trouble, dt), step_text(plan, state, dt)));
}

void stop_on_vanishing_step(const State& state, const char* waves, double dt) {
  throw RunError(
      fmt::format("t = {:.9g}, step {}: {} {:.4g} and leaves a step of {:.3g}: "
                  "likely cause, a run that diverged",
                  state.time, state.steps + 1, waves, state.wave_max, dt));
}

}  // namespace tether::mpm
