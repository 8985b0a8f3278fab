// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/rehearsal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "run/make.hpp"
#include "run/request.hpp"

namespace tether {
namespace {

constexpr double rehearsal_seconds = 0.1;                    ///< that the steps on trial take together [s]
constexpr long long least_steps = 6;                         ///< of them
constexpr double longest_step = 0.7, most_megabytes = 3000;  ///< by the estimate, for which a rehearsal is made [s, MB]

/// What writing costs in addition to the forming of what is written: of a run's files, a record, a field of a snapshot
/// and a number of it; measured [s].
constexpr double seconds_per_run = 3e-3, seconds_per_record = 25e-6, seconds_per_field = 2.2e-4,
                 seconds_per_number = 20e-9;
/// What the library that writes holds, with snapshots more, and for each field of each snapshot; measured [MB].
constexpr double writing_megabytes = 6, snapshot_megabytes = 3.5, field_megabytes = 2.5e-3;

/// What a nonzero of the factors, a number and its row in L and in U, takes once more where bodies go from cell to
/// cell: the steps on trial do not see that their pattern is renewed, of which the library of factors holds the old one
/// for a while. Measured on flaps and a block within 25 % of the whole [MB].
constexpr double renewed_megabytes = 24e-6;

/// Where the trial stood when the solver came back.
struct Mark {
  double cpu = 0;   // [s]
  double time = 0;  // of the scene [time]
  long long steps = 0;
  long long point_steps = 0;
};

struct Trial {
  std::vector<Mark> marks;
  double start_cpu = 0;                     // of reading and setting up [s]
  double record_cpu = 0, snapshot_cpu = 0;  // of forming one [s]
  std::size_t columns = 0, fields = 0, snapshot_numbers = 0;
  double factor_nonzeros = 0;  // of a flow with bodies
};

void count(const Snapshot& snapshot, Trial& trial) {
  trial.fields += snapshot.fields.size();
  for (const Field& field : snapshot.fields) trial.snapshot_numbers += field.values.size();
}

/// Forms what is written once, and times it.
void try_outputs(const Solver& solver, const Scene& scene, Trial& trial) {
  const double begin = seconds_now().cpu;
  trial.columns = solver.record().size();
  const double formed = seconds_now().cpu;
  if (scene.outputs.points > 0) count(solver.points(), trial);
  if (scene.outputs.grid > 0) count(solver.grid(), trial), count(solver.solids(), trial);
  trial.record_cpu = formed - begin, trial.snapshot_cpu = seconds_now().cpu - formed;
}

double factor_nonzeros_of(const Solver& solver) {
  for (const auto& [key, value] : solver.more_summary()) {
    if (key == "factor_nonzeros") return std::stod(value);
  }
  return 0;
}

Trial try_steps(const Plan& plan) {
  Trial trial;
  const std::unique_ptr<Solver> solver = make_solver(plan);
  trial.start_cpu = seconds_now().cpu;
  const double tmax = plan.scene.clock.tmax;
  const auto mark = [&] {
    const RunCounts counts = solver->counts();
    trial.marks.push_back({seconds_now().cpu, solver->time(), counts.steps, counts.point_steps});
  };
  mark();
  long long ahead = 1;  // steps to go before the next look at the clock
  while (solver->time() < tmax) {
    const double dt = solver->counts().dt_last, time = solver->time();
    solver->advance(
        std::min(tmax, std::max(time + (static_cast<double>(ahead) - 0.5) * dt, std::nextafter(time, tmax))));
    mark();
    const double taken = trial.marks.back().cpu - trial.marks.front().cpu;
    if (taken > rehearsal_seconds && trial.marks.back().steps >= least_steps) break;
    if (taken < rehearsal_seconds / 8) ahead *= 2;
  }
  try_outputs(*solver, plan.scene, trial);
  if (plan.scene.flow() && plan.scene.solids()) trial.factor_nonzeros = factor_nonzeros_of(*solver);
  return trial;
}

/// The mark from which on the later half of the steps was made: the first ones also set up what is kept. There are two
/// marks at least.
const Mark& settled(const std::vector<Mark>& marks) {
  const auto later_half = [&](const Mark& mark) { return 2 * (mark.steps + 1) > marks.back().steps; };
  return *std::find_if(marks.begin(), marks.end() - 2, later_half);
}

/// How often something is written at this interval: at the start, at the end, and between them once a step at most.
double times_due(double interval, double tmax, double steps) {
  return interval > 0 ? std::min(std::ceil(tmax / interval), steps) + 1 : 0;
}

Cost carried_on(const Trial& trial, const Scene& scene) {
  const Mark &first = trial.marks.front(), &last = trial.marks.back(), &from = settled(trial.marks);
  const double tmax = scene.clock.tmax, left = tmax - last.time;
  const auto made = static_cast<double>(last.steps - from.steps);
  const double steps_left = left > 0 ? std::ceil(left / (last.time - from.time) * made * (1 - 1e-9)) : 0;
  const double step_cpu = (last.cpu - from.cpu) / made;
  Cost cost;
  cost.rehearsed = last.steps;
  cost.steps = static_cast<double>(last.steps) + steps_left;
  cost.point_steps = static_cast<double>(last.point_steps) +
                     steps_left * static_cast<double>(last.point_steps - from.point_steps) / made;
  const double records = times_due(scene.outputs.history, tmax, cost.steps);
  const double snapshots =
      std::max(times_due(scene.outputs.points, tmax, cost.steps), times_due(scene.outputs.grid, tmax, cost.steps));
  cost.seconds = trial.start_cpu + (last.cpu - first.cpu) + steps_left * step_cpu + seconds_per_run +
                 records * (trial.record_cpu + seconds_per_record) +
                 snapshots * (trial.snapshot_cpu + seconds_per_field * static_cast<double>(trial.fields) +
                              seconds_per_number * static_cast<double>(trial.snapshot_numbers));
  cost.megabytes = peak_memory_mb() + writing_megabytes + (snapshots > 0 ? snapshot_megabytes : 0) +
                   field_megabytes * snapshots * static_cast<double>(trial.fields) +
                   renewed_megabytes * trial.factor_nonzeros +
                   1e-6 * sizeof(double) * records * static_cast<double>(trial.columns);
  return cost;
}

}  // namespace

Plan rehearsed(Plan plan) {
  const bool large = plan.cost.seconds > longest_step * plan.cost.steps || plan.cost.megabytes > most_megabytes;
  if (large) return plan;
  try {
    const Trial trial = try_steps(plan);
    if (trial.marks.size() > 1) plan.cost = carried_on(trial, plan.scene);
  } catch (const RunError& error) {
    plan.warnings.push_back(fmt::format("the first steps, made on trial, fail: {}", error.what()));
  }
  return plan;
}

}  // namespace tether
