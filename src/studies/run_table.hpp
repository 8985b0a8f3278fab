// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/finished_run.hpp"
#include "studies/table.hpp"

namespace tether {

/// The columns that every table of runs has beside a study's own.
std::vector<std::string> fixed_columns();

/// Adds deck and axes to a table whose rows are of these combinations.
void add_inputs(StudyTable& table, const Study& study, const std::vector<Combination>& rows);

/// A row a run, in the order of combinations: its inputs, quantities and their observed orders, cost, exit code,
/// message. `runs` stand in that order; those that never were are left out.
StudyTable run_table(const Study& study, const std::vector<FinishedRun>& runs);

}  // namespace tether
