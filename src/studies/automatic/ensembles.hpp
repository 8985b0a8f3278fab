// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/automatic/search.hpp"
#include "studies/automatic/trial_runs.hpp"

namespace tether::automatic {

/// Finds out whether a number scatters, by runs at a level whose steps are varied. Chaos has as much scatter on finer
/// cells; what falls with them is an error like any other.
class Ensembles {
 public:
  /// The reference must outlive this; the runs leave out what `left_out` says.
  Ensembles(TrialRuns& runs, std::vector<std::string> left_out) : runs_(runs), left_out_(std::move(left_out)) {}

  /// Looks at the level that the search has come to, at the second and, where there the number scatters, two later.
  void look(Search& search, double tolerance);

 private:
  double scatter_at(const Resolution& at, double own);

  TrialRuns& runs_;
  std::vector<std::string> left_out_;
  double first_ = 0;
  std::size_t next_look_ = 0;
  bool settled_ = false;
};

}  // namespace tether::automatic
