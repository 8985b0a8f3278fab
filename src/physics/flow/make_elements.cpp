// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/make_elements.hpp"

#include "physics/flow/elements_fields.hpp"

namespace tether::fem {

std::unique_ptr<FlowElements> make_flow_elements(const FlowUnknowns& unknowns, Team& team) {
  using Q1 = ShapesOf<ElementKind::quad4>;
  using Q2 = ShapesOf<ElementKind::quad9>;
  if (unknowns.flow.element == FlowElement::q1q1) return std::make_unique<FlowElementsOf<Q1, Q1>>(unknowns, team);
  return std::make_unique<FlowElementsOf<Q2, Q1>>(unknowns, team);
}

}  // namespace tether::fem
