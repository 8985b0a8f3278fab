// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "deck/deck.hpp"

namespace tether {

/// What is wrong with a path that stands in a deck ("is absolute", ...): it counts from the deck's folder and climbs at
/// most one folder. Empty where nothing is wrong.
std::string path_mistake(const std::string& path);

/// What would be right, with an example.
std::string path_hint(const std::string& example);

/// The file of that name, counted from the deck's folder.
std::filesystem::path path_beside(const Deck& deck, const std::string& name);

}  // namespace tether
