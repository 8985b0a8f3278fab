// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/bars/solver.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <utility>

#include "base/diagnostics.hpp"
#include "physics/step_clock.hpp"

namespace tether::fem {
namespace {

/// Steps between looks at what is behind walls: by number, so that what is reported does not depend on outputs.
constexpr long long steps_between_looks = 64;

/// The wall behind which a place lies, or null.
const char* wall_before(const Scene& scene, double x, double y) {
  const BackgroundGrid& grid = scene.grid;
  if (x < grid.x0 && scene.walls.left != Wall::open) return "left";
  if (x > grid.x1 && scene.walls.right != Wall::open) return "right";
  if (y < grid.y0 && scene.walls.bottom != Wall::open) return "bottom";
  return y > grid.y1 && scene.walls.top != Wall::open ? "top" : nullptr;
}

/// "point 3 (body 1, particle file)".
std::string point_text(const Scene& scene, std::size_t p) {
  std::size_t b = 0;
  while (p >= scene.bodies[b].first + scene.bodies[b].count) ++b;
  return fmt::format("point {} (body {}, {})", p + 1, b + 1, scene.bodies[b].name);
}

/// Finds, of the first bar without a finite length, the end that is farther off. A bar's second end may be an anchor,
/// which stays where it is.
std::size_t overflowed_point(const BarArrays& bars, const BarState& state, std::size_t points) {
  std::size_t e = 0;
  const auto squared = [&] {
    const double dx = state.x[bars.b[e]] - state.x[bars.a[e]], dy = state.y[bars.b[e]] - state.y[bars.a[e]];
    return dx * dx + dy * dy;
  };
  while (e + 1 < bars.bars() && squared() < std::numeric_limits<double>::infinity()) ++e;
  const auto way = [&](std::size_t n) {
    const double sum = std::abs(state.x[n]) + std::abs(state.y[n]);
    return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
  };
  return bars.b[e] < points && way(bars.b[e]) > way(bars.a[e]) ? bars.b[e] : bars.a[e];
}

}  // namespace

BarSolver::BarSolver(const Plan& plan)
    : plan_(plan),
      mesh_(bars_of(plan.scene)),
      bars_(plan.scene, mesh_),
      state_(start(plan.scene, mesh_, bars_)),
      columns_(bar_columns(plan.scene)) {}

void BarSolver::advance(double until, long long most) {
  while (state_.time < until && state_.time < plan_.scene.clock.tmax && most-- > 0) step(next_step());
}

double BarSolver::next_step() const {
  return step_before_end(plan_.step.first_step(), state_.time, plan_.scene.clock.tmax);
}

void BarSolver::step(double dt) {
  if (state_.steps > 0 && dt != state_.dt_last) carry_over(dt);
  if (!central_difference_step(bars_, state_, dt)) stop(dt);
  state_.count_step(dt, plan_.scene.clock.tmax);
  if (state_.steps % steps_between_looks == 0) look_behind_walls();
}

/// Steps of another length keep another energy: the total goes on from where it stands.
void BarSolver::carry_over(double dt) {
  const double change = dt * dt - state_.dt_last * state_.dt_last;
  state_.carried_over += 0.125 * change * squared_forces_per_mass(state_, plan_.scene);
}

void BarSolver::look_behind_walls() {
  for (std::size_t p = 0; p < plan_.scene.points.size() && !state_.behind_warned; ++p) {
    const char* wall = wall_before(plan_.scene, state_.x[p], state_.y[p]);
    if (!wall) continue;
    messages_.push_back(
        fmt::format("t = {:.6g}: {} is behind the {} wall at ({:.6g}, {:.6g}): bars feel walls at their ends only",
                    state_.time, point_text(plan_.scene, p), wall, state_.x[p], state_.y[p]));
    state_.behind_warned = true;
  }
}

void BarSolver::stop(double dt) const {
  const std::size_t p = overflowed_point(bars_, state_, plan_.scene.points.size());
  const double ratio = dt / plan_.step.first_limit;
  const char* cause = ratio > 1 ? "a step too long" : "a stiffness, load or stress too large";
  throw RunError(fmt::format(
      "t = {:.9g}, step {}: {} at ({:.6g}, {:.6g}) is the end of a bar without a finite length: its numbers "
      "overflowed; the step is {:#.3g} of the limit {}: likely cause, {}",
      state_.time + dt, state_.steps + 1, point_text(plan_.scene, p), state_.x[p], state_.y[p], ratio,
      plan_.step.limit_name, cause));
}

RunCounts BarSolver::counts() const {
  const std::size_t points = plan_.scene.points.size();
  return {state_.steps, state_.steps * static_cast<long long>(points), points, state_.dt_min, state_.dt_last};
}

Record BarSolver::record() const {
  return columns_.record(sums_of(state_, bars_, plan_.scene, state_.steps == 0 ? next_step() : state_.dt_last));
}

Snapshot BarSolver::points() const { return point_fields(state_, bars_, plan_.scene); }

std::vector<std::string> BarSolver::take_messages() { return std::exchange(messages_, {}); }

}  // namespace tether::fem
