// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/load.hpp"

#include <filesystem>

#include "base/file.hpp"
#include "deck/document.hpp"
#include "deck/reader.hpp"
#include "plan/make_plan.hpp"
#include "read/build.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/path.hpp"
#include "read/points/points_group.hpp"

namespace tether {

namespace {

std::vector<std::string> texts_of(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> texts;
  for (const auto& diagnostic : diagnostics) texts.push_back(to_text(diagnostic));
  return texts;
}

/// Says which command runs a deck of many runs.
std::string command_for(const Deck& study) {
  const std::string mode = study.text("study.mode");
  return mode == "chart" || mode == "map" ? "tether " + mode + " runs it"
                                          : "tether sweep runs it; with --dry-run it lists the runs";
}

}  // namespace

Deck load_deck(const std::string& file, const DeckOptions& options, Diagnostics& diagnostics) {
  return read_deck(read_file(file), file, options.overrides, diagnostics);
}

std::string effective_text(const Deck& deck, const std::optional<ParticleFile>& particles) {
  const Deck named = deck.mesh_text() ? deck.with_mesh_named(effective_mesh_file) : deck;
  return effective_deck(particles ? named.with_particle_data(particles->lines) : named);
}

Loaded load_scene(const Deck& given_deck, const DeckOptions& options, Diagnostics& diagnostics) {
  const Deck deck = load_mesh(options.path.empty() ? given_deck : given_deck.with_path(options.path), diagnostics);
  if (deck.is_study() && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark_on_group(Severity::error, study_group, "this is a study of many runs, none itself",
                                         command_for(deck)));
  }
  std::optional<std::filesystem::path> given;
  if (!options.particles.empty()) given = options.particles;
  if (!deck.complete()) {  // without a grid and a clock there is no scene to look at
    check_without_grid(deck_of_path(deck, path_of(deck, diagnostics), diagnostics), diagnostics);
    if (deck.has_group("in")) load_particles(deck, given, diagnostics);
    diagnostics.throw_if_errors();
  }
  const auto particles = load_particles(deck, given, diagnostics);
  const Path path = path_of(deck, diagnostics);
  Scene scene = build_scene(deck_of_path(deck, path, diagnostics), particles, path, diagnostics);
  diagnostics.throw_if_errors();
  return {deck, make_plan(std::move(scene)), effective_text(deck, particles), texts_of(diagnostics.warnings()),
          texts_of(diagnostics.remarks())};
}

Loaded load(const std::string& file, const DeckOptions& options) {
  Diagnostics diagnostics;
  const Deck deck = load_deck(file, options, diagnostics);
  return load_scene(deck, options, diagnostics);
}

}  // namespace tether
