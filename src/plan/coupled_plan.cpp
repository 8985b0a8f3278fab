// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/coupled_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/vec.hpp"
#include "model/coupled.hpp"
#include "model/size.hpp"
#include "model/solids.hpp"
#include "plan/flow_mesh_term.hpp"
#include "plan/solid_plan.hpp"

namespace tether {
namespace {

/// Names the mode. Whether splitting would hold is reported apart, where the solver's matrices can be asked.
std::string mode_text(const Scene& scene) {
  if (!scene.solids()) return "there is no body: one projection a step";
  const Coupling& coupling = scene.coupled()->coupling;
  if (scene.coupled()->mesh && coupling.simultaneous)
    return "simultaneous, on a mesh whose faces are the bodies' sides; power balances to rounding";
  return fmt::format("{}: {}", word_of(coupling.mode), coupling.meaning);
}

/// Says by what the systems are solved, and why.
std::string systems_text(const Coupled& coupled) {
  const bool direct = systems_of(coupled) == Systems::direct;
  const char* by = direct ? "factors" : "conjugate gradients";
  if (coupled.systems != Systems::automatic) return fmt::format("{}, as the deck says", by);
  if (coupled.grid.dim == 2) return fmt::format("{}: the box is plane", by);
  return fmt::format("{}: {} cells in space are {} than {:.0f}", by, coupled.grid.cell_count(),
                     direct ? "no more" : "more", most_cells_of_factors);
}

/// Returns the area of a part of a side, per unit depth in the plane.
double area_of(int side, const Box<3>& patch) {
  double area = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != axis_of_side(side))
      area *= patch.high[static_cast<std::size_t>(axis)] - patch.low[static_cast<std::size_t>(axis)];
  }
  return area;
}

std::string sides_text(const Coupled& coupled, double gravity) {
  std::string to_fluid, to_nothing;
  for (std::size_t side = 0; side < 2 * static_cast<std::size_t>(coupled.grid.dim); ++side) {
    if (is_wall(coupled.sides[side])) continue;
    std::string& text = coupled.sides[side] == BoxSide::open ? to_fluid : to_nothing;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", box_side_names[side]);
  }
  for (const Opening& opening : coupled.openings)
    to_fluid +=
        fmt::format("{}{} in part (area {:.4g})", to_fluid.empty() ? "" : ", ",
                    box_side_names[static_cast<std::size_t>(opening.side)], area_of(opening.side, opening.patch));
  if (!to_fluid.empty() && (gravity != 0 || !coupled.smoke_boxes.empty()))
    to_fluid += fmt::format(" (to fluid at rest, of pressure zero at y = {:.6g})", coupled.level);
  if (!to_nothing.empty()) to_nothing += " (to nothing)";
  return to_fluid + (to_fluid.empty() || to_nothing.empty() ? "" : ", ") + to_nothing;
}

std::string jets_text(const Coupled& coupled) {
  std::string text;
  for (const Jet& jet : coupled.jets) {
    const double area = area_of(jet.side, jet.patch);
    text += fmt::format("{}jet {} on the {} (area {:.4g}, speed {:.4g})", text.empty() ? "" : ", ", jet.number,
                        box_side_names[static_cast<std::size_t>(jet.side)], area, jet.speed);
  }
  return text;
}

Term term(const char* name, bool on, const std::string& yes, const std::string& no) {
  return {name, on, on ? yes : no};
}

std::string liquid_text(const Coupled& coupled) {
  if (!coupled.liquid) return {};
  const Liquid& liquid = *coupled.liquid;
  return fmt::format("{} region{} at the start, {} particles a cell; air is {}", liquid.regions.size(),
                     liquid.regions.size() == 1 ? "" : "s", std::pow(liquid.per_axis, coupled.grid.dim),
                     liquid.air == Air::empty ? "nothing" : "sealed where it is shut in");
}

std::string gravity_text(double along_y, double along_x) {
  return fmt::format("gravc = {:.6g} in y{}", along_y, along_x == 0 ? "" : fmt::format(", {:.6g} in x", along_x));
}

Term cfl_term(const Scene& scene) {
  const CflNumber cfl = cfl_number(scene);
  return term("CFL number", cfl.number > 0,
              fmt::format("{:.3g} cells a step by {}, {:.4g}; the run has that of the velocities it finds", cfl.number,
                          cfl.of, cfl.speed),
              "the deck gives no velocity; the run has that of those it finds");
}

std::vector<Term> fluid_terms(const Scene& scene) {
  const Coupled& c = *scene.coupled();
  const std::string open = sides_text(c, scene.gravity);
  return {
      {"advection", true,
       c.liquid                               ? "by particles, which carry velocities and their slopes"
       : c.mesh                               ? "from the mesh before: of order 1"
       : c.advection == Advection::maccormack ? "MacCormack's, limited: of order 2"
                                              : "semi-Lagrangian: of order 1"},
      term("liquid surface", c.liquid.has_value(), liquid_text(c), "the fluid fills the box"),
      term("viscosity", c.viscosity > 0,
           fmt::format("mu {:.4g}: walls and obstacles hold the fluid{}", c.viscosity,
                       scene.solids() ? (c.bodies_slip ? ", bodies do not" : ", and so do bodies") : ""),
           "mu = 0: the fluid slips along walls"),
      term("gravity", scene.gravity != 0 || c.gravity_x != 0, gravity_text(scene.gravity, c.gravity_x), "gravc = 0"),
      term("smoke", c.smoke, fmt::format("weight {:.4g}, lift {:.4g}", c.smoke_weight, c.smoke_lift),
           "no jet brings smoke or temperature"),
      term("jets", !c.jets.empty(), jets_text(c), "none given"),
      term("open sides", !open.empty(), open, "walls all round"),
      term("obstacles", !c.obstacles.empty() || !c.shaped.empty(),
           c.shaped.empty() ? fmt::format("{}", c.obstacles.size())
                            : fmt::format("{} of whole cells, {} that cut cells", c.obstacles.size(), c.shaped.size()),
           "none given"),
      term("void", !c.voids.empty() || c.cavities_only,
           c.cavities_only ? "everywhere but in cavities of bodies" : fmt::format("{} boxes", c.voids.size()),
           c.liquid ? "air where no liquid is" : "fluid everywhere"),
      {"linear systems", true, systems_text(c)},
      cfl_term(scene),
  };
}

/// Says how steps find where solids go, and why.
std::string step_text(const Coupled& coupled, const Solids& solids, double tstep) {
  const bool asked = coupled.step != SolidsStep::automatic, paper = coupled.integrator == CoupledIntegrator::paper;
  const double gain = linear_gain(solids, tstep);
  if (keeps_energy(coupled, solids, tstep))
    return fmt::format("keeps the energy: Newton's method over solids, contact and pressures, {}",
                       asked                     ? "as the deck says"
                       : gain > most_linear_gain ? fmt::format("since turning at the start would give a body {:.2g} of "
                                                               "its energy in a linear one",
                                                               gain)
                                                 : "since bodies meet");
  const char* rule =
      paper ? "linear, the paper's: backward Euler in the velocity, damps by h omega/4" : "linear, trapezoidal rule";
  if (!coupled.coupling.balances_power()) return fmt::format("{}: the mode has no other", rule);
  if (asked) return fmt::format("{}, as the deck says", rule);
  return fmt::format("{}: no body is to meet another, and turning at the start gives {}", rule,
                     gain > 0 ? fmt::format("{:.2g} of its energy at most", gain) : "no energy");
}

/// Says what stops bodies, and whether they stop each other.
std::vector<Term> contact_terms(const Coupled& coupled, const Solids& solids, double tstep) {
  if (keeps_energy(coupled, solids, tstep))
    return {term("contact", solids.contact.has_value(), solids.contact ? contact_text(*solids.contact) : "",
                 "contact = .false.")};
  return {term("contact", coupled.contact, fmt::format("with walls and obstacles, friction {:.4g}", coupled.friction),
               "contact = .false."),
          {"contact between bodies", false, "bodies go through one another: $contact has them meet"}};
}

std::vector<Term> body_terms(const Scene& scene) {
  const Coupled& c = *scene.coupled();
  const Solids& s = *scene.solids();
  const double tstep = scene.clock.tstep;
  std::vector<Term> terms{
      {"step of the solids", true, step_text(c, s, tstep)},
      flow_mesh_term(scene),
      term("closed regions", c.volume_term, "found each step, their volumes held", "volume_term = .false."),
      term("repair of areas", !c.coupling.simultaneous && c.area_repair,
           "balances the walls' velocities of closed regions", "the mode needs none, or area_repair = .false."),
      term("convex stiffness", c.convex && !keeps_energy(c, s, tstep),
           "K' of each element is made positive semi-definite",
           c.convex ? "Newton's method takes the forces' own slopes" : "convex = .false."),
      term("friction of the fluid on bodies", sticks_to_bodies(c), "it sticks to them",
           c.viscosity > 0 ? "bodies_slip = .true.: mu acts at walls and obstacles alone" : "mu = 0"),
      term("damping", s.alpha > 0 || s.beta > 0, fmt::format("alpha {:.4g}, beta {:.4g}", s.alpha, s.beta),
           "alpha = beta = 0"),
      term("loads", !s.loads.empty(), loads_text(s), "none given"),
      term("supports", !s.supports.empty(), supports_text(s), "none given"),
      term("springs", !c.springs.empty(), fmt::format("{}", c.springs.size()), "none given"),
  };
  const auto contact = contact_terms(c, s, tstep);
  terms.insert(terms.end(), contact.begin(), contact.end());
  return terms;
}

}  // namespace

std::vector<Term> coupled_terms(const Scene& scene) {
  std::vector<Term> terms{{"mode", scene.solids() != nullptr, mode_text(scene)}};
  const auto add = [&](const std::vector<Term>& more) { terms.insert(terms.end(), more.begin(), more.end()); };
  add(fluid_terms(scene));
  if (scene.solids()) add(body_terms(scene));
  const bool space = scene.coupled()->grid.dim == 3;
  terms.push_back(
      {"third dimension", space, space ? "the box is three-dimensional" : "the box is plane, one unit deep"});
  return terms;
}

/// Measured on trials: a factorisation 0.2 microseconds for each of n log n in the plane, conjugate gradients 5 for
/// each cell in space, all else 1, and 15 for each cell of a mesh, which is made anew.
Cost coupled_cost(const Scene& scene, const StepRule& rule) {
  constexpr double bytes_per_nonzero = 12, seconds_per_nonzero = 2e-8, seconds_by_krylov = 5e-6,
                   seconds_per_cell = 1e-6, seconds_per_triangle = 1.5e-5, bytes_per_particle = 200,
                   seconds_per_particle = 4e-7;
  const Coupled& coupled = *scene.coupled();
  const double box = static_cast<double>(coupled.grid.cell_count()) * coupled.grid.volume();
  const double cells = coupled.mesh ? mesh_cells_of(box, coupled.mesh->size, coupled.grid.dim)
                                    : static_cast<double>(coupled.grid.cell_count());
  const double unknowns = (coupled.mesh ? (coupled.grid.dim == 2 ? 1.5 : 2) : 1) * cells +
                          static_cast<double>(scene.solids() ? scene.solids()->mesh.x.size() : 0);
  const bool direct = systems_of(coupled) == Systems::direct;
  const double nonzeros = !direct                 ? 0
                          : coupled.grid.dim == 2 ? 10 * unknowns * std::log2(unknowns + 2)
                                                  : 12 * std::pow(unknowns, 4.0 / 3);
  // A step that keeps the energy takes several corrections of Newton's method, each by factors of a full matrix.
  const double solutions = scene.solids() && keeps_energy(coupled, *scene.solids(), scene.clock.tstep) ? 5 : 1;
  // Of a liquid, half of the box.
  const double particles = coupled.liquid ? 0.5 * cells * std::pow(coupled.liquid->per_axis, coupled.grid.dim) : 0;
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.deck_step * (1 - 1e-9));
  cost.point_steps = cost.steps * cells;
  cost.megabytes = 1e-6 * (bytes_per_cell * unknowns + bytes_per_nonzero * nonzeros + bytes_per_particle * particles);
  cost.seconds = cost.steps *
                 ((coupled.mesh ? seconds_per_triangle : seconds_per_cell) * cells + seconds_per_particle * particles +
                  solutions * (seconds_per_nonzero * nonzeros + (direct ? 0 : seconds_by_krylov * unknowns)));
  return cost;
}

std::string coupled_head(const Scene& scene) {
  const StaggeredGrid& grid = scene.coupled()->grid;
  const bool space = grid.dim == 3;
  std::string text = fmt::format("path: coupled ({}, incompressible flow{})\n", space ? "space" : "plane",
                                 scene.solids() ? " and solids" : "");
  text += space ? fmt::format("grid: {} x {} x {} cells of {:.6g} x {:.6g} x {:.6g}\n", grid.n[0], grid.n[1], grid.n[2],
                              grid.d[0], grid.d[1], grid.d[2])
                : fmt::format("grid: {} x {} cells of {:.6g} x {:.6g}\n", grid.n[0], grid.n[1], grid.d[0], grid.d[1]);
  if (const auto& sizes = scene.coupled()->mesh)
    text += fmt::format("mesh of the fluid: {} of {:.4g}, made anew as bodies move; the grid is that of mesh.nc\n",
                        space ? "tetrahedra" : "triangles", sizes->size);
  text += fmt::format("fluid: density {:.4g}\n", scene.coupled()->density);
  if (!scene.solids()) return text;
  const Mesh& mesh = scene.solids()->mesh;
  text += fmt::format("solids: {} elements {}, {} nodes, {} bodies\n", mesh.element_count(), element_name(mesh.kind),
                      mesh.node_count(), count_parts(mesh));
  return text + regions_text(*scene.solids());
}

namespace {

/// The largest size of a factor at times of the run; an expression without a value at one of them has none there.
double largest_factor(const Amplitude& amplitude, double tmax) {
  constexpr int times = 100;
  std::vector<double> all = amplitude.time;
  for (int k = 0; k <= times; ++k) all.push_back(k * tmax / times);
  double largest = 0;
  for (const double t : all) {
    if (t < 0 || t > tmax) continue;
    try {
      largest = std::max(largest, std::abs(amplitude.at(t)));
    } catch (const RunError&) {
      continue;
    }
  }
  return largest;
}

}  // namespace

CflNumber cfl_number(const Scene& scene) {
  const Coupled& coupled = *scene.coupled();
  CflNumber worst;
  const auto consider = [&](int axis, double speed, const std::string& of) {
    const double number = std::abs(speed) * scene.clock.tstep / coupled.grid.d[static_cast<std::size_t>(axis)];
    if (number > worst.number) worst = {number, std::abs(speed), of};
  };
  for (const Jet& jet : coupled.jets)
    consider(axis_of_side(jet.side), jet.speed * largest_factor(jet.amplitude, scene.clock.tmax),
             fmt::format("jet {}", jet.number));
  for (int axis = 0; axis < coupled.grid.dim; ++axis) {
    consider(axis, coupled.start[static_cast<std::size_t>(axis)], "the fluid at the start");
    if (!scene.solids()) continue;
    for (const SolidRegion& region : scene.solids()->regions)
      consider(axis, region.velocity[static_cast<std::size_t>(axis)], region.name + " at the start");
  }
  return worst;
}

}  // namespace tether
