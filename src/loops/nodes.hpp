// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// The loops over nodes of a background grid.

namespace tether {

/// Nodes one after the other, the end excluded.
struct NodeSpan {
  std::size_t begin = 0, end = 0;
};

/// The nodes that points may touch, by rows: those marked since begin(), and what fills up eight neighbours. Nothing
/// else is touched in a step.
class ActiveNodes {
 public:
  ActiveNodes(int nx, int ny)
      : nx_(static_cast<std::size_t>(nx)),
        eights_((nx_ + eight - 1) / eight),
        marks_(eights_ * static_cast<std::size_t>(ny), 0) {}

  void begin() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }
  /// Marks columns i0 to i1 of rows j0 to j1, the last included; those that the grid does not have do not count.
  void mark(int i0, int i1, int j0, int j1) {
    const std::size_t first = static_cast<std::size_t>(std::max(0, i0)) / eight,
                      last = std::min(static_cast<std::size_t>(i1) / eight, eights_ - 1);
    const std::size_t rows = marks_.size() / eights_;
    for (auto j = static_cast<std::size_t>(std::max(0, j0)); j <= static_cast<std::size_t>(j1) && j < rows; ++j) {
      for (std::size_t k = first; k <= last; ++k) marks_[j * eights_ + k] = 1;
    }
  }
  void end() {
    spans_.clear();
    for (std::size_t j = 0; j < marks_.size() / eights_; ++j) {
      for (std::size_t k = 0; k < eights_; ++k) {
        if (marks_[j * eights_ + k] == 0) continue;
        const std::size_t from = k;
        while (k + 1 < eights_ && marks_[j * eights_ + k + 1] != 0) ++k;
        add({j * nx_ + from * eight, j * nx_ + std::min(nx_, (k + 1) * eight)});
      }
    }
  }
  const std::vector<NodeSpan>& spans() const { return spans_; }
  /// Whether one of the nine nodes in and around a column of a row may be touched, or one of those that fill it up.
  bool any_around(std::size_t n) const {
    const std::size_t i = n % nx_, j = n / nx_, left = i > 0 ? (i - 1) / eight : 0,
                      right = std::min((i + 1) / eight, eights_ - 1), rows = marks_.size() / eights_;
    for (std::size_t row = j > 0 ? j - 1 : 0; row <= j + 1 && row < rows; ++row) {
      if (marks_[row * eights_ + left] != 0 || marks_[row * eights_ + right] != 0) return true;
    }
    return false;
  }

 private:
  /// A row that is touched as a whole goes on in the next one.
  void add(NodeSpan span) {
    if (!spans_.empty() && spans_.back().end == span.begin)
      spans_.back().end = span.end;
    else
      spans_.push_back(span);
  }

  static constexpr std::size_t eight = 8;
  std::size_t nx_, eights_;
  std::vector<std::uint8_t> marks_;  // of eight columns of a row
  std::vector<NodeSpan> spans_;
};

/// Calls body(n) for each active node, in their order.
template <class Body>
inline void for_nodes(const ActiveNodes& active, const Body& body) {
  for (const NodeSpan span : active.spans()) {
    for (std::size_t n = span.begin; n < span.end; ++n) body(n);
  }
}

}  // namespace tether
