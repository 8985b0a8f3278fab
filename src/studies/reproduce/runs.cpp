// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "deck/reader.hpp"
#include "read/method.hpp"
#include "studies/combinations.hpp"
#include "studies/read_study.hpp"
#include "studies/sweep.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;

/// Seconds between looks at the clock while nothing ends.
constexpr double patience = 1;

/// Where a run of one deck has written, by its key; a bisection is read from its own folder.
fs::path files_of(const PlannedRun& run) {
  if (run.study.mode == Mode::bisect) return run.out;
  return run_folder(run.out, run_key(read_deck(run.study, combinations(run.study).front())));
}

std::optional<RunRecord> record_of(const PlannedRun& run) {
  return read_record(files_of(run), run_key(read_deck(run.study, combinations(run.study).front())));
}

/// For the process of a run. A kill or a full disk leaves no record of a run: the last line of the report tells of it.
Ending sweep_alone(const PlannedRun& run, const std::string& command, int threads) {
  return end_of(run.study.file, [&] {
    const SweepResult result = sweep(run.study, {run.out, 1, threads, command, {}});
    if (result.signal != 0) throw Interrupted(result.signal, "interrupted");
    if (!result.verdicts.empty()) throw RunError(result.verdicts.front());
    if (run.study.mode == Mode::bisect || record_of(run)) return;
    const std::string why = split_lines(result.report).back();
    if (result.file_trouble > 0) throw FileError(why);
    throw RunError(why);
  });
}

/// How a run ended, by the record that it left; else by how its process did.
Ending ending_of(const PlannedRun& run, const Ending& of_process) {
  if (of_process.exit_code != exit_done || run.study.mode == Mode::bisect) return of_process;
  return record_of(run).value_or(RunRecord{}).ending;
}

/// Runs under way and those that wait.
class Pool {
 public:
  Pool(const std::vector<PlannedRun>& runs, Shares shares, const std::string& command,
       const std::function<void(const SweepProgress&)>& progress)
      : runs_(runs),
        jobs_(static_cast<std::size_t>(shares.jobs)),
        threads_(shares.threads),
        command_(command),
        progress_(progress),
        ends_(runs.size()) {}

  std::vector<RunEnd> run_all() {
    while (next_ < runs_.size() || workers_.count() > 0) {
      while (next_ < runs_.size() && workers_.count() < jobs_) start();
      heed(watch_.wait(patience));
      while (auto ended = workers_.take()) take(*ended);
      tell();
    }
    heed(watch_.take());
    if (signal_ != 0) throw Interrupted(signal_, "interrupted; the same command goes on where this one was");
    return std::move(ends_);
  }

 private:
  void start() {
    const PlannedRun& run = runs_[next_];
    workers_.start(next_++, [&] { return sweep_alone(run, command_, threads_); });
  }
  void take(const Finished& ended) {
    const PlannedRun& run = runs_[ended.id];
    const Ending ending = ending_of(run, ended.ending);
    ends_[ended.id] = {{ending.exit_code, one_line(ending.message)}, files_of(run)};
    ++done_, failed_ += ending.exit_code == exit_done ? 0 : 1;
    seconds_run_ += ended.wall_seconds;
  }
  /// Interrupted: nothing is started any more, and the runs stop at their next look at signals.
  void heed(int signal) {
    if (signal != SIGINT && signal != SIGTERM) return;
    signal_ = signal;
    next_ = runs_.size();
    workers_.tell(signal);
  }
  void tell() const {
    if (!progress_) return;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    const std::size_t left = runs_.size() - done_;
    const double each = done_ > 0 ? seconds_run_ / static_cast<double>(done_) : 0;
    progress_({done_, failed_, left, wall.count(), each * static_cast<double>(left) / static_cast<double>(jobs_)});
  }

  const std::vector<PlannedRun>& runs_;
  std::size_t jobs_;
  int threads_;
  const std::string& command_;
  const std::function<void(const SweepProgress&)>& progress_;
  std::vector<RunEnd> ends_;
  SignalWatch watch_{SIGINT, SIGTERM, SIGCHLD};
  Workers workers_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t next_ = 0, done_ = 0, failed_ = 0;
  double seconds_run_ = 0;
  int signal_ = 0;
};

}  // namespace

std::vector<RunEnd> run_all(const std::vector<PlannedRun>& runs, Shares shares, const std::string& command,
                            const std::function<void(const SweepProgress&)>& progress) {
  return Pool(runs, shares, command, progress).run_all();
}

namespace {

namespace fs = std::filesystem;

/// Lists the runs of problems one after the other; what is wrong with their decks is told at once at the end.
class Planner {
 public:
  explicit Planner(fs::path out) : out_(std::move(out)) {}

  void add(std::size_t number, const Problem& problem) {
    number_ = number, problem_ = &problem;
    add(Role::thesis, problem.by_points ? "thesis" : "deck", problem.thesis);
    if (problem.robust) add(Role::robust, "robust", *problem.robust);
  }

  std::vector<PlannedRun> all() {
    if (!unreadable_.empty()) throw FileError(fmt::format("{}", fmt::join(unreadable_, "\n")));
    diagnostics_.throw_if_errors();
    return std::move(runs_);
  }

 private:
  void add(Role role, const std::string& name, MethodRuns method) {
    if (problem_->by_points) method.overrides.insert(method.overrides.begin(), fmt::format("mpm.method='{}'", name));
    if (!problem_->study.empty()) return add_bisection(role, method, name);
    if (!method.varied)
      add_run(role, problem_->deck, method.overrides, name);
    else
      add_varied(role, method, name);
    if (problem_->compared_with.empty()) return;
    const Role reference = role == Role::thesis ? Role::thesis_reference : Role::robust_reference;
    add_run(reference, problem_->compared_with, method.overrides, name + "-reference");
  }

  void add_run(Role role, const std::string& deck, const std::vector<std::string>& overrides, const std::string& name) {
    const auto text = read(deck);
    if (!text) return;
    check(*text, deck, overrides);
    Study study;
    study.file = deck, study.text = *text, study.title = problem_->name;
    study.decks = {{1, study.file, *text}};
    study.sets = overrides;
    runs_.push_back({number_, role, std::move(study), out_ / problem_->name / name});
  }

  /// The mistakes of a deck are told once, not with every run of it.
  void check(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
    Diagnostics of_the_run;
    read_deck(text, file, overrides, of_the_run);
    if (!of_the_run.has_errors() || !told_.insert(file).second) return;
    for (const auto& mistake : of_the_run.errors()) diagnostics_.add(mistake);
  }

  /// Every part of dt = min(tstep, dtmax, cfl dx/c) is varied: whichever is the least, the step differs.
  void add_varied(Role role, const MethodRuns& method, const std::string& name) {
    const auto text = read(problem_->deck);
    if (!text) return;
    Diagnostics of_the_runs;
    const Deck deck = read_deck(*text, problem_->deck, method.overrides, of_the_runs);
    if (of_the_runs.has_errors()) return add_run(role, problem_->deck, method.overrides, name);  // tells them
    int k = 0;
    for (const double factor : ensemble_factors(varied_fraction, varied_runs)) {
      auto overrides = method.overrides;
      overrides.push_back(fmt::format("in.tstep={}", factor * deck.real("in.tstep")));
      if (deck.given("in.dtmax")) overrides.push_back(fmt::format("in.dtmax={}", factor * deck.real("in.dtmax")));
      if (cfl_of(deck) > 0) overrides.push_back(fmt::format("mpm.cfl={}", factor * cfl_of(deck)));
      add_run(role, problem_->deck, overrides, fmt::format("{}-{}", name, ++k));
    }
  }

  /// The study as it stands, but of this problem's deck alone.
  void add_bisection(Role role, const MethodRuns& method, const std::string& name) {
    if (!read(problem_->study)) return;
    Study study = read_study(problem_->study);
    const auto other = [&](const BaseDeck& deck) { return !fs::equivalent(deck.file, problem_->deck); };
    study.decks.erase(std::remove_if(study.decks.begin(), study.decks.end(), other), study.decks.end());
    if (study.decks.empty()) {
      throw InputError(fmt::format("{}: the study does not name the deck {}", problem_->study, problem_->deck));
    }
    study.sets.insert(study.sets.end(), method.overrides.begin(), method.overrides.end());
    runs_.push_back({number_, role, std::move(study), out_ / problem_->name / name});
  }

  /// The text of a file; nothing where it cannot be read, which is noted.
  std::optional<std::string> read(const fs::path& file) {
    try {
      return read_file(file);
    } catch (const FileError& error) {
      if (std::find(unreadable_.begin(), unreadable_.end(), error.what()) == unreadable_.end())
        unreadable_.emplace_back(error.what());
      return std::nullopt;
    }
  }

  fs::path out_;
  std::size_t number_ = 0;
  const Problem* problem_ = nullptr;  // whose runs are being added
  std::vector<PlannedRun> runs_;
  std::vector<std::string> unreadable_;
  std::set<std::string> told_;  // decks whose mistakes are noted
  Diagnostics diagnostics_;
};

}  // namespace

std::vector<PlannedRun> plan_runs(const std::vector<Problem>& problems, const fs::path& out) {
  Planner planner(out);
  for (std::size_t k = 0; k < problems.size(); ++k) planner.add(k, problems[k]);
  return planner.all();
}

}  // namespace tether::published
