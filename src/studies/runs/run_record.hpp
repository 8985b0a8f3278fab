// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/process.hpp"
#include "deck/deck.hpp"

namespace tether {

/// What is known of a finished run of a study: file run.txt in its folder.
struct RunRecord {
  std::string key;  ///< of run_key()
  Ending ending;    ///< its message without line ends
  double cpu_seconds = 0, wall_seconds = 0;
};

/// Returns whether the ending says nothing of the run itself: a kill, a full disk. Such a run is tried again by the
/// next sweep.
inline bool is_lost(const Ending& ending) { return ending.exit_code == exit_file || ending.exit_code >= exit_signal; }

/// Returns what makes a run this run: SHA-256 of its deck with all values and its particle data, and of the program's
/// version and git hash.
std::string run_key(const Deck& deck);

/// The folder below a study's in which the run writes: runs/<two digits of its key>/<sixteen>, so that of ten thousand
/// runs no folder has more than some hundreds.
std::filesystem::path run_folder(const std::filesystem::path& out, const std::string& key);

/// The record in the folder, if the run of this key came to an end there and the numbers of a good end are whole.
std::optional<RunRecord> read_record(const std::filesystem::path& folder, const std::string& key);

/// Writes run.txt in one go: whoever kills the program leaves a whole record or none. Throws FileError.
void write_record(const std::filesystem::path& folder, const RunRecord& record);

/// A message of several lines as one, without the lines of carets.
std::string one_line(const std::string& message);

}  // namespace tether
