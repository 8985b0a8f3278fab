// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/border_search.hpp"

#include <deque>
#include <utility>

namespace tether {

BorderSearch::BorderSearch(std::array<std::size_t, 2> size, std::array<bool, 2> ordered, std::size_t stride)
    : size_(size), ordered_(ordered), stride_(stride), holds_(size[0] * size[1]), asked_(size[0] * size[1], false) {}

std::vector<std::size_t> BorderSearch::next() {
  want_coarse();
  want_halves();
  want_along_border();
  return std::exchange(wanted_, {});
}

/// The values of an axis on the coarse grid.
std::vector<std::size_t> BorderSearch::coarse(std::size_t axis) const {
  const std::size_t step = ordered_[axis] ? stride_ : 1;
  std::vector<std::size_t> values;
  for (std::size_t k = 0; k < size_[axis]; k += step) values.push_back(k);
  if (values.back() + 1 != size_[axis]) values.push_back(size_[axis] - 1);
  return values;
}

/// The square at a value of this axis and one of the other.
std::size_t BorderSearch::at(std::size_t axis, std::size_t along, std::size_t across) const {
  return axis == 0 ? along + size_[0] * across : across + size_[0] * along;
}

void BorderSearch::want(std::size_t square) {
  if (asked_[square]) return;
  asked_[square] = true;
  wanted_.push_back(square);
}

void BorderSearch::want_coarse() {
  for (const std::size_t y : coarse(1)) {
    for (const std::size_t x : coarse(0)) want(at(0, x, y));
  }
}

void BorderSearch::want_halves() {
  for (const std::size_t axis : {0UL, 1UL}) {
    if (!ordered_[axis]) continue;
    const auto values = coarse(axis);
    for (const std::size_t across : coarse(1 - axis)) {
      for (std::size_t k = 1; k < values.size(); ++k) want_half(axis, values[k - 1], values[k], across);
    }
  }
}

/// Between two values at which the verdicts differ, down to neighbours.
void BorderSearch::want_half(std::size_t axis, std::size_t low, std::size_t high, std::size_t across) {
  while (high - low > 1 && differ(at(axis, low, across), at(axis, high, across))) {
    const std::size_t middle = (low + high) / 2, square = at(axis, middle, across);
    want(square);
    if (!holds_[square]) return;
    (differ(at(axis, low, across), square) ? high : low) = middle;
  }
}

/// Neighbours that differ have the border between them: it goes on across another side of these two by two squares.
void BorderSearch::want_along_border() {
  for (const std::size_t axis : {0UL, 1UL}) {
    const std::size_t other = 1 - axis;
    if (!ordered_[axis] || !ordered_[other]) continue;
    for (std::size_t across = 0; across < size_[other]; ++across) {
      for (std::size_t k = 1; k < size_[axis]; ++k) {
        if (!differ(at(axis, k - 1, across), at(axis, k, across))) continue;
        if (across > 0) want(at(axis, k - 1, across - 1)), want(at(axis, k, across - 1));
        if (across + 1 < size_[other]) want(at(axis, k - 1, across + 1)), want(at(axis, k, across + 1));
      }
    }
  }
}

std::vector<std::optional<std::size_t>> BorderSearch::deciding() const {
  std::vector<std::optional<std::size_t>> by(holds_.size());
  std::deque<std::size_t> reached;
  for (std::size_t k = 0; k < by.size(); ++k) {
    if (holds_[k]) by[k] = k, reached.push_back(k);
  }
  const auto reach = [&](std::size_t from, std::size_t to) {
    if (!by[to] && !asked_[to]) by[to] = by[from], reached.push_back(to);
  };
  for (; !reached.empty(); reached.pop_front()) {
    const std::size_t k = reached.front(), x = k % size_[0], y = k / size_[0];
    if (ordered_[0] && x > 0) reach(k, k - 1);
    if (ordered_[0] && x + 1 < size_[0]) reach(k, k + 1);
    if (ordered_[1] && y > 0) reach(k, k - size_[0]);
    if (ordered_[1] && y + 1 < size_[1]) reach(k, k + size_[0]);
  }
  return by;
}

}  // namespace tether
