// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/solid_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "model/solids.hpp"

namespace tether {
namespace {

const char* integrator_text(Integrator integrator) {
  switch (integrator) {
    case Integrator::energy:
      return "discrete gradient: keeps energy and momenta at any step";
    case Integrator::midpoint:
      return "mid-point rule";
    case Integrator::trapezoid:
      return "Newmark's trapezoidal rule";
    case Integrator::central:
      return "central differences with lumped masses";
    case Integrator::equilibrium:
      break;
  }
  return "none: each step is an equilibrium";
}

/// Nonzeros of a factor, by what nested dissection leaves on regular meshes (A. George, SIAM J. Numer. Anal. 10 (1973)
/// 345-363): n log n in the plane, n^(4/3) in space.
double factor_nonzeros(const Mesh& mesh) {
  const double n = static_cast<double>(mesh.x.size());
  return mesh.dim() == 2 ? 8 * n * std::log2(n + 2) : 12 * std::pow(n, 4.0 / 3);
}

std::size_t pressure_count(const Solids& solids) {
  return static_cast<std::size_t>(
      std::ranges::count_if(solids.loads, [](const Load& load) { return load.pressure != 0; }));
}

}  // namespace

std::string contact_text(const Contact& contact) {
  std::string what = contact.bodies ? "bodies with each other" : "";
  const auto add = [&](const std::string& more) { what += (what.empty() ? "" : ", ") + more; };
  if (contact.itself) add("with themselves");
  if (!contact.planes.empty()) add(fmt::format("with {} walls and planes", contact.planes.size()));
  if (!contact.obstacles.empty()) add(fmt::format("with {} obstacles", contact.obstacles.size()));
  const bool asked = contact.step != ContactStep::automatic;
  return fmt::format("{}; gap {:.4g}, {}; {}{}", what, contact.gap,
                     contact.friction > 0 ? fmt::format("friction {:.4g}", contact.friction) : "no friction",
                     is_damped(contact) ? "damped" : "keeps the energy",
                     asked                ? ", as the deck asks"
                     : is_damped(contact) ? ", since friction wants steady pressures"
                                          : "");
}

std::string supports_text(const Solids& solids) {
  std::string text;
  for (const Support& support : solids.supports) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i) axes += support.fixed[i] ? std::string(1, "xyz"[i]) : "";
    text += fmt::format("{}{} ({} nodes in {})", text.empty() ? "" : ", ", support.amplitude.of, support.nodes.size(),
                        axes);
  }
  return text;
}

std::string loads_text(const Solids& solids) {
  const std::size_t pressures = pressure_count(solids);
  const auto dead = std::count_if(solids.loads.begin(), solids.loads.end(),
                                  [](const Load& load) { return load.is_dead() || load.pressure == 0; });
  std::string text;
  if (dead > 0) text = fmt::format("{}, dead", dead);
  if (pressures > 0)
    text += fmt::format("{}{} {}", dead > 0 ? ", " : "", pressures,
                        pressures == 1 ? "pressure, that follows its sides" : "pressures, that follow their sides");
  return text;
}

std::string regions_text(const Solids& solids) {
  std::string text;
  for (const SolidRegion& region : solids.regions)
    text += fmt::format("{}: density {:.4g}, {}\n", region.name, region.density,
                        std::visit([](const auto& law) { return law_text(law); }, region.law));
  return text;
}

StepRule solid_step_rule(const Scene& scene) {
  StepRule rule;
  rule.deck_step = scene.clock.tstep;
  rule.cfl = 0;  // the solver limits explicit steps, whose limit changes with the shape
  rule.first_limit = rule.sharp_limit = std::numeric_limits<double>::infinity();
  return rule;
}

std::vector<Term> solid_terms(const Solids& solids, double gravity) {
  const bool damped = solids.alpha > 0 || solids.beta > 0;
  const auto term = [](const char* name, bool on, const std::string& yes, const std::string& no) {
    return Term{name, on, on ? yes : no};
  };
  return {
      term("inertia", solids.integrator != Integrator::equilibrium, integrator_text(solids.integrator),
           integrator_text(solids.integrator)),
      term("gravity", gravity != 0, fmt::format("gravc = {:.6g} in y", gravity), "gravc = 0"),
      term("loads", !solids.loads.empty(), loads_text(solids), "none given"),
      term("supports", !solids.supports.empty(), supports_text(solids),
           "none given, and no wall that a node stands at"),
      term("damping", damped, fmt::format("alpha {:.4g}, beta {:.4g}", solids.alpha, solids.beta), "alpha = beta = 0"),
      term("contact", solids.contact.has_value(), solids.contact ? contact_text(*solids.contact) : "",
           "without $contact bodies on a mesh do not meet, and walls stop none but hold what stands at them"),
      {"third dimension", solids.mesh.dim() == 3,
       solids.mesh.dim() == 3 ? "the mesh is three-dimensional" : "the mesh is plane, one unit deep"},
  };
}

Cost solid_cost(const Scene& scene, const StepRule& rule) {
  constexpr double bytes_per_nonzero = 12, seconds_per_nonzero = 5e-8, iterations = 4;
  const Mesh& mesh = scene.solids()->mesh;
  const bool direct = scene.solids()->integrator != Integrator::central;
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.first_step() * (1 - 1e-9));
  cost.point_steps = cost.steps * static_cast<double>(mesh.node_count());
  const bool unsymmetric =  // L and U
      scene.solids()->integrator == Integrator::energy || pressure_count(*scene.solids()) > 0;
  const double factor = direct ? factor_nonzeros(mesh) * (unsymmetric ? 2 : 1) : 0;
  const double element_matrices =
      static_cast<double>(mesh.element_count()) * std::pow(mesh.dim() * node_count_of(mesh.kind), 2);
  cost.megabytes = 1e-6 * bytes_per_nonzero * (factor + 2 * element_matrices);
  cost.seconds =
      cost.steps * seconds_per_nonzero * (direct ? iterations * (factor + element_matrices) : element_matrices);
  return cost;
}

std::string solid_head(const Solids& solids) {
  const Mesh& mesh = solids.mesh;
  std::string text = fmt::format("path: fem (elastic bodies, {})\nmesh: {} elements {}, {} nodes, {} unknowns\n",
                                 mesh.dim() == 2 ? "plane" : "space", mesh.element_count(), element_name(mesh.kind),
                                 mesh.node_count(), mesh.x.size());
  if (const int parts = count_parts(mesh); parts > 1) text += fmt::format("{} parts that nothing joins\n", parts);
  return text + regions_text(solids);
}

namespace {

/// What a step costs on a machine of 2020's make; only for the estimate [s].
constexpr double seconds_per_reduced_step = 1.5e-6, seconds_per_constrained_step = 8e-6;

std::string text_of(const Eigen::Vector3d& place) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]);
}

std::string form_reason(const Rigid& rigid) {
  if (rigid.form == RigidForm::constrained)
    return fmt::format("six{}, with a multiplier each", rigid.pin ? " and three of the pin" : "");
  return fmt::format("in their null space: {} unknowns, no multipliers", rigid.unknowns());
}

std::string point_reason(const Rigid& rigid) {
  return rigid.point ? "reference point " + text_of(*rigid.point) : "reference point at the centre of mass";
}

bool is_orthonormal(const Eigen::Matrix3d& d) { return (d.transpose() * d).isIdentity(1e-12); }

/// "1 on sides or in volumes, 2 torques, 1 at points", or "" where nothing acts.
std::string loads_reason(const Solids& solids, const Rigid& rigid) {
  const auto turning = static_cast<std::size_t>(
      std::count_if(rigid.forces.begin(), rigid.forces.end(), [](const RigidForce& force) { return force.turning; }));
  std::string text;
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  const std::size_t pressures = pressure_count(solids);
  add(solids.loads.size() - pressures, "dead on sides or in volumes");
  add(pressures, "by pressures that turn with the body");
  add(rigid.torques.size(), "by torques");
  add(rigid.forces.size() - turning, "dead at points");
  add(turning, "at points that turn with the body");
  return text;
}

}  // namespace

std::vector<Term> rigid_terms(const Scene& scene) {
  const Rigid& rigid = *scene.rigid();
  const Solids& solids = *scene.solids();
  const std::string loads = loads_reason(solids, rigid);
  const char* kind = is_orthonormal(rigid.directors) ? "orthonormal" : "skew";
  return {
      {"inertia", true, "of the mesh, as it turns; mid-point rule: keeps energy and momenta"},
      {"frame", true, fmt::format("{}, directors {}", point_reason(rigid), kind)},
      {"constraints", true, form_reason(rigid)},
      {"gravity", scene.gravity != 0,
       scene.gravity != 0 ? fmt::format("gravc = {:.6g} in y", scene.gravity) : "gravc = 0"},
      {"loads", !loads.empty(), loads.empty() ? "none given" : loads},
      {"pin", rigid.pin.has_value(), rigid.pin ? "at " + text_of(*rigid.pin) : "none given: the body is free"},
      {"strain", false, "the body is rigid: laws of its regions have no effect"},
      {"damping", false, "a rigid body has none"},
      {"contact", false, "bodies on a mesh do not meet, and walls do not stop them"},
      {"third dimension", true, "the body moves in space"},
  };
}

Cost rigid_cost(const Scene& scene, const StepRule& rule) {
  const bool reduced = scene.rigid()->form == RigidForm::reduced;
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.first_step() * (1 - 1e-9));
  cost.point_steps = cost.steps;
  cost.megabytes = 1e-6 * static_cast<double>(sizeof(double) * (20 * scene.solids()->mesh.x.size()));
  cost.seconds = cost.steps * (reduced ? seconds_per_reduced_step : seconds_per_constrained_step);
  return cost;
}

std::string rigid_head(const Scene& scene) {
  const Mesh& mesh = scene.solids()->mesh;
  std::string text =
      fmt::format("path: fem (rigid body)\nmesh: {} elements {}, {} nodes, for mass and shape\nunknowns: {}\n",
                  mesh.element_count(), element_name(mesh.kind), mesh.node_count(), scene.rigid()->unknowns());
  for (const SolidRegion& region : scene.solids()->regions)
    text += fmt::format("{}: density {:.4g}\n", region.name, region.density);
  return text;
}

}  // namespace tether
