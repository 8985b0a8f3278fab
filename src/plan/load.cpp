// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/load.hpp"

#include <filesystem>

#include "base/file.hpp"
#include "deck/document.hpp"
#include "deck/reader.hpp"
#include "plan/make_plan.hpp"
#include "read/build.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/method.hpp"
#include "read/points/points_group.hpp"

namespace tether {

namespace {

std::vector<std::string> texts_of(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> texts;
  for (const auto& diagnostic : diagnostics) texts.push_back(to_text(diagnostic));
  return texts;
}

}  // namespace

Deck load_deck(const std::string& file, const DeckOptions& options, Diagnostics& diagnostics) {
  return read_deck(read_file(file), file, options.overrides, diagnostics);
}

std::string effective_text(const Deck& deck, const std::optional<ParticleFile>& particles, Path path) {
  const std::vector<std::string> also =
      path == Path::fem ? std::vector<std::string>{"fem"} : std::vector<std::string>{};
  const Deck named = deck.mesh_text() ? deck.with_mesh_named(effective_mesh_file) : deck;
  return effective_deck(particles ? named.with_particle_data(particles->lines) : named, also);
}

Loaded load_scene(const Deck& given_deck, const DeckOptions& options, Diagnostics& diagnostics) {
  const Deck deck = load_mesh(given_deck, diagnostics);
  if (deck.is_study() && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark_on_group(Severity::error, study_group, "this is a study of many runs, none itself",
                                         "tether sweep runs it; with --dry-run it lists the runs"));
  }
  std::optional<std::filesystem::path> given;
  if (!options.particles.empty()) given = options.particles;
  if (!deck.complete()) {  // without a grid and a clock there is no scene to look at
    check_without_grid(deck, diagnostics);
    if (deck.has_group("in")) load_particles(deck, given, diagnostics);
    diagnostics.throw_if_errors();
  }
  const auto particles = load_particles(deck, given, diagnostics);
  const Path path = path_of(deck, options.path, diagnostics);
  Scene scene = build_scene(deck, particles, path, diagnostics);
  diagnostics.throw_if_errors();
  return {deck, make_plan(std::move(scene)), effective_text(deck, particles, path), texts_of(diagnostics.warnings()),
          texts_of(diagnostics.remarks())};
}

Loaded load(const std::string& file, const DeckOptions& options) {
  Diagnostics diagnostics;
  const Deck deck = load_deck(file, options, diagnostics);
  return load_scene(deck, options, diagnostics);
}

}  // namespace tether
