// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/flow_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "grid/carried_nodes.hpp"
#include "grid/mesh_place.hpp"
#include "grid/thickness.hpp"
#include "model/solids.hpp"
#include "plan/solid_plan.hpp"

namespace tether {
namespace {

const char* boundary_name(Boundary boundary) {
  constexpr const char* names[] = {"no-slip wall", "slip wall", "moving wall", "inflow", "open", "periodic"};
  return names[static_cast<int>(boundary)];
}

bool has(const Flow& flow, Boundary boundary) {
  return std::any_of(flow.sides.begin(), flow.sides.end(),
                     [&](const FlowSide& side) { return side.boundary == boundary; });
}

const char* integrator_text(FlowIntegrator integrator, bool solids) {
  if (solids && integrator == FlowIntegrator::steady)
    return "none: each step is a steady solution with the bodies at rest, whose loads and prescribed velocities grow";
  return integrator == FlowIntegrator::midpoint ? "mid-point rule: of order 2, pressures belong to the steps' middles"
         : integrator == FlowIntegrator::euler  ? "backward Euler: of order 1, damps"
                                                : "none: each step is a steady flow, of a Reynolds number that grows";
}

std::string sides_text(const Flow& flow) {
  std::string text;
  for (const FlowSide& side : flow.sides)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", side.name, boundary_name(side.boundary));
  return text;
}

std::string size_text(const Flow& flow) {
  std::string text = fmt::format("density {:.4g}, viscosity {:.4g}", flow.density, flow.viscosity);
  if (flow.speed > 0)
    text += fmt::format(", Reynolds number {:.4g}", flow.density * flow.speed * flow.length / flow.viscosity);
  return text;
}

/// Says by what corrections are solved, and why.
std::string systems_text(const Flow& flow, bool solids) {
  const bool krylov = systems_of(flow, solids) == Systems::krylov;
  const std::string by = krylov ? "GMRES with incomplete factors" : "LU factors, kept while they lead on";
  if (flow.systems != Systems::automatic) return by + ", as the deck says";
  if (flow.integrator == FlowIntegrator::steady) return by + ": GMRES takes many iterations for steady flows";
  if (solids) return by + ": GMRES takes many iterations for stiff bodies";
  return by + fmt::format(": {:.0f} unknowns are {} than {:.0f}", unknowns_of(flow), krylov ? "more" : "no more",
                          most_unknowns_of_factors);
}

}  // namespace

std::string outside_text(const Scene& scene) {
  const Flow& flow = *scene.flow();
  if (!flow.fluid_outside) return "nothing is beyond open sides: their pressure is zero";
  if (scene.gravity == 0) return "an open side says what the pressure is";
  return fmt::format("fluid at rest is beyond open sides, of pressure zero at y = {:.6g}", flow.level);
}

std::string closed_text(const Flow& flow) {
  return any_own_volume(flow) ? "no side is open: its level is that at which the bodies together keep their volume"
                              : "to zero at one node, since no side is open";
}

/// How many nodes the fluid carries at the start.
std::string solids_text(const Scene& scene) {
  const Mesh& mesh = scene.solids()->mesh;
  CarriedNodes carried(scene.flow()->mesh, mesh, lighter_regions(*scene.flow(), *scene.solids()));
  carried.choose(mesh.x);
  const std::string text =
      fmt::format("{} regions, a source of the fluid's momentum; its velocity moves ", scene.solids()->regions.size());
  if (carried.all()) return text + fmt::format("all of their {} nodes", mesh.node_count());
  return text + fmt::format("{} of their {} nodes, as many as it has there, and the others follow these",
                            carried.nodes().size(), mesh.node_count());
}

bool all_own_volume(const Flow& flow) {
  return std::ranges::none_of(flow.volume_by_fluid, [](bool by_fluid) { return by_fluid; });
}

std::string volume_text(const Flow& flow) {
  if (all_own_volume(flow)) return "the bodies' own laws hold their volumes";
  return any_own_volume(flow) ? "holds the volume of some; the others have a law of their own for it"
                              : "holds their volumes";
}

std::vector<Term> flow_terms(const Scene& scene) {
  const Flow& flow = *scene.flow();
  const bool equal_orders = flow.element == FlowElement::q1q1, closed = !has(flow, Boundary::open);
  const bool driven = !flow.acceleration.absent(), solids = scene.solids() != nullptr;
  return {
      {"inertia", true,
       fmt::format("convection by {}",
                   flow.linearisation == Linearisation::newton ? "Newton's method" : "Picard's iteration")},
      {"time", flow.integrator != FlowIntegrator::steady, integrator_text(flow.integrator, solids)},
      {"viscosity", true, size_text(flow)},
      {"stabilisation", equal_orders && flow.stabilisation > 0,
       equal_orders ? fmt::format("{:.6g} of SUPG, PSPG and LSIC, which equal orders of velocity and pressure need",
                                  flow.stabilisation)
                    : "a pressure of lower order than the velocity needs none"},
      {"boundary", true, sides_text(flow)},
      {"pressure pinned", closed && !any_own_volume(flow), closed ? closed_text(flow) : outside_text(scene)},
      {"gravity", scene.gravity != 0,
       scene.gravity != 0 ? fmt::format("gravc = {:.6g} in y", scene.gravity) : "gravc = 0"},
      {"body force", driven, driven ? "by bx, by" : "bx and by not given"},
      {"immersed solids", solids, solids ? solids_text(scene) : "every region is fluid"},
      {"contact of bodies", solids && scene.solids()->contact,
       solids && scene.solids()->contact ? contact_text(*scene.solids()->contact)
                                         : "without $contact the fluid between bodies is all that keeps them apart"},
      {"pressure in bodies", solids && !all_own_volume(flow), solids ? volume_text(flow) : "there are none"},
      {"linear systems", true, systems_text(flow, solids)},
      {"third dimension", false, "the mesh is plane, one unit deep"},
  };
}

/// Measured: an iteration takes a back-substitution or, one in three, an elimination, of some 40 nonzeros an unknown
/// and its logarithm; a step by GMRES 4 microseconds an unknown, and 3 kilobytes.
Cost flow_cost(const Scene& scene, const StepRule& rule) {
  constexpr double bytes_per_nonzero = 12, seconds_per_nonzero = 2e-8, iterations = 5;
  constexpr double bytes_by_krylov = 3000, seconds_by_krylov = 4e-6;
  const double n = unknowns_of(*scene.flow()), nonzeros = 6 * n * std::log2(n + 2);
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.deck_step * (1 - 1e-9));
  cost.point_steps = cost.steps * static_cast<double>(scene.flow()->mesh.node_count());
  if (systems_of(*scene.flow(), scene.solids() != nullptr) == Systems::krylov) {
    cost.megabytes = 1e-6 * bytes_by_krylov * n, cost.seconds = cost.steps * seconds_by_krylov * n;
    return cost;
  }
  cost.megabytes = 1e-6 * (bytes_per_nonzero * nonzeros + 3000 * static_cast<double>(scene.flow()->mesh.node_count()));
  cost.seconds = cost.steps * iterations * nonzeros * seconds_per_nonzero;
  return cost;
}

std::string flow_head(const Scene& scene) {
  const Flow& flow = *scene.flow();
  std::string text =
      fmt::format("path: fem (incompressible flow{})\nmesh: {} elements {}, {} nodes\nunknowns: {:.0f}\n",
                  scene.solids() ? " with immersed solids" : "", flow.mesh.element_count(),
                  flow.element == FlowElement::q1q1 ? "q1q1" : "q2q1", flow.mesh.node_count(), unknowns_of(flow));
  if (!scene.solids()) return text;
  const Mesh& mesh = scene.solids()->mesh;
  text += fmt::format("solids: {} elements {}, {} nodes\n", mesh.element_count(), element_name(mesh.kind),
                      mesh.node_count());
  for (const SolidRegion& region : scene.solids()->regions)
    text += fmt::format("{}: density {:.4g}\n", region.name, region.density);
  return text;
}

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
