// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/make_plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/diagnostics.hpp"
#include "model/find_strip.hpp"
#include "model/size.hpp"
#include "model/solids.hpp"
#include "plan/bending.hpp"
#include "plan/coupled_plan.hpp"
#include "plan/flow_mesh_term.hpp"
#include "plan/flow_plan.hpp"
#include "plan/plan_text.hpp"
#include "plan/reference_plan.hpp"
#include "plan/solid_plan.hpp"

namespace tether {
namespace {

/// What a point-step of the MPM path costs on a machine of 2020's make; only for the estimate [s].
constexpr double seconds_per_point_step = 45e-9;

/// Turn of a rigid body in a step from which it is reported: the mid-point rule's phase is off by its square over 12
/// [rad].
constexpr double told_turn = 0.5;

struct FirstWave {
  const Scene& scene;
  const Body& body;
  double operator()(const PlaneElastic& law) const { return law.sound_speed(body.density); }
  double operator()(const FiniteElastic& law) const { return law.sound_speed(body.density); }
  double operator()(const LinearFluid& law) const { return law.sound_speed(body.density); }
  double operator()(const Membrane& law) const { return law.sound_speed(body.density); }
  double operator()(const IdealGas& law) const {
    double speed = 0;
    for (std::size_t p = body.first; p < body.first + body.count; ++p) {
      speed = std::max(speed, std::hypot(scene.points.vx[p], scene.points.vy[p]));
    }
    return std::sqrt(law.sound_speed_squared(body.specific_energy)) + speed;
  }
};

/// What the deck's rule does not see: pressure waves run faster than sqrt(E / rho), and viscosity spreads momentum over
/// a cell in rho h^2 / (4 (4/3) mu). The shortest of these over all bodies [time].
struct SharpLimit {
  const Body& body;
  double h;
  double operator()(const PlaneElastic& law) const { return h / std::sqrt((law.lambda + 2 * law.G) / body.density); }
  double operator()(const FiniteElastic& law) const { return h / law.sound_speed(body.density); }
  double operator()(const IdealGas& law) const { return by_friction(law.mu); }
  double by_friction(double mu) const {
    return mu > 0 ? body.density * h * h / (16.0 / 3 * mu) : std::numeric_limits<double>::infinity();
  }
  double operator()(const LinearFluid& law) const { return by_friction(law.mu); }
  double operator()(const Membrane&) const { return std::numeric_limits<double>::infinity(); }
};

double sharp_limit(const Scene& scene, double h) {
  double limit = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) limit = std::min(limit, std::visit(SharpLimit{body, h}, body.material));
  return limit;
}

StepRule step_rule(const Scene& scene) {
  StepRule rule;
  rule.deck_step = scene.clock.tstep;
  rule.cfl = scene.clock.cfl;
  rule.h = std::min(scene.grid.dx, scene.grid.dy);
  double gas_wave = 0;
  for (const Body& body : scene.bodies) {
    double& fastest = std::holds_alternative<IdealGas>(body.material) ? gas_wave : rule.solid_speed;
    fastest = std::max(fastest, std::visit(FirstWave{scene, body}, body.material));
  }
  for (const Edge& edge : scene.edges.of) {
    if (edge.kind != EdgeKind::inflow) continue;
    const auto& gas = std::get<IdealGas>(scene.bodies[edge.body].material);
    gas_wave = std::max(gas_wave, std::sqrt(gas.sound_speed_squared(edge.energy)) + std::hypot(edge.u, edge.v));
  }
  rule.first_limit = rule.limit(gas_wave);
  rule.sharp_limit = sharp_limit(scene, rule.h);
  return rule;
}

/// Points of the strips beyond open edges, as they are at the start.
double points_of_strips(const Scene& scene) {
  int lattice = 0;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<IdealGas>(body.material)) lattice = std::max(lattice, body.lattice);
  }
  double cells = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (scene.edges.of[k].open()) cells += strip_cells * (k < 2 ? scene.grid.cells_y() : scene.grid.cells_x());
  }
  return cells * lattice * lattice;
}

/// Memory of a node and of a point of the scene [bytes].
struct Bytes {
  double node = bytes_per_node, point = bytes_per_point;
};

Bytes bytes_of(const Scene& scene) {
  const bool gas = find_body<IdealGas>(scene);
  Bytes bytes;
  if (gas) bytes.node += bytes_of_gas_node, bytes.point += bytes_of_gas;
  if (scene.method.transfer == Transfer::apic) bytes.point += bytes_of_field;
  if (find_body<FiniteElastic>(scene)) bytes.point += bytes_of_deformation;
  if (find_body<Membrane>(scene)) bytes.point += bytes_of_membrane;
  if (scene.outputs.checkpoint > 0) bytes.node += more_bytes_per_node, bytes.point += more_bytes_per_point;
  return bytes;
}

Cost cost_of(const Scene& scene, const StepRule& rule) {
  const double points = static_cast<double>(points_that_run(scene)) + points_of_strips(scene);
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.first_step() * (1 - 1e-9));
  cost.point_steps = cost.steps * points;
  const Bytes bytes = bytes_of(scene);
  cost.megabytes =
      megabytes_of_program + 1e-6 * (static_cast<double>(scene.grid.nodes()) * bytes.node + points * bytes.point);
  if (scene.strip) cost.megabytes += 1e-6 * static_cast<double>(scene.strip->points()) * bytes_of_strip_point;
  cost.seconds = cost.point_steps * seconds_per_point_step;
  return cost;
}

/// Warns of the deck's step against the limit of the rule.
std::string step_warning(const StepRule& rule) {
  const double ratio = rule.deck_step / rule.first_limit;
  const std::string above = fmt::format("the deck's step {:.4g} is {:#.3g} times the limit {} = {:.4g}", rule.deck_step,
                                        ratio, rule.limit_name, rule.first_limit);
  if (rule.cfl == 0) return ratio > 1 + 1e-9 ? above + " and taken as it is (cfl = 0)" : "";
  const double limited = rule.cfl * rule.first_limit;
  if (rule.deck_step <= limited * (1 + 1e-9)) return "";
  const std::string factor = rule.cfl == 1 ? "" : fmt::format(", which is cfl = {:.3g} times that", rule.cfl);
  return fmt::format("{}: steps are limited to {:.4g}{}", above, limited, factor);
}

/// Warns of the fluid in a box that crosses many cells in a step; says nothing where it does not.
std::string cfl_warning(const Scene& scene) {
  const CflNumber cfl = cfl_number(scene);
  const double most = scene.limits.cfl.warn;
  if (most <= 0 || cfl.number <= most) return "";
  return fmt::format(
      "{}, {:.4g}, crosses {:.4g} cells in a step, more than {:.4g} (cfl of $limits): much of what the "
      "fluid carries along is lost; with tstep = {:.3g} it crosses {:.4g}",
      cfl.of, cfl.speed, cfl.number, most, scene.clock.tstep * most / cfl.number, most);
}

/// Warns of a rigid body that turns far in a step [time]; says nothing where it does not.
std::string turn_warning(const Rigid& rigid, double step) {
  const double turn = step * rigid.omega.norm();
  if (turn <= told_turn) return "";
  return fmt::format("the body turns by {:.3g} rad in a step: its phase will be off by {:.2g} of itself", turn,
                     turn * turn / 12);
}

/// Warns of the step against the limits that the rule knows, and against those that it does not.
std::vector<std::string> step_warnings(const StepRule& rule) {
  std::vector<std::string> warnings;
  const std::string step = step_warning(rule);
  if (!step.empty()) warnings.push_back(step);
  if (rule.cfl > 0 && rule.first_step() > rule.sharp_limit) {
    warnings.push_back(
        fmt::format("steps of {:.4g} are {:#.3g} times what pressure waves or viscosity allow ({:.4g}), which "
                    "the rule dx/sqrt(E/rho) does not see: lower tstep or cfl",
                    rule.first_step(), rule.first_step() / rule.sharp_limit, rule.sharp_limit));
  }
  return warnings;
}

/// A step that is lost in the rounding of the time would never reach the end.
void refuse_lost_steps(const Clock& clock, const StepRule& rule) {
  if (clock.tmax + rule.first_step() > clock.tmax) return;
  throw InputError(
      fmt::format("steps of {:.3g} are lost against tmax = {:.6g}", rule.first_step(), clock.tmax),
      fmt::format("tstep is {:.3g}, the limit {} {:.3g}", rule.deck_step, rule.limit_name, rule.first_limit));
}

/// Step, terms and cost of each physics.
struct PlanOfPhysics {
  const Scene& scene;
  Plan& plan;

  void operator()(const MaterialPoints&) const {
    plan.step = step_rule(scene);
    plan.terms = terms_of(scene);
    for (auto& term : strip_terms(scene)) plan.terms.push_back(std::move(term));
    plan.cost = cost_of(scene, plan.step);
  }
  void operator()(const Bars&) const {
    const BarMesh mesh = bars_of(scene);
    plan.step = bar_step_rule(scene, mesh);
    plan.terms = bar_terms(scene, mesh);
    plan.cost = bar_cost(scene, mesh, plan.step);
  }
  void operator()(const ElasticBodies& bodies) const {
    by_deck_step(solid_terms(*bodies.solids, scene.gravity), solid_cost);
  }
  void operator()(const RigidBody&) const { by_deck_step(rigid_terms(scene), rigid_cost); }
  void operator()(const MeshFlow&) const { by_deck_step(flow_terms(scene), flow_cost); }
  void operator()(const BoxFlow&) const { by_deck_step(coupled_terms(scene), coupled_cost); }

 private:
  /// Makes the plan of what takes the deck's step: what runs on a mesh or in a box.
  void by_deck_step(std::vector<Term> terms, Cost (*cost)(const Scene& scene, const StepRule& rule)) const {
    plan.step = solid_step_rule(scene);
    plan.terms = std::move(terms);
    plan.cost = cost(scene, plan.step);
  }
};

/// Warnings that each physics adds to those of its step.
struct WarningsOfPhysics {
  const Scene& scene;
  Plan& plan;

  void operator()(const MaterialPoints&) const {
    if (scene.method.order == StressOrder::usl)
      warn("order = 'usl' is unstable well below the limit dx/c: it divides by nodal masses however small");
  }
  void operator()(const Bars&) const {}
  void operator()(const ElasticBodies& bodies) const { look_at_bending(*bodies.solids); }
  void operator()(const RigidBody& body) const { warn(turn_warning(*body.rigid, plan.step.first_step())); }
  void operator()(const MeshFlow& flow) const {
    if (!flow.solids) return;
    look_at_bending(*flow.solids);
    for (auto& warning : immersed_warnings(*flow.flow, *flow.solids)) warn(std::move(warning));
  }
  void operator()(const BoxFlow& flow) const {
    warn(cfl_warning(scene));
    warn(flow_mesh_warning(scene));
    if (flow.solids) look_at_bending(*flow.solids);
  }

 private:
  void warn(std::string warning) const {
    if (!warning.empty()) plan.warnings.push_back(std::move(warning));
  }
  void look_at_bending(const Solids& solids) const {
    plan.bending = bending_of(solids);
    warn(bending_warning(plan.bending, solids));
    warn(lean_warning(plan.bending));
    warn(trace_warning(solids));
  }
};

}  // namespace

Plan make_plan(Scene scene) {
  Plan plan;
  std::visit(PlanOfPhysics{scene, plan}, scene.physics);
  refuse_lost_steps(scene.clock, plan.step);
  plan.warnings = step_warnings(plan.step);
  std::visit(WarningsOfPhysics{scene, plan}, scene.physics);
  for (auto& term : reference_terms(scene)) plan.terms.push_back(std::move(term));
  for (auto& warning : reference_warnings(scene)) plan.warnings.push_back(std::move(warning));
  plan.scene = std::move(scene);
  return plan;
}

}  // namespace tether
