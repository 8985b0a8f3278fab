// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "studies/runs/run_record.hpp"
#include "studies/runs/workers.hpp"

namespace tether {

/// What whoever does a run has to know of it: all of it can be sent to another machine that sees the same files.
struct RunTask {
  std::string deck, text;  ///< the deck's name, and what it says
  std::vector<std::string> overrides;
  std::string key;               ///< of run_key()
  std::filesystem::path folder;  ///< the run's own
  std::filesystem::path sign;    ///< a file that stands in the studies' folder as long as they are run
  int threads = 1;
  double most_cpu_seconds = std::numeric_limits<double>::infinity();  ///< a run that takes more is stopped
};

/// Does a run as the command line does it, in this process, which should be its own; from its newest checkpoint where
/// it was interrupted. Of a run that ends well the message is its warnings, since its numbers may mean less than they
/// seem to. Signals end it at its next look at them.
Ending do_run(const RunTask& task);

/// Returns what the plan of a run expects it to take; nothing of one whose scene cannot be built.
Cost expected_cost(const Deck& deck);

/// The record of a run whose process has ended. It is written to the run's folder where the ending says something of
/// the run itself; an interruption, a kill, a full disk say nothing of it, and the next sweep tries it again. Throws
/// FileError.
RunRecord record_end(const RunTask& task, const Finished& process);

/// A task and a record as texts that can be sent. What reads them throws FileError where a text is none.
std::string text_of(const RunTask& task);
RunTask task_of(const std::string& text);
std::string text_of(const RunRecord& record);
RunRecord record_of(const std::string& text);

/// The command that makes this run alone.
std::string command_of(const RunTask& task);

}  // namespace tether
