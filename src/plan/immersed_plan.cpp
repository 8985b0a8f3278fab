// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/immersed_plan.hpp"

#include <fmt/format.h>

#include "base/index.hpp"
#include "grid/body_thickness.hpp"
#include "grid/carried_nodes.hpp"
#include "grid/node_spacing.hpp"

namespace tether {
ImmersedSpacing coarsest_spacing(const Flow& flow, const Solids& solids) {
  const NodeSpacings spacings(flow.mesh);
  ImmersedSpacing worst;
  int below = -1;
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    const auto here = spacings.of_element(solids.mesh, solids.mesh.x, e, below);
    if (!here) continue;
    for (const NodeSpacing& edge : *here) {
      if (edge.ratio() > worst.ratio()) worst = {solids.mesh.region[e], edge.of_body, edge.of_mesh};
    }
  }
  return worst;
}

namespace {

std::string warning_of_spacing(const Flow& flow, const Solids& solids) {
  const ImmersedSpacing worst = coarsest_spacing(flow, solids);
  if (worst.ratio() <= coarse_spacing) return "";
  const int of_solid = order_of(solids.mesh.kind), of_fluid = order_of(flow.mesh.kind);
  return fmt::format(
      "{}: its {} elements are up to {:.3g} long in a fluid of elements {:.3g} long there, their nodes {:.3g} times as "
      "far apart as the fluid's: the fluid goes through between them and the body moves too little; elements of {:.3g} "
      "or less stop it",
      solids.regions[at(worst.region)].name, element_name(solids.mesh.kind), of_solid * worst.of_solid,
      of_fluid * worst.of_fluid, worst.ratio(), of_solid * worst.of_fluid);
}

std::string warning_of_thickness(const Flow& flow, const Solids& solids) {
  const ThinBody thin = BodyThickness(flow.mesh, solids.mesh).thinnest(solids.mesh.x);
  const int order = order_of(flow.mesh.kind);
  if (thin.region < 0 || thin.cells >= least_cells_across(order)) return "";
  return fmt::format("{}: it is {:.3g} cells of the fluid thick: {}", solids.regions[at(thin.region)].name, thin.cells,
                     thin_body_advice(order));
}

}  // namespace

std::vector<std::string> immersed_warnings(const Flow& flow, const Solids& solids) {
  std::vector<std::string> warnings{warning_of_spacing(flow, solids), warning_of_thickness(flow, solids)};
  std::erase(warnings, "");
  return warnings;
}

}  // namespace tether
