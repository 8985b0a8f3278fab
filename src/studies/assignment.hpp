// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "deck/deck.hpp"

namespace tether {

/// A cell of a study's table.
using Cell = std::variant<double, std::string>;

/// What is wrong with a text of a study, and where in it (columns from 1).
struct Mistake {
  int column = 1;
  std::string message, hint;
};

/// A text "group.name(subscripts)=v1,v2,..." of a study, taken apart as the deck reader does it.
struct Assignment {
  std::string variable;             ///< "in.nx", "reg.yvi(3:4,1:2)": lower case, without blanks
  std::string group, name;          ///< lower case
  Subscript first{1, 1};            ///< the first element that is set
  std::vector<std::string> values;  ///< each as a deck writes it: "51", "'musl'", "4*0.01"
  std::set<std::string> one_value;  ///< the elements that a single value sets, "in.nx"
  std::set<std::string> all;        ///< those that all values set, one after the other
  std::vector<Mistake> mistakes;    ///< where there are any, the rest means nothing

  /// The override that sets value k alone.
  std::string override_text(std::size_t k) const { return variable + "=" + values[k]; }
  /// Value k as the deck holds it.
  Cell cell(std::size_t k) const;
};

/// What is to suit the table of variables: the name alone, each value by itself (an axis), or all values one after the
/// other (a fixed --set). What does not is a mistake, as the deck reader reports it.
enum class Taken { name_alone, one_by_one, together };

Assignment read_assignment(const std::string& text, Taken taken);

}  // namespace tether
