// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "studies/reproduce/problem.hpp"

namespace tether::published {

/// The problem of a deck that has a group $published, with what the group takes from another deck (`like`). Mistakes
/// go to the diagnostics, at their places.
Problem problem_of(const Deck& deck, Diagnostics& diagnostics);

/// Its name alone: the group's, else the file's.
std::string problem_name(const Deck& deck);

}  // namespace tether::published
