// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"

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
  ActiveNodes(int nx, int ny) : ActiveNodes(nx, ny, 0, ny - 1) {}
  /// Counts marks on rows first_row to last_row alone.
  ActiveNodes(int nx, int ny, int first_row, int last_row)
      : nx_(static_cast<std::size_t>(nx)),
        eights_((nx_ + eight - 1) / eight),
        first_row_(first_row),
        last_row_(last_row),
        marks_(eights_ * static_cast<std::size_t>(ny), 0) {}

  void begin() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }
  /// Marks columns i0 to i1 of rows j0 to j1, the last included; those that the grid does not have do not count.
  void mark(int i0, int i1, int j0, int j1) {
    const std::size_t first = static_cast<std::size_t>(std::max(0, i0)) / eight,
                      last = std::min(static_cast<std::size_t>(i1) / eight, eights_ - 1);
    for (int j = std::max(first_row_, j0); j <= std::min(last_row_, j1); ++j) {
      for (std::size_t k = first; k <= last; ++k) marks_[static_cast<std::size_t>(j) * eights_ + k] = 1;
    }
  }
  void end() {
    spans_.clear(), pieces_.clear();
    for (std::size_t j = 0; j < marks_.size() / eights_; ++j) {
      for (std::size_t k = 0; k < eights_; ++k) {
        if (marks_[j * eights_ + k] == 0) continue;
        const std::size_t from = k;
        while (k + 1 < eights_ && marks_[j * eights_ + k + 1] != 0) ++k;
        add({j * nx_ + from * eight, j * nx_ + std::min(nx_, (k + 1) * eight)});
      }
    }
    cut_into_pieces();
  }
  const std::vector<NodeSpan>& spans() const { return spans_; }
  /// Spans of about as many nodes, for one thread or another; they do not depend on how many there are.
  std::size_t pieces() const { return pieces_.size(); }
  std::span<const NodeSpan> piece(std::size_t k) const {
    const std::size_t begin = k > 0 ? pieces_[k - 1] : 0;
    return std::span(spans_).subspan(begin, pieces_[k] - begin);
  }
  /// Returns whether one of the nine nodes in and around a column of a row may be touched, or one of those that fill it
  /// up.
  bool any_around(std::size_t n) const {
    const std::size_t i = n % nx_, j = n / nx_, left = i > 0 ? (i - 1) / eight : 0,
                      right = std::min((i + 1) / eight, eights_ - 1), rows = marks_.size() / eights_;
    for (std::size_t row = j > 0 ? j - 1 : 0; row <= j + 1 && row < rows; ++row) {
      if (marks_[row * eights_ + left] != 0 || marks_[row * eights_ + right] != 0) return true;
    }
    return false;
  }

 private:
  /// A row that is touched as a whole goes on in the next one, up to the length of a piece.
  void add(NodeSpan span) {
    if (!spans_.empty() && spans_.back().end == span.begin) span.begin = spans_.back().begin, spans_.pop_back();
    for (; span.end > span.begin + nodes_in_piece; span.begin += nodes_in_piece)
      spans_.push_back({span.begin, span.begin + nodes_in_piece});
    spans_.push_back(span);
  }
  void cut_into_pieces() {
    std::size_t nodes = 0;
    for (std::size_t s = 0; s < spans_.size(); ++s) {
      nodes += spans_[s].end - spans_[s].begin;
      if (nodes < nodes_in_piece && s + 1 < spans_.size()) continue;
      pieces_.push_back(s + 1), nodes = 0;
    }
  }

  static constexpr std::size_t eight = 8, nodes_in_piece = 4096;
  std::size_t nx_, eights_;
  int first_row_, last_row_;
  std::vector<std::uint8_t> marks_;  // of eight columns of a row
  std::vector<NodeSpan> spans_;
  std::vector<std::size_t> pieces_;  // the span after each one's last
};

/// Calls body(n) for each node of some spans, in their order.
template <class Body>
inline void for_nodes(std::span<const NodeSpan> spans, const Body& body) {
  for (const NodeSpan span : spans) {
    for (std::size_t n = span.begin; n < span.end; ++n) body(n);
  }
}
/// Does the same for each active node.
template <class Body>
inline void for_nodes(const ActiveNodes& active, const Body& body) {
  for_nodes(std::span(active.spans()), body);
}
/// Does the same in any order, by all threads of a team; the body writes at node n alone.
template <class Body>
inline void for_nodes(Team& team, const ActiveNodes& active, const Body& body) {
  team.each(0, active.pieces(), [&](std::size_t k) { for_nodes(active.piece(k), body); });
}

}  // namespace tether
