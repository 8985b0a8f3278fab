// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/path.hpp"

#include <fmt/format.h>

#include "scene/flow_of_deck.hpp"

namespace tether {

const char* path_name(Path path) { return path == Path::mpm ? "mpm" : "fem"; }

Path path_of(const Deck& deck, const std::string& wanted, Diagnostics& diagnostics) {
  const bool meshed = deck.has_group("mesh"), rigid = deck.has_group("rigid");
  const bool flow = has_flow(deck);
  const bool fem = meshed || rigid || flow || deck.has_group("fem");
  if (wanted == "mpm" && flow) {
    diagnostics.add(deck.remark(Severity::error, deck.has_group("flow") ? "flow" : "fem", "", {1, 1},
                                "the mpm path has no incompressible flow",
                                "leave --path away: a fluid on a mesh runs by finite elements"));
  } else if (wanted == "mpm" && (meshed || rigid)) {
    const char* group = meshed ? "mesh" : "rigid";
    diagnostics.add(deck.remark(Severity::error, group, "", {1, 1}, "the mpm path has no use for a mesh",
                                fmt::format("leave --path away: a deck with ${} runs by finite elements", group)));
  }
  if (wanted.empty()) return fem ? Path::fem : Path::mpm;
  return wanted == "fem" ? Path::fem : Path::mpm;
}

}  // namespace tether
