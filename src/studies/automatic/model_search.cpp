// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/model_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::automatic {
namespace {

/// The level at which choices are tried: half as many cells and steps as the deck's, else the deck's own.
constexpr double tried_at = 0.5;

Resolution cheap_level(const Automatic& automatic) {
  return {automatic.refinement.in_space() ? tried_at : 1, automatic.refinement.in_time() ? tried_at : 1};
}

std::vector<std::string> all_left_out(const std::vector<Decision>& decisions) {
  std::vector<std::string> all;
  for (const Decision& decision : decisions) {
    if (decision.left_out) all.insert(all.end(), decision.choice.overrides.begin(), decision.choice.overrides.end());
  }
  return all;
}

double change_of(const TrialRun& with, const TrialRun& without) {
  if (!with.trial.value || !without.trial.value) return no_number;
  return std::abs((*without.trial.value - *with.trial.value) / *with.trial.value);
}

/// Keeps the one of those left out that changes most.
void keep_largest(std::vector<Decision>& decisions) {
  Decision* largest = nullptr;
  for (Decision& decision : decisions) {
    if (decision.left_out && (!largest || std::abs(decision.change) > std::abs(largest->change))) largest = &decision;
  }
  if (largest == nullptr) return;
  largest->left_out = false, largest->why = "together with the others it counts";
}

}  // namespace

Simplified simplify(const Automatic& automatic, TrialRuns& runs) {
  Simplified simplified;
  if (automatic.choices.empty()) return simplified;
  Resolution at = cheap_level(automatic);
  auto whole = runs.make({{at, {}, "model"}}).front();
  if (!whole.trial.value) whole = runs.make({{at = {1, 1}, {}, "model"}}).front();
  if (!whole.trial.value) return simplified;  // the search will say why
  std::vector<WantedRun> wanted;
  for (const Choice& choice : automatic.choices) wanted.push_back({at, choice.overrides, "model"});
  const auto without = runs.make(wanted);
  for (std::size_t k = 0; k < without.size(); ++k) {
    simplified.decisions.push_back(
        {.choice = automatic.choices[k], .left_out = false, .change = 0, .saved = 0, .why = ""});
    decide(simplified.decisions.back(), *whole.trial.value, without[k].trial.value.value_or(no_number),
           whole.trial.seconds, without[k].trial.seconds, automatic.aim.tolerance);
  }
  for (simplified.left_out = all_left_out(simplified.decisions); !simplified.left_out.empty();
       simplified.left_out = all_left_out(simplified.decisions)) {
    simplified.change = change_of(whole, runs.make({{at, simplified.left_out, "model"}}).front());
    if (simplified.change < share_of_model * automatic.aim.tolerance) return simplified;
    keep_largest(simplified.decisions);
  }
  simplified.change = 0;
  return simplified;
}

bool holds(const Automatic& automatic, TrialRuns& runs, const Simplified& simplified, const TrialRun& chosen) {
  if (simplified.left_out.empty()) return true;
  const auto whole = runs.make({{chosen.trial.wanted, {}, "model"}}).front();
  return change_of(whole, chosen) < share_of_model * automatic.aim.tolerance;
}

void keep_all(Simplified& simplified) {
  for (Decision& decision : simplified.decisions) {
    if (decision.left_out)
      decision.left_out = false, decision.why = "it counts on finer cells, or the search without it ends";
  }
  simplified.left_out.clear();
  simplified.change = 0;
}

}  // namespace tether::automatic
