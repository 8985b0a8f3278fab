// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/blocks.hpp"

#include <algorithm>
#include <limits>

namespace tether::mpm {
namespace {

constexpr int rows_of_strip = 16;

/// Room for blocks that come in between layouts: a sixteenth, and some for small bodies.
std::size_t with_room(std::size_t blocks) { return blocks + blocks / 16 + 16; }

bool before(const Blocks::Group& a, const Blocks::Group& b) { return a.row != b.row ? a.row < b.row : a.cell < b.cell; }

}  // namespace

Blocks::Blocks(int cells_x, int cells_y, double middle)
    : middle_(middle),
      groups_x_((static_cast<std::size_t>(cells_x) + lanes - 1) / lanes),
      group_(groups_x_ * static_cast<std::size_t>(cells_y), none) {}

std::vector<std::size_t> Blocks::lay_out(const std::vector<Cell>& points) {
  groups_.clear(), next_.clear(), free_.clear();
  capacity_ = std::numeric_limits<std::size_t>::max(), full_ = false;
  std::fill(group_.begin(), group_.end(), none);
  std::vector<std::size_t> slots;
  slots.reserve(points.size());
  std::size_t layer = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool again = k > 0 && points[k].row == points[k - 1].row && points[k].cell == points[k - 1].cell;
    layer = again ? layer + 1 : 0;
    Group& group = group_of(points[k]);
    if (group.first == none) add_block(group);
    while (next_.size() <= group.first + layer) add_block(group);
    slots.push_back((group.first + layer) * lanes + static_cast<std::size_t>(points[k].cell) % lanes);
  }
  laid_out_ = next_.size(), capacity_ = with_room(laid_out_);
  make_strips();
  return slots;
}

Blocks::Group& Blocks::group_of(Cell cell) {
  std::uint32_t& number = group_[index(cell.row, cell.cell)];
  if (number == none) {
    number = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back({cell.row, cell.cell - cell.cell % static_cast<int>(lanes), none, none});
    unsettled_ = true;
  }
  return groups_[number];
}

std::uint32_t Blocks::add_block(Group& group) {
  auto block = static_cast<std::uint32_t>(next_.size());
  if (!free_.empty()) {
    block = free_.back(), free_.pop_back();
  } else if (next_.size() == capacity_) {
    full_ = true;
    return none;
  } else {
    next_.push_back(none);
  }
  if (group.last == none)
    group.first = block;
  else
    next_[group.last] = block;
  group.last = block;
  return block;
}

void Blocks::drop_last(Group& group) {
  free_.push_back(group.last);
  if (group.first == group.last) {
    group.first = group.last = none, unsettled_ = true;
    return;
  }
  std::uint32_t before = group.first;
  while (next_[before] != group.last) before = next_[before];
  next_[before] = none, group.last = before;
}

void Blocks::settle() {
  if (!unsettled_) return;
  std::erase_if(groups_, [](const Group& group) { return group.last == none; });
  std::sort(groups_.begin(), groups_.end(), before);
  std::fill(group_.begin(), group_.end(), none);
  make_strips();
}

/// Strips of odd numbers after those of even ones.
void Blocks::make_strips() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    group_[index(groups_[g].row, groups_[g].cell)] = static_cast<std::uint32_t>(g);
  }
  strips_.clear();
  for (const int round : {0, 1}) {
    for (std::size_t g = 0; g < groups_.size();) {
      const int strip = groups_[g].row / rows_of_strip;
      std::size_t end = g;
      while (end < groups_.size() && groups_[end].row / rows_of_strip == strip) ++end;
      if (strip % 2 == round) strips_.push_back({g, end});
      g = end;
    }
  }
  unsettled_ = false;
}

std::vector<int> Blocks::memory() const {
  std::vector<int> memory{static_cast<int>(groups_.size()), static_cast<int>(next_.size()), static_cast<int>(laid_out_),
                          static_cast<int>(capacity_), static_cast<int>(free_.size())};
  for (const Group& group : groups_) {
    memory.insert(memory.end(), {group.row, group.cell, static_cast<int>(group.first), static_cast<int>(group.last)});
  }
  for (const std::uint32_t next : next_) memory.push_back(static_cast<int>(next));
  for (const std::uint32_t block : free_) memory.push_back(static_cast<int>(block));
  return memory;
}

void Blocks::remember(const std::vector<int>& memory) {
  auto from = memory.begin();
  const auto number = [&] { return *from++; };
  groups_.resize(static_cast<std::size_t>(number())), next_.resize(static_cast<std::size_t>(number()));
  laid_out_ = static_cast<std::size_t>(number()), capacity_ = static_cast<std::size_t>(number());
  free_.resize(static_cast<std::size_t>(number()));
  for (Group& group : groups_) {
    group.row = number(), group.cell = number();
    group.first = static_cast<std::uint32_t>(number()), group.last = static_cast<std::uint32_t>(number());
  }
  for (std::uint32_t& next : next_) next = static_cast<std::uint32_t>(number());
  for (std::uint32_t& block : free_) block = static_cast<std::uint32_t>(number());
  std::fill(group_.begin(), group_.end(), none);
  full_ = false;
  make_strips();
}

}  // namespace tether::mpm
