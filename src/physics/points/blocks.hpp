// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tether::mpm {

/// Where the points of a body stand that runs by lanes. Eight neighbouring cells of a row are a group, a lane for each;
/// a block is eight slots, one of each lane, and a group's blocks are a chain. A cell's points stand in its lane of the
/// chain's first blocks. A slot without a point has mass 0 and stands in the middle of its cell. By splines a "cell" is
/// what lies nearest to a node. Slots are counted from the body's first one.
class Blocks {
 public:
  static constexpr std::size_t lanes = 8;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Blocks of eight cells from `cell` on in `row`.
  struct Group {
    int row, cell;
    std::uint32_t first, last, layers;        // blocks of the chain
    std::array<std::uint32_t, lanes> points;  // of each cell
  };
  /// Groups of neighbouring rows, which no other of the same round shares nodes with.
  struct Strip {
    std::size_t begin, end;
  };
  struct Cell {
    int row, cell;
  };

  /// `middle` of a cell from its node on, along both axes [cells].
  Blocks(int cells_x, int cells_y, double middle = 0);

  double middle() const { return middle_; }

  const std::vector<Group>& groups() const { return groups_; }
  /// In the order of their sweep: every other one first.
  const std::vector<Strip>& strips() const { return strips_; }
  /// How many strips the first round has.
  std::size_t second_round() const { return second_round_; }
  std::uint32_t next(std::uint32_t block) const { return next_[block]; }
  std::size_t blocks() const { return next_.size(); }
  /// Points in all cells.
  std::size_t points() const;

  /// Begins anew with so many points in each cell, by rows of cells_x().
  void lay_out(const std::vector<std::uint32_t>& points_in);
  std::size_t cells_x() const { return cells_x_; }
  std::size_t cells_y() const { return cells_y_; }

  /// The slot of a cell's next point, and whether its block is one that the group did not have before.
  struct Entered {
    std::size_t slot;
    bool new_block;
  };
  Entered enter(Cell cell);
  /// The slot of the cell's last point, which is no slot of a point any more.
  std::size_t leave(Cell cell);
  /// Gives blocks back that no cell of the group of `cell` needs.
  void close_ranks(Cell cell);
  /// Puts groups that came in since into the order of the sweep.
  void settle();

  /// So many blocks were added since the layout that points should be laid out anew.
  bool scattered() const { return 12 * (next_.size() - free_.size()) > 13 * laid_out_ + 96; }

  /// Calls visit(slot) for the slots of a lane's points.
  template <class Visit>
  void each_slot(const Group& group, std::size_t lane, const Visit& visit) const {
    std::uint32_t block = group.first;
    for (std::uint32_t k = group.points[lane]; k > 0; --k, block = next_[block]) visit(block * lanes + lane);
  }

  // What a checkpoint has of them: groups, the chains, and free blocks.
  std::vector<int> memory() const;
  void remember(const std::vector<int>& memory);

 private:
  Group& group_of(Cell cell);
  std::size_t slot(const Group& group, std::size_t layer, Cell cell) const;
  void make_strips();
  void add_block(Group& group);
  void drop_last(Group& group);
  std::size_t index(int row, int cell) const {
    return static_cast<std::size_t>(row) * groups_x_ + static_cast<std::size_t>(cell) / lanes;
  }

  double middle_;
  std::size_t cells_x_, cells_y_, groups_x_;
  std::vector<Group> groups_;
  std::vector<Strip> strips_;
  std::size_t second_round_ = 0;      // its first strip
  std::vector<std::uint32_t> next_;   // of each block
  std::vector<std::uint32_t> free_;   // blocks that no group has
  std::vector<std::uint32_t> group_;  // of eight cells: its number, none where it holds no point
  std::size_t laid_out_ = 0;          // blocks
  std::size_t in_order_ = 0;          // groups, from the first one on
  bool unsettled_ = false;
};

}  // namespace tether::mpm
