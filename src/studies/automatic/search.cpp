// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/search.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace tether::automatic {
namespace {

/// Runs after which a search that has found nothing ends.
constexpr std::size_t most_trials = 30;

/// Settings are looked for at powers of 2^(1/4) of the coarsest, up to 2^10 of it.
constexpr int steps_of_a_factor_2 = 4, most_factors_2 = 10;

/// A setting not run yet is run only where it is expected to cost this part of the best that was run, or less.
constexpr double worth_a_run = 0.7;

/// Before a goal is run, a run that says something of the limit is, where it costs less than this part.
constexpr double worth_asking = 0.3;

/// A run says nearly as much of the limit as another one where it says this part of that.
constexpr double nearly_as_much = 0.7;

}  // namespace

Search::Search(const Aim& aim) : aim_(aim) {}

std::vector<Sample> Search::samples() const {
  std::vector<Sample> all;
  for (const Trial& trial : trials_) {
    if (trial.value) all.push_back({trial.at, *trial.value});
  }
  return all;
}

Posterior Search::posterior() const {
  const auto values = samples();
  if (values.empty()) throw std::logic_error("a search without a run");
  return Posterior(values, aim_.theory, scatter_);
}

double Search::seconds() const {
  double sum = 0;
  for (const Trial& trial : trials_) sum += trial.seconds;
  return sum;
}

std::vector<Resolution> Search::end(const std::string& why) {
  why_not_ = why;
  return {};
}

/// The coarsest one, one with its steps halved, one with both halved: so that what cells do is known from what steps
/// do.
std::vector<Resolution> Search::first_ones() const {
  const auto [space, time] = aim_.coarsest;
  std::vector<Resolution> all{aim_.coarsest};
  if (aim_.theory.time) all.push_back({space, 2 * time});
  if (aim_.theory.space) all.push_back({2 * space, all.back().time});
  return all;
}

CostLaw Search::law() const {
  std::vector<Expense> costs;
  for (const Trial& trial : trials_) {
    if (trial.value) costs.push_back({trial.at, trial.seconds});
  }
  return CostLaw(costs, aim_.powers);
}

/// Levels that are too coarse to be run say nothing: the search begins from finer ones.
std::vector<Resolution> Search::begin_finer() {
  if (aim_.coarsest.space >= 1 && aim_.coarsest.time >= 1) return end("the runs fail, the deck's own one, too");
  if (aim_.theory.space) aim_.coarsest.space *= 2;
  if (aim_.theory.time) aim_.coarsest.time *= 2;
  std::vector<Resolution> all;
  for (const Resolution& at : first_ones()) {
    if (!was_wanted(at)) all.push_back(at);
  }
  return all;
}

std::vector<Resolution> Search::next() {
  if (found_ || !why_not_.empty()) return {};
  if (wanted_.empty()) return first_ones();
  if (samples().size() < 2) return begin_finer();
  if (std::ranges::all_of(samples(), [](const Sample& sample) { return sample.value == 0; }))
    return end("the number is 0 in every run: a tolerance relative to it says nothing");
  const Posterior now = posterior();
  const CostLaw cost = law();
  const auto at = decide(now, cost);
  if (found_ && !at) return {};
  const double more = at ? cost.seconds(*at) : 0;
  if (at && trials_.size() < most_trials && seconds() + more <= aim_.budget) return found_.reset(), std::vector{*at};
  if (found_) return {};  // a cheaper one is not within reach
  const std::string off =
      fmt::format("{} runs know the limit to {:.2g} % of it", samples().size(), 100 * now.bound(now.limit(), promise));
  if (!at) return end(off + ", and finer ones fail");
  if (trials_.size() >= most_trials) return end(off + ", and more do not make it better known");
  return end(fmt::format("{}; the next one would take about {:.2g} s of the budget, which has {:.2g} s left", off, more,
                         aim_.budget - seconds()));
}

/// The run to make next; none where the one that was found is the cheapest, or no run is left.
std::optional<Resolution> Search::decide(const Posterior& posterior, const CostLaw& law) {
  if (!has_own_size()) return Resolution{1, 1};
  auto goal = cheapest_expected(posterior, law);
  if (has_levels()) look(posterior);
  if (found_) {
    const bool pays = goal && !was_wanted(*goal) && law.seconds(*goal) < worth_a_run * trials_[found_->trial].seconds;
    if (pays) return goal;
    return agrees_by_chance_perhaps(posterior) ? std::optional(beside_the_levels()) : std::nullopt;
  }
  // What is expected far away is found wrong early: no step is longer than to twice as fine.
  if (goal) goal = Resolution{std::min(goal->space, 2 * finest().space), std::min(goal->time, 2 * finest().time)};
  const auto informing = most_informing(posterior, law);
  const bool is_new = goal && !was_wanted(*goal) && !is_known_to_fail(*goal);
  const bool is_cheap = informing && is_new && law.seconds(*informing) < worth_asking * law.seconds(*goal);
  return is_new && !is_cheap ? goal : informing;
}

/// Levels that all agree to the tolerance may do so by chance: no error was seen to fall. A run that is none of them is
/// made before anything is promised.
bool Search::agrees_by_chance_perhaps(const Posterior& posterior) const {
  const bool agree = std::ranges::all_of(samples(), [&](const Sample& sample) {
    return std::abs(sample.value - posterior.limit()) <= aim_.tolerance * std::abs(posterior.limit());
  });
  return agree && !was_wanted(beside_the_levels());
}

/// Cells and steps that are 1.5 times as fine as the deck's, which no halving comes to.
Resolution Search::beside_the_levels() const {
  constexpr double between = 1.5;
  return {aim_.theory.space ? between : 1, aim_.theory.time ? between : 1};
}

/// The search ends with no runs that are all coarser than the deck's own: what its cells resolve is known to be there.
bool Search::has_own_size() const {
  return std::ranges::any_of(wanted_, [](const Resolution& at) { return at.space >= 1 && at.time >= 1; });
}

bool Search::was_wanted(const Resolution& at) const { return std::ranges::find(wanted_, at) != wanted_.end(); }

/// What failed, fails with longer steps and smaller cells, too.
bool Search::is_known_to_fail(const Resolution& at) const {
  return std::ranges::any_of(failed_, [&](const Resolution& failed) {
    return at.space >= failed.space && at.time <= failed.time && !(failed.space < 1 && at.space > 1);
  });
}

void Search::take(const Trial& trial) {
  wanted_.push_back(trial.wanted);
  if (!trial.value) failed_.push_back(trial.wanted);
  const bool known = std::ranges::any_of(trials_, [&](const Trial& other) { return other.at == trial.at; });
  if (!known) trials_.push_back(trial);
}

std::size_t Search::levels(double Resolution::*part) const {
  std::set<double> different;
  for (const Sample& sample : samples()) different.insert(sample.at.*part);
  return different.size();
}

bool Search::has_levels() const {
  const bool space = !aim_.theory.space || levels(&Resolution::space) >= levels_in_space;
  const std::size_t least = aim_.theory.space ? levels_in_time : levels_in_time_alone;
  return space && (!aim_.theory.time || levels(&Resolution::time) >= least);
}

/// Finds the cheapest of the runs that were made that meets the tolerance.
void Search::look(const Posterior& posterior) {
  for (std::size_t k = 0; k < trials_.size(); ++k) {
    const Trial& trial = trials_[k];
    if (!trial.value || posterior.chance_of(*trial.value, aim_.tolerance) < promise) continue;
    if (found_ && trials_[found_->trial].seconds <= trial.seconds) continue;
    const double limit = posterior.limit();
    found_ = {k, (*trial.value - limit) / std::abs(limit), posterior.bound(*trial.value, promise)};
  }
}

std::optional<Resolution> Search::cheapest_expected(const Posterior& posterior, const CostLaw& law) const {
  const int most = steps_of_a_factor_2 * most_factors_2;
  const int spaces = aim_.theory.space ? most : 0, times = aim_.theory.time ? most : 0;
  std::optional<Resolution> best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= spaces; ++i) {
    for (int j = 0; j <= times; ++j) {
      const Resolution at{aim_.coarsest.space * std::exp2(static_cast<double>(i) / steps_of_a_factor_2),
                          aim_.coarsest.time * std::exp2(static_cast<double>(j) / steps_of_a_factor_2)};
      const double seconds = law.seconds(at);
      if (seconds >= least || is_known_to_fail(at)) continue;
      if (posterior.chance_at(at, aim_.tolerance) < promise) continue;
      best = at, least = seconds;
    }
  }
  return best;
}

/// The finest cells and steps that were run.
Resolution Search::finest() const {
  Resolution all = aim_.coarsest;
  for (const Trial& trial : trials_) {
    if (!trial.value) continue;
    all.space = std::max(all.space, trial.wanted.space), all.time = std::max(all.time, trial.wanted.time);
  }
  return all;
}

/// The cheapest of the runs that say nearly as much of the limit as the one that says most. None is more than twice as
/// fine in cells and steps as any before, so that what is expected is found wrong early.
std::optional<Resolution> Search::most_informing(const Posterior& posterior, const CostLaw& law) const {
  const Resolution most = finest();
  std::vector<std::pair<Resolution, double>> candidates;  // each with what it says
  double most_said = 0;
  for (double space = aim_.coarsest.space; space <= (aim_.theory.space ? 2 * most.space : 1); space *= 2) {
    for (double time = aim_.coarsest.time; time <= (aim_.theory.time ? 2 * most.time : 1); time *= 2) {
      const Resolution at{space, time};
      if (was_wanted(at) || is_known_to_fail(at)) continue;
      candidates.emplace_back(at, posterior.informs(at));
      most_said = std::max(most_said, candidates.back().second);
    }
  }
  std::optional<Resolution> best;
  for (const auto& [at, said] : candidates) {
    if (said >= nearly_as_much * most_said && (!best || law.seconds(at) < law.seconds(*best))) best = at;
  }
  return best;
}

/// That of the second level, which is cheap and not the worst.
std::optional<Resolution> Search::to_vary() const {
  if (!aim_.theory.time || samples().size() < 2 || !trials_.back().value) return std::nullopt;
  return trials_.back().wanted;
}

}  // namespace tether::automatic
