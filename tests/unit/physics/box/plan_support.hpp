// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "deck/reader.hpp"
#include "plan/make_plan.hpp"
#include "read/build.hpp"

namespace tether::coupled {

/// The plan of a deck of the coupled path; throws InputError for its mistakes.
inline Plan plan_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Diagnostics diagnostics;
  const Deck deck = read_deck(text, "a.in", overrides, diagnostics);
  Scene scene = build_scene(deck, std::nullopt, Path::coupled, diagnostics);
  diagnostics.throw_if_errors();
  return make_plan(std::move(scene));
}

/// A name for what a test adds to its deck.
struct DeckVariant {
  const char* name;
  std::vector<std::string> overrides;
};
inline void PrintTo(const DeckVariant& variant, std::ostream* out) { *out << variant.name; }

}  // namespace tether::coupled
