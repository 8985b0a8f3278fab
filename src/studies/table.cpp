// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/file.hpp"
#include "results/netcdf_file.hpp"

namespace tether {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string csv_cell(const TableColumn& column, std::size_t row) {
  if (const auto* texts = std::get_if<Texts>(&column.cells)) return quoted((*texts)[row]);
  const double number = std::get<Numbers>(column.cells)[row];
  return std::isnan(number) ? "" : fmt::format("{}", number);
}

/// Numbers stand at the right, texts at the left.
std::vector<std::string> aligned_column(const TableColumn& column) {
  std::vector<std::string> cells{column.name};
  if (const auto* texts = std::get_if<Texts>(&column.cells)) {
    cells.insert(cells.end(), texts->begin(), texts->end());
  } else {
    for (const double number : std::get<Numbers>(column.cells))
      cells.push_back(std::isnan(number) ? "-" : fmt::format("{:.5g}", number));
  }
  std::size_t width = 0;
  for (const auto& cell : cells) width = std::max(width, cell.size());
  const bool left = std::holds_alternative<Texts>(column.cells);
  for (auto& cell : cells) cell.insert(left ? cell.size() : 0, width - cell.size(), ' ');
  return cells;
}

std::size_t longest(const Texts& texts) {
  std::size_t length = 1;
  for (const auto& text : texts) length = std::max(length, text.size());
  return length;
}

/// Defines the column over the dimension of rows.
int define(NetcdfFile& file, const TableColumn& column, int row) {
  int variable = 0;
  if (const auto* texts = std::get_if<Texts>(&column.cells)) {
    variable = file.text_variable(column.name, {row, file.dimension(column.name + "_length", longest(*texts))});
  } else {
    variable = file.number_variable(column.name, {row});
    if (!column.unit.empty()) file.attribute(variable, "units", column.unit);
  }
  file.attribute(variable, "long_name", column.meaning);
  return variable;
}

void put(NetcdfFile& file, const TableColumn& column, int variable) {
  if (const auto* numbers = std::get_if<Numbers>(&column.cells)) {
    file.put(variable, {{0}, {numbers->size()}}, *numbers);
    return;
  }
  const auto& texts = std::get<Texts>(column.cells);
  const std::size_t length = longest(texts);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    auto padded = texts[k];
    padded.resize(length, '\0');  // readers of character variables cut at the first NUL
    file.put_text(variable, {{k, 0}, {1, length}}, padded);
  }
}

}  // namespace

std::size_t StudyTable::rows() const {
  if (columns.empty()) return 0;
  return std::visit([](const auto& cells) { return cells.size(); }, columns.front().cells);
}

std::string csv_text(const StudyTable& table) {
  std::string text;
  const auto end_of_cell = [&](const TableColumn& column) { return &column == &table.columns.back() ? '\n' : ','; };
  for (const auto& column : table.columns) text += quoted(column.name) + end_of_cell(column);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto& column : table.columns) text += csv_cell(column, row) + end_of_cell(column);
  }
  return text;
}

std::string aligned_text(const StudyTable& table, const std::vector<std::string>& names) {
  std::vector<std::string> lines(table.rows() + 1);
  for (const auto& name : names) {
    const auto named = [&](const TableColumn& column) { return column.name == name; };
    const auto cells = aligned_column(*std::find_if(table.columns.begin(), table.columns.end(), named));
    for (std::size_t k = 0; k < lines.size(); ++k) lines[k] += (lines[k].empty() ? "" : "  ") + cells[k];
  }
  std::string text;
  for (auto& line : lines) text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  return text;
}

void write_netcdf(const std::filesystem::path& path, const StudyTable& table, const Provenance& provenance) {
  replace_whole(path, Reach::system, [&](const std::filesystem::path& fresh) {
    NetcdfFile file(fresh, NetcdfFormat::offset64);
    write_provenance(file, provenance);
    const int row = file.dimension(table.row, NetcdfFile::unlimited);  // there may be none
    std::vector<int> variables;
    for (const auto& column : table.columns) variables.push_back(define(file, column, row));
    file.end_definitions();
    for (std::size_t k = 0; k < variables.size(); ++k) put(file, table.columns[k], variables[k]);
    file.close();
  });
}

}  // namespace tether
