// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/solids.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vec.hpp"
#include "deck/spelling.hpp"
#include "read/materials.hpp"
#include "read/mesh/contact.hpp"
#include "read/mesh/mesh_of_deck.hpp"
#include "read/mesh/rigid.hpp"
#include "read/mesh/sides.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// The law of a region, whose numbers are reported where they are out of range.
ElasticLaw law_of(const Deck& deck, int r, int dim, Diagnostics& diagnostics) {
  const auto error = [&](AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, name, at, fmt::format("region {}: {}", r, message), hint));
  };
  check_law_words(deck, r, diagnostics);
  const std::string name = law_word(deck, r);
  const double E = deck.real("reg.matr", 1, r), nu = deck.real("reg.matr", 2, r);
  if (!(E > 0)) error("reg.matr", {1, r}, fmt::format("the modulus must be > 0, not {:.6g}", E), "matr(1,r) is E");
  if (name == HoopFibre::word) return HoopFibre::of(elastic_constants(deck, r, Plane::strain));
  const int ipath = deck.given("reg.ipath", 4, r) ? deck.integer("reg.ipath", 4, r) : 0;
  if (ipath != 0 && ipath != 2)
    error("reg.ipath", {4, r}, fmt::format("ipath(4) = {} is no elastic law", ipath),
          "a mesh takes 0, plane strain or space, and 2, plane stress");
  if (ipath == 2 && dim == 3)
    error("reg.ipath", {4, r}, "plane stress has no meaning in space",
          fmt::format("write ipath(4,{})=0, the law in space, or leave z of $mesh away", r));
  if (!(nu > -1) || !(nu < 0.5)) {
    error("reg.matr", {2, r}, fmt::format("Poisson's ratio {:.6g} is out of range", nu), "-1 < nu < 0.5");
    return StVenantKirchhoff{};
  }
  const ElasticConstants given = elastic_constants(deck, r, ipath == 2 ? Plane::stress : Plane::strain);
  return law_of_word<ElasticLaw>(name, given).value_or(StVenantKirchhoff{});  // a fluid's region is no solid
}

SolidRegion region_of(const Deck& deck, int r, int dim, Diagnostics& diagnostics) {
  SolidRegion region;
  region.name = fmt::format("region {}", r);
  if (!deck.has_group("rigid")) region.law = law_of(deck, r, dim, diagnostics);
  region.velocity = {deck.real("reg.vrx", r), deck.real("reg.vry", r), deck.real("fem.vrz", r)};
  for (int i = 1; i <= 3; ++i) region.spin[static_cast<std::size_t>(i - 1)] = deck.real("fem.spin", i, r);
  if (deck.given("reg.densir", r)) {
    region.density = deck.real("reg.densir", r);
  } else {
    diagnostics.add(deck.remark(Severity::error, "reg.densir", {r, 1},
                                fmt::format("region {}: densir({}) is not given", r, r),
                                "every region needs its density"));
  }
  return region;
}

Integrator integrator_of(const Deck& deck) {
  if (deck.logical("fem.static")) return Integrator::equilibrium;
  return word<Integrator>(deck, "fem.integrator");
}

/// Part of an element by which a tracked place may lie outside of the bodies: more than rounding of the deck's digits.
constexpr double most_outside = 1e-6;

/// Returns the name that the history gives to the place: its node, if it is one, and where it is at the start.
std::string tracked_name(const MeshPlace& place, const Vec<3>& at, int dim) {
  const std::string where = dim == 3 ? fmt::format("({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2])
                                     : fmt::format("({:.6g}, {:.6g})", at[0], at[1]);
  return place.nodes.size() == 1 ? fmt::format("node {} at {}", place.nodes[0] + 1, where) : "place " + where;
}

/// The places of tracked_at, each within an element; one that lies in no body is a mistake.
void track_places(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  const int dim = solids.mesh.dim();
  for (const Subscript at : deck.given_elements("points.tracked_at")) {
    if (at[0] != 1 || !deck.given("points.tracked_at", 2, at[1])) continue;
    const Vec<3> x{deck.real("points.tracked_at", 1, at[1]), deck.real("points.tracked_at", 2, at[1]),
                   deck.real("mesh.tracked_z", at[1])};
    NearestPlace nearest = nearest_place(solids.mesh, x);
    std::string name = tracked_name(nearest.place, x, dim);
    if (nearest.away > most_outside * nearest.element_size)
      diagnostics.add(deck.remark(
          Severity::error, "points.tracked_at", {1, at[1]},
          fmt::format("{} lies in no body: it is about {:.3g} outside of the nearest element, {:.2g} of its size",
                      name.substr(name.find('(')), nearest.away, nearest.away / nearest.element_size),
          dim == 3 ? "tracked_at(1:2,k) and tracked_z(k) of $mesh are the place at the start"
                   : "tracked_at(1:2,k) is the place at the start"));
    solids.tracked.push_back({std::move(nearest.place), std::move(name)});
  }
}

/// Reports an equilibrium that the supports leave undetermined, where no contact may hold the bodies, and damping that
/// takes a turn for strain.
void check_free_motions(const Deck& deck, const Solids& solids, Diagnostics& diagnostics) {
  const bool rests = solids.integrator == Integrator::equilibrium || solids.from_equilibrium;
  const bool damped = solids.beta > 0;
  const int parts = count_parts(solids.mesh), left = rests || damped ? free_motions(solids) : 0;
  if (rests && left > 0 && !solids.contact) {
    diagnostics.add(deck.remark(
        Severity::error, solids.from_equilibrium ? AnyVariable("fem.settle") : "fem.static", {1, 1},
        fmt::format("the supports leave {} rigid motion{}{} free: there is no equilibrium", left, left > 1 ? "s" : "",
                    parts > 1 ? fmt::format(" of one of {} parts that nothing joins", parts) : ""),
        "hold more by fix_on and fix, or by a wall that the body stands at"));
  }
  if (damped && left > 0)
    diagnostics.add(deck.remark(Severity::warning, "fem.beta", {1, 1},
                                "beta damps the turning of a body that nothing holds, as if it were strain",
                                "it acts with the stiffness of the shape at the start; alpha damps all motion"));
}

/// Checks what only motions have, in a deck that has none.
void check_equilibria(const Deck& deck, Diagnostics& diagnostics) {
  if (!deck.logical("fem.static")) return;
  const Variables moving{"reg.vrx",   "reg.vry",  "fem.vrz",        "fem.spin",
                         "fem.alpha", "fem.beta", "fem.integrator", "fem.cfl"};
  for (const AnyVariable name : moving) {
    for (const Subscript at : deck.given_elements(name)) {
      if (is_default(deck, name, at)) continue;
      diagnostics.add(
          deck.remark(Severity::warning, name, at,
                      fmt::format("{} of ${} has no effect: static=.true. looks for equilibria, which have no motion",
                                  name, name.group()),
                      ""));
      break;
    }
  }
}

}  // namespace

void add_solids(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (deck.has_group("rigid")) {
    check_rigid(deck, diagnostics);
    if (auto* body = std::get_if<RigidBody>(&scene.physics)) body->rigid = rigid_of(deck, diagnostics);
    if (!deck.has_group("mesh")) return;
  }
  check_mesh_deck(deck, diagnostics);
  add_solids_on(meshes_of(deck, diagnostics).bodies, deck, scene, diagnostics);
}

void add_solids_on(std::optional<Mesh> mesh, const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  const int dim = mesh ? mesh->dim() : deck.given_elements("mesh.z").empty() ? 2 : 3;
  Solids solids;
  for (const int r : regions_of(deck, false)) solids.regions.push_back(region_of(deck, r, dim, diagnostics));
  if (!mesh) return;
  solids.mesh = std::move(*mesh);
  solids.integrator = integrator_of(deck);
  solids.dilatation = word<Dilatation>(deck, "fem.dilatation");
  if (!has_flow(deck)) solids.alpha = deck.real("fem.alpha"), solids.beta = deck.real("fem.beta");
  solids.tolerance = deck.real("fem.tolerance");
  solids.from_equilibrium = deck.logical("fem.settle");
  check_equilibria(deck, diagnostics);
  add_loads(deck, solids, diagnostics);
  track_places(deck, solids, diagnostics);
  solids.contact = contact_of(deck, scene, solids, diagnostics);
  if (scene.path() != Path::coupled) check_overlaps(deck, solids, diagnostics);
  if (scene.rigid()) {
    check_rigid_places(deck, *scene.rigid(), solids.mesh, diagnostics);
    check_rigid_walls(deck, scene, solids.mesh, diagnostics);
  } else {
    add_supports(deck, scene, solids, diagnostics);
    check_supports_agree(deck, solids, diagnostics);
  }
  if (!scene.rigid() && scene.path() != Path::coupled) check_free_motions(deck, solids, diagnostics);
  set_solids(scene.physics, std::make_shared<const Solids>(std::move(solids)));
}

namespace {

constexpr const char* plane_hint = "x and y are all there is; with z of the regions in $mesh there are bodies in space";

std::string region_hint(const Deck& deck) {
  return regions_of(deck, true).empty() ? "regions are 1 to nreg"
                                        : "loads act on the regions that are no fluid; a fluid has bx, by of $flow";
}

/// Adds the nodes of a mesh that stand at an edge, held there as its wall does.
void add_wall(const Deck& deck, const GridEdge& edge, Solids& solids, Diagnostics& diagnostics) {
  const Mesh& mesh = solids.mesh;
  if (edge.wall == Wall::open) return;
  Support support;
  support.nodes = nodes_at(mesh, edge);
  support.amplitude.of = fmt::format("the wall {}", edge.variable);
  check_wall(deck, mesh, edge, support.nodes.size(), diagnostics);
  if (edge.wall == Wall::fixed) {
    support.fixed = {true, true, mesh.dim() == 3};
  } else {
    support.fixed[edge.axis] = true;
  }
  if (!support.nodes.empty()) solids.supports.push_back(std::move(support));
}

}  // namespace

namespace {

/// Sets what load k acts on; false where there is nothing of that name, which is reported.
bool place_load(const Deck& deck, int k, const Solids& solids, Load& load, Diagnostics& diagnostics) {
  const std::string on = deck.text("fem.load_on", k);
  if (!on.starts_with("region ")) {
    const NamedPart part = named_part(deck, "fem.load_on", k, solids.mesh, diagnostics);
    if (part.sides) load.sides = *part.sides;
    if (part.nodes) load.nodes = *part.nodes;
    return part.sides || part.nodes;
  }
  const auto named = std::find_if(solids.regions.begin(), solids.regions.end(),
                                  [&](const SolidRegion& region) { return region.name == on; });
  load.region = static_cast<int>(named - solids.regions.begin());
  if (named != solids.regions.end()) return true;
  refuse(deck, "fem.load_on", {k, 1}, fmt::format("there is no {}", on), region_hint(deck), diagnostics);
  return false;
}

/// A pressure pushes against sides that have a body on one side of them and nothing on the other.
void check_pressure(const Deck& deck, int k, const Load& load, const Mesh& mesh, Diagnostics& diagnostics) {
  if (load.pressure == 0) return;
  if (load.sides.empty())
    return refuse(deck, "fem.pressure", {k, 1}, fmt::format("the pressure of load {} has no side to push against", k),
                  fmt::format("load_on({0}) names a side of a body; load(1,{0}) is the force on {1}", k,
                              load.region < 0 ? "each node of a set" : "a volume of a region"),
                  diagnostics);
  const std::vector<std::size_t> elements = elements_of_sides(mesh, load.sides);
  if (std::find(elements.begin(), elements.end(), mesh.element_count()) == elements.end()) return;
  refuse(deck, "fem.pressure", {k, 1},
         fmt::format("the pressure of load {} acts on '{}', which has elements on both sides", k,
                     deck.text("fem.load_on", k)),
         "a pressure pushes against outer sides of bodies", diagnostics);
}

Load load_of(const Deck& deck, int k, const Mesh& mesh, Diagnostics& diagnostics) {
  Load load;
  bool sized = deck.given("fem.pressure", k);
  for (int i = 1; i <= 3; ++i) {
    load.force[static_cast<std::size_t>(i - 1)] = deck.real("fem.load", i, k);
    sized |= deck.given("fem.load", i, k);
  }
  load.pressure = deck.real("fem.pressure", k);
  if (!sized)
    refuse(deck, "fem.load_on", {k, 1},
           fmt::format("load {} has no size: neither load(1,{}) nor pressure({}) is given", k, k, k),
           fmt::format("write load(1:2,{0})=0.,-1., force per area along x and y, or pressure({0})=1.", k),
           diagnostics);
  if (mesh.dim() == 2 && load.force[2] != 0)
    refuse(deck, "fem.load", {3, k}, fmt::format("load {} acts along z, but the mesh is plane", k), plane_hint,
           diagnostics);
  load.amplitude = amplitude_of(deck, "fem.load", k, diagnostics);
  return load;
}

}  // namespace

void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  check_all_act(deck, "load", "fem.load_on",
                {"fem.load", "fem.pressure", "fem.load_time", "fem.load_factor", "fem.load_expression"}, diagnostics);
  for (const Subscript at : deck.given_elements("fem.load_on")) {
    Load load = load_of(deck, at[0], solids.mesh, diagnostics);
    if (!place_load(deck, at[0], solids, load, diagnostics)) continue;
    check_pressure(deck, at[0], load, solids.mesh, diagnostics);
    solids.loads.push_back(std::move(load));
  }
}

void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics) {
  check_all_act(deck, "support", "fem.fix_on", {"fem.fix", "fem.fix_time", "fem.fix_factor", "fem.fix_expression"},
                diagnostics);
  for (const GridEdge& edge : edges_of(scene)) add_wall(deck, edge, solids, diagnostics);
  for (const Subscript at : deck.given_elements("fem.fix_on")) {
    const int k = at[0];
    Support support;
    support.nodes = named_part(deck, "fem.fix_on", k, solids.mesh, diagnostics).all_nodes(), support.number = k;
    if (support.nodes.empty()) continue;
    for (int i = 1; i <= 3; ++i) {
      const auto axis = static_cast<std::size_t>(i - 1);
      support.fixed[axis] = deck.given("fem.fix", i, k);
      if (support.fixed[axis]) support.displacement[axis] = deck.real("fem.fix", i, k);
    }
    if (support.fixed == std::array<bool, 3>{})
      refuse(deck, "fem.fix_on", at, fmt::format("support {} holds no direction", k),
             fmt::format("write fix(1,{0})=0,0{1}", k, solids.mesh.dim() == 3 ? ",0" : ""), diagnostics);
    if (solids.mesh.dim() == 2 && support.fixed[2])
      refuse(deck, "fem.fix", {3, k}, fmt::format("support {} holds z, but the mesh is plane", k), plane_hint,
             diagnostics);
    support.amplitude = amplitude_of(deck, "fem.fix", k, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

}  // namespace tether
