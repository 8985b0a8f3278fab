// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/scene.hpp"
#include "solvers/mpm/arrays.hpp"
#include "solvers/mpm/range.hpp"

namespace tether::mpm {

/// Sorts the slots of bodies by cell, then by point number: neighbours in space become neighbours in memory, and the
/// order does not depend on what it was before. Keeps its work space between calls.
class CellSort {
 public:
  explicit CellSort(std::size_t points);
  /// All bodies of the scene but its strings, which keep the order of their file: it runs along them.
  void operator()(Points& points, const std::vector<Range>& bodies, const Scene& scene, const BackgroundGrid& shape);

 private:
  void sort_body(Points& points, Range range, const BackgroundGrid& shape);
  struct Key {
    int cell, id;
    std::size_t slot;
  };
  template <class T>
  void permute(std::vector<T>& array, std::vector<T>& scratch, Range range) const;

  std::vector<Key> keys_;
  std::vector<double> doubles_;
  std::vector<int> ints_;
};

}  // namespace tether::mpm
