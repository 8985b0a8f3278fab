// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan/plan.hpp"
#include "results/results.hpp"
#include "run/request.hpp"

namespace tether {

/// What a finished run leaves for its caller.
struct RunOutcome {
  Summary summary;
  History history;
};

/// Runs a plan to its end and writes its folder; from a checkpoint as if the run had never stopped. Throws RunError
/// after having written all records up to it and the message, Interrupted after having written a checkpoint, FileError
/// when a file cannot be read or written or another process works in the folder, InputError where the checkpoint is of
/// another deck.
RunOutcome run(Plan plan, const RunRequest& request);

}  // namespace tether
