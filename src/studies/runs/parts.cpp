// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/parts.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/letters.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "studies/runs/local_crew.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

/// Plans that are made of parts at most: they are made one after the other.
constexpr std::size_t most_plans = 200;

/// The first run of a part, and how many it has.
struct FirstRun {
  const StudyRun* of = nullptr;
  Variant variant;
  double runs = 1;
};

/// Runs that a part has in all: a bisection halves its interval until it is short enough, a map may have to run each
/// square of a deck.
double runs_of_a_part(const Study& study) {
  const auto& [low, high, tolerance] = study.interval;
  const double larger = std::max(std::abs(low), std::abs(high));
  if (study.bisects()) return 2 + std::max(0., std::ceil(std::log2((high - low) / (tolerance * larger))));
  return study.mode == Mode::map ? count_combinations(study) / static_cast<double>(study.decks.size()) : 1;
}

/// By the parts' numbers, less 1.
std::vector<FirstRun> first_runs(const std::vector<StudyRun>& studies) {
  std::vector<FirstRun> all;
  PartNumbers numbers;
  for (const StudyRun& each : studies) {
    const auto variants = Sequences(each.study).first();
    const auto parts = numbers.of(each.study, variants);
    for (std::size_t n = 0; n < variants.size(); ++n) {
      if (parts[n] > all.size()) all.resize(parts[n], {&each, variants[n], runs_of_a_part(each.study)});
    }
  }
  return all;
}

PartCost cost_of(const FirstRun& first, std::size_t number) {
  const Study& study = first.of->study;
  const Combination combination = combinations(study)[first.variant.combination];
  const Cost cost = expected_cost(read_deck(study, combination, first.variant.varied));
  return {number, cost.seconds * first.runs, cost.megabytes};
}

}  // namespace

std::set<std::size_t> unfinished_parts(const std::vector<StudyRun>& studies) {
  LocalCrew nobody(1);
  return Scheduler(studies, {.out = {}, .crew = nobody, .command = {}, .progress = {}, .doing = Doing::collect})
      .run_all()
      .unfinished;
}

std::vector<PartCost> costs_of(const std::vector<StudyRun>& studies, const std::set<std::size_t>& parts) {
  const auto firsts = first_runs(studies);
  const std::vector<std::size_t> numbers(parts.begin(), parts.end());
  const std::size_t stride = (numbers.size() + most_plans - 1) / most_plans;
  std::vector<PartCost> costs, planned;
  for (std::size_t k = 0; k < numbers.size(); k += stride)
    planned.push_back(cost_of(firsts[numbers[k] - 1], numbers[k]));
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const PartCost &before = planned[k / stride], &after = planned[std::min(k / stride + 1, planned.size() - 1)];
    const bool is_planned = k % stride == 0;
    costs.push_back({.number = numbers[k],
                     .seconds = is_planned ? before.seconds : std::max(before.seconds, after.seconds),
                     .megabytes = is_planned ? before.megabytes : std::max(before.megabytes, after.megabytes)});
  }
  return costs;
}

std::string sum_of(const std::vector<StudyRun>& studies) {
  constexpr std::size_t digits = 12;
  Packed all;
  for (const auto& [study, out, most_cpu_seconds] : studies) {
    const auto every = combinations(study);
    all.add(study.text);
    for (const Variant& variant : Sequences(study).first()) {
      const Combination& combination = every[variant.combination];
      all.add(study.decks[combination.deck].file).add(overrides_of(study, combination, variant.varied));
    }
  }
  return sha256(all.text()).substr(0, digits);
}

namespace {

void refuse_other_parts(const std::vector<StudyRun>& studies, std::size_t last, const std::string& sum) {
  if (const std::string now = sum_of(studies); !sum.empty() && sum != now)
    throw InputError(fmt::format(
        "the study has changed since its parts were listed: its sum is {} now, not {}; --list and --slurm number its "
        "parts anew",
        now, sum));
  if (const std::size_t count = first_runs(studies).size(); last > count)
    throw InputError(fmt::format("there is no part {}: this command has {}", last, count));
}

}  // namespace

void do_parts(const std::vector<StudyRun>& studies, const StudyOptions& options, const std::string& work,
              const std::string& sum) {
  refuse_other_parts(studies, *options.parts.rbegin(), sum);
  const auto lock = take_folder(options, work);
  const Scheduler::Outcome all = Scheduler(studies, options).run_all();
  if (all.signal != 0) throw Interrupted(all.signal, "interrupted; the same command goes on where this one was");
  std::vector<std::string> said;  // by the runs that are lost: nothing else shows it
  for (const StudyOutcome& each : all.studies) {
    for (const FinishedRun& run : each.runs) {
      if (is_lost(run.record.ending)) said.push_back(run.record.ending.message);
    }
  }
  refuse_file_trouble(said.size(), said.empty() ? "" : said.front());
}

std::optional<std::set<std::size_t>> part_numbers(const std::string& text) {
  constexpr long long most = 1'000'000;  // more than a study has
  std::set<std::size_t> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string item = text.substr(from, to - from);
    const std::size_t dash = item.find('-');
    const auto first = parse_integer(item.substr(0, dash));
    const auto last = dash == std::string::npos ? first : parse_integer(item.substr(dash + 1));
    if (!first || !last || *first < 1 || *last < *first || *last > most) return std::nullopt;
    for (long long number = *first; number <= *last; ++number) numbers.insert(static_cast<std::size_t>(number));
    from = to + 1;
  }
  return numbers;
}

std::string part_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t end = k + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[k]);
    if (end > k + 1) text += fmt::format("-{}", numbers[end - 1]);
    k = end;
  }
  return text;
}

}  // namespace tether
