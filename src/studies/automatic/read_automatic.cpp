// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "deck/document.hpp"
#include "read/points/points_group.hpp"
#include "studies/automatic/automatic.hpp"
#include "studies/combinations.hpp"
#include "studies/reading_checks.hpp"
#include "studies/study_checks.hpp"

namespace tether::automatic {
namespace {

/// A search begins with cells, or steps, that are this part as many as the deck's.
constexpr double coarsest_part = 0.25;

/// A plan may estimate a small run so many times too costly.
constexpr double estimate_over_cost = 5;

std::string quoted(const std::string& text) {
  std::string quotes = "'";
  for (const char c : text) quotes += c == '\'' ? "''" : std::string(1, c);
  return quotes + "'";
}

/// The way of a body or a point: the size of the box that it stays in.
std::string way_of(const std::string& what) {
  return fmt::format("max({0}_x_1) - min({0}_x_1) + max({0}_y_1) - min({0}_y_1)", what);
}

/// A scene's own figure of merit: the first number that its deck publishes of the history; else the way of its first
/// tracked point, what its first probe shows at the end, the way of its first body, or its largest kinetic energy.
/// Empty where its runs write none of them.
std::string figure_of_merit(const Deck& deck, const Written& written) {
  const auto has = [&](const char* column) {
    return std::ranges::find(written.columns, column) != written.columns.end();
  };
  if (deck.text("published.compared_with").empty()) {
    for (const auto& at : deck.given_elements("published.is")) {
      const std::string number = deck.text("published.is", at[0]);
      if (!published::read_reading(number).columns.empty()) return number;
    }
  }
  if (has("point_x_1")) return way_of("point");
  if (has("probe_vx_1")) return "last(probe_vx_1)";
  if (has("body_x_1")) return way_of("body");
  return has("energy_kinetic") ? "max(energy_kinetic)" : "";
}

/// The deck with its own figure of merit where it does not say what is wanted.
Deck with_quantity(const Loaded& loaded, const Written& written, const DeckOptions& options, Diagnostics& diagnostics) {
  const Deck& deck = loaded.deck;
  const bool given = deck.given("auto.quantity");
  if (given && !deck.text("auto.quantity").empty()) return deck;
  const std::string figure = given ? "" : figure_of_merit(deck, written);
  if (figure.empty()) {
    diagnostics.add(deck.remark(Severity::error, "auto.quantity", {1, 1},
                                "there is no figure of merit: nothing that --auto could be true to",
                                "$auto quantity='KEY OR EXPRESSION' $ names one, 'max(point_y_1)' for example"));
    return deck;
  }
  DeckOptions more = options;
  more.overrides.push_back("auto.quantity=" + quoted(figure));
  Diagnostics remarked;  // when the deck was read first
  return load_deck(deck.file(), more, remarked);
}

Study study_of_deck(const Deck& deck) {
  Study study;
  study.file = deck.file();
  study.text = effective_deck(deck);
  study.title = fmt::format("the cheapest setting of {}", deck.file());
  study.decks = {{1, deck.file(), study.text}};
  return study;
}

Aim aim_of(const Deck& deck, const Scene& scene, const Refinement& refinement, double tolerance) {
  return {.tolerance = tolerance,
          .theory = theory_of(deck, scene, refinement, Way::own),
          .coarsest = {refinement.in_space() ? coarsest_part : 1, refinement.in_time() ? coarsest_part : 1},
          .powers = {static_cast<double>(refinement.dimensions()), 1},
          .nested = refinement.is_of_a_grid(),
          .budget = deck.real("auto.budget")};
}

void refuse_what_stays(const Deck& deck, const Scene& scene, const Refinement& refinement, Diagnostics& diagnostics) {
  const auto refuse = [&](AnyVariable name, const std::string& what, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, name, {1, 1}, what, hint));
  };
  if (!deck.text("mesh.file").empty())
    refuse("mesh.file", "--auto cannot make the mesh of a file finer", "cells of $mesh count cells that it can");
  Diagnostics reported;  // when the scene was built
  if (scene.points.size() > 0 && load_particles(deck, std::nullopt, reported))
    refuse("in.particles", "--auto cannot make the points of a file more",
           "regions of $reg and curves of $membrane have points that it can");
  if (!refinement.in_space() && !refinement.in_time())
    refuse("in.tstep", "the deck has neither cells nor steps that could be made finer", "");
}

/// What a run of that resolution takes, by its plan [s]; 0 where its scene cannot be built.
double expected_seconds(const Automatic& automatic, const Resolution& at) {
  double seconds = 0;
  end_of(automatic.study.file, [&] {
    Diagnostics of_the_run;
    const Study study = study_of_run(automatic, automatic.refinement.overrides(at, Way::own));
    seconds = load_scene(read_deck(study, {0, {}}), {}, of_the_run).plan.cost.seconds;
  });
  return seconds;
}

/// The least that a search makes: three levels.
void refuse_small_budget(const Deck& deck, const Automatic& automatic, Diagnostics& diagnostics) {
  double seconds = 0;
  const Aim& aim = automatic.aim;
  Resolution at = aim.coarsest;
  for (int level = 0; level < 3; ++level) {
    seconds += expected_seconds(automatic, at);
    at = {aim.theory.space ? 2 * at.space : 1, aim.theory.time ? 2 * at.time : 1};
  }
  if (seconds <= estimate_over_cost * aim.budget) return;
  diagnostics.add(
      deck.remark(Severity::error, "auto.budget", {1, 1},
                  fmt::format("the budget of {:.3g} s is too small: the first three levels alone take about {:.2g} s",
                              aim.budget, seconds),
                  fmt::format("budget={:.2g} and more for what the tolerance asks for", 2 * seconds)));
}

}  // namespace

Study study_of_run(const Automatic& automatic, const std::vector<std::string>& overrides) {
  Study study = automatic.study;
  study.sets.insert(study.sets.end(), overrides.begin(), overrides.end());
  return study;
}

Automatic read_automatic(const std::string& file, const DeckOptions& options, double tolerance) {
  if (!(tolerance > 0) || !(tolerance < 1))
    throw InputError(fmt::format("--auto takes a relative tolerance above 0 and below 1, not {}", tolerance),
                     "--auto 0.01 is one per cent");
  DeckOptions asked = options;
  if (!options.path.empty()) asked.overrides.push_back("in.path=" + quoted(options.path));
  asked.path.clear();
  Diagnostics diagnostics;
  const Loaded loaded = load_scene(load_deck(file, asked, diagnostics), {}, diagnostics);
  const Scene& scene = loaded.plan.scene;
  const Written written = written_by(loaded);
  const Deck deck = with_quantity(loaded, written, asked, diagnostics);
  Automatic automatic{.study = study_of_deck(deck),
                      .quantity = deck.text("auto.quantity"),
                      .value = {},
                      .refinement = Refinement(deck, scene),
                      .choices = {},
                      .aim = {},
                      .by_elements = {}};
  const Refinement& refinement = automatic.refinement;
  if (deck.logical("auto.simplify")) automatic.choices = choices_of(deck, scene, refinement);
  automatic.aim = aim_of(deck, scene, refinement, tolerance);
  automatic.by_elements = theory_of(deck, scene, refinement, Way::elements);
  refuse_what_stays(deck, scene, refinement, diagnostics);
  StudyRemarks remarks(deck, diagnostics);
  if (!automatic.quantity.empty()) automatic.value = checked_reading(deck, "auto.quantity", written, remarks);
  if (!diagnostics.has_errors()) refuse_small_budget(deck, automatic, diagnostics);
  diagnostics.throw_if_errors();
  return automatic;
}

}  // namespace tether::automatic
