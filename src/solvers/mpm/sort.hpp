// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "loops/points.hpp"
#include "model/scene.hpp"
#include "solvers/mpm/arrays.hpp"

namespace tether::mpm {

/// Sorts the slots of bodies by cell, then by point number: neighbours in space become neighbours in memory, and the
/// order does not depend on what it was before. All that a point remembers moves with it. Keeps its work space between
/// calls.
class CellSort {
 public:
  /// What a point is sorted by, and its slot before.
  struct Key {
    int cell, id;
    std::size_t slot;
  };
  explicit CellSort(std::size_t points);
  /// All bodies of the scene but its strings, which keep the order of their file: it runs along them.
  void operator()(Points& points, const std::vector<Range>& bodies, const Scene& scene, const BackgroundGrid& shape);

 private:
  void sort_body(Points& points, Range range, const BackgroundGrid& shape);
  template <class Number>
  void permute(std::vector<Number>& array, Range range);

  std::vector<Key> keys_;
  std::tuple<std::vector<double>, std::vector<int>, std::vector<std::uint8_t>> scratch_;  // one for each type of array
};

}  // namespace tether::mpm
