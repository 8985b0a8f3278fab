// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algebra/sparse_matrix.hpp"

namespace tether::fem {

/// What acts on elastic bodies in a step and is found together with their places, as the pressures of a fluid are. It
/// has unknowns of its own, which Newton's method corrects with the places. Vectors have dim numbers a node.
class Surroundings {
 public:
  Surroundings() = default;
  virtual ~Surroundings() = default;
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// Adds its forces on bodies that are at q1 at the step's end [force].
  virtual void add_forces(std::span<const double> q1, std::span<double> f) = 0;
  /// Finds a correction of the places q1 and of its own unknowns from the bodies' tangent K and what their forces leave
  /// over. `change` has that of supported places, and takes that of the others. False where there is none.
  virtual bool correct(const SparseMatrix& K, std::span<const double> right, std::span<const double> q1,
                       std::span<double> change) = 0;
  /// Goes from where its unknowns were before the last correction by this part of it.
  virtual void go(double part) = 0;
  /// Returns what its own equations leave over at places q1, as a force like that by which its unknowns were found to
  /// change for it at a step's first correction [force].
  virtual double left_over(std::span<const double> q1) = 0;
  /// Returns whether these hold with places q1.
  virtual bool settled(std::span<const double> q1) = 0;
  /// Remembers its unknowns, and goes back to them.
  virtual void keep() = 0;
  virtual void go_back() = 0;
};

}  // namespace tether::fem
