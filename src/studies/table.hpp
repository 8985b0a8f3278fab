// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// A column of a study's table: numbers (a missing one is not a number) or texts.
struct TableColumn {
  std::string name, meaning;
  std::string unit;  ///< of the CF conventions, empty where the decks decide it
  std::variant<std::vector<double>, std::vector<std::string>> cells;
};

template <class Cell>
TableColumn table_column(const char* name, const char* meaning, std::vector<Cell> cells, const char* unit = "") {
  return {name, meaning, unit, std::move(cells)};
}

/// Columns of equal length; `row` is what a row is called, "run" or "combination".
struct StudyTable {
  std::string row;
  std::vector<TableColumn> columns;

  std::size_t rows() const;
};

/// Names, then a line a row (RFC 4180, lines end with LF): numbers in digits that read back to the same, a missing one
/// empty, texts in quotes where they need them.
std::string csv_text(const StudyTable& table);

/// Writes for people the columns of these names below each other, numbers with five digits, a missing one '-'.
std::string aligned_text(const StudyTable& table, const std::vector<std::string>& names);

/// The table as NetCDF with the attributes that every file carries, texts as characters (row, length). It takes the
/// place of an older file in one go. Throws FileError.
void write_netcdf(const std::filesystem::path& path, const StudyTable& table, const Provenance& provenance);

}  // namespace tether
