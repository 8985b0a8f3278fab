// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/named_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Folders that a relative path climbs above the one it starts from.
int climbs(const fs::path& path) {
  int level = 0, lowest = 0;
  for (const auto& part : path) {
    if (part == "..")
      lowest = std::min(lowest, --level);
    else if (part != "." && !part.empty())
      ++level;
  }
  return -lowest;
}

}  // namespace

std::string path_mistake(const std::string& path) {
  if (fs::path(path).is_absolute()) return "is absolute";
  return climbs(path) > 1 ? "climbs more than one folder" : "";
}

std::string path_hint(const std::string& example) {
  return fmt::format("write a path from the deck's folder, at most one folder up, such as '{}'", example);
}

fs::path path_beside(const Deck& deck, const std::string& name) { return fs::path(deck.file()).parent_path() / name; }

}  // namespace tether
