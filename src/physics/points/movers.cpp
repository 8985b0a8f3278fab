// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/movers.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "physics/points/layout.hpp"

namespace tether::mpm {

std::vector<double*> arrays_of(Points& points) {
  std::vector<double*> arrays;
  points.each_array([&](auto& array) {
    if constexpr (std::is_same_v<decltype(array.data()), double*>) arrays.push_back(array.data());
  });
  return arrays;
}

Movers::Movers(State& state, const Scene& scene, std::size_t body)
    : state_(state), scene_(scene), body_(body), blocks_(*state.blocks[body]), arrays_(arrays_of(state.points)) {}

void Movers::move(std::span<const Moved> moved, std::span<const Blocks::Cell> entered, std::span<const double> noted) {
  const std::size_t numbers = arrays_.size(), known = noted.size() / numbers;
  ids_.clear();
  for (const Moved& point : moved) ids_.push_back(state_.points.id[state_.ranges[body_].begin + point.slot]);
  read(moved.subspan(known));
  // Of a cell the last first: whoever stands after one that leaves is there to stay.
  for (auto point = moved.rbegin(); point != moved.rend(); ++point) leave(*point);
  for (std::size_t k = 0; k < moved.size(); ++k)
    enter(entered[k], ids_[k], k < known ? &noted[k * numbers] : &numbers_[(k - known) * numbers]);
  for (const Moved& point : moved) blocks_.close_ranks(point.cell);
}

void Movers::settle() { blocks_.settle(); }

void Movers::read(std::span<const Moved> moved) {
  numbers_.clear();
  for (const Moved& point : moved) {
    for (const double* array : arrays_) numbers_.push_back(array[state_.ranges[body_].begin + point.slot]);
  }
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
