// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fields/quantity.hpp"

// Tables of columns in words, for the guides.

namespace tether {

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
