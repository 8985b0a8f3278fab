// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tether::mpm {

/// Where the points of a body stand that runs by lanes. Eight neighbouring cells of a row are a group, a lane for each;
/// a block is eight slots, one of each lane, and a group's blocks are a chain. A slot without a point has mass 0 and
/// stands in the middle of its cell. By splines a "cell" is what lies nearest to a node.
class Blocks {
 public:
  static constexpr std::size_t lanes = 8;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Blocks of eight cells from `cell` on in `row`.
  struct Group {
    int row, cell;
    std::uint32_t first, last;
  };
  /// Groups of neighbouring rows, which no other of the same round shares nodes with.
  struct Strip {
    std::size_t begin, end;
  };

  /// `middle` of a cell from its node on, along both axes [cells].
  Blocks(int cells_x, int cells_y, double middle = 0);

  double middle() const { return middle_; }

  const std::vector<Group>& groups() const { return groups_; }
  /// In the order of their sweep: every other one first.
  const std::vector<Strip>& strips() const { return strips_; }
  std::uint32_t next(std::uint32_t block) const { return next_[block]; }
  std::size_t blocks() const { return next_.size(); }
  /// Blocks that the body's slots have room for.
  std::size_t capacity() const { return capacity_; }

  struct Cell {
    int row, cell;
  };
  /// Begins anew with the points' cells, which ascend by rows, then by cells. Returns the slot of each point, counted
  /// from the body's first one.
  std::vector<std::size_t> lay_out(const std::vector<Cell>& points);

  /// A slot, counted from the body's first one, and whether its block is one that the group did not have before.
  struct Found {
    std::size_t slot;
    bool new_block;
  };
  /// A free slot of a cell, `no_slot` where there is no room any more.
  template <class IsFree>
  Found find_free(Cell cell, const IsFree& is_free) {
    const std::size_t lane = static_cast<std::size_t>(cell.cell) % lanes;
    Group& group = group_of(cell);
    for (std::uint32_t block = group.first; block != none; block = next_[block]) {
      const std::size_t slot = block * lanes + lane;
      if (is_free(slot)) return {slot, false};
    }
    const std::uint32_t block = add_block(group);
    return {block == none ? no_slot : block * lanes + lane, true};
  }
  static constexpr std::size_t no_slot = std::numeric_limits<std::size_t>::max();
  /// A cell's first free slot with a point in a later one, and the last such point's.
  struct Gap {
    std::size_t free = no_slot, last = no_slot;
    bool is_there() const { return last != no_slot; }
  };
  template <class IsFree>
  Gap gap(Cell cell, const IsFree& is_free) {
    Gap gap;
    for (std::uint32_t block = group_of(cell).first; block != none; block = next_[block]) {
      const std::size_t slot = block * lanes + static_cast<std::size_t>(cell.cell) % lanes;
      const bool free = is_free(slot);
      if (free && gap.free == no_slot) gap.free = slot;
      if (!free && gap.free != no_slot) gap.last = slot;
    }
    return gap;
  }
  /// Takes blocks without points from the end of a cell's group.
  template <class IsFree>
  void drop_empty(Cell cell, const IsFree& is_free) {
    Group& group = group_of(cell);
    const auto is_empty = [&](std::uint32_t block) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (!is_free(block * lanes + lane)) return false;
      }
      return true;
    };
    while (group.last != none && is_empty(group.last)) drop_last(group);
  }
  /// Puts groups that came in since into the order of the sweep.
  void settle();

  /// A point has found no room.
  bool full() const { return full_; }
  /// So many blocks were added since the layout that points should be laid out anew.
  bool scattered() const { return full_ || 12 * (next_.size() - free_.size()) > 13 * laid_out_ + 96; }

  // What a checkpoint has of them: rows, cells, first and last blocks of groups, the chains, and free blocks.
  std::vector<int> memory() const;
  void remember(const std::vector<int>& memory);

 private:
  Group& group_of(Cell cell);
  void make_strips();
  std::uint32_t add_block(Group& group);
  void drop_last(Group& group);
  std::size_t index(int row, int cell) const {
    return static_cast<std::size_t>(row) * groups_x_ + static_cast<std::size_t>(cell) / lanes;
  }

  double middle_;
  std::size_t groups_x_;
  std::vector<Group> groups_;
  std::vector<Strip> strips_;
  std::vector<std::uint32_t> next_;   // of each block
  std::vector<std::uint32_t> free_;   // blocks that no group has
  std::vector<std::uint32_t> group_;  // of eight cells: its number, none where it holds no point
  std::size_t laid_out_ = 0, capacity_ = 0;
  bool full_ = false, unsettled_ = false;
};

}  // namespace tether::mpm
