// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/search.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace tether::automatic {
namespace {

/// Runs after which a search that has found nothing ends.
constexpr std::size_t most_trials = 30;

/// A setting not run yet is run only where it is expected to cost this part of the best that was run, or less.
constexpr double worth_a_run = 0.5;

/// Before a goal is run, a run that says something of the limit is, where it costs less than this part.
constexpr double worth_asking = 0.15;

/// Cells and steps that are 1.5 times as fine as the deck's, which no halving comes to.
Resolution between_the_levels(const Aim& aim) {
  constexpr double as_fine = 1.5;
  return {aim.theory.space ? as_fine : 1, aim.theory.time ? as_fine : 1};
}

}  // namespace

std::optional<Posterior> Search::posterior() const {
  const auto values = samples_of(trials_);
  if (values.empty()) return std::nullopt;
  return Posterior(values, aim_.theory, scatter_);
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

/// Levels that are too coarse to be run say nothing: the search begins from finer ones.
std::vector<Resolution> Search::begin_finer() {
  const auto has = [&](NoValue why) {
    return std::ranges::any_of(trials_, [why](const Trial& trial) { return !trial.value && trial.why == why; });
  };
  if (has(NoValue::file)) return end("the runs do not write what the number is read off");
  own_size_fails_ = aim_.coarsest.space >= 1 && aim_.coarsest.time >= 1;
  if (own_size_fails_)
    return end(has(NoValue::number) ? "the runs end well and do not show the number, not even the deck's own one"
                                    : "the runs fail, the deck's own one, too");
  if (aim_.theory.space) aim_.coarsest.space *= 2;
  if (aim_.theory.time) aim_.coarsest.time *= 2;
  std::vector<Resolution> all;
  for (const Resolution& at : first_ones()) {
    if (std::ranges::none_of(trials_, [&](const Trial& trial) { return trial.wanted == at; })) all.push_back(at);
  }
  return all;
}

std::vector<Resolution> Search::next(double spent) {
  if (found_ || !why_not_.empty()) return {};
  if (trials_.empty()) return first_ones();
  const auto samples = samples_of(trials_);
  if (samples.size() < 2)
    return spent < aim_.budget ? begin_finer() : end("the budget is used up before two runs ended well");
  if (std::ranges::all_of(samples, [](const Sample& sample) { return sample.value == 0; }))
    return end("the number is 0 in every run: a tolerance relative to it says nothing");
  const Outlook outlook(aim_, trials_, scatter_);
  const auto best = has_own_size() && has_levels() ? cheapest_that_meets(outlook.posterior()) : std::nullopt;
  const bool is_doubtful = best && agree_perhaps_by_chance(outlook.posterior());
  const auto at = decide(outlook, best, is_doubtful);
  const double left = aim_.budget - spent, more = at ? outlook.seconds(*at) : 0;
  if (at && trials_.size() < most_trials && more <= left) return {*at};
  if (best && !is_doubtful) return found_ = best, std::vector<Resolution>{};
  const std::string known = what_is_known(outlook.posterior(), is_doubtful);
  own_size_fails_ = !at && !has_own_size() && left > 0;
  if (!at) return end(known + (has_own_size() ? ", and others fail" : ", and the deck's own cells and steps fail"));
  if (trials_.size() >= most_trials) return end(known + ", and more do not make it better known");
  return end(fmt::format("{}; the next one would take about {:.2g} s of the budget, which has {:.2g} s left", known,
                         more, std::max(left, 0.)));
}

std::string Search::what_is_known(const Posterior& posterior, bool is_doubtful) const {
  return fmt::format("{} runs know the limit to {:.2g} % of it{}", samples_of(trials_).size(),
                     100 * posterior.bound(posterior.limit(), promise),
                     is_doubtful ? ", since they all agree, which may be chance" : "");
}

/// The run to make next; none where the best that was run is the cheapest, or no run is left.
std::optional<Resolution> Search::decide(const Outlook& outlook, const std::optional<Setting>& best,
                                         bool is_doubtful) const {
  if (!has_own_size()) return own_size(outlook);
  auto goal = outlook.cheapest_expected();
  if (best) {
    if (goal && outlook.is_new(*goal) && outlook.seconds(*goal) < worth_a_run * best->trial.seconds) return goal;
    const Resolution between = between_the_levels(aim_);
    return is_doubtful && outlook.is_new(between) ? std::optional(between) : std::nullopt;
  }
  if (goal) goal = outlook.within_reach(*goal);
  const auto informing = outlook.most_informing();
  if (!goal || !outlook.is_new(*goal)) return informing;
  const bool is_cheap = informing && outlook.seconds(*informing) < worth_asking * outlook.seconds(*goal);
  return is_cheap ? informing : goal;
}

/// Levels that all agree to the tolerance may do so by chance, unless an error is seen to fall from one to the next. A
/// run that is none of them is made before anything is promised.
bool Search::agree_perhaps_by_chance(const Posterior& posterior) const {
  const bool agree = std::ranges::all_of(samples_of(trials_), [&](const Sample& sample) {
    return std::abs(sample.value - posterior.limit()) <= aim_.tolerance * std::abs(posterior.limit());
  });
  const auto is_between = [&](const Trial& trial) { return trial.value && trial.wanted == between_the_levels(aim_); };
  return agree && !error_falls() && std::ranges::none_of(trials_, is_between);
}

/// Returns whether the distance of the levels' values from the finest one's falls from level to level, from one that
/// counts on.
bool Search::error_falls() const {
  constexpr double counts = 0.01, falling = 0.8;       // of the tolerance; of the distance before
  std::map<double, std::pair<double, double>> levels;  // the finest steps of each and their value
  for (const Sample& sample : samples_of(trials_)) {
    const auto [size, other] =
        aim_.theory.space ? std::pair(sample.at.space, sample.at.time) : std::pair(sample.at.time, 0.);
    auto& [finest, value] = levels[size];
    if (other >= finest) finest = other, value = sample.value;
  }
  if (levels.size() < levels_in_space) return false;
  const double last = levels.rbegin()->second.second;
  double before = std::numeric_limits<double>::infinity(), first = std::abs(levels.begin()->second.second - last);
  for (const auto& [size, level] : levels) {
    const double distance = std::abs(level.second - last);
    if (distance > falling * before) return false;
    before = distance;
  }
  return first > counts * aim_.tolerance * std::abs(last);
}

bool Search::has_own_size() const {
  return std::ranges::any_of(
      trials_, [](const Trial& trial) { return trial.value && trial.wanted.space >= 1 && trial.wanted.time >= 1; });
}

/// The deck's own cells and steps; finer ones where they fail.
std::optional<Resolution> Search::own_size(const Outlook& outlook) const {
  for (const Resolution& at : {Resolution{1, 1}, {1, 2}, {2, 2}, {2, 4}}) {
    const bool is_possible = (at.space == 1 || aim_.theory.space) && (at.time == 1 || aim_.theory.time);
    if (is_possible && outlook.is_new(at)) return at;
  }
  return std::nullopt;
}

std::size_t Search::levels(double Resolution::*part) const {
  std::set<double> different;
  for (const Sample& sample : samples_of(trials_)) different.insert(sample.at.*part);
  return different.size();
}

bool Search::has_levels() const {
  const bool space = !aim_.theory.space || levels(&Resolution::space) >= levels_in_space;
  const std::size_t least = aim_.theory.space ? levels_in_time : levels_in_time_alone;
  return space && (!aim_.theory.time || levels(&Resolution::time) >= least);
}

std::optional<Setting> Search::cheapest_that_meets(const Posterior& posterior) const {
  std::optional<Setting> best;
  for (const Trial& trial : trials_) {
    if (!trial.value || posterior.chance_of(*trial.value, aim_.tolerance) < promise) continue;
    if (best && best->trial.seconds <= trial.seconds) continue;
    const double limit = posterior.limit();
    best = {trial, (*trial.value - limit) / std::abs(limit), posterior.bound(*trial.value, promise)};
  }
  return best;
}

}  // namespace tether::automatic
