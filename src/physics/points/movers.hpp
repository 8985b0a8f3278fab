// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/scene.hpp"
#include "physics/points/lanes/work.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Arrays of numbers that go with a point from slot to slot.
std::vector<double*> arrays_of(Points& points);

/// Points of a body on their way from cell to cell. They go strip by strip: all of a strip leave before one enters, so
/// that what goes on together finds the room that it leaves, and neighbours stay neighbours in memory. The last point
/// of a cell takes the slot of one that left, so that a group has no more blocks than its fullest cell needs. A body
/// whose slots are all taken gets more.
class Movers {
 public:
  Movers(State& state, const Scene& scene, std::size_t body);

  /// Takes points of a strip to slots of the cells that they enter, one for each. `moved` has them in the order of
  /// their slots in each cell, and `noted` what arrays_of() had of the first ones.
  void move(std::span<const Moved> moved, std::span<const Blocks::Cell> entered, std::span<const double> noted);
  /// After all have moved: groups of cells that came in stand in the order of the sweep.
  void settle();

 private:
  /// The numbers that have not been noted.
  void read(std::span<const Moved> moved);
  void leave(const Moved& point);
  void enter(Blocks::Cell cell, int id, const double* numbers);
  void make_room();

  State& state_;
  const Scene& scene_;
  std::size_t body_;
  Blocks& blocks_;
  std::vector<double*> arrays_;
  std::vector<int> ids_;         // of those who are under way
  std::vector<double> numbers_;  // of those of whom they were not noted
};

}  // namespace tether::mpm
