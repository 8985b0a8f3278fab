// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "fields/history_layout.hpp"
#include "fields/snapshot.hpp"

namespace tether {

/// A history kept in memory, for figures of merit that need the whole of it.
struct History {
  HistoryLayout layout;
  std::vector<Record> records;
  /// One flat column by name; throws std::out_of_range where there is none.
  std::vector<double> column(const std::string& name) const;
};

/// Attributes that every NetCDF file carries.
struct Provenance {
  std::string title;        ///< the deck's header lines
  std::string command;      ///< the command line, for `history`
  std::string deck_text;    ///< the deck as read
  std::string deck_sha256;  ///< of deck_text
  Units units = Units::none;
  std::string run_sha256 = {};  ///< of deck.effective: the same for all files of a run
};

/// `key = value` lines of summary.txt, in order.
using Summary = std::vector<std::pair<std::string, std::string>>;

/// Columns of numbers over a common first column, for the exact solution (`reference.txt`).
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};

}  // namespace tether
