// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <variant>

#include "model/bars.hpp"
#include "model/find_strip.hpp"
#include "model/solids.hpp"
#include "plan/bending.hpp"
#include "plan/coupled_plan.hpp"
#include "plan/flow_plan.hpp"
#include "plan/solid_plan.hpp"

namespace tether {
namespace {

/// What the scene is made of on its path, and on which grid.
struct Head {
  const Scene& scene;
  std::string operator()(const MaterialPoints&) const {
    return fmt::format("path: mpm (material points, {})\ngrid: {} x {} nodes, cells {:.6g} x {:.6g}\n",
                       scene.geometry == Geometry::plane ? "plane" : "axisymmetric", scene.grid.nx, scene.grid.ny,
                       scene.grid.dx, scene.grid.dy);
  }
  std::string operator()(const Bars&) const { return "path: fem (bars)\n"; }
  std::string operator()(const ElasticBodies& bodies) const { return solid_head(*bodies.solids); }
  std::string operator()(const RigidBody&) const { return rigid_head(scene); }
  std::string operator()(const MeshFlow&) const { return flow_head(scene); }
  std::string operator()(const BoxFlow&) const { return coupled_head(scene); }
};

/// The step, and against which limit.
struct StepText {
  const Plan& plan;
  std::string operator()(const MaterialPoints&) const { return limited(" at the start"); }
  std::string operator()(const Bars&) const { return limited(""); }
  std::string operator()(const ElasticBodies& bodies) const {
    return by_deck(bodies.solids->integrator == Integrator::central ? ", or cfl 2/omega where that is less" : "");
  }
  std::string operator()(const RigidBody&) const { return by_deck(""); }
  std::string operator()(const MeshFlow&) const { return by_deck(""); }
  std::string operator()(const BoxFlow&) const { return by_deck(""); }

 private:
  std::string by_deck(const char* limit) const {
    return fmt::format("step: {:.6g}, the deck's{}\n", plan.step.deck_step, limit);
  }
  std::string limited(const char* when) const {
    return fmt::format("step: {:.6g}{} (deck {:.6g}, limit {} {:.6g}, cfl {:.3g})\n", plan.step.first_step(), when,
                       plan.step.deck_step, plan.step.limit_name, plan.step.first_limit, plan.step.cfl);
  }
};

}  // namespace

std::string to_text(const Plan& plan) {
  const Scene& scene = plan.scene;
  std::string text = std::visit(Head{scene}, scene.physics);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    text += fmt::format("body {}: {}, {} points, {}\n", b + 1, body.name, body.count,
                        material_name(body.material, scene.geometry));
  }
  text += "modelled:\n";
  for (const Term& term : plan.terms) {
    if (term.on) text += fmt::format("  {}: {}\n", term.name, term.reason);
  }
  text += "left out:\n";
  for (const Term& term : plan.terms) {
    if (!term.on) text += fmt::format("  {}: {}\n", term.name, term.reason);
  }
  text += std::visit(StepText{plan}, scene.physics);
  if (const auto solids = scene.solids()) text += bending_text(plan.bending, *solids);
  text +=
      fmt::format("cost: {:.0f} steps, {:.4g} point-steps, {:.3g} MB, about {:.2g} CPU s on one core ({})\n",
                  plan.cost.steps, plan.cost.point_steps, plan.cost.megabytes, plan.cost.seconds,
                  plan.cost.rehearsed > 0 ? fmt::format("carried on from {} steps made on trial", plan.cost.rehearsed)
                                          : "an estimate by formulas: no steps were made on trial");
  for (const auto& warning : plan.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

namespace {

struct Namer {
  Geometry geometry;

  std::string operator()(const PlaneElastic& law) const {
    return fmt::format("linear elastic, {} (E {:.4g}, nu {:.3g})", across(law.plane == PlaneElastic::Plane::stress),
                       law.E, law.nu);
  }
  std::string operator()(const FiniteElastic& law) const {
    return std::visit([this](const auto& of) { return law_text(of) + ", " + across(of.plane_stress()); }, law.law);
  }
  /// Says what holds the body across the plane.
  const char* across(bool plane_stress) const {
    if (geometry == Geometry::axisymmetric) return "about the axis";
    return plane_stress ? "plane stress" : "plane strain";
  }
  std::string operator()(const IdealGas& gas) const {
    const char* rule = gas.rule == DensityRule::cell         ? "by cell (4.5)"
                       : gas.rule == DensityRule::quadratic  ? "by quadratic interpolation (4.6)"
                       : gas.rule == DensityRule::continuity ? "by continuity (4.7)"
                                                             : "from the gas at the nodes";
    return fmt::format("ideal gas, gamma {:.4g}, density {}", gas.gm1 + 1, rule);
  }
  std::string operator()(const LinearFluid& law) const {
    return fmt::format("linear fluid, beta {:.4g} (6.1){}", law.beta,
                       law.mu > 0 ? fmt::format(", viscosity {:.4g}", law.mu) : "");
  }
  std::string operator()(const Membrane& law) const {
    const std::string way = law.wrinkle ? "one-way" : "two-way";
    if (law.kind == Membrane::Kind::uniaxial) return fmt::format("string, E {:.4g}, {}", law.E, way);
    return fmt::format("membrane in plane stress, E {:.4g}, nu {:.3g}, {}", law.E, law.nu, way);
  }
};

std::string order_reason(StressOrder order) {
  switch (order) {
    case StressOrder::usf:
      return "first, from the mapped velocity (usf)";
    case StressOrder::usl:
      return "last, from the solution of the momentum equation (usl)";
    case StressOrder::musl:
      break;
  }
  return "last, from the point momenta mapped back (musl, the thesis')";
}

std::string kernel_reason(const Method& method) {
  const char* functions = method.kernel == Kernel::linear ? "bilinear shape functions" : "quadratic B-splines";
  return fmt::format("{}, {}", functions,
                     method.transfer == Transfer::flip ? "velocities by increments (flip)"
                                                       : "velocities with the field about a point (apic)");
}

std::string contact_reason(const Method& method) {
  if (method.contact == ContactRule::release) return fmt::format("release by criterion {} (A.1.3)", method.criterion);
  return "an impulse where points of two bodies touch and approach, without friction";
}

std::string tangents_reason(const Method& method) {
  static constexpr const char* rules[] = {"a string is there, connected in file order",
                                          "by the simple color function (7.2)",
                                          "by quadratic interpolation (7.4)",
                                          "by cubic interpolation (7.6)",
                                          "by the mass matrix of linear functions (7.12)",
                                          "by the mass matrix of quadratic functions (7.18)"};
  return rules[static_cast<int>(method.normals)];
}

/// Each open edge, and what is outside it.
std::string edges_reason(const Scene& scene) {
  std::string text;
  for (std::size_t k = 0; k < 4; ++k) {
    const Edge& edge = scene.edges.of[k];
    if (!edge.open()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", edge_names[k],
                        edge.kind == EdgeKind::inflow ? "inflow" : "outflow");
    if (edge.kind == EdgeKind::inflow)
      text += fmt::format(" of {}, density {:.6g}, energy {:.6g}, velocity ({:.6g}, {:.6g})",
                          scene.bodies[edge.body].name, edge.density, edge.energy, edge.u, edge.v);
    else if (edge.has_outside)
      text += fmt::format(" to density {:.6g}, energy {:.6g}", edge.density, edge.energy);
  }
  return text;
}

}  // namespace

std::string material_name(const Material& material, Geometry geometry) { return std::visit(Namer{geometry}, material); }

std::vector<Term> strip_terms(const Scene& scene) {
  const char* name = "one row for all of a strip";
  if (scene.strip)
    return {{name, true,
             fmt::format("{} of {} points run, each for up to {} abreast; all are written", scene.strip->first.size(),
                         scene.strip->points(), scene.strip->most_abreast())}};
  const std::variant<Strip, NoStrip> found = find_strip(scene);
  const Strip* strip = std::get_if<Strip>(&found);
  if (!strip || strip->most_abreast() == 1) return {};
  return {{name, false,
           fmt::format("reduce=.true. of $mpm would run {} of {} points, with the same results", strip->first.size(),
                       strip->points())}};
}

std::vector<Term> terms_of(const Scene& scene) {
  const Body* gas_body = find_body<IdealGas>(scene);
  const IdealGas* gas = gas_body ? &std::get<IdealGas>(gas_body->material) : nullptr;
  const bool rubs = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                [](const Body& body) { return is_viscous_fluid(body.material); });
  const Method& method = scene.method;
  const bool strings = find_body<Membrane>(scene) != nullptr;
  const bool elements = strings && method.membrane_strain == MembraneStrain::element;
  const bool contact = method.contact != ContactRule::none && may_touch(scene);
  const bool shocks = gas && gas->lambda != 0 && (gas->coef1 != 0 || gas->coef2 != 0);
  const auto term = [](const char* name, bool on, const std::string& yes, const std::string& no) {
    return Term{name, on, on ? yes : no};
  };
  return {
      {"stress update", true, order_reason(method.order)},
      {"shape functions and transfer", true, kernel_reason(method)},
      term("gravity", scene.gravity != 0, fmt::format("gravc = {:.6g} in y", scene.gravity), "gravc = 0"),
      term("energy equation (4.8)", gas, "a gas is there", "no gas"),
      term("viscosity (4.1)", (gas && gas->mu != 0) || rubs, "mu > 0", gas ? "mu = 0" : "no gas"),
      term("artificial viscosity (4.11)", shocks,
           gas && gas->local_speed ? "both coefficients 1, with the local sound speed" : "lambda and a coefficient > 0",
           gas ? "lambda or both coefficients are 0" : "no gas"),
      term("tangents (7.1)", strings && !elements, tangents_reason(method),
           strings ? "elements between the points carry the strain" : "no string"),
      term("membrane elements", elements, "strain by the distance between consecutive points",
           strings ? "strain by the points' strain rates (5.2)" : "no string"),
      term("contact and release", contact, contact_reason(method),
           method.contact != ContactRule::none
               ? "no solid meets another body"
               : "bodies share one velocity field where they share a node, as in the thesis' basic method"),
      term("heat ledger", method.ledger && gas, "what transfer and elements lose heats the gas",
           gas ? "what the method loses of the energy is lost" : "no gas"),
      term("open edges", scene.edges.any(), edges_reason(scene), "no gas passes the edges of the grid"),
      term("pressure outside", scene.ambient != 0,
           fmt::format("pambient = {:.6g} on membranes that enclose gas", scene.ambient), "pambient = 0"),
      {"heat conduction", false, "not in the source's energy equation (4.8)"},
      {"third dimension", false,
       scene.geometry == Geometry::plane ? "the scene is plane, one unit deep"
                                         : "the scene is a body of revolution, without swirl"},
  };
}

}  // namespace tether
