// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/scheduler.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "studies/runs/read_run.hpp"

namespace tether {
namespace {

/// What estimates may take of the time of the crew: they save idle time at the end, and no more than that.
constexpr double share_of_estimates = 0.02;

bool is_interrupted(const Ending& ending) {
  return ending.exit_code == exit_signal + SIGINT || ending.exit_code == exit_signal + SIGTERM;
}

}  // namespace

Scheduler::Scheduler(const std::vector<StudyRun>& studies, const StudyOptions& options)
    : studies_(studies), options_(options) {
  for (const StudyRun& each : studies) {
    combinations_.push_back(combinations(each.study));
    indices_.emplace_back(each.study, each.out);
    outcome_.studies.push_back({{}, Sequences(each.study)});
  }
}

std::vector<std::size_t> PartNumbers::of(const Study& study, const std::vector<Variant>& first) {
  const std::size_t before = count_;
  const auto combinations = static_cast<std::size_t>(count_combinations(study));
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < first.size(); ++n) {
    std::size_t part = n;  // of its study, from 0
    if (study.bisects())
      part = first[n].combination;
    else if (study.mode == Mode::map)
      part = first[n].combination / (combinations / study.decks.size());
    numbers.push_back(before + part + 1);
    count_ = std::max(count_, numbers.back());
  }
  return numbers;
}

Scheduler::Outcome Scheduler::run_all() {
  want_first();
  if (options_.doing == Doing::collect)
    collect();
  else
    do_what_is_wanted();
  for (RunIndex& index : indices_) {
    if (options_.doing != Doing::parts) index.write();
  }
  for (StudyOutcome& each : outcome_.studies) {
    each.is_whole = outcome_.signal == 0 && each.unfinished == 0;
    std::sort(each.runs.begin(), each.runs.end(), [](const FinishedRun& a, const FinishedRun& b) {
      return std::tie(a.variant.combination, a.variant.number) < std::tie(b.variant.combination, b.variant.number);
    });
  }
  return std::move(outcome_);
}

void Scheduler::want_first() {
  PartNumbers numbers;
  for (std::size_t k = 0; k < studies_.size(); ++k) {
    const auto variants = outcome_.studies[k].sequences.first();
    const auto parts = numbers.of(studies_[k].study, variants);
    for (std::size_t n = 0; n < variants.size(); ++n) {
      if (is_wanted(parts[n]))
        queue_[{.number = next_number_++}] = {.study = k, .part = parts[n], .variant = variants[n]};
    }
  }
}

bool Scheduler::is_wanted(std::size_t part) const {
  return options_.doing != Doing::parts || options_.parts.contains(part);
}

void Scheduler::do_what_is_wanted() {
  Crew& crew = options_.crew;
  do {
    start_what_fits();
    estimate_one();
    if (crew.count() > 0) heed(watch_.wait(patience, crew.news()));
    take_estimate();
    take_what_ended();
    tell_progress();
  } while ((!queue_.empty() && outcome_.signal == 0) || crew.count() > 0);
  heed(watch_.take());
  if (outcome_.signal != 0) take_finished_before();
}

/// Follows the studies as far as finished runs lead.
void Scheduler::collect() {
  while (!queue_.empty()) {
    Wanted wanted = std::move(queue_.extract(queue_.begin()).mapped());
    look_up(wanted);
    if (auto run = finished_before(wanted))
      finish(wanted, std::move(*run));
    else if (outcome_.unfinished.insert(wanted.part).second)
      ++outcome_.studies[wanted.study].unfinished;
  }
}

void Scheduler::start_what_fits() {
  if (outcome_.signal != 0) return;
  for (auto at = queue_.begin(); at != queue_.end() && options_.crew.count() < options_.crew.size();) {
    at = start(at->second) ? queue_.erase(at) : std::next(at);
  }
}

/// False where it has to wait: the same run, wanted by another combination, is under way.
bool Scheduler::start(Wanted& wanted) {
  look_up(wanted);
  if (under_way_.contains(folder_of(wanted))) return false;
  if (auto run = finished_before(wanted)) {
    finish(wanted, std::move(*run));
    return true;
  }
  options_.crew.start(next_id_, task_of(wanted));
  under_way_.insert(folder_of(wanted));
  started_[next_id_++] = wanted;
  return true;
}

/// Of those that still wait when the studies are interrupted, takes what had been finished before.
void Scheduler::take_finished_before() {
  for (auto& [rank, wanted] : queue_) {
    look_up(wanted);
    if (auto run = finished_before(wanted)) finish(wanted, std::move(*run));
  }
}

/// By the index, else by the files that it left.
std::optional<FinishedRun> Scheduler::finished_before(const Wanted& wanted) const {
  if (auto run = indices_[wanted.study].find(wanted.variant, wanted.key)) return run;
  auto record = read_record(folder_of(wanted), wanted.key);
  if (!record) return std::nullopt;
  return finished_run(studies_[wanted.study].study, wanted.variant, std::move(*record), true, folder_of(wanted));
}

void Scheduler::look_up(Wanted& wanted) const {
  if (wanted.key.empty()) wanted.key = run_key(deck_of(wanted));
}

std::filesystem::path Scheduler::folder_of(const Wanted& wanted) const {
  return run_folder(studies_[wanted.study].out, wanted.key);
}

Deck Scheduler::deck_of(const Wanted& wanted) const {
  const Combination& combination = combinations_[wanted.study][wanted.variant.combination];
  return read_deck(studies_[wanted.study].study, combination, wanted.variant.varied);
}

RunTask Scheduler::task_of(const Wanted& wanted) const {
  const Study& study = studies_[wanted.study].study;
  const Combination& combination = combinations_[wanted.study][wanted.variant.combination];
  const BaseDeck& deck = study.decks[combination.deck];
  return {.deck = deck.file,
          .text = deck.text,
          .overrides = overrides_of(study, combination, wanted.variant.varied),
          .key = wanted.key,
          .folder = folder_of(wanted),
          .sign = options_.out / FolderLock::file_name,
          .threads = options_.threads,
          .most_cpu_seconds = studies_[wanted.study].most_cpu_seconds};
}

void Scheduler::take_what_ended() {
  while (auto done = options_.crew.take()) {
    const Wanted wanted = std::move(started_.extract(done->id).mapped());
    under_way_.erase(folder_of(wanted));
    seconds_run_ += done->record.wall_seconds;
    const bool is_unfinished = done->given_back || is_interrupted(done->record.ending);
    if (outcome_.signal != 0 && is_unfinished) continue;
    if (done->given_back)
      queue_[{.number = next_number_++}] = wanted;
    else
      finish(wanted, finished_run(studies_[wanted.study].study, wanted.variant, std::move(done->record), false,
                                  folder_of(wanted)));
  }
}

void Scheduler::finish(const Wanted& wanted, FinishedRun run) {
  StudyOutcome& outcome = outcome_.studies[wanted.study];
  ++done_, failed_ += run.failed() ? 1U : 0U, reused_ += run.reused ? 1U : 0U;
  indices_[wanted.study].add(run);
  if (outcome_.signal == 0) {
    for (const Variant& next : outcome.sequences.after(run))
      queue_[{.number = next_number_++}] = {.study = wanted.study, .part = wanted.part, .variant = next};
  }
  outcome.runs.push_back(std::move(run));
}

/// Has a process find out how long one of the runs takes that wait: the last one, which is the least likely to begin
/// meanwhile. Not where the order does not matter, nor where it would hold up the runs themselves.
void Scheduler::estimate_one() {
  const double share = seconds_passed() * static_cast<double>(options_.crew.size()) * share_of_estimates;
  if (options_.crew.size() == 1 || outcome_.signal != 0 || queue_.size() < 2 || estimators_.count() > 0 ||
      seconds_estimating_ > share)
    return;
  const auto& [rank, wanted] = *std::prev(queue_.end());
  if (rank.seconds >= 0) return;  // all are known
  estimators_.start(rank.number, [&] {
    return Ending{exit_done, fmt::format("{}", expected_cost(deck_of(wanted)).seconds)};
  });
}

void Scheduler::take_estimate() {
  const auto ended = estimators_.take();
  if (!ended) return;
  seconds_estimating_ += ended->cpu_seconds;
  auto run = queue_.extract(Rank{.number = ended->id});
  if (run.empty()) return;  // it has begun
  run.key().seconds = parse_real(ended->ending.message).value_or(0);
  queue_.insert(std::move(run));
}

/// Interrupted: nothing is started any more, and the runs stop at their next look at signals.
void Scheduler::heed(int signal) {
  if (signal != SIGINT && signal != SIGTERM) return;
  outcome_.signal = signal;
  options_.crew.tell(signal);
}

double Scheduler::seconds_passed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Scheduler::tell_progress() const {
  if (!options_.progress) return;
  const std::size_t run_now = done_ - reused_;
  const std::size_t left = queue_.size() + options_.crew.count();
  const double each = run_now > 0 ? seconds_run_ / static_cast<double>(run_now) : 0;
  const double seconds_left = each * static_cast<double>(left) / static_cast<double>(options_.crew.size());
  options_.progress({done_, failed_, left, seconds_passed(), seconds_left});
}

}  // namespace tether
