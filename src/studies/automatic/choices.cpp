// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/choices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "model/coupled.hpp"
#include "model/find_strip.hpp"
#include "model/solids.hpp"

namespace tether::automatic {
namespace {

/// A run without a part may cost so much more and still count as no dearer: small runs are not timed better.
constexpr double timing_noise = 0.1;

/// By the robust method its coefficients are its own, else they are the deck's.
bool has_artificial_viscosity(const Deck& deck) {
  const bool robust = deck.text("mpm.method") == "robust";
  const bool local = deck.given("mpm.viscosity") ? deck.text("mpm.viscosity") == "local" : robust;
  const bool linear_or_quadratic = deck.real("fluid.coef1") != 0 || deck.real("fluid.coef2") != 0;
  return local || (deck.real("fluid.lambda") != 0 && linear_or_quadratic);
}

void add_points(const Deck& deck, const Scene& scene, std::vector<Choice>& choices) {
  if (!scene.strip && std::holds_alternative<Strip>(find_strip(scene)))
    choices.push_back({"rows of points that are alike (one row in their place)", {"mpm.reduce=.true."}});
  if (scene.method.contact != ContactRule::none && has_solid(scene))
    choices.push_back({"contact between bodies", {"mpm.contact='none'"}});
  if (deck.real("fluid.mu") != 0) choices.push_back({"viscosity of the gas", {"fluid.mu=0"}});
  const bool has_gas = find_body<IdealGas>(scene) != nullptr;
  if (has_gas && has_artificial_viscosity(deck))
    choices.push_back({"artificial viscosity", {"mpm.viscosity='deck'", "fluid.lambda=0"}});
  if (scene.ambient != 0) choices.push_back({"pressure outside", {"fluid.pambient=0"}});
}

/// Laws of large strains in place of which the linear one stands.
void add_linear(const Deck& deck, std::vector<Choice>& choices) {
  Choice linear{"large strains", {}};
  for (int r = 1; r <= deck.integer("reg.nreg"); ++r) {
    const std::string law = deck.text("fem.law", r);
    if (law == "svk" || law == "neo-hookean") linear.overrides.push_back(fmt::format("fem.law({})='linear'", r));
  }
  if (!linear.overrides.empty()) choices.push_back(std::move(linear));
}

void add_box(const Deck& deck, const Scene& scene, std::vector<Choice>& choices) {
  if (deck.real("coupled.viscosity") != 0) choices.push_back({"viscosity of the fluid", {"coupled.viscosity=0"}});
  if (!scene.solids()) return;
  if (deck.text("coupled.mode") == "cut-cell" && deck.text("coupled.flow") == "grid")
    choices.push_back(
        {"solving fluid and bodies together (mode='splitting' in its place)", {"coupled.mode='splitting'"}});
  if (deck.logical("coupled.contact")) choices.push_back({"contact with walls", {"coupled.contact=.false."}});
  if (keeps_energy(*scene.coupled(), *scene.solids(), scene.clock.tstep))
    choices.push_back({"steps that keep the energy", {"coupled.step='linear'"}});
}

}  // namespace

std::vector<Choice> choices_of(const Deck& deck, const Scene& scene) {
  std::vector<Choice> choices;
  if (scene.path() == Path::mpm) add_points(deck, scene, choices);
  if (scene.coupled()) add_box(deck, scene, choices);
  if (std::holds_alternative<ElasticBodies>(scene.physics)) {
    choices.push_back({"deformation (one rigid body in its place)", {"rigid.form='reduced'"}});
    add_linear(deck, choices);
  }
  return choices;
}

void decide(Decision& decision, double with, double without, double seconds_with, double seconds_without,
            double tolerance) {
  decision.change = (without - with) / std::abs(with);
  decision.saved = 1 - seconds_without / seconds_with;
  if (!std::isfinite(decision.change))
    decision.why = "its run fails";
  else if (!(std::abs(decision.change) < share_of_model * tolerance))
    decision.why = "it counts";
  else if (decision.saved < -timing_noise)
    decision.why = "the run costs more without it";
  decision.left_out = decision.why.empty();
}

std::string decisions_text(const std::vector<Decision>& decisions) {
  std::string text;
  for (const Decision& decision : decisions) {
    text += fmt::format("{}: {}", decision.left_out ? "left out" : "kept", decision.choice.name);
    if (std::isfinite(decision.change))
      text += fmt::format(", which changes the number by {:.2g} %", 100 * decision.change);
    text += decision.left_out ? fmt::format(", with {}\n", fmt::join(decision.choice.overrides, " "))
                              : fmt::format(": {}\n", decision.why);
  }
  return text;
}

}  // namespace tether::automatic
