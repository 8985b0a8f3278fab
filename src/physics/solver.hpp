// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fields/fields_in_turn.hpp"
#include "results/results.hpp"

namespace tether {

/// What a run has cost so far.
struct RunCounts {
  long long steps = 0;
  long long point_steps = 0;
  std::size_t points = 0;
  double dt_min = 0;   ///< shortest step but for one cut by the end [time]
  double dt_last = 0;  ///< [time]
};

/// A path's solver: its state and its step. One virtual call an output interval, none inside it.
class Solver {
 public:
  virtual ~Solver() = default;

  virtual double time() const = 0;
  /// Takes steps until time() >= `until`, but no more than `most` (the last one lands on the scene's tmax). Throws
  /// RunError.
  virtual void advance(double until, long long most) = 0;
  void advance(double until) { advance(until, std::numeric_limits<long long>::max()); }
  /// Nothing will be read before this time, unless advance() ends because it has taken `most` steps: what record(),
  /// save() and the fields ask for need not be there earlier. Without it, it is there whenever advance() comes back.
  virtual void expect_reading(double) {}
  /// Returns whether it is there now.
  virtual bool readable() const { return true; }
  virtual RunCounts counts() const = 0;
  /// Cells that hold points or fluid, or elements.
  virtual std::size_t cells_active() const { return 0; }

  virtual HistoryLayout history_layout() const = 0;
  virtual Record record() const = 0;
  virtual Snapshot points() const = 0;
  /// Hands the same to `write`, where there are points; one field after the other where that saves memory.
  virtual void write_points(const std::function<void(const FieldsInTurn&)>& write) const {
    if (const Snapshot all = points(); !all.fields.empty()) write(all);
  }
  virtual Snapshot grid() const = 0;
  /// Fields of bodies that have a mesh of their own beside that of grid(); none else.
  virtual Snapshot solids() const { return {time(), {}}; }
  /// Facets of a liquid's surface, their corners one after the other; none else.
  virtual Snapshot surface() const { return {time(), {}}; }
  /// Cells of a flow on a mesh that changes, their corners one after the other; none else.
  virtual Snapshot flow_cells() const { return {time(), {}}; }
  /// All that the next step depends on, so that a solver of the same plan goes on from it to the last bit. restore()
  /// throws FileError where the saved state is not of this path and scene.
  virtual SavedState save() const = 0;
  virtual void restore(const SavedState& saved) = 0;
  /// Lists what parts of the steps took in this process; a part may be a part of another one.
  virtual std::vector<CostPart> cost_parts() const { return {}; }
  /// Returns what the path reports in summary.txt beside what all paths do.
  virtual Summary more_summary() const { return {}; }
  /// Returns whether a record costs hardly anything compared with a step, so that what goes wrong can be looked for
  /// after every step.
  virtual bool watched_each_step() const { return false; }
  /// Says where the most distorted element of bodies on a mesh is, for a message.
  virtual std::string worst_element() const { return {}; }
  /// Warnings that came up since the last call.
  virtual std::vector<std::string> take_messages() = 0;
};

}  // namespace tether
