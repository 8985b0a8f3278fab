// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/reproduce/problem.hpp"

namespace tether::published {

/// The published problems of these names, in the order of their sources; all where there are none. They are the decks
/// with a group $published in a folder and in its folder published/; a name that ends with ".in" is a deck's path.
/// Throws InputError that names every name that is none of a problem's, the nearest one, and the list, or every mistake
/// of the problems' groups; FileError where a deck cannot be read.
std::vector<Problem> problems_named(const std::vector<std::string>& names, const std::filesystem::path& decks);

}  // namespace tether::published
