// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <optional>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "deck/reader.hpp"
#include "read/method.hpp"
#include "studies/combinations.hpp"
#include "studies/read_study.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;

/// Lists the runs of problems one after the other; what is wrong with their decks is reported at once at the end.
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
    runs_.push_back({{std::move(study), out_ / problem_->name / name}, number_, role});
  }

  /// The mistakes of a deck are reported once, not with every run of it.
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
    if (of_the_runs.has_errors()) return add_run(role, problem_->deck, method.overrides, name);  // reports them
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
    runs_.push_back({{std::move(study), out_ / problem_->name / name}, number_, role});
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
