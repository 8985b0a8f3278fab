// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/movers.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "physics/points/layout.hpp"

namespace tether::mpm {

namespace {

bool of_one_group(const Moved& a, const Moved& b) {
  const auto group = [](Blocks::Cell cell) { return static_cast<std::size_t>(cell.cell) / Blocks::lanes; };
  return a.cell.row == b.cell.row && group(a.cell) == group(b.cell);
}

/// How many of these points are the next batch: no more than have their numbers noted, but at least a group's.
std::size_t batch_of(std::span<const Moved> moved) {
  if (moved.size() <= LaneFindings::most_noted) return moved.size();
  std::size_t end = LaneFindings::most_noted;
  while (end > 0 && of_one_group(moved[end - 1], moved[end])) --end;
  if (end > 0) return end;
  while (++end < moved.size() && of_one_group(moved[end - 1], moved[end])) {
  }
  return end;
}

}  // namespace

std::vector<double*> arrays_of(Points& points) {
  std::vector<double*> arrays;
  points.each_array([&](auto& array) {
    if constexpr (std::is_same_v<decltype(array.data()), double*>) arrays.push_back(array.data());
  });
  return arrays;
}

Movers::Movers(State& state, const Scene& scene, std::size_t body)
    : state_(state), scene_(scene), body_(body), blocks_(*state.blocks[body]), arrays_(arrays_of(state.points)) {}

void Movers::move(std::span<const Moved> moved, std::span<const Blocks::Cell> entered,
                  const std::vector<double>& numbers) {
  const std::size_t noted = numbers.size() / arrays_.size();
  for (std::size_t begin = 0; begin < moved.size();) {
    const std::size_t count = batch_of(moved.subspan(begin));
    const auto batch = moved.subspan(begin, count);
    const bool known = begin + count <= noted;
    const std::vector<double> read = known ? std::vector<double>{} : numbers_of(batch);
    move_batch(batch, entered.subspan(begin, count), known ? numbers.data() + begin * arrays_.size() : read.data());
    begin += count;
  }
  blocks_.settle();
}

void Movers::move_batch(std::span<const Moved> moved, std::span<const Blocks::Cell> entered, const double* numbers) {
  ids_.clear();
  for (const Moved& point : moved) ids_.push_back(state_.points.id[state_.ranges[body_].begin + point.slot]);
  // Of a cell the last first: whoever stands after one that leaves is there to stay.
  for (auto point = moved.rbegin(); point != moved.rend(); ++point) leave(*point);
  for (std::size_t k = 0; k < moved.size(); ++k) enter(entered[k], ids_[k], numbers + k * arrays_.size());
  for (const Moved& point : moved) blocks_.close_ranks(point.cell);
}

std::vector<double> Movers::numbers_of(std::span<const Moved> moved) const {
  std::vector<double> numbers;
  numbers.reserve(moved.size() * arrays_.size());
  for (const Moved& point : moved) {
    for (const double* array : arrays_) numbers.push_back(array[state_.ranges[body_].begin + point.slot]);
  }
  return numbers;
}

/// The cell's last point moves up.
void Movers::leave(const Moved& point) {
  auto& id = state_.points.id;
  const std::size_t first = state_.ranges[body_].begin, last = first + blocks_.leave(point.cell);
  if (const std::size_t to = first + point.slot; to != last) {
    for (double* array : arrays_) array[to] = array[last];
    id[to] = id[last];
  }
  for (double* array : arrays_) array[last] = 0;
  id[last] = -1;
  stand_in_the_middle(state_, body_, last, point.cell);
}

void Movers::enter(Blocks::Cell cell, int id, const double* numbers) {
  const auto [slot, new_block] = blocks_.enter(cell);
  if (new_block) {
    if (blocks_.blocks() * Blocks::lanes > state_.ranges[body_].size()) make_room();
    const std::size_t lane = slot % Blocks::lanes;
    empty_block(state_, body_, slot / Blocks::lanes, {cell.row, cell.cell - static_cast<int>(lane)});
  }
  const std::size_t to = state_.ranges[body_].begin + slot;
  for (double* array : arrays_) array[to] = *numbers++;
  state_.points.id[to] = id;
}

/// More slots after the body's; those of the bodies after it move on.
void Movers::make_room() {
  Slots& range = state_.ranges[body_];
  const std::size_t more = slots_for(blocks_.blocks()) - range.size(), end = range.end;
  state_.points.each_array([&]<class Number>(LineArray<Number>& array) {
    array.reserve(array.size() + more);  // and no more, as a growing array would
    array.insert(array.begin() + static_cast<std::ptrdiff_t>(end), more, Number{});
  });
  std::fill_n(state_.points.id.begin() + static_cast<std::ptrdiff_t>(end), more, -1);
  for (Slots& of : state_.ranges) {
    if (of.begin >= end) of.begin += more, of.end += more;
  }
  range.end += more, state_.empty_slots += more;
  state_.list_fluids(scene_);
  arrays_ = arrays_of(state_.points);
}

}  // namespace tether::mpm
