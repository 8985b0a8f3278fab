// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "studies/map/map.hpp"
#include "studies/sweep.hpp"

namespace tether::map {

/// What there is to say at the end.
struct MapResult {
  std::string report;               ///< for people
  int signal = 0;                   ///< that interrupted it
  std::size_t file_trouble = 0;     ///< runs that could not read or write a file
  std::size_t telling_nothing = 0;  ///< runs without a verdict, and bisections that hold at their upper end alone
  std::size_t unfinished = 0;       ///< parts that were to be collected and are not finished
};

/// Runs the squares along the border, several runs side by side, and writes map.nc and map.csv, a row a square,
/// table.nc and table.csv, a row a run, and map.txt, the report. Runs that were made before are known again. Throws
/// FileError, also where another process works in the same folder.
MapResult make_map(const Map& map, const StudyOptions& options);

}  // namespace tether::map
