// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/choices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/numbers.hpp"
#include "model/coupled.hpp"
#include "model/find_strip.hpp"
#include "model/solids.hpp"

namespace tether::automatic {
namespace {

/// A run without a part may cost so much more and still count as no dearer, over the run and in seconds: small runs are
/// not timed better, and where they take hundredths of a second nothing depends on it.
constexpr double timing_noise = 0.1, seconds_of_noise = 0.02;

bool has_artificial_viscosity(const IdealGas& law) {
  const bool linear_or_quadratic = law.coef1 != 0 || law.coef2 != 0;
  return law.lambda != 0 && linear_or_quadratic;
}

void add_points(const Deck& deck, const Scene& scene, std::vector<Choice>& choices) {
  if (!scene.strip && std::holds_alternative<Strip>(find_strip(scene)))
    choices.push_back({"rows of points that are alike (one row in their place)", {{"mpm.reduce=.true."}}});
  if (scene.method.contact != ContactRule::none && has_solid(scene))
    choices.push_back({"contact between bodies", {{"mpm.contact='none'"}}});
  if (deck.real("fluid.mu") != 0) choices.push_back({"viscosity of the gas", {{"fluid.mu=0"}}});
  const Body* gas = find_body<IdealGas>(scene);
  if (gas != nullptr && has_artificial_viscosity(std::get<IdealGas>(gas->material)))
    choices.push_back({"artificial viscosity", {{"mpm.viscosity='deck'", "fluid.lambda=0"}}});
  if (scene.ambient != 0) choices.push_back({"pressure outside", {{"fluid.pambient=0"}}});
}

/// Laws of large strains in place of which the linear one stands.
void add_linear(const Deck& deck, std::vector<Choice>& choices) {
  Choice linear{"large strains", {}};
  for (int r = 1; r <= deck.integer("reg.nreg"); ++r) {
    const std::string law = deck.text("fem.law", r);
    if (law == "svk" || law == "neo-hookean")
      linear.without.overrides.push_back(fmt::format("fem.law({})='linear'", r));
  }
  if (!linear.without.overrides.empty()) choices.push_back(std::move(linear));
}

void add_box(const Deck& deck, const Scene& scene, std::vector<Choice>& choices) {
  if (deck.real("coupled.viscosity") != 0) choices.push_back({"viscosity of the fluid", {{"coupled.viscosity=0"}}});
  if (!scene.solids()) return;
  if (deck.text("coupled.mode") == "cut-cell" && deck.text("coupled.flow") == "grid")
    choices.push_back(
        {"solving fluid and bodies together (mode='splitting' in its place)", {{"coupled.mode='splitting'"}}});
  if (deck.logical("coupled.contact")) choices.push_back({"contact with walls", {{"coupled.contact=.false."}}});
  if (keeps_energy(*scene.coupled(), *scene.solids(), scene.clock.tstep))
    choices.push_back({"steps that keep the energy", {{"coupled.step='linear'"}}});
}

/// Another way to solve the same: elements of order 1 for those of order 2, cells of the grid for triangles, finite
/// elements for material points where the deck has a mesh, too; or for a fluid and the bodies in it the bodies alone.
void add_ways(const Deck& deck, const Scene& scene, const Refinement& refinement, std::vector<Choice>& choices) {
  const auto add = [&](const std::string& name, const std::string& override) {
    choices.push_back({name, {{override}}});
  };
  const std::string element = deck.text("mesh.element");
  if (scene.solids() && !scene.rigid() && element.ends_with('2'))
    add("elements of order 2 (order 1 in their place)", fmt::format("mesh.element='{}1'", element.front()));
  if (scene.flow() && deck.text("flow.element") == "q2q1")
    add("elements of order 2 of the fluid (order 1 in their place)", "flow.element='q1q1'");
  if (scene.coupled() && deck.text("coupled.flow") == "mesh")
    add("cells that fit bodies (those of the grid in their place)", "coupled.flow='grid'");
  if (!refinement.has_elements()) return;
  const LeftOut by_elements{{"in.path='fem'"}, Way::elements};
  if (scene.path() == Path::mpm) choices.push_back({"material points (finite elements in their place)", by_elements});
  if (scene.coupled() && scene.solids())
    choices.push_back({"the fluid (the bodies alone, by finite elements, in its place)", by_elements});
}

}  // namespace

std::vector<Choice> choices_of(const Deck& deck, const Scene& scene, const Refinement& refinement) {
  std::vector<Choice> choices;
  add_ways(deck, scene, refinement, choices);
  if (scene.path() == Path::mpm) add_points(deck, scene, choices);
  if (scene.coupled()) add_box(deck, scene, choices);
  if (std::holds_alternative<ElasticBodies>(scene.physics)) {
    choices.push_back({"deformation (one rigid body in its place)", {{"rigid.form='reduced'"}}});
    add_linear(deck, choices);
  }
  return choices;
}

Decision decided(const Choice& choice, const Trial& with, const Trial& without, double tolerance) {
  Decision decision{.choice = choice, .left_out = false, .change = no_number, .why = ""};
  if (with.value && without.value) decision.change = (*without.value - *with.value) / std::abs(*with.value);
  if (!without.value)
    decision.why = without.why == NoValue::scene ? "the deck cannot do without it"
                   : without.why == NoValue::run ? "the run fails without it"
                                                 : "the run does not show the number without it";
  else if (!(std::abs(decision.change) < most_change(tolerance)))
    decision.why = "it counts";
  else if (without.seconds > (1 + timing_noise) * with.seconds + seconds_of_noise)
    decision.why = "the run costs more without it";
  decision.left_out = decision.why.empty();
  return decision;
}

std::string decisions_text(const std::vector<Decision>& decisions) {
  std::string text;
  for (const Decision& decision : decisions) {
    text += fmt::format("{}: {}", decision.left_out ? "left out" : "kept", decision.choice.name);
    if (std::isfinite(decision.change))
      text += fmt::format(", which changes the number by {:.2g} %", 100 * decision.change);
    text += decision.left_out ? fmt::format(", with {}\n", fmt::join(decision.choice.without.overrides, " "))
                              : fmt::format(": {}\n", decision.why);
  }
  return text;
}

}  // namespace tether::automatic
