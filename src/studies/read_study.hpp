// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "studies/study.hpp"

namespace tether {

/// Reads a study deck and the decks that it names. Throws InputError with every mistake, FileError where the study deck
/// cannot be read.
Study read_study(const std::string& file);

}  // namespace tether
