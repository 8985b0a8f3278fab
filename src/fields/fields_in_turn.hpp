// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "fields/column_text.hpp"

namespace tether {

/// Fields of all points, or of all nodes, at one time, that are made one after the other when somebody asks: who writes
/// them has the numbers of one in memory, and not those of all.
class FieldsInTurn {
 public:
  /// Puts the numbers of a field, counted from 0. Several threads may ask for different fields at once.
  using Fill = std::function<void(std::size_t field, std::span<double> numbers)>;
  /// The numbers of a field that are there already, until the next call. Fields are asked for in their order.
  using View = std::function<std::span<const double>(std::size_t field)>;

  FieldsInTurn(double time, std::vector<Quantity> quantities, std::size_t count, Fill fill)
      : time_(time), quantities_(std::move(quantities)), count_(count), fill_(std::move(fill)) {}
  FieldsInTurn(double time, std::vector<Quantity> quantities, std::size_t count, View view)
      : time_(time), quantities_(std::move(quantities)), count_(count), view_(std::move(view)) {}
  /// Takes the fields of a snapshot, which has to outlive it. Throws std::invalid_argument where a field is longer than
  /// another.
  FieldsInTurn(const Snapshot& snapshot);
  /// Returns the same, of which a team may make several fields at once.
  FieldsInTurn shared_by(Team& team) && {
    team_ = &team;
    return std::move(*this);
  }

  double time() const { return time_; }
  const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Numbers of each field.
  std::size_t count() const { return count_; }
  void fill(std::size_t field, std::span<double> numbers) const;
  /// The numbers of a field: where they are, or in `room`, which has as many.
  std::span<const double> numbers(std::size_t field, std::span<double> room) const;
  /// Null where no team makes them.
  Team* team() const { return team_; }
  /// All at once.
  Snapshot snapshot() const;

 private:
  double time_;
  std::vector<Quantity> quantities_;
  std::size_t count_;
  Fill fill_;  // one of the two
  View view_;
  Team* team_ = nullptr;
};

}  // namespace tether
