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
  std::vector<std::string> left_out;  ///< overrides of all that is left out
  double change = 0;                  ///< of the number without all of it, over the number; not negative
};

/// Tries each choice by a pair of cheap runs, with and without; then all that may be left out at once, and fewer until
/// they change the number by less than a third of the tolerance together.
Simplified simplify(const Automatic& automatic, TrialRuns& runs);

/// Returns whether the chosen run and the same one of the whole model differ by less than a third of the tolerance:
/// what coarse cells do not show, finer ones may.
bool holds(const Automatic& automatic, TrialRuns& runs, const Simplified& simplified, const TrialRun& chosen);

/// Takes everything back into the model, since it counts on finer cells.
void keep_all(Simplified& simplified);

}  // namespace tether::automatic
