// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/flow/flow.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/numbers.hpp"
#include "deck/words.hpp"
#include "grid/mesh_flaws.hpp"
#include "read/flow/checks.hpp"
#include "read/materials.hpp"
#include "read/mesh/mesh_of_deck.hpp"
#include "read/mesh/solids.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Density and viscosity, in which all regions of the fluid agree.
void read_material(const Deck& deck, Flow& flow, Diagnostics& diagnostics) {
  const std::vector<int> regions = regions_of(deck, true);
  for (const int r : regions) {
    const auto error = [&](AnyVariable name, Subscript at, const std::string& message, const char* hint) {
      refuse(deck, name, at, fmt::format("region {}: {}", r, message), hint, diagnostics);
    };
    const bool linear = deck.given("reg.ipath", 4, r) && deck.integer("reg.ipath", 4, r) == 8;  // its first is beta
    const double viscosity = deck.real("reg.matr", linear ? 2 : 1, r);
    if (!deck.given("reg.densir", r)) {
      error("reg.densir", {r, 1}, fmt::format("densir({}) is not given", r), "every region needs its density");
      continue;
    }
    const double density = deck.real("reg.densir", r);
    if (r == regions.front()) flow.density = density, flow.viscosity = viscosity;
    if (!(viscosity > 0))
      error("reg.matr", {linear ? 2 : 1, r}, fmt::format("the viscosity must be > 0, not {:.6g}", viscosity),
            linear ? "matr(2,r) is mu of a fluid with ipath(4,r) = 8" : "matr(1,r) is mu of a fluid");
    constexpr const char* one = "the regions of a fluid are one fluid, of one density and one viscosity";
    if (density != flow.density)
      error("reg.densir", {r, 1},
            fmt::format("the density {:.6g} is not {:.6g} of region {}", density, flow.density, regions[0]), one);
    if (viscosity != flow.viscosity)
      error("reg.matr", {linear ? 2 : 1, r},
            fmt::format("the viscosity {:.6g} is not {:.6g} of region {}", viscosity, flow.viscosity, regions[0]), one);
  }
}

/// The velocity at the start: u0, v0, or that of the first region where they are not given.
FlowVector start_of(const Deck& deck, Diagnostics& diagnostics) {
  FlowVector start = flow_vector_of(deck, {"flow.u0", "flow.v0"}, 1, "u0, v0 of $flow", diagnostics);
  const int first = regions_of(deck, true).front();
  const std::array given{deck.given("flow.u0"), deck.given("flow.v0")};
  const std::array v{deck.real("reg.vrx", first), deck.real("reg.vry", first)};
  for (std::size_t i = 0; i < 2; ++i) {
    if (given[i] || v[i] == 0) continue;
    start.component[i] =
        std::make_shared<const Expression>(fmt::format("{:.17g}", v[i]), std::vector<std::string>{"x", "y", "t"});
  }
  return start;
}

void read_method(const Deck& deck, Flow& flow, Diagnostics& diagnostics) {
  flow.element = word<FlowElement>(deck, "flow.element");
  flow.stabilisation = deck.real("flow.stabilisation");
  flow.integrator =
      deck.logical("flow.steady") ? FlowIntegrator::steady : word<FlowIntegrator>(deck, "flow.integrator");
  flow.linearisation = word<Linearisation>(deck, "flow.linearisation");
  flow.systems = word<Systems>(deck, "flow.solver");
  flow.tolerance = deck.real("flow.tolerance");
  const bool speed = deck.given("flow.speed"), length = deck.given("flow.length");
  if (speed != length)
    refuse(deck, speed ? AnyVariable("flow.speed") : "flow.length", {1, 1},
           fmt::format("{} is not given, but {} is", speed ? "length" : "speed", speed ? "speed" : "length"),
           "the Reynolds number and coefficients take both", diagnostics);
  if (speed && length) flow.speed = deck.real("flow.speed"), flow.length = deck.real("flow.length");
}

/// Returns the penalties of the regions of the solids, in their order.
std::vector<double> penalties_of(const Deck& deck) {
  std::vector<double> penalties;
  for (const int r : regions_of(deck, false)) penalties.push_back(deck.real("flow.penalty", r));
  return penalties;
}

/// Says of the same regions whether the fluid's pressure holds the volume: of fibres, which have no law for it, always.
std::vector<bool> volumes_by_fluid_of(const Deck& deck) {
  std::vector<bool> by_fluid;
  for (const int r : regions_of(deck, false))
    by_fluid.push_back(law_word(deck, r) == HoopFibre::word ||
                       word<VolumeOf>(deck, "flow.volume", r) == VolumeOf::fluid);
  return by_fluid;
}

/// Leaves a region's volume to the fluid where supports hold all of its nodes: nothing of it answers to the pressure.
void leave_held_volumes_to_fluid(const Solids& solids, Flow& flow) {
  std::vector<bool> held(solids.mesh.node_count(), false), free(solids.regions.size(), false);
  for (const Support& support : solids.supports) {
    for (const int n : support.nodes) held[at(n)] = held[at(n)] || (support.fixed[0] && support.fixed[1]);
  }
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    const int* nodes = solids.mesh.element(e);
    if (!std::all_of(nodes, nodes + node_count_of(solids.mesh.kind), [&](int n) { return held[at(n)]; }))
      free[at(solids.mesh.region[e])] = true;
  }
  for (std::size_t r = 0; r < free.size(); ++r) flow.volume_by_fluid[r] = flow.volume_by_fluid[r] || !free[r];
}

/// A pressure and a balance of what goes in and out are of one fluid, which hangs together by sides.
void check_one_fluid(const Deck& deck, const Flow& flow, Diagnostics& diagnostics) {
  const Mesh& mesh = flow.mesh;
  if (std::any_of(flow.sides.begin(), flow.sides.end(),
                  [](const FlowSide& side) { return side.boundary == Boundary::periodic; }))
    return;  // which may join parts
  const std::vector<int> parts = blocks_by_sides(mesh);
  const auto other = std::find_if(parts.begin(), parts.end(), [](int part) { return part > 0; });
  if (other == parts.end()) return;
  const auto e = static_cast<std::size_t>(other - parts.begin());
  const std::vector<int> regions = regions_of(deck, true);
  const int r = regions[static_cast<std::size_t>(mesh.region[e])];
  const int first = regions[static_cast<std::size_t>(mesh.region[0])];
  const std::string at = place_text(mesh, mesh.element(e)[0]);
  refuse(deck, "fem.law", {r, 1},
         r == first ? fmt::format("the fluid of region {} does not hang together: a part of it is at {}", r, at)
                    : fmt::format("the fluid of region {} does not hang together with that of region {}", r, first),
         "parts are joined by whole sides, in Gmsh by 'Coherence'; fluids that nothing joins take a deck each",
         diagnostics);
}

double highest(const Mesh& mesh) {
  double y = mesh.x[1];
  for (std::size_t n = 0; n < mesh.node_count(); ++n) y = std::max(y, mesh.x[2 * n + 1]);
  return y;
}

Flow flow_on(const Deck& deck, Mesh mesh, const Solids* solids, Diagnostics& diagnostics) {
  Flow flow;
  flow.mesh = std::move(mesh);
  read_material(deck, flow, diagnostics);
  read_method(deck, flow, diagnostics);
  flow.sides = flow_sides_of(deck, flow.mesh, diagnostics);
  flow.twin = twins_of(deck, flow.mesh, flow.sides, diagnostics);
  if (!diagnostics.has_errors()) check_one_fluid(deck, flow, diagnostics);
  flow.fluid_outside = word<FlowOutside>(deck, "flow.outside") == FlowOutside::fluid;
  flow.level = deck.given("flow.level") ? deck.real("flow.level") : highest(flow.mesh);
  flow.acceleration = flow_vector_of(deck, {"flow.bx", "flow.by"}, 1, "bx, by of $flow", diagnostics);
  flow.start = start_of(deck, diagnostics);
  flow.forces = force_sides_of(deck, flow.mesh, solids, diagnostics);
  add_probes(deck, flow, diagnostics);
  flow.volume_penalty = penalties_of(deck);
  flow.volume_by_fluid = volumes_by_fluid_of(deck);
  return flow;
}

}  // namespace

FlowVector flow_vector_of(const Deck& deck, const std::array<TextVariable, 2>& names, int k, const std::string& of,
                          Diagnostics& diagnostics) {
  FlowVector vector;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!deck.given(names[i], k)) continue;
    vector.component[i] = expression_of(deck, names[i], k, {"x", "y", "t"}, diagnostics);
  }
  vector.factor.of = of;
  return vector;
}

void add_flow(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (!check_flow_frame(deck, diagnostics)) return;
  check_mesh_deck(deck, diagnostics);
  DeckMeshes meshes = meshes_of(deck, diagnostics);
  if (!regions_of(deck, false).empty()) add_solids_on(std::move(meshes.bodies), deck, scene, diagnostics);
  check_flow_deck(deck, diagnostics);
  if (!meshes.fluid) return;
  const auto flow = std::make_shared<Flow>(flow_on(deck, std::move(*meshes.fluid), scene.solids(), diagnostics));
  place_probes(deck, *flow, diagnostics);
  place_bodies(deck, scene, *flow, diagnostics);
  if (scene.solids()) leave_held_volumes_to_fluid(*scene.solids(), *flow);
  check_flow_velocities(deck, scene.clock, *flow, diagnostics);
  std::get<MeshFlow>(scene.physics).flow = flow;
}

}  // namespace tether
