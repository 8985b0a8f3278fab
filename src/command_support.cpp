// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_support.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <set>

#include "base/diagnostics.hpp"
#include "base/process.hpp"

namespace tether {
namespace {

std::string deck_name(const std::string& deck) { return std::filesystem::path(deck).stem().string(); }

}  // namespace

Voice::Voice(const std::string& log, bool quiet) : quiet_(quiet) {
  if (!log.empty()) log_.emplace(log);
}

void Voice::out(const std::string& text) { say(stdout, !quiet_, text); }
void Voice::err(const std::string& text) { say(stderr, !quiet_, text); }

void Voice::say(std::FILE* stream, bool heard, const std::string& text) {
  if (heard) std::fputs(text.c_str(), stream);  // guarded() finds out where stdout takes no more
  log(text);
}

void Voice::log(const std::string& text) {
  if (log_ && !text.empty()) log_->append(text);
}

int guarded(const std::string& name, const std::function<void()>& command, Voice* voice) {
  const Ending ending = end_of(name, [&command] {
    command();
    if (std::fflush(stdout) != 0) throw FileError("the standard output takes no more text");
  });
  std::fputs(ending.message.c_str(), stderr);  // nowhere to report it where this fails
  if (voice == nullptr || ending.exit_code == exit_done) return ending.exit_code;
  const Ending logged = end_of(name, [&] { voice->log(ending.message); });
  std::fputs(logged.message.c_str(), stderr);
  return std::max(ending.exit_code, logged.exit_code);
}

std::filesystem::path folder_of(const std::string& deck, const RunOptions& options, bool several) {
  const std::filesystem::path out = options.out.empty() ? "out" : options.out;
  return options.out.empty() || several ? out / deck_name(deck) : out;
}

void refuse_shared_folders(const std::vector<std::string>& decks, const RunOptions& options) {
  if (decks.size() > 1 && !options.restart.empty()) {
    throw InputError("--restart goes with one deck, the checkpoint's", "run the others by themselves");
  }
  std::set<std::string> names;
  for (const auto& deck : decks) {
    if (!names.insert(deck_name(deck)).second) {
      throw InputError(fmt::format("two decks are named {} and would write into one folder", deck_name(deck)),
                       "run them one by one, each with its own --out");
    }
  }
}

}  // namespace tether
