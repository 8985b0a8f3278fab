// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "physics/box/columns.hpp"
#include "physics/box/step.hpp"
#include "results/results.hpp"

namespace tether::coupled {

/// What the coupled path writes.
class CoupledFields {
 public:
  /// Both must outlive the fields.
  CoupledFields(const Scene& scene, const CoupledStep& step);

  HistoryLayout history_layout() const { return columns_.layout(); }
  Record record(const CoupledState& state) const { return columns_.record(sums_of(state)); }
  /// At the solids' nodes; nothing without solids.
  Snapshot solid_fields(const CoupledState& state) const;

 private:
  CoupledSums sums_of(const CoupledState& state) const;
  void add_motion_of_solids(const CoupledState& state, CoupledSums& sums) const;
  void add_bodies(const CoupledState& state, CoupledSums& sums) const;
  std::vector<Components> forces_of_parts(std::span<const double> forces) const;

  const Scene& scene_;
  const CoupledStep& step_;
  std::vector<int> part_of_node_;                 // connected part, or -1
  std::vector<std::vector<double>> part_masses_;  // of each part, by nodes [mass]
  std::vector<std::size_t> part_of_sheet_;
  Columns<CoupledSums> columns_;
};

}  // namespace tether::coupled
