// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "deck/parser.hpp"

namespace tether {

/// Puts the values of parsed items into a deck, by the table of variables.
class Assigner {
 public:
  explicit Assigner(Deck::Contents& contents) : contents_(contents) {}

  /// The groups of a deck, in its order; a value that is set again replaces the first, with a warning.
  void assign(const std::vector<Group>& groups, Remarks& remarks);
  /// An override, whose name is "group.name"; it replaces silently.
  void assign_override(Item item, Remarks& remarks);

  /// "group.name" of all variables that the deck or an override tried to set, rightly or not.
  const std::set<std::string>& mentioned() const { return mentioned_; }
  /// "group.name" of variables that have an item with null values only, and where.
  const std::map<std::string, Place>& left_empty() const { return left_empty_; }

 private:
  void item(const std::string& group, const Item& item, bool replaces, Remarks& remarks);
  void fail(const std::string& full_name);
  void values(const Variable& variable, const Item& item, bool replaces, Remarks& remarks);

  Deck::Contents& contents_;
  std::set<std::string> mentioned_;
  std::map<std::string, Place> left_empty_;
  long long budget_ = 500000;  ///< elements; beyond any use, but not beyond memory
};

}  // namespace tether
