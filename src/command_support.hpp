// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/text_file.hpp"
#include "run_options.hpp"

namespace tether {

/// What a command says: on the terminal, and in a log file, where one is wanted.
class Voice {
 public:
  /// An empty name means no log; `quiet` that the terminal hears nothing but errors. Throws FileError where the log
  /// cannot be made.
  Voice(const std::string& log, bool quiet);

  void out(const std::string& text);  ///< to stdout
  void err(const std::string& text);  ///< to stderr
  void log(const std::string& text);  ///< to the log alone

 private:
  void say(std::FILE* stream, bool heard, const std::string& text);

  bool quiet_;
  std::optional<TextFile> log_;
};

/// Runs the command, reports on stderr, and in the voice's log, what went wrong, and returns the exit code.
int guarded(const std::string& name, const std::function<void()>& command, Voice* voice = nullptr);

/// One deck's own folder: DIR for a single deck, DIR/<deck name> for several, out/<deck name> without --out.
std::filesystem::path folder_of(const std::string& deck, const RunOptions& options, bool several);

/// Two decks of one name would write into one folder; a checkpoint is of one deck. Throws InputError.
void refuse_shared_folders(const std::vector<std::string>& decks, const RunOptions& options);

}  // namespace tether
