// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "studies/study.hpp"
#include "studies/study_remarks.hpp"

namespace tether {

/// The columns of the history that a study wants are those of some of its runs: their scenes are built, without a
/// step, until each column was found. Where that cannot be known (a scene that cannot be built, more runs than are
/// looked at), nothing is told; the runs will show.
void check_columns(const Study& study, StudyRemarks& remarks);

}  // namespace tether
