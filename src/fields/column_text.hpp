// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/numbers.hpp"

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

/// What a history holds: its quantities in order (the first is `time`), and what the bodies and points are called.
struct HistoryLayout {
  std::vector<Quantity> quantities;
  std::vector<std::string> body_names;
  std::vector<std::string> point_names;
  double rounding_energy = 0;  ///< where no more is exchanged nothing is [energy]
  /// Numbers of quantity q: 1, or the number of bodies, or the number of tracked points.
  std::size_t count(const Quantity& q) const;
  /// Names of the flat columns in order: `time`, ... `body_x_1`, `body_x_2`, ... `point_y_1`.
  std::vector<std::string> column_names() const;
};

/// One record: the numbers of all quantities, one after the other, as many as column_names().
using Record = std::vector<double>;

// Tables of columns in words, for the guides.

/// A row of such a table.
struct ColumnText {
  std::string name;
  Dimension dimension = Dimension::number;
  std::string meaning;
  std::string when;  ///< empty: always
};

/// The columns that a physics may have.
struct PhysicsColumns {
  std::string physics;
  std::vector<ColumnText> columns;
};

/// The name with the axes of a vector and the first number of several.
std::string column_text_name(const std::string& name, bool vector, bool several);

/// Both conditions, of which either may be empty.
std::string joined_conditions(const std::string& of_group, const std::string& of_row);

/// One table of all columns in Markdown: rows of the same name, dimension and meaning are one, which says of which
/// physics it is and when.
std::string columns_markdown(const std::vector<PhysicsColumns>& all);

/// The columns of each physics, a line each.
std::string columns_listing(const std::vector<PhysicsColumns>& all);

/// Throws std::logic_error where two of them have the same name.
void refuse_twins(const std::vector<Quantity>& quantities);

}  // namespace tether
