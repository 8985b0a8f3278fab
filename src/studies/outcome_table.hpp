// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "studies/finished_run.hpp"
#include "studies/table.hpp"

namespace tether {

/// An ensemble's row a combination: of each quantity mean, spread (standard deviation, n - 1), least and largest, over
/// the runs that have it; and how many failed.
StudyTable ensemble_table(const Study& study, const std::vector<FinishedRun>& runs);

/// A bisection's row a combination: the largest value at which the criterion held, the smallest at which it did not.
StudyTable bisection_table(const Study& study, const std::vector<FinishedRun>& runs,
                           const std::vector<Bisection>& bisections);

}  // namespace tether
