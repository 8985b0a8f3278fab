// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace tether {

/// Which squares of a map are to be run so that its border is known: where neighbours along an axis differ in whether
/// they hold. The squares of a coarse grid are run first. Where two of them differ, halves between them lead to a piece
/// of the border; from each piece the squares on both its sides are run, so that it is followed to its end. What is
/// wanted depends on what is known alone, not on the order in which it became known. A closed border around no square
/// of the coarse grid is not seen.
class BorderSearch {
 public:
  /// A map of size[0] times size[1] squares; square k stands at (k % size[0], k / size[0]). Along an axis that is not
  /// ordered, of words, every value is by itself. The coarse grid has every stride-th value of an ordered axis, and the
  /// last one.
  BorderSearch(std::array<std::size_t, 2> size, std::array<bool, 2> ordered, std::size_t stride);

  /// Those that are wanted now; none is named twice.
  std::vector<std::size_t> next();
  void take(std::size_t square, bool holds) { holds_[square] = holds; }

  /// Returns for each square the nearest one that was run on its side of the border: itself, where it was. None where
  /// no run says anything, and for squares whose own run does not.
  std::vector<std::optional<std::size_t>> deciding() const;

 private:
  std::vector<std::size_t> coarse(std::size_t axis) const;
  std::size_t at(std::size_t axis, std::size_t along, std::size_t across) const;
  void want_coarse();
  void want_halves();
  void want_half(std::size_t axis, std::size_t low, std::size_t high, std::size_t across);
  void want_along_border();
  void want(std::size_t square);
  bool differ(std::size_t a, std::size_t b) const { return holds_[a] && holds_[b] && *holds_[a] != *holds_[b]; }

  std::array<std::size_t, 2> size_;
  std::array<bool, 2> ordered_;
  std::size_t stride_;
  std::vector<std::optional<bool>> holds_;
  std::vector<bool> asked_;
  std::vector<std::size_t> wanted_;
};

}  // namespace tether
