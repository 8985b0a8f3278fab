// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/flow.hpp"
#include "model/solids.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Describes a flow on a mesh, and solids immersed in it.
std::vector<Term> flow_terms(const Scene& scene);
Cost flow_cost(const Scene& scene, const StepRule& rule);
std::string flow_head(const Scene& scene);

/// Where a body's elements are the longest over the fluid's that they lie in at the start, along the same direction.
/// Distances between nodes: of biquadratic elements half their length.
struct ImmersedSpacing {
  int region = -1;                    ///< the body's, from 0; -1 where there is none
  double of_solid = 0, of_fluid = 0;  ///< [length]
  double ratio() const { return of_fluid > 0 ? of_solid / of_fluid : 0; }
};
ImmersedSpacing coarsest_spacing(const Flow& flow, const Solids& solids);

/// Says what is to be said of it and of bodies that are thin in cells of the fluid.
std::vector<std::string> immersed_warnings(const Flow& flow, const Solids& solids);

}  // namespace tether
