// SPDX-License-Identifier: GPL-3.0-or-later
#include "load.hpp"

#include <filesystem>
#include <optional>

#include "base/file.hpp"
#include "deck/document.hpp"
#include "deck/reader.hpp"
#include "scene/build.hpp"
#include "scene/load_particles.hpp"

namespace tether {
namespace {

std::vector<std::string> texts(const std::vector<Diagnostic>& diagnostics) {
  std::vector<std::string> lines;
  for (const auto& diagnostic : diagnostics) lines.push_back(to_text(diagnostic));
  return lines;
}

/// The deck alone; throws with every mistake in it.
Deck load_deck(const std::string& file, const DeckOptions& options, std::vector<std::string>& warnings) {
  Diagnostics diagnostics;
  Deck deck = read_deck(read_file(file), file, options.overrides, diagnostics);
  for (auto& warning : texts(diagnostics.warnings())) warnings.push_back(std::move(warning));
  diagnostics.throw_if_errors();
  return deck;
}

}  // namespace

Loaded load(const std::string& file, const DeckOptions& options) {
  std::vector<std::string> warnings;
  const Deck deck = load_deck(file, options, warnings);
  Diagnostics diagnostics;
  std::optional<std::filesystem::path> given;
  if (!options.particles.empty()) given = options.particles;
  const auto particles = load_particles(deck, given, diagnostics);
  Scene scene = build_scene(deck, particles, diagnostics);
  for (auto& warning : texts(diagnostics.warnings())) warnings.push_back(std::move(warning));
  diagnostics.throw_if_errors();
  const std::string effective = effective_deck(particles ? deck.with_particle_data(particles->lines) : deck);
  return {deck, make_plan(std::move(scene)), effective, std::move(warnings)};
}

}  // namespace tether
