// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

namespace tether::coupled {

/// What one facet of the surface has in one row of a coupling matrix: at its node a along the axis i number 3 a + i
/// from the first on.
struct SideEntry {
  int row = 0, side = 0;
  std::size_t first = 0;
};

/// Entries and their numbers.
struct SideEntries {
  std::vector<SideEntry> entries;
  std::vector<double> values;
};

/// Sums entries of a matrix facet by facet: the many that the points of one facet give the same place become one.
class SideSums {
 public:
  /// Sums those of facets that have entries at this many nodes.
  explicit SideSums(std::size_t nodes) : count_(3 * nodes) {}
  /// Entries from now on are this facet's.
  void begin(int side) {
    if (side != side_) flush();
    side_ = side;
  }
  /// The sums of a row, of the present facet; valid until the next call.
  double* row(int row) {
    const auto [place, fresh] = rows_.emplace(row, all_.values.size());
    if (fresh) all_.values.resize(all_.values.size() + count_, 0.0);
    return &all_.values[place->second];
  }
  /// All of them, facet by facet, the rows of a facet ascending.
  SideEntries take() {
    flush();
    return std::move(all_);
  }

 private:
  void flush() {
    for (const auto& [row, first] : rows_) all_.entries.push_back({row, side_, first});
    rows_.clear();
  }

  std::size_t count_;
  int side_ = -1;
  std::map<int, std::size_t> rows_;
  SideEntries all_;
};

}  // namespace tether::coupled
