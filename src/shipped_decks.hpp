// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tether {

/// A deck that comes with the program.
struct ShippedDeck {
  std::string name;   ///< "sod", "charts/sod"
  std::string title;  ///< the first sentence of its header, or its first words
};

/// All of them, by name, those of the folder itself first.
std::vector<ShippedDeck> shipped_decks(const std::filesystem::path& folder);

/// Copies a deck into `into`, with the files that it names, and theirs: particle files, meshes, the decks of a study.
/// All land next to each other ("charts/sod" as charts-sod.in), and decks name them there. Returns the paths, the
/// deck's own first. Throws InputError for a name that is none, and before anything is written FileError where a file
/// of one of the names is there.
std::vector<std::filesystem::path> copy_shipped_deck(const std::filesystem::path& folder, const std::string& name,
                                                     const std::filesystem::path& into);

}  // namespace tether
