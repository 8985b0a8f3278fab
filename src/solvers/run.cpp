// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "results/compare.hpp"
#include "results/energy_drift.hpp"
#include "results/result_folder.hpp"
#include "solvers/make.hpp"

namespace tether {
namespace {

/// Part of an interval by which a record may come early, so that rounding does not put it off by a step.
constexpr double early = 1e-9;

/// Part of the run after which the solver comes back for a progress line, whatever is due.
constexpr double progress_part = 1e-3;

/// Rise of the total energy, over what was exchanged, from which a run is told to gain energy.
constexpr double told_growth = 0.05;

/// Times k * interval at which something is due; never for an interval of 0.
class Due {
 public:
  explicit Due(double interval) : interval_(interval) { follow(0); }
  double next() const { return next_; }
  /// Whether it is due at this time; if so, the next is after it.
  bool passed(double time) {
    if (!(time >= next_)) return false;
    follow(time);
    return true;
  }

 private:
  void follow(double time) {
    const double never = std::numeric_limits<double>::max();
    const double k = std::floor(time / interval_ + early) + 1;
    next_ = interval_ > 0 ? std::max((k - early) * interval_, std::nextafter(time, never)) : never;
  }
  double interval_;
  double next_ = 0;
};

struct Clocks {
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  double cpu = cpu_now();

  static double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  static double cpu_now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  double wall_seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count(); }
  double cpu_seconds() const { return cpu_now() - cpu; }
};

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1e-3 * static_cast<double>(usage.ru_maxrss);  // Linux counts kilobytes
}

/// A run under way: the solver, the folder, and what is due when.
class Runner {
 public:
  Runner(const Plan& plan, const RunRequest& request)
      : plan_(plan),
        request_(request),
        solver_(make_solver(plan)),
        folder_(request.folder, solver_->history_layout(), request.provenance),
        history_{solver_->history_layout(), {}},
        history_due_(plan.scene.outputs.history),
        points_due_(plan.scene.outputs.points),
        grid_due_(plan.scene.outputs.grid) {
    folder_.deck_effective(request.deck_effective);
    for (const auto& message : request.messages) folder_.message(message);
    for (const auto& warning : plan.warnings) folder_.message("warning: " + warning);
  }

  RunOutcome to_the_end() {
    const double tmax = plan_.scene.clock.tmax;
    write_record();
    write_points();
    write_grid();
    while (solver_->time() < tmax) {
      const double look = solver_->time() + progress_part * tmax;
      solver_->advance(std::min({tmax, look, history_due_.next(), points_due_.next(), grid_due_.next()}));
      pass_messages();
      tell_progress();
      write_what_is_due(solver_->time() >= tmax);
    }
    return finish();
  }

  void stopped(const std::string& why) {
    pass_messages();
    folder_.message("error: " + why);
  }

 private:
  void write_what_is_due(bool end) {
    const double time = solver_->time();
    if (history_due_.passed(time) || end) write_record();
    if (points_due_.passed(time) || end) write_points();
    if (grid_due_.passed(time) || end) write_grid();
  }
  void write_record() {
    history_.records.push_back(solver_->record());
    folder_.append(history_.records.back());
  }
  void tell_progress() {
    if (!request_.progress) return;
    const RunCounts counts = solver_->counts();
    request_.progress({solver_->time(), plan_.scene.clock.tmax, counts.dt_last, counts, clocks_.wall_seconds()});
  }
  void write_points() {
    last_points_ = solver_->points();
    folder_.points(last_points_);
  }
  void write_grid() {
    if (plan_.scene.outputs.grid > 0) folder_.grid(plan_.scene.grid, solver_->grid());
  }
  void pass_messages() {
    for (const auto& message : solver_->take_messages()) warn(message);
  }
  RunOutcome finish() {
    const Comparison comparison = compare_or_say_why_not();
    warn_of_what_looks_wrong(comparison);
    if (!comparison.exact.names.empty()) folder_.reference(comparison.exact);
    Summary summary = summary_of_run();
    for (auto& line : summary_of(comparison)) summary.push_back(std::move(line));
    folder_.finish(summary);
    return {std::move(summary), std::move(history_)};
  }
  /// States that no exact solution covers (a gas without pressure, say) cost the comparison, not the run.
  Comparison compare_or_say_why_not() {
    try {
      return compare(plan_.scene, history_, last_points_);
    } catch (const std::domain_error& error) {
      warn(fmt::format("no comparison with the exact solution: {}", error.what()));
      return {};
    }
  }
  void warn_of_what_looks_wrong(const Comparison& comparison) {
    for (const Merit& merit : comparison.merits) {
      if (std::isnan(merit.error))
        warn(fmt::format("the run does not show its {}: too short, or no such motion", merit.name));
    }
    const double growth = energy_growth(history_);
    if (growth > told_growth) {
      warn(fmt::format(
          "the total energy rose by {:.2g} of the largest energy exchanged: points that change cell, a step "
          "near the limit, or a run that diverges",
          growth));
    }
  }
  void warn(const std::string& message) {
    folder_.message("warning: " + message);
    if (request_.warn) request_.warn(message);
  }
  Summary summary_of_run() const {
    const RunCounts counts = solver_->counts();
    const double cpu = clocks_.cpu_seconds();
    const auto number = [](auto value) { return fmt::format("{}", value); };
    return {{"path", "mpm"},
            {"steps", number(counts.steps)},
            {"points", number(counts.points)},
            {"cells_active", number(counts.cells_active)},
            {"time_end", number(solver_->time())},
            {"dt_min", number(counts.dt_min)},
            {"cpu_seconds", number(cpu)},
            {"wall_seconds", number(clocks_.wall_seconds())},
            {"ns_per_point_step", number(1e9 * cpu / static_cast<double>(std::max(counts.point_steps, 1LL)))},
            {"peak_memory_mb", number(peak_memory_mb())},
            {"energy_drift", number(energy_drift(history_))},
            {"mass_drift", number(mass_drift(history_))}};
  }

  const Plan& plan_;
  const RunRequest& request_;
  Clocks clocks_;
  std::unique_ptr<Solver> solver_;
  ResultFolder folder_;
  History history_;
  Snapshot last_points_;  // the final state is always written, so in the end it is this
  Due history_due_, points_due_, grid_due_;
};

}  // namespace

RunRequest request_of(const Loaded& loaded, const std::filesystem::path& folder, const std::string& command) {
  const std::string& text = loaded.deck.text();
  const Scene& scene = loaded.plan.scene;
  return {folder, {scene.title, command, text, sha256(text), scene.units}, loaded.effective, loaded.warnings, {}, {}};
}

RunOutcome run(const Plan& plan, const RunRequest& request) {
  Runner runner(plan, request);
  try {
    return runner.to_the_end();
  } catch (const RunError& error) {
    runner.stopped(error.what());
    throw;
  }
}

}  // namespace tether
