// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "studies/map/map.hpp"

namespace tether::map {

/// Reads a map deck, and builds the scene at each value of each axis, the other axis at its first value and at its last
/// one, so that mistakes are reported before the first run. Throws InputError with all of them, FileError where the
/// deck cannot be read.
Map read_map(const std::string& file);

}  // namespace tether::map
