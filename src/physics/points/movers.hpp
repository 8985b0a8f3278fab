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

/// Points of a body on their way from cell to cell. They go in batches of whole groups of cells. All of a batch leave
/// before one enters, so that what goes on together finds the room that it leaves; the last point of a cell takes the
/// slot of one that left, so that a group has no more blocks than its fullest cell needs. A body whose slots are all
/// taken gets more.
class Movers {
 public:
  Movers(State& state, const Scene& scene, std::size_t body);

  /// Takes points to slots of the cells that they enter, one for each. `moved` has them by groups of cells, in the
  /// order of their slots in each cell, and `numbers` what arrays_of() had of the first ones.
  void move(std::span<const Moved> moved, std::span<const Blocks::Cell> entered, const std::vector<double>& numbers);

 private:
  void move_batch(std::span<const Moved> moved, std::span<const Blocks::Cell> entered, const double* numbers);
  std::vector<double> numbers_of(std::span<const Moved> moved) const;
  void leave(const Moved& point);
  void enter(Blocks::Cell cell, int id, const double* numbers);
  void make_room();

  State& state_;
  const Scene& scene_;
  std::size_t body_;
  Blocks& blocks_;
  std::vector<double*> arrays_;
  std::vector<int> ids_;  // of those who are under way
};

}  // namespace tether::mpm
