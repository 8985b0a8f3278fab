// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "solvers/coupled/closed_regions.hpp"
#include "solvers/coupled/flow_box.hpp"
#include "solvers/coupled/outside.hpp"

namespace tether::coupled {

/// Where the solids are and what that makes of the fluid: what a step begins with.
struct Placement {
  SurfacePieces pieces;
  Crossings crossings;
  CutCells cut;
  FlowDomain domain;
  PressureNumbers numbers;
  CouplingMap map;
  CouplingMatrix crossing_map;  ///< of the paper's own mode
};

/// Places solids in the box. All of its arguments must outlive it.
class Placer {
 public:
  Placer(const Coupled& scene, const SolidSurface& surface, const FlowBox& box, const Outside& outside)
      : scene_(scene), surface_(surface), box_(box), outside_(outside) {}

  /// With the solids' nodes at q.
  Placement at(std::span<const double> q) const;

 private:
  void map(std::span<const double> q, Placement& at) const;

  const Coupled& scene_;
  const SolidSurface& surface_;
  const FlowBox& box_;
  const Outside& outside_;
};

}  // namespace tether::coupled
