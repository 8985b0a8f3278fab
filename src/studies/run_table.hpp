// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/combinations.hpp"
#include "studies/table.hpp"

namespace tether {

/// The columns that every table of runs has beside a study's own.
std::vector<std::string> fixed_columns();

/// Counts the warnings of a run that ended well, whose message they are.
double count_warnings(const Ending& ending);

/// Adds deck and axes to a table whose rows are of these combinations.
void add_inputs(StudyTable& table, const Study& study, const std::vector<Combination>& rows);

/// A row a run, in the order of combinations: its inputs, quantities and their observed orders, cost, exit code,
/// message. `runs` stand in that order; those that never were are left out.
StudyTable run_table(const Study& study, const std::vector<FinishedRun>& runs);

/// An ensemble's row a combination: of each quantity mean, spread (standard deviation, n - 1), least and largest, over
/// the runs that have it; and how many failed.
StudyTable ensemble_table(const Study& study, const std::vector<FinishedRun>& runs);

/// A bisection's row a combination: the largest value at which the criterion held, the smallest at which it did not.
StudyTable bisection_table(const Study& study, const std::vector<FinishedRun>& runs,
                           const std::vector<Bisection>& bisections);

}  // namespace tether
