// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/path.hpp"

namespace tether {

const char* path_name(Path path) { return path == Path::mpm ? "mpm" : "fem"; }

Path path_of(const Deck& deck, const std::string& wanted, Diagnostics& diagnostics) {
  const bool meshed = deck.has_group("mesh"), fem = meshed || deck.has_group("fem");
  if (wanted == "mpm" && meshed) {
    diagnostics.add(deck.remark(Severity::error, "mesh", "", {1, 1}, "the mpm path has no use for a mesh",
                                "leave --path away: a deck with $mesh runs by finite elements"));
  }
  if (wanted.empty()) return fem ? Path::fem : Path::mpm;
  return wanted == "fem" ? Path::fem : Path::mpm;
}

}  // namespace tether
