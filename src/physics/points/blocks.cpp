// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/blocks.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tether::mpm {
namespace {

constexpr int rows_of_strip = 16;

bool before(const Blocks::Group& a, const Blocks::Group& b) { return a.row != b.row ? a.row < b.row : a.cell < b.cell; }

std::size_t lane_of(Blocks::Cell cell) { return static_cast<std::size_t>(cell.cell) % Blocks::lanes; }

}  // namespace

Blocks::Blocks(int cells_x, int cells_y, double middle)
    : middle_(middle),
      cells_x_(static_cast<std::size_t>(cells_x)),
      cells_y_(static_cast<std::size_t>(cells_y)),
      groups_x_((cells_x_ + lanes - 1) / lanes),
      group_(groups_x_ * cells_y_, none) {}

void Blocks::lay_out(const std::vector<std::uint32_t>& points_in) {
  groups_.clear(), next_.clear(), free_.clear();
  std::fill(group_.begin(), group_.end(), none);
  for (std::size_t n = 0; n < points_in.size(); ++n) {
    if (points_in[n] == 0) continue;
    const Cell cell{static_cast<int>(n / cells_x_), static_cast<int>(n % cells_x_)};
    Group& group = group_of(cell);
    group.points[lane_of(cell)] = points_in[n];
    group.layers = std::max(group.layers, points_in[n]);
  }
  for (Group& group : groups_) {
    for (std::uint32_t layers = std::exchange(group.layers, 0); layers > 0; --layers) add_block(group);
  }
  laid_out_ = next_.size();
  make_strips();
}

std::size_t Blocks::points() const {
  std::size_t sum = 0;
  for (const Group& group : groups_) sum = std::accumulate(group.points.begin(), group.points.end(), sum);
  return sum;
}

Blocks::Group& Blocks::group_of(Cell cell) {
  std::uint32_t& number = group_[index(cell.row, cell.cell)];
  if (number == none) {
    number = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back({cell.row, cell.cell - static_cast<int>(lane_of(cell)), none, none, 0, {}});
    unsettled_ = true;
  }
  return groups_[number];
}

std::size_t Blocks::slot(const Group& group, std::size_t layer, Cell cell) const {
  std::uint32_t block = group.first;
  for (; layer > 0; --layer) block = next_[block];
  return block * lanes + lane_of(cell);
}

Blocks::Entered Blocks::enter(Cell cell) {
  Group& group = group_of(cell);
  const std::uint32_t layer = group.points[lane_of(cell)]++;
  const bool new_block = layer == group.layers;
  if (new_block) add_block(group);
  return {slot(group, layer, cell), new_block};
}

std::size_t Blocks::leave(Cell cell) {
  Group& group = group_of(cell);
  return slot(group, --group.points[lane_of(cell)], cell);
}

void Blocks::close_ranks(Cell cell) {
  Group& group = group_of(cell);
  const std::uint32_t layers = *std::max_element(group.points.begin(), group.points.end());
  while (group.layers > layers) drop_last(group);
}

void Blocks::add_block(Group& group) {
  auto block = static_cast<std::uint32_t>(next_.size());
  if (free_.empty()) {
    next_.push_back(none);
  } else {
    block = free_.back(), free_.pop_back();
  }
  (group.layers == 0 ? group.first : next_[group.last]) = block;
  group.last = block;
  ++group.layers;
}

void Blocks::drop_last(Group& group) {
  free_.push_back(group.last);
  if (--group.layers == 0) {
    group.first = group.last = none, unsettled_ = true;
    return;
  }
  std::uint32_t before_last = group.first;
  while (next_[before_last] != group.last) before_last = next_[before_last];
  next_[before_last] = none, group.last = before_last;
}

void Blocks::settle() {
  if (!unsettled_) return;
  for (const Group& group : groups_) group_[index(group.row, group.cell)] = none;
  const auto middle = groups_.begin() + static_cast<std::ptrdiff_t>(in_order_);
  std::sort(middle, groups_.end(), before);
  std::inplace_merge(groups_.begin(), middle, groups_.end(), before);
  std::erase_if(groups_, [](const Group& group) { return group.layers == 0; });
  make_strips();
}

/// Strips of odd numbers after those of even ones.
void Blocks::make_strips() {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    group_[index(groups_[g].row, groups_[g].cell)] = static_cast<std::uint32_t>(g);
  }
  in_order_ = groups_.size();
  strips_.clear();
  for (const int round : {0, 1}) {
    for (std::size_t g = 0; g < groups_.size();) {
      const int strip = groups_[g].row / rows_of_strip;
      std::size_t end = g;
      while (end < groups_.size() && groups_[end].row / rows_of_strip == strip) ++end;
      if (strip % 2 == round) strips_.push_back({g, end});
      g = end;
    }
    if (round == 0) second_round_ = strips_.size();
  }
  unsettled_ = false;
}

std::vector<int> Blocks::memory() const {
  std::vector<int> memory{static_cast<int>(groups_.size()), static_cast<int>(next_.size()), static_cast<int>(laid_out_),
                          static_cast<int>(free_.size())};
  const auto note = [&](std::uint32_t number) { memory.push_back(static_cast<int>(number)); };
  for (const Group& group : groups_) {
    memory.push_back(group.row), memory.push_back(group.cell);
    note(group.first), note(group.last), note(group.layers);
    for (const std::uint32_t points : group.points) note(points);
  }
  for (const std::uint32_t next : next_) note(next);
  for (const std::uint32_t block : free_) note(block);
  return memory;
}

void Blocks::remember(const std::vector<int>& memory) {
  auto from = memory.begin();
  const auto number = [&] { return static_cast<std::uint32_t>(*from++); };
  groups_.resize(number()), next_.resize(number());
  laid_out_ = number();
  free_.resize(number());
  for (Group& group : groups_) {
    group.row = *from++, group.cell = *from++;
    group.first = number(), group.last = number(), group.layers = number();
    for (std::uint32_t& points : group.points) points = number();
  }
  for (std::uint32_t& next : next_) next = number();
  for (std::uint32_t& block : free_) block = number();
  std::fill(group_.begin(), group_.end(), none);
  make_strips();
}

}  // namespace tether::mpm
