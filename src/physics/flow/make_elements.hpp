// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "physics/flow/elements.hpp"

namespace tether::fem {

/// The elements of a flow; the unknowns, and the flow that they are of, must outlive them, as must
/// the team that shares their loops.
std::unique_ptr<FlowElements> make_flow_elements(const FlowUnknowns& unknowns, Team& team);

}  // namespace tether::fem
