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
  Ensembles(TrialRuns& runs, LeftOut left_out) : runs_(runs), left_out_(std::move(left_out)) {}

  /// Looks at the coarsest level and, as long as the number scatters, at two more, each twice as fine, once there are
  /// such.
  void look(Search& search, const Aim& aim);

 private:
  double scatter_at(const Trial& trial);

  TrialRuns& runs_;
  LeftOut left_out_;
  std::optional<Resolution> looked_at_;
  int looks_ = 0;
  double before_ = 0;  // scatter at the last look
  bool is_settled_ = false;
};

}  // namespace tether::automatic
