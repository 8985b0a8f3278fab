// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/path_of_deck.hpp"

#include <fmt/format.h>

#include "read/regions_of_deck.hpp"

namespace tether {
namespace {

void refuse(const Deck& deck, const char* group, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, group, "", {1, 1}, message, hint));
}

/// Tells of a deck that has no points for the mpm path.
void check_points(const Deck& deck, Diagnostics& diagnostics) {
  if (has_flow(deck))
    return refuse(deck, deck.has_group("flow") ? "flow" : "fem", "the mpm path has no incompressible flow",
                  "leave --path away: a fluid on a mesh runs by finite elements", diagnostics);
  if (!deck.has_group("mesh") && !deck.has_group("rigid")) return;
  const char* group = deck.has_group("mesh") ? "mesh" : "rigid";
  refuse(deck, group, "the mpm path has no use for a mesh",
         fmt::format("leave --path away: a deck with ${} runs by finite elements", group), diagnostics);
}

/// The path that the deck's groups name.
Path path_of_groups(const Deck& deck) {
  if (deck.has_group("coupled")) return Path::coupled;
  const bool fem = deck.has_group("mesh") || deck.has_group("rigid") || deck.has_group("fem") || has_flow(deck);
  return fem ? Path::fem : Path::mpm;
}

}  // namespace

Path path_of(const Deck& deck, const std::string& wanted, Diagnostics& diagnostics) {
  const Path own = path_of_groups(deck);
  if (wanted.empty() || wanted == path_name(own)) return own;
  if (own == Path::coupled) {
    refuse(deck, "coupled", fmt::format("the {} path has no use for $coupled", wanted),
           "leave --path away: a deck with $coupled runs by the coupled path", diagnostics);
    return own;
  }
  if (wanted == "coupled") {
    refuse(deck, "in", "the coupled path needs $coupled", "it describes the fluid in the box of $in", diagnostics);
    return own;
  }
  if (wanted == "mpm") check_points(deck, diagnostics);
  return wanted == "fem" ? Path::fem : Path::mpm;
}

}  // namespace tether
