// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/column_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <stdexcept>

namespace tether {

std::size_t HistoryLayout::count(const Quantity& q) const {
  if (q.per == Per::body) return body_names.size();
  if (q.per == Per::point) return point_names.size();
  return 1;
}

std::vector<std::string> HistoryLayout::column_names() const {
  std::vector<std::string> names;
  for (const auto& q : quantities) {
    if (q.per == Per::scene) {
      names.push_back(q.name);
      continue;
    }
    for (std::size_t k = 1; k <= count(q); ++k) names.push_back(fmt::format("{}_{}", q.name, k));
  }
  return names;
}

namespace {

/// Those physics that have a row under one condition.
struct Holders {
  std::string when;
  std::vector<std::string> physics;
};

struct Row {
  ColumnText column;
  std::vector<Holders> of;
};

/// The row of the same column; else a new one, next to those of its name.
Row& row_of(std::vector<Row>& rows, const ColumnText& column) {
  auto place = rows.end();
  for (auto row = rows.begin(); row != rows.end(); ++row) {
    if (row->column.name != column.name) continue;
    if (row->column.dimension == column.dimension && row->column.meaning == column.meaning) return *row;
    place = row + 1;
  }
  return *rows.insert(place, Row{column, {}});
}

void add_holder(Row& row, const std::string& when, const std::string& physics) {
  const auto same = std::ranges::find(row.of, when, &Holders::when);
  if (same == row.of.end()) {
    row.of.push_back({when, {physics}});
  } else {
    same->physics.push_back(physics);
  }
}

/// "points, bars: with iout(38); flows".
std::string text_of(const std::vector<Holders>& of, std::size_t all) {
  std::string text;
  for (const Holders& holders : of) {
    if (!text.empty()) text += "; ";
    std::string who;
    for (const std::string& physics : holders.physics) who += (who.empty() ? "" : ", ") + physics;
    text += holders.physics.size() == all ? "all" : who;
    if (!holders.when.empty()) text += ": " + holders.when;
  }
  return text;
}

}  // namespace

std::string column_text_name(const std::string& name, bool vector, bool several) {
  const std::string number = several ? "_1" : "";
  return vector ? fmt::format("{}x{}, y, z", name, number) : name + number;
}

std::string joined_conditions(const std::string& of_group, const std::string& of_row) {
  return of_group.empty() || of_row.empty() ? of_group + of_row : of_group + ", " + of_row;
}

std::string columns_markdown(const std::vector<PhysicsColumns>& all) {
  std::vector<Row> rows;
  for (const PhysicsColumns& one : all) {
    for (const ColumnText& column : one.columns) add_holder(row_of(rows, column), column.when, one.physics);
  }
  std::string text = "| column | dimension | of | meaning |\n|---|---|---|---|\n";
  for (const Row& row : rows) {
    text += fmt::format("| {} | {} | {} | {} |\n", row.column.name, dimension_text(row.column.dimension),
                        text_of(row.of, all.size()), row.column.meaning);
  }
  return text;
}

std::string columns_listing(const std::vector<PhysicsColumns>& all) {
  std::string text;
  for (const PhysicsColumns& one : all) {
    text += one.physics + "\n";
    for (const ColumnText& column : one.columns) {
      text += fmt::format("  {:<28} {:<17} {}{}\n", column.name, dimension_text(column.dimension), column.meaning,
                          column.when.empty() ? "" : fmt::format(" ({})", column.when));
    }
  }
  return text;
}

void refuse_twins(const std::vector<Quantity>& quantities) {
  std::set<std::string> names;
  for (const Quantity& quantity : quantities) {
    if (!names.insert(quantity.name).second)
      throw std::logic_error(fmt::format("two columns are called {}", quantity.name));
  }
}

}  // namespace tether
