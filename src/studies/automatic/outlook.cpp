// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/outlook.hpp"

#include <algorithm>
#include <cmath>

namespace tether::automatic {
namespace {

/// Settings are looked for at powers of 2^(1/4) of the coarsest, up to 2^10 of it; nested cells at 1/4, 1/2, 1, 2, 3,
/// 4, 6, 8 and so on of the deck's.
constexpr int steps_of_a_factor_2 = 4, most_factors_2 = 10;

/// A run says nearly as much of the limit as another one where it says this part of that.
constexpr double nearly_as_much = 0.7;

/// What runs cost grows by leaps, so that all of them together cost little more than the last: a run that is made to
/// know more costs less than this part of the most costly one so far, or so many times as much.
constexpr double small_change = 0.1, least_leap = 2.5, most_leap = 10;

/// How much finer than all so far such a run may be.
constexpr double finer_cells = 2, finer_steps = 4;

std::vector<Expense> expenses_of(const std::vector<Trial>& trials) {
  std::vector<Expense> all;
  for (const Trial& trial : trials) {
    if (trial.value) all.push_back({trial.at, trial.seconds});
  }
  return all;
}

}  // namespace

std::vector<Sample> samples_of(const std::vector<Trial>& trials) {
  std::vector<Sample> all;
  for (const Trial& trial : trials) {
    const bool known = std::ranges::any_of(all, [&](const Sample& other) { return other.at == trial.at; });
    if (trial.value && !known) all.push_back({trial.at, *trial.value});
  }
  return all;
}

Outlook::Outlook(const Aim& aim, const std::vector<Trial>& trials, double scatter)
    : aim_(aim),
      trials_(trials),
      posterior_(samples_of(trials), aim.theory, scatter),
      law_(expenses_of(trials), aim.powers),
      finest_(aim.coarsest) {
  for (const Trial& trial : trials) {
    if (!trial.value) continue;
    finest_.space = std::max(finest_.space, trial.wanted.space);
    finest_.time = std::max(finest_.time, trial.wanted.time);
    most_seconds_ = std::max(most_seconds_, trial.seconds);
  }
}

/// A scene that cannot be built cannot be built with coarser cells either. A run that failed fails with longer steps
/// and finer cells, too, unless one such run ended well.
bool Outlook::is_known_to_fail(const Resolution& at) const {
  const auto is_worse = [](const Resolution& a, const Resolution& b) { return a.space >= b.space && a.time <= b.time; };
  return std::ranges::any_of(trials_, [&](const Trial& failed) {
    if (failed.value) return false;
    if (failed.why == NoValue::scene) return at.space <= failed.wanted.space;
    return is_worse(at, failed.wanted) && std::ranges::none_of(trials_, [&](const Trial& other) {
             return other.value && is_worse(other.wanted, failed.wanted);
           });
  });
}

/// How much finer than the deck's the limit makes the steps in cells of that size: in proportion to them, as in the
/// runs whose steps it cut; 0 where it cut none.
double Outlook::cut_to(double space) const {
  double steps = 0;
  for (const Trial& trial : trials_) {
    if (trial.value && trial.at.time > is_cut * trial.wanted.time)
      steps = std::max(steps, trial.at.time * std::min(1., space / trial.wanted.space));
  }
  return steps;
}

bool Outlook::is_new(const Resolution& at) const {
  const double cut = cut_to(at.space);
  const auto is_it = [&](const Trial& trial) {
    const bool are_cut = std::max(trial.wanted.time, at.time) < is_cut * cut;
    return trial.wanted.space == at.space && (trial.wanted.time == at.time || are_cut);
  };
  return std::ranges::none_of(trials_, is_it) && !is_known_to_fail(at);
}

/// How fine cells may be, over the deck's. Where bodies do not fit the cells, those that are no whole part of others
/// are cut by bodies otherwise, and have errors of their own.
std::vector<double> Outlook::spaces() const {
  if (!aim_.theory.space) return {aim_.coarsest.space};
  std::vector<double> all;
  for (int i = 0; i <= steps_of_a_factor_2 * most_factors_2; ++i) {
    const double factor = std::exp2(static_cast<double>(i) / steps_of_a_factor_2);
    if (!aim_.nested || i % steps_of_a_factor_2 == 0) all.push_back(aim_.coarsest.space * factor);
    if (aim_.nested && i % steps_of_a_factor_2 == 0 && all.back() > 1) all.push_back(1.5 * all.back());
  }
  return all;
}

std::optional<Resolution> Outlook::cheapest_expected() const {
  const int times = aim_.theory.time ? steps_of_a_factor_2 * most_factors_2 : 0;
  std::optional<Resolution> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double space : spaces()) {
    for (int j = 0; j <= times; ++j) {
      const Resolution at{space, aim_.coarsest.time * std::exp2(static_cast<double>(j) / steps_of_a_factor_2)};
      if (seconds(at) >= least || is_known_to_fail(at)) continue;
      if (!posterior_.meets(as_run(at), aim_.tolerance, promise)) continue;
      best = at, least = seconds(at);
    }
  }
  return best;
}

Resolution Outlook::within_reach(const Resolution& at) const {
  return {std::min(at.space, finer_cells * finest_.space), std::min(at.time, finer_cells * finest_.time)};
}

/// The new resolutions at powers of 2, those that make a leap or cost small change; all where none does. Small change
/// is spent once between leaps.
std::vector<Resolution> Outlook::in_reach() const {
  std::vector<Resolution> all, leaps;
  const bool was_cheap = trials_.back().seconds < small_change * most_seconds_;
  for (double space = aim_.coarsest.space; space <= (aim_.theory.space ? finer_cells * finest_.space : 1); space *= 2) {
    for (double time = aim_.coarsest.time; time <= (aim_.theory.time ? finer_steps * finest_.time : 1); time *= 2) {
      const Resolution at{space, time};
      if (!is_new(at)) continue;
      all.push_back(at);
      const double times_the_most = seconds(at) / most_seconds_;
      const bool is_leap = times_the_most > least_leap && times_the_most < most_leap;
      if (is_leap || (times_the_most < small_change && !was_cheap)) leaps.push_back(at);
    }
  }
  return leaps.empty() ? all : leaps;
}

std::optional<Resolution> Outlook::most_informing() const {
  const std::vector<Resolution> candidates = in_reach();
  std::vector<double> said;
  for (const Resolution& at : candidates) said.push_back(posterior_.informs(as_run(at)));
  std::optional<Resolution> best;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (said[k] < nearly_as_much * *std::ranges::max_element(said)) continue;
    if (!best || seconds(candidates[k]) < seconds(*best)) best = candidates[k];
  }
  return best;
}

}  // namespace tether::automatic
