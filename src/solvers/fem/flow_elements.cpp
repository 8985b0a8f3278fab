// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_elements.hpp"

#include "solvers/fem/flow_elements_fields.hpp"

namespace tether::fem {

std::unique_ptr<FlowElements> make_flow_elements(const FlowUnknowns& unknowns) {
  using Q1 = ShapesOf<ElementKind::quad4>;
  using Q2 = ShapesOf<ElementKind::quad9>;
  if (unknowns.flow.element == FlowElement::q1q1) return std::make_unique<FlowElementsOf<Q1, Q1>>(unknowns);
  return std::make_unique<FlowElementsOf<Q2, Q1>>(unknowns);
}

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
