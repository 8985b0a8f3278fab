// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/boxes.hpp"
#include "grid/figures.hpp"

namespace tether {

/// Reads figures that variables of a deck describe, or reports why there is none.
class FigureReader {
 public:
  FigureReader(const Deck& deck, const StaggeredGrid& grid, Diagnostics& diagnostics)
      : deck_(deck), grid_(grid), diagnostics_(diagnostics) {}

  /// Returns by which of these variables each number is given; `what` has the numbers: "region of liquid".
  std::map<int, AnyVariable> given(const char* what, const Variables& names);

  std::optional<Box<3>> box(RealVariable name, int k);
  std::optional<Figure> ellipse(RealVariable name, int k);
  std::optional<Figure> polygon(RealVariable name, int k);
  std::optional<Figure> plane(RealVariable name, int k);

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint);
  Subscript first_given(RealVariable name, int k) const;
  int count(RealVariable name, int k) const;

  const Deck& deck_;
  const StaggeredGrid& grid_;
  Diagnostics& diagnostics_;
};

}  // namespace tether
