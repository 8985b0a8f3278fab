// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/lexer.hpp"

namespace tether {

/// A number of a subscript and where it stands.
struct Bound {
  long long value = 1;
  int line = 0, column = 0;
};

/// A subscript: i, or first:last:step with any of them left out.
struct Section {
  std::optional<Bound> first, last, step;
  bool range = false;  ///< there was a ':'
  int line = 0, column = 0;
};

/// r*value, or a null value (",,", r*) that leaves its elements as they are.
struct ItemValue {
  enum class Kind { null, word, quoted };
  Kind kind = Kind::null;
  long long count = 1;
  bool counted = false;  ///< a count was written
  std::string text;
  int line = 0, column = 0;  ///< of the value itself, after its count
  int count_column = 0;
};

/// name(subscripts) = values
struct Item {
  Token name;
  bool subscripted = false;
  std::vector<Section> sections;
  std::vector<ItemValue> values;
  bool broken = false;  ///< an error was reported; subscripts and values mean nothing
};

struct Group {
  Token opener;
  std::vector<Item> items;
};

/// Groups and their items. What cannot be understood becomes an error, and reading goes on at the next item. The inside
/// of groups that the table of variables does not have is passed over.
std::vector<Group> parse_groups(const std::vector<Token>& tokens, Remarks& remarks);

/// The one item of an override, broken if it is none.
Item parse_override(const std::vector<Token>& tokens, Remarks& remarks);

}  // namespace tether
