// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/model_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::automatic {
namespace {

/// What is left out may change the number on finer cells by so many times what it changes on those of the pairs, and by
/// this part of the most that it may ever change in any case. Where it changes it by more, the search has less.
constexpr double growth_allowed = 2, least_allowed = 0.1;

/// What changes the number by less than so many times what it may is tried once more, on finer cells.
constexpr double near_enough = 10;

LeftOut all_left_out(const std::vector<Decision>& decisions) {
  LeftOut all;
  for (const Decision& decision : decisions) {
    if (!decision.left_out) continue;
    const LeftOut& without = decision.choice.without;
    all.overrides.insert(all.overrides.end(), without.overrides.begin(), without.overrides.end());
    if (without.way == Way::elements) all.way = Way::elements;
  }
  return all;
}

double change_of(const Trial& with, const Trial& without) {
  if (!with.value || !without.value) return no_number;
  return std::abs((*without.value - *with.value) / *with.value);
}

/// How often the cells, or the steps, of one level are halved to those of another.
double halvings(const Resolution& from, const Resolution& to) {
  return std::log2(std::max(to.space / from.space, to.time / from.time));
}

/// The coarsest level at which the whole model runs.
Trial coarsest_run(const Automatic& automatic, TrialRuns& runs) {
  Resolution at = automatic.aim.coarsest;
  for (;;) {
    const Trial whole = runs.make({{at, {}, Purpose::model}}).front();
    if (whole.value || whole.why == NoValue::file || (at.space >= 1 && at.time >= 1)) return whole;
    at = {std::min(1., 2 * at.space), std::min(1., 2 * at.time)};
  }
}

/// Keeps the one of those left out that changes most.
void keep_largest(std::vector<Decision>& decisions, const std::string& why) {
  Decision* largest = nullptr;
  for (Decision& decision : decisions) {
    if (decision.left_out && (!largest || std::abs(decision.change) > std::abs(largest->change))) largest = &decision;
  }
  if (largest != nullptr) largest->left_out = false, largest->why = why;
}

/// Finds what all that is left out changes at once, and leaves out fewer until they change the number by less than a
/// third of the tolerance together.
void leave_out(Simplified& simplified, const Automatic& automatic, TrialRuns& runs) {
  const double most = most_change(automatic.aim.tolerance);
  const Trial& whole = simplified.whole;
  for (;;) {
    simplified.left_out = all_left_out(simplified.decisions);
    simplified.change = simplified.allowed = 0;
    if (!simplified.leaves_out()) return;
    const Trial simple = runs.make({{whole.wanted, simplified.left_out, Purpose::model}}).front();
    simplified.change = change_of(whole, simple);
    simplified.saving = std::max(1., whole.seconds / std::max(simple.seconds, least_seconds));
    simplified.allowed = std::clamp(growth_allowed * simplified.change, least_allowed * most, most);
    if (simplified.change < most) return;
    keep_largest(simplified.decisions, "together with the others it counts");
  }
}

/// Decides by pairs of runs at the level of the whole one those of the choices that are looked for. Returns whether a
/// decision changed.
template <class Looked>
bool decide(std::vector<Decision>& decisions, const Looked& is_looked_for, const Trial& whole,
            const Automatic& automatic, TrialRuns& runs) {
  std::vector<Decision*> all;
  std::vector<WantedRun> wanted;
  for (Decision& decision : decisions) {
    if (!is_looked_for(decision)) continue;
    all.push_back(&decision);
    wanted.push_back({whole.wanted, decision.choice.without, Purpose::model});
  }
  const std::vector<Trial> without = runs.make(wanted);
  bool changed = false;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool before = all[k]->left_out;
    *all[k] = decided(all[k]->choice, whole, without[k], automatic.aim.tolerance);
    changed |= all[k]->left_out != before;
  }
  return changed;
}

/// Tries what nearly may be left out with cells half as large, where these are no finer than the deck's: coarse cells
/// blur. Where that changes a decision, the run there is that of the pairs.
void try_once_more(Simplified& simplified, const Automatic& automatic, TrialRuns& runs) {
  const Resolution& at = simplified.whole.wanted;
  const double near = near_enough * most_change(automatic.aim.tolerance);
  const auto is_near = [&](const Decision& each) { return !each.left_out && std::abs(each.change) < near; };
  const Resolution finer{std::min(1., 2 * at.space), std::min(1., 2 * at.time)};
  if (finer == at || std::ranges::none_of(simplified.decisions, is_near)) return;
  const Trial again = runs.make({{finer, {}, Purpose::model}}).front();
  if (again.value && decide(simplified.decisions, is_near, again, automatic, runs)) simplified.whole = again;
}

bool is_left_out(const Decision& decision) { return decision.left_out; }

}  // namespace

Simplified simplify(const Automatic& automatic, TrialRuns& runs) {
  Simplified simplified;
  if (automatic.choices.empty()) return simplified;
  simplified.whole = coarsest_run(automatic, runs);
  if (!simplified.whole.value) return simplified;  // the search will say why
  for (const Choice& choice : automatic.choices)
    simplified.decisions.push_back({.choice = choice, .left_out = false, .change = 0, .why = ""});
  const auto any = [](const Decision&) { return true; };
  decide(simplified.decisions, any, simplified.whole, automatic, runs);
  try_once_more(simplified, automatic, runs);
  leave_out(simplified, automatic, runs);
  return simplified;
}

double change_at(const Resolution& at, const Trial& simple, TrialRuns& runs, const Simplified& simplified) {
  const Trial whole = runs.make({{simple.wanted, {}, Purpose::model}}).front();
  const double change = change_of(whole, simple), since = halvings(simplified.whole.wanted, simple.wanted);
  const double growth = since > 0 ? std::max(0., change - simplified.change) / since : 0;
  return change + growth * std::max(0., halvings(simple.wanted, at));
}

void decide_again(const Resolution& at, Simplified& simplified, const Automatic& automatic, TrialRuns& runs) {
  simplified.whole = runs.make({{at, {}, Purpose::model}}).front();
  if (!decide(simplified.decisions, is_left_out, simplified.whole, automatic, runs))
    keep_largest(simplified.decisions, "together with the others it counts on finer cells");
  leave_out(simplified, automatic, runs);
}

void keep_all(Simplified& simplified, const std::string& why) {
  for (Decision& decision : simplified.decisions) {
    if (decision.left_out) decision.left_out = false, decision.why = why;
  }
  simplified.left_out = {};
  simplified.change = simplified.allowed = 0;
}

}  // namespace tether::automatic
