// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/units.hpp"

namespace tether {

/// Whether a quantity of the history is one number a record, or one per body, or one per tracked point.
enum class Per { scene, body, point };

/// How a column counts in the balance of the total energy: not at all, as energy that came from outside, as energy that
/// went out or that the physics turned into heat, or as energy that the method itself lost (advection, transfer). Such
/// a column holds the sum since the start, formed from its own terms, never as what is missing.
enum class Book { none, gained, given, lost };

/// Name (as in the contract), dimension and meaning of one column of the history or one field of a snapshot.
struct Quantity {
  std::string name;
  Dimension dimension = Dimension::number;
  std::string meaning;
  Per per = Per::scene;
  Book book = Book::none;
};

/// What a history holds: its quantities in order (the first is `time`), and what the bodies and points are called.
struct HistoryLayout {
  std::vector<Quantity> quantities;
  std::vector<std::string> body_names;
  std::vector<std::string> point_names;
  /// Numbers of quantity q: 1, or the number of bodies, or the number of tracked points.
  std::size_t count(const Quantity& q) const;
  /// Names of the flat columns in order: `time`, ... `body_x_1`, `body_x_2`, ... `point_y_1`.
  std::vector<std::string> column_names() const;
};

/// One record: the numbers of all quantities, one after the other, as many as column_names().
using Record = std::vector<double>;

/// A history kept in memory, for figures of merit that need the whole of it.
struct History {
  HistoryLayout layout;
  std::vector<Record> records;
  /// One flat column by name; throws std::out_of_range where there is none.
  std::vector<double> column(const std::string& name) const;
};

/// One field of a snapshot: one number for each point (or node).
struct Field {
  Quantity quantity;
  std::vector<double> values;
};

/// Fields of all points, or of all nodes, at one time. For points the fields `x` and `y` and `id` come first.
struct Snapshot {
  double time = 0;
  std::vector<Field> fields;
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
