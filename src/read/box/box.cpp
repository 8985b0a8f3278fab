// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/box/box.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/words.hpp"
#include "read/box/checks.hpp"
#include "read/mesh/solids.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// The cells of $in's box, in space with those of $coupled along z.
StaggeredGrid grid_of(const Deck& deck, const BackgroundGrid& plane) {
  StaggeredGrid grid;
  grid.n = {plane.nx - 1, plane.ny - 1, 1};
  grid.low = {plane.x0, plane.y0, 0};
  grid.d = {(plane.x1 - plane.x0) / grid.n[0], (plane.y1 - plane.y0) / grid.n[1], 1};
  if (!deck.given("coupled.nz")) return grid;
  grid.dim = 3;
  grid.n[2] = deck.integer("coupled.nz") - 1;
  grid.low[2] = deck.real("coupled.zback");
  grid.d[2] = (deck.real("coupled.zfront") - grid.low[2]) / grid.n[2];
  return grid;
}

void read_method(const Deck& deck, Coupled& coupled) {
  coupled.coupling = coupling_of(word<CouplingMode>(deck, "coupled.mode"));
  coupled.step = word<SolidsStep>(deck, "coupled.step");
  coupled.integrator = word<CoupledIntegrator>(deck, "coupled.integrator");
  coupled.advection = word<Advection>(deck, "coupled.advection");
  coupled.systems = word<Systems>(deck, "coupled.solver");
  coupled.tolerance = deck.real("coupled.tolerance");
  coupled.contact = deck.logical("coupled.contact");
  coupled.friction = deck.real("coupled.friction");
  coupled.bodies_slip = deck.logical("coupled.bodies_slip");
  coupled.volume_term = deck.logical("coupled.volume_term");
  coupled.area_repair = deck.logical("coupled.area_repair");
  coupled.convex = deck.logical("coupled.convex");
}

void read_mesh(const Deck& deck, Coupled& coupled) {
  if (word<FlowCells>(deck, "coupled.flow") == FlowCells::grid) return;
  const double cell = std::min(coupled.grid.d[0], coupled.grid.d[1]);
  const double size = deck.given("coupled.size") ? deck.real("coupled.size") : cell;
  coupled.mesh = {.size = size,
                  .near = deck.given("coupled.size_near") ? deck.real("coupled.size_near") : size,
                  .growth = deck.real("coupled.growth")};
}

void read_fluid(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  if (deck.given("coupled.density")) {
    coupled.density = deck.real("coupled.density");
  } else {
    diagnostics.add(deck.remark(Severity::error, "coupled.density", {1, 1}, "the fluid has no density",
                                "write density=... in $coupled; densir of $reg is that of the solids"));
  }
  coupled.viscosity = deck.real("coupled.viscosity");
  coupled.start = {deck.real("coupled.u0"), deck.real("coupled.v0"), deck.real("coupled.w0")};
  coupled.cavities_only = word<FluidIn>(deck, "coupled.fluid_in") == FluidIn::cavities;
  for (int side = 0; side < 6; ++side)
    coupled.sides[static_cast<std::size_t>(side)] = word<BoxSide>(deck, "coupled.side", side + 1);
  coupled.level = deck.given("coupled.level") ? deck.real("coupled.level") : coupled.grid.high(1);
  coupled.gravity_x = deck.real("coupled.gravity_x");
  coupled.smoke_weight = deck.real("coupled.smoke_weight");
  coupled.smoke_lift = deck.real("coupled.smoke_lift");
}

/// Returns whether a mesh, which may be a file's, can go through the fluid.
bool check_mesh(const Deck& deck, const Mesh& mesh, const StaggeredGrid& grid, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& message, const char* hint) {
    diagnostics.add(deck.remark(Severity::error, "mesh.file", {1, 1}, message, hint));
    return false;
  };
  if (mesh.dim() == grid.dim) return true;
  return refuse(fmt::format("the mesh is of {} dimensions, but the box of {}", mesh.dim(), grid.dim),
                "nz, zback and zfront of $coupled make the box three-dimensional");
}

/// The solids that the scene has by then, with the deck's hinges, springs and contact.
void add_bodies(const Deck& deck, Scene& scene, Coupled& coupled, Diagnostics& diagnostics) {
  if (!check_mesh(deck, scene.solids()->mesh, coupled.grid, diagnostics)) return;
  auto solids = std::make_shared<Solids>(*scene.solids());
  add_hinges(deck, *solids, diagnostics);
  add_springs(deck, *solids, coupled, diagnostics);
  if (deck.has_group("contact")) solids->contact.emplace();
  if (keeps_energy(coupled, *solids, scene.clock.tstep)) {
    solids->integrator = Integrator::energy;
    solids->contact = contact_in_box(deck, scene, coupled, *solids, diagnostics);
  }
  check_overlaps(deck, *solids, diagnostics);
  set_solids(scene.physics, std::move(solids));
}

}  // namespace

void add_coupled(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (!check_coupled_frame(deck, diagnostics)) return;
  const auto coupled = std::make_shared<Coupled>();
  coupled->grid = grid_of(deck, scene.grid);
  read_method(deck, *coupled);
  read_fluid(deck, *coupled, diagnostics);
  read_mesh(deck, *coupled);
  add_openings(deck, *coupled, diagnostics);
  add_jets(deck, *coupled, diagnostics);
  add_boxes(deck, *coupled, diagnostics);
  add_shaped_obstacles(deck, *coupled, diagnostics);
  add_liquid(deck, *coupled, diagnostics);
  if (deck.has_group("mesh")) add_solids(deck, scene, diagnostics);
  if (scene.solids()) add_bodies(deck, scene, *coupled, diagnostics);
  const bool energy = scene.solids() && keeps_energy(*coupled, *scene.solids(), scene.clock.tstep);
  check_coupled_deck(deck, *coupled, energy, diagnostics);
  check_liquid(deck, scene, *coupled, diagnostics);
  check_flow_mesh(deck, *coupled, diagnostics);
  if (!diagnostics.has_errors()) {
    check_coupled_places(deck, scene, *coupled, diagnostics);
    check_coupled_regions(deck, scene, *coupled, diagnostics);
  }
  std::get<BoxFlow>(scene.physics).box = coupled;
}

}  // namespace tether
