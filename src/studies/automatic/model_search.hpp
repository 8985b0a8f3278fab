// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/automatic/choices.hpp"
#include "studies/automatic/trial_runs.hpp"

namespace tether::automatic {

/// What a model does without.
struct Simplified {
  std::vector<Decision> decisions;
  LeftOut left_out;    ///< all of it
  Trial whole = {};    ///< the run of the pairs that has it all
  double change = 0;   ///< of the number there without all of it, over the number; not negative
  double saving = 1;   ///< how many times as much the run of the whole model costs
  double allowed = 0;  ///< what the change may be on finer cells: the part of the tolerance for it

  bool leaves_out() const { return !left_out.overrides.empty(); }
};

/// Tries each choice by a pair of runs at the coarsest level that runs, with and without, and what nearly may be left
/// out at the next one, too; then all that may be left out at once, and fewer until they change the number by less than
/// a third of the tolerance together.
Simplified simplify(const Automatic& automatic, TrialRuns& runs);

/// Makes a run of the simplified model once more with the whole one, and returns by how much of the number the two
/// differ; at the finer level `at` they will if the difference goes on growing as it does from the level of the pairs
/// to this one. What coarse cells do not show, finer ones may. Not a number where the whole model fails.
double change_at(const Resolution& at, const Trial& simple, TrialRuns& runs, const Simplified& simplified);

/// Tries all that is left out once more, at a level where the simplified model and the whole one differ by too much; at
/// least one part goes back into the model.
void decide_again(const Resolution& at, Simplified& simplified, const Automatic& automatic, TrialRuns& runs);

/// Takes everything back into the model, and says why.
void keep_all(Simplified& simplified, const std::string& why);

}  // namespace tether::automatic
