// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_text.hpp"

#include <fmt/format.h>

#include "model/bars.hpp"
#include "model/solids.hpp"
#include "plan/coupled_plan.hpp"
#include "plan/flow_plan.hpp"
#include "plan/rigid_plan.hpp"
#include "plan/solid_plan.hpp"
#include "plan/terms.hpp"

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
    text += fmt::format("body {}: {}, {} points, {}\n", b + 1, body.name, body.count, material_name(body.material));
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
  text +=
      fmt::format("cost: {:.0f} steps, {:.4g} point-steps, {:.3g} MB, about {:.2g} CPU s on one core ({})\n",
                  plan.cost.steps, plan.cost.point_steps, plan.cost.megabytes, plan.cost.seconds,
                  plan.cost.rehearsed > 0 ? fmt::format("carried on from {} steps made on trial", plan.cost.rehearsed)
                                          : "an estimate by formulas: no steps were made on trial");
  for (const auto& warning : plan.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

}  // namespace tether
