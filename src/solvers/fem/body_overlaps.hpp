// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grid/overlaps.hpp"
#include "model/solids.hpp"
#include "solvers/fem/overlap_count.hpp"

namespace tether::fem {

/// Nothing stops one body at another: it is seen here, counted and told once. The solids must outlive it.
class BodyOverlaps {
 public:
  explicit BodyOverlaps(const Solids& solids) : solids_(solids), finder_(solids.mesh) {}

  /// Counts with the nodes at q; the first time that there are any a warning is added.
  void look(std::span<const double> q, double time, OverlapCount& count, std::vector<std::string>& messages);

 private:
  std::string name_of(int part) const;

  const Solids& solids_;
  OverlapFinder finder_;
};

}  // namespace tether::fem
