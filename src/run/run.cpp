// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "results/checkpoint.hpp"
#include "results/compare.hpp"
#include "results/energy_drift.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "run/outputs.hpp"
#include "run/restart.hpp"
#include "run/summary.hpp"
#include "run/watch.hpp"

namespace tether {
namespace {

/// Part of the run after which the solver comes back for a progress line, whatever is due.
constexpr double progress_part = 1e-3;

/// Where a record costs as much as a step or two, so that looking costs less than a hundredth.
constexpr long long steps_between_looks = 64;

/// A run under way: the solver, and its outputs.
class Runner {
 public:
  Runner(Plan plan, const RunRequest& request)
      : plan_(std::move(plan)),
        request_(request),
        clocks_(request.clocks),
        solver_(plan_.scene.reference == ReferenceKind::none ? make_solver_with_points_of(plan_, request.threads)
                                                             : make_solver(plan_, request.threads)),
        lock_(request.folder, request.deck),
        earlier_(request.restart.empty() ? earlier_run(request.folder, request.deck_effective) : EarlierRun{}),
        outputs_(plan_, request, *solver_),
        watch_(plan_.scene, solver_->history_layout()) {
    if (!lock_.weakness().empty())
      outputs_.warn(
          fmt::format("the folder cannot be locked ({}): another run into it would not be refused", lock_.weakness()));
  }

  void from_the_start() {
    clear_away();
    outputs_.write_the_start();
    look(outputs_.history().records.back());
    clocks_.end_of_setup();
  }

  void from(const Checkpoint& checkpoint) {
    solver_->restore(checkpoint.state);
    clocks_.go_on_from(checkpoint);
    outputs_.restore(checkpoint);
    watch_.restore(checkpoint.watched, checkpoint.records.front());
    clocks_.end_of_setup();
    last_checkpoint_ = request_.restart, last_checkpoint_time_ = checkpoint.time;
  }

  RunOutcome to_the_end() {
    if (request_.threads > 1) outputs_.write_meanwhile();
    while (!at_end()) {
      const double next = std::min(plan_.scene.clock.tmax, outputs_.next());
      go_on(std::min(next, look_ahead()), next);
      if (is_asked_to_stop() && !solver_->readable()) go_on(solver_->time(), solver_->time());
      stop_if_interrupted();
    }
    return finish();
  }

  /// The error's text with what there is to go on from, which also goes into messages.txt.
  std::string stopped(const std::string& why) {
    outputs_.wait();
    pass_messages();
    std::string text = why;
    if (!last_checkpoint_.empty()) {
      text += fmt::format("; last good checkpoint: {} (t = {:.6g})", last_checkpoint_.string(), last_checkpoint_time_);
    }
    outputs_.note("error: " + text);
    return text;
  }

 private:
  void clear_away() {
    if (earlier_.text.empty()) return;
    for (const auto& checkpoint : earlier_.foreign_checkpoints) remove_checkpoint(checkpoint);
    outputs_.note("remark: " + earlier_.text);
    if (request_.remark) request_.remark(earlier_.text);
  }
  /// Advances. Where a record costs next to nothing, it looks at every step, else at some: a run that goes wrong
  /// between records is to end by its limits, too.
  void advance(double until) {
    const long long every = solver_->watched_each_step() ? 1 : steps_between_looks;
    do {
      solver_->advance(until, every - solver_->counts().steps % every);
      if (solver_->counts().steps % every == 0) look(solver_->record());
    } while (solver_->time() < until && !at_end() && signal_ == 0);
  }
  void look(const Record& record) {
    watch_.look(record, *solver_);
    for (const auto& message : watch_.take_messages()) outputs_.warn(message);
  }
  bool at_end() const { return solver_->time() >= plan_.scene.clock.tmax; }
  /// At least one step, and no further than the next look at signals and progress.
  double look_ahead() const {
    const double time = solver_->time(), tmax = plan_.scene.clock.tmax;
    const double ahead = std::min(progress_part * tmax, pace_.ahead(solver_->counts().dt_last));
    return std::max(time + ahead, std::nextafter(time, tmax));
  }
  void pass_messages() {
    for (const auto& message : solver_->take_messages()) outputs_.warn(message);
  }
  void tell_progress() {
    if (!request_.progress) return;
    const RunCounts counts = solver_->counts();
    request_.progress({solver_->time(), plan_.scene.clock.tmax, counts.dt_last, counts, clocks_.whole().wall});
  }
  /// Steps until a time, one at least, of which nothing is read before another one, and what is due after them.
  void go_on(double until, double reading) {
    solver_->expect_reading(reading);
    advance(std::max(until, std::nextafter(solver_->time(), plan_.scene.clock.tmax)));
    pace_.came_back(clocks_.whole().wall);
    pass_messages();
    tell_progress();
    const std::size_t before = outputs_.history().records.size();
    outputs_.write_what_is_due(at_end());
    if (!solver_->watched_each_step() && outputs_.history().records.size() > before)
      look(outputs_.history().records.back());
    if (outputs_.takes_checkpoint(at_end())) write_checkpoint();
  }
  void write_checkpoint() {
    outputs_.wait();
    Checkpoint now;
    now.provenance = request_.provenance;
    now.deck_effective = request_.deck_effective;
    now.time = solver_->time();
    now.state = solver_->save();
    now.watched = watch_.save();
    outputs_.save(now);
    now.whole = clocks_.whole(), now.setup = clocks_.setup();
    now.parts = clocks_.with_earlier(solver_->cost_parts());
    last_checkpoint_ = add_checkpoint(request_.folder, now), last_checkpoint_time_ = now.time;
  }
  bool is_asked_to_stop() {
    if (signal_ == 0 && request_.interrupted) signal_ = request_.interrupted();
    return signal_ != 0;
  }
  void stop_if_interrupted() {
    if (at_end() || !is_asked_to_stop()) return;
    write_checkpoint();
    const auto text = fmt::format("interrupted at t = {:.6g}, step {}; the same command goes on with --restart {}",
                                  solver_->time(), solver_->counts().steps, last_checkpoint_.string());
    outputs_.note(text);
    throw Interrupted(signal_, text);
  }
  RunOutcome finish() {
    outputs_.wait();
    const Comparison comparison = compare_or_say_why_not();
    warn_of_what_looks_wrong(comparison);
    if (!comparison.exact.names.empty()) outputs_.folder().reference(comparison.exact);
    Summary summary = summary_of_run();
    for (auto& line : watch_.summary()) summary.push_back(std::move(line));
    if (!balances_energy(plan_.scene, outputs_.history().layout))
      std::erase_if(summary, [](const auto& line) { return line.first.starts_with("energy_"); });
    if (std::isnan(energy_growth(outputs_.history())))
      std::erase_if(summary, [](const auto& line) { return line.first == "energy_growth"; });
    for (auto& line : scene_summary(plan_, outputs_.history())) summary.push_back(std::move(line));
    for (auto& line : solver_->more_summary()) summary.push_back(std::move(line));
    for (const auto& [name, taken] : clocks_.with_earlier(solver_->cost_parts())) {
      summary.push_back(line_of(SummaryKey(name + "_cpu_seconds"), taken.cpu));
      summary.push_back(line_of(SummaryKey(name + "_wall_seconds"), taken.wall));
    }
    for (auto& line : summary_of(comparison)) summary.push_back(std::move(line));
    outputs_.folder().finish(summary);
    return {std::move(summary), outputs_.history()};
  }
  /// States that no exact solution covers (a gas without pressure, say) cost the comparison, not the run.
  Comparison compare_or_say_why_not() {
    try {
      if (plan_.scene.reference == ReferenceKind::none) return {};
      return compare(plan_.scene, outputs_.history(), solver_->points());
    } catch (const std::domain_error& error) {
      outputs_.warn(fmt::format("no comparison with the exact solution: {}", error.what()));
      return {};
    }
  }
  void warn_of_what_looks_wrong(const Comparison& comparison) {
    for (const Merit& merit : comparison.merits) {
      if (std::isnan(merit.error))
        outputs_.warn(fmt::format("the run does not show its {}: too short, or no such motion", merit.name));
    }
    if (!balances_energy(plan_.scene, outputs_.history().layout)) return;
    for (const std::string& lost : lost_energy_warnings(plan_.scene, outputs_.history())) outputs_.warn(lost);
    const double rise = energy_rise(outputs_.history());
    const double most = plan_.scene.limits.energy_growth.warn;
    if (most > 0 && rise > most) {
      outputs_.warn(
          fmt::format("the total energy rose by {:.2g} of the largest energy exchanged: {}, or a run that diverges "
                      "(energy_growth of $limits)",
                      rise,
                      plan_.scene.path() == Path::mpm ? "points that change cell, a step near the limit"
                                                      : "a step near the limit or too long"));
    }
  }
  Summary summary_of_run() const {
    const RunCounts counts = solver_->counts();
    const Seconds whole = clocks_.whole(), setup = clocks_.setup();
    return {line_of("path", path_name(plan_.scene.path())),
            line_of("steps", counts.steps),
            line_of("points", counts.points),
            line_of("cells_active", solver_->cells_active()),
            line_of("dx", plan_.scene.grid.dx),
            line_of("time_end", solver_->time()),
            line_of("dt_min", counts.dt_min),
            line_of("cpu_seconds", whole.cpu),
            line_of("wall_seconds", whole.wall),
            line_of("setup_cpu_seconds", setup.cpu),
            line_of("setup_wall_seconds", setup.wall),
            line_of("threads", request_.threads),
            line_of("ns_per_point_step",
                    1e9 * (whole - setup).cpu / static_cast<double>(std::max(counts.point_steps, 1LL))),
            line_of("peak_memory_mb", peak_memory_mb()),
            line_of("energy_drift", energy_drift(outputs_.history())),
            line_of("energy_lost", energy_lost(outputs_.history())),
            line_of("energy_growth", energy_growth(outputs_.history())),
            line_of("energy_rise", energy_rise(outputs_.history())),
            line_of("mass_drift", mass_drift(outputs_.history()))};
  }

  Plan plan_;
  const RunRequest& request_;
  Clocks clocks_;
  std::unique_ptr<Solver> solver_;
  FolderLock lock_;     // before the outputs, which it outlives
  EarlierRun earlier_;  // before the outputs, which take the place of its
  RunOutputs outputs_;
  Watch watch_;
  Pace pace_;
  std::filesystem::path last_checkpoint_;
  double last_checkpoint_time_ = 0;
  int signal_ = 0;  // to stop for
};

}  // namespace

RunOutcome run(Plan plan, const RunRequest& request) {
  std::optional<Checkpoint> checkpoint;  // read before the run makes its folder anew
  if (!request.restart.empty()) {
    checkpoint = checkpoint_for(request.restart, request.deck_effective);
  }
  Runner runner(std::move(plan), request);
  if (checkpoint)
    runner.from(*checkpoint);
  else
    runner.from_the_start();
  try {
    return runner.to_the_end();
  } catch (const RunError& error) {
    throw RunError(runner.stopped(error.what()), error.failure());
  }
}

}  // namespace tether
