// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_clusters.hpp"

#include <cstddef>
#include <vector>

namespace tether::fem {

Lists clusters_of(const Flow& flow) {
  Lists clusters;
  const auto per_element = static_cast<std::size_t>(node_count_of(flow.mesh.kind));
  for (std::size_t e = 0; e < flow.mesh.element_count(); ++e) {
    std::vector<int> nodes;
    for (std::size_t a = 0; a < per_element; ++a)
      nodes.push_back(flow.twin[static_cast<std::size_t>(flow.mesh.element(e)[a])]);
    clusters.add(nodes);
  }
  return clusters;
}

}  // namespace tether::fem
