// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

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

}  // namespace tether
