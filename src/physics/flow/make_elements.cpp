// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/make_elements.hpp"

#include "physics/flow/elements_of_shape.hpp"

namespace tether::fem {

std::unique_ptr<FlowElements> make_flow_elements(const FlowUnknowns& unknowns, Team& team) {
  return std::make_unique<FlowElementsOfShape>(unknowns, team);
}

}  // namespace tether::fem
