// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "plan/plan.hpp"

namespace tether {

/// How a deck is to be read.
struct DeckOptions {
  std::vector<std::string> overrides;  ///< group.name=value
  std::string particles;               ///< empty: what the deck names
  std::string path;                    ///< empty: what the deck's groups say
};

/// A deck on its way to a run: what was read, what it asks for, what will be done.
struct Loaded {
  Deck deck;
  Plan plan;
  std::string effective;              ///< text of deck.effective: the deck with all values and its particle data
  std::vector<std::string> warnings;  ///< of deck and particle file
  std::vector<std::string> remarks;   ///< on what does no harm there
};

/// The deck alone; remarks go into `diagnostics`. Throws FileError where it cannot be read.
Deck load_deck(const std::string& file, const DeckOptions& options, Diagnostics& diagnostics);

/// Name of the copy of a mesh file that stands beside deck.effective, which names it.
constexpr const char* effective_mesh_file = "deck.effective.msh";

/// The text of deck.effective: all values, the particle data in place of the file that the deck names, the copy of the
/// mesh file.
std::string effective_text(const Deck& deck, const std::optional<ParticleFile>& particles);

/// Mesh and particle file, scene and plan of a deck. Mistakes of the deck and of what it asks for are reported
/// together, as far as the deck can be understood: throws InputError with all of them.
Loaded load_scene(const Deck& deck, const DeckOptions& options, Diagnostics& diagnostics);

/// Both.
Loaded load(const std::string& file, const DeckOptions& options);

}  // namespace tether
