// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "fields/column_text.hpp"

namespace tether {

/// Fields of all points, or of all nodes, at one time, that are made one after the other when somebody asks: who writes
/// them has the numbers of one in memory, and not those of all.
class FieldsInTurn {
 public:
  /// Puts the numbers of a field, counted from 0.
  using Fill = std::function<void(std::size_t field, std::span<double> numbers)>;

  FieldsInTurn(double time, std::vector<Quantity> quantities, std::size_t count, Fill fill)
      : time_(time), quantities_(std::move(quantities)), count_(count), fill_(std::move(fill)) {}
  /// Of a snapshot, which has to outlive it. Throws std::invalid_argument where a field is longer than another.
  FieldsInTurn(const Snapshot& snapshot);

  double time() const { return time_; }
  const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Numbers of each field.
  std::size_t count() const { return count_; }
  void fill(std::size_t field, std::span<double> numbers) const { fill_(field, numbers); }
  /// All at once.
  Snapshot snapshot() const;

 private:
  double time_;
  std::vector<Quantity> quantities_;
  std::size_t count_;
  Fill fill_;
};

}  // namespace tether
