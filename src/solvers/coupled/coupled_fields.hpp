// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "results/results.hpp"
#include "solvers/coupled/coupled_step.hpp"

namespace tether::coupled {

/// What the coupled path writes.
class CoupledFields {
 public:
  /// Both must outlive the fields.
  CoupledFields(const Scene& scene, const CoupledStep& step);

  HistoryLayout history_layout() const;
  Record record(const CoupledState& state) const;
  /// At the cells' middles: the scene's cell mesh has a node there.
  Snapshot cell_fields(const CoupledState& state) const;
  /// At the solids' nodes; nothing without solids.
  Snapshot solid_fields(const CoupledState& state) const;

 private:
  void add_books(HistoryLayout& layout) const;
  static Record booked(const EnergyBooks& books);
  double pressure_energy(const CoupledState& state) const;
  void add_bodies(const CoupledState& state, Record& record) const;
  void add_smoke(const CoupledState& state, Record& record) const;
  void add_forces(std::span<const double> forces, Record& record) const;

  const Scene& scene_;
  const CoupledStep& step_;
  std::vector<std::vector<double>> part_masses_;  // of each part, by nodes [mass]
  std::vector<std::size_t> part_of_sheet_;
  std::vector<double> first_volumes_;  // that the surface's sheets enclose at the start [volume]
};

}  // namespace tether::coupled
