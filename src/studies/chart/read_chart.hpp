// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "studies/chart/chart.hpp"

namespace tether::chart {

/// Reads a chart deck, and builds the scene of each of its runs, so that every mistake is reported before the first
/// run. Throws InputError with all of them, FileError where the deck cannot be read.
Chart read_chart(const std::string& file);

}  // namespace tether::chart
