// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/solver.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/diagnostics.hpp"
#include "model/find_strip.hpp"
#include "physics/points/layout.hpp"
#include "physics/points/nodes.hpp"
#include "physics/points/point_laws.hpp"
#include "physics/points/steps.hpp"
#include "physics/step_clock.hpp"
#include "results/summary_keys.hpp"

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

bool is_inside_out(const Points& P, std::size_t p) { return !P.fxx.empty() && !(deformation(P, p).volume_ratio() > 0); }

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
      if (const double rho = P.at(&Points::rho, p); rho < 0)
        return fmt::format("has the negative density {:.4g}: likely cause, dt div v below -1", rho);
      if (is_inside_out(P, p))
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

Failure failure_of(const State& state, const Trouble& trouble) {
  const Points& P = state.points;
  const std::size_t p = trouble.slot;
  const bool placed = std::isfinite(P.x[p]) && std::isfinite(P.y[p]);
  if (trouble.kind == TroubleKind::at_open_edge || (trouble.kind == TroubleKind::left_grid && placed))
    return Failure::loses_points;
  if (trouble.kind == TroubleKind::unsound && (P.at(&Points::rho, p) < 0 || is_inside_out(P, p)))
    return Failure::inverts;
  return Failure::diverges;
}

}  // namespace

void stop_on_trouble(const State& state, const Plan& plan, const Trouble& trouble, double dt) {
  const std::size_t p = trouble.slot;
  const std::size_t b = body_of(state, p);
  const double x = state.points.x[p], y = state.points.y[p];
  const std::size_t number = Unfolding(plan.scene.strip.get()).first_of(static_cast<std::size_t>(state.points.id[p]));
  throw RunError(fmt::format("t = {:.9g}, step {}: point {} (body {}, {}) at ({:.6g}, {:.6g}) in {} {}{}",
                             state.time + dt, state.steps + 1, number + 1, b + 1, plan.scene.bodies[b].name, x, y,
                             cell_text(state.grid.frame.deck, x, y),
                             what_happened(state, plan.scene.walls, trouble, dt), step_text(plan, state, dt)),
                 failure_of(state, trouble));
}

void stop_on_vanishing_step(const State& state, const char* waves, double dt) {
  throw RunError(
      fmt::format("t = {:.9g}, step {}: {} {:.4g} and leaves a step of {:.3g}: "
                  "likely cause, a run that diverged",
                  state.time, state.steps + 1, waves, state.wave_max, dt));
}

namespace {

/// A step this much shorter than the deck's is no step any more.
constexpr double vanishing = 1e-9;

/// At what moves no more than a cell in as many steps.
constexpr int steps_between_looks = 64;
/// A count of what is on which side of a membrane costs some steps.
constexpr int steps_between_counts = 1024;

/// Whose waves the step limit follows.
const char* wave_text(const Scene& scene) {
  if (!find_body<FiniteElastic>(scene)) return "the gas moves at c + |v| =";
  return find_body<IdealGas>(scene) ? "the fastest wave, of gas or of strained solids, runs at"
                                    : "in strained solids waves run at";
}

}  // namespace

MpmSolver::MpmSolver(const Plan& plan, int threads) : MpmSolver(plan, plan.scene.points, threads) {}

MpmSolver::MpmSolver(const Plan& plan, PointSet points, int threads)
    : plan_(plan),
      row_(plan.scene.strip ? std::make_unique<const Scene>(scene_of_row(plan.scene)) : nullptr),
      scene_(row_ ? *row_ : plan.scene),
      set_(step_set(scene_)),
      state_(start(scene_, row_ ? points_of_row(*scene_.strip, points) : std::move(points), {.threads = threads})),
      strings_(scene_, state_),
      stretches_(scene_),
      mixing_(scene_, state_.grid.frame),
      leaks_(scene_, state_),
      columns_(history_columns(scene_)) {
  if (strings_.on()) strings_.look(state_, scene_, messages_);
  messages_.clear();  // the deck's remarks have it
  if (plan.step.first_step() < plan.step.deck_step) note_warning(state_.warned, PointDoubt::limit);  // the plan has it
  const auto encloses = [](const std::optional<Elements>& of) { return of && of->encloses(); };
  const bool acts = std::any_of(state_.elements_of.begin(), state_.elements_of.end(), encloses) ||
                    std::any_of(state_.ambient_of.begin(), state_.ambient_of.end(), encloses);
  if (scene_.ambient != 0 && !acts) {
    messages_.push_back("pambient acts on nothing: no membrane is closed or has both its ends at walls");
  }
}

void MpmSolver::advance(double until, long long most) {
  const double tmax = scene_.clock.tmax;
  while (state_.time < until && state_.time < tmax && most-- > 0) {
    const double dt = next_step(), after = state_.time + dt * (1 + 1e-9);  // rounding must not take the last records
    readable_ = most == 0 || after >= std::min(std::max(until, reading_), tmax);
    step(dt, readable_);
  }
}

double MpmSolver::next_step() {
  double dt = plan_.step.step(state_.wave_max);
  if (dt < plan_.step.deck_step && note_warning(state_.warned, PointDoubt::limit)) {
    messages_.push_back(fmt::format("t = {:.6g}: {} {:.4g}: steps are limited to {:.4g}", state_.time,
                                    wave_text(scene_), state_.wave_max, dt));
  }
  const bool gets_on = dt > vanishing * plan_.step.deck_step && state_.time + dt > state_.time;
  if (!gets_on) stop_on_vanishing_step(state_, wave_text(scene_), dt);
  return step_before_end(dt, state_.time, scene_.clock.tmax);
}

void MpmSolver::step(double dt, bool records) {
  StepWork work{.state = state_, .scene = scene_, .found = {}, .records = records};
  if (state_.strips.on()) state_.strips.before_step(state_.points, state_.ranges, scene_);
  set_.step(work, dt);
  if (state_.strips.on() && work.found.trouble.kind == TroubleKind::none) pass_edges(work, dt);
  if (work.found.trouble.kind != TroubleKind::none) stop_on_trouble(state_, plan_, work.found.trouble, dt);
  state_.crossings_since_sort += work.found.crossings;
  state_.balance.add(work.nodes, work.found.squares, work.found.lifted, scene_.method.transfer == Transfer::apic,
                     scene_.gravity, dt);
  finish_step(work.found, dt);
}

/// Changes what gas that passes an edge changes: points, and with them the sums at the nodes.
void MpmSolver::pass_edges(StepWork& work, double dt) {
  forget_sums(state_, set_);
  const EdgeFindings edges = state_.strips.after_step(state_.body_points(), scene_, dt, state_.time + dt);
  work.found.join(edges.found);
  if (edges.regrouped) state_.list_fluids(scene_);
  for (auto& text : state_.strips.take_news()) messages_.push_back(std::move(text));
  if (work.found.trouble.kind == TroubleKind::none) map_anew(state_, scene_, set_);
}

void MpmSolver::finish_step(const StepFindings& found, double dt) {
  state_.count_step(dt, scene_.clock.tmax);
  state_.point_steps += static_cast<long long>(state_.point_count());
  state_.c_max = std::sqrt(found.c_squared_max);
  state_.wave_max = found.wave_max;
  state_.heat_given += found.heat;
  state_.heat_under_way += found.heat;
  look();
  sort_where_scattered();
  if (found.crossings > 0 && !state_.strips.on()) set_.list_active(state_);
}

void MpmSolver::look() {
  if (strings_.on()) strings_.look(state_, scene_, messages_);
  if (stretches_.on() && (state_.steps % steps_between_looks == 1 || state_.time >= scene_.clock.tmax))
    stretches_.look(state_, scene_, messages_);
  if (mixing_.on() && state_.steps % steps_between_looks == 1) mixing_.look(state_, scene_, messages_);
  const bool last = state_.time >= scene_.clock.tmax;
  if (leaks_.on() && (last || state_.steps % steps_between_counts == 0)) leaks_.look(state_, scene_, messages_);
}

/// Once a quarter of the points have changed cell, neighbours in space are no longer neighbours in memory.
void MpmSolver::sort_where_scattered() {
  const auto scattered = [](const std::optional<Blocks>& blocks) { return blocks && blocks->scattered(); };
  if (std::any_of(state_.blocks.begin(), state_.blocks.end(), scattered)) {
    lay_out(state_, scene_);
    state_.list_fluids(scene_);
  }
  if (4 * state_.crossings_since_sort < static_cast<long long>(state_.point_count())) return;
  state_.crossings_since_sort = 0;
  sort_bodies(sort_, state_, scene_);
}

RunCounts MpmSolver::counts() const {
  const std::size_t points = scene_.strip ? scene_.strip->points() : state_.point_count();
  return {state_.steps, state_.point_steps, points, state_.dt_min, state_.dt_last};
}

Snapshot MpmSolver::points() const { return point_fields(state_, scene_).snapshot(); }

void MpmSolver::write_points(const std::function<void(const FieldsInTurn&)>& write) const {
  write(point_fields(state_, scene_).shared_by(*state_.team));
}

Snapshot MpmSolver::grid() const { return grid_fields(state_, scene_, set_); }

Summary MpmSolver::more_summary() const {
  std::size_t by_lanes = 0;
  const Unfolding unfolding(scene_.strip.get());
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const std::size_t first = scene_.bodies[b].first, count = state_.blocks[b] ? state_.blocks[b]->points() : 0;
    by_lanes += unfolding.unfolded(first, first + count);
  }
  Summary summary{line_of("points_by_lanes", by_lanes)};
  if (scene_.strip) summary.push_back(line_of("points_of_row", state_.point_count()));
  if (strings_.on()) summary.push_back(line_of("widest_gap", state_.widest_gap));
  if (stretches_.on()) summary.push_back(line_of("points_apart", state_.points_apart));
  if (mixing_.on()) summary.push_back(line_of("gases_apart", state_.gases_apart));
  if (leaks_.on()) summary.push_back(line_of("gas_leaked", state_.gas_leaked));
  return summary;
}

std::vector<std::string> MpmSolver::take_messages() { return std::exchange(messages_, {}); }

}  // namespace tether::mpm
