// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_files.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "base/diagnostics.hpp"

namespace tether {

std::filesystem::path shared_folder() {
  std::error_code reason;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", reason).parent_path();
  for (const char* way : {"../share/tether", "../..", ".."}) {
    const auto folder = (program / way).lexically_normal();
    if (std::filesystem::exists(folder / "decks/sod.in", reason) &&
        std::filesystem::exists(folder / "post/plot.py", reason))
      return folder;
  }
  throw FileError(
      fmt::format("{}: there are no decks and scripts in ../share/tether, where an installed program has them, nor "
                  "above the folder of a program that was built",
                  program.string()));
}

void become_script(const std::string& script, const std::vector<std::string>& words) {
  const char* named = std::getenv("TETHER_PYTHON");
  const std::string python = named != nullptr && *named != '\0' ? named : "/usr/bin/python3";
  std::vector<std::string> all{python, (shared_folder() / "post" / script).string()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp(python.c_str(), arguments.data());
  throw FileError(fmt::format("{}: cannot be started: {}; TETHER_PYTHON may name a Python with numpy and matplotlib",
                              python, std::strerror(errno)));
}

}  // namespace tether
