// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/elastic_law.hpp"

#include <fmt/format.h>

namespace tether {
namespace {

/// A word of $reg, or where it has none and there is a mesh, of $fem.
std::string word_of_region(const Deck& deck, const char* name, int r) {
  if (deck.given("reg", name, r)) return deck.text("reg", name, r);
  return deck.has_group("mesh") || deck.has_group("fem") ? deck.text("fem", name, r) : "";
}

}  // namespace

std::string law_word(const Deck& deck, int r) { return word_of_region(deck, "law", r); }

ElasticConstants elastic_constants(const Deck& deck, int r, Plane plane) {
  const std::string volumetric = word_of_region(deck, "volumetric", r);
  return {.E = deck.real("reg", "matr", 1, r),
          .nu = deck.real("reg", "matr", 2, r),
          .plane = plane,
          .volumetric = find_word<Volumetric>(volumetric).value_or(Volumetric::log),
          .centre_x = deck.real("fem", "fibre_x", r),
          .centre_y = deck.real("fem", "fibre_y", r)};
}

void check_law_words(const Deck& deck, int r, Diagnostics& diagnostics) {
  for (const char* name : {"law", "volumetric"}) {
    if (!deck.given("reg", name, r) || !deck.given("fem", name, r)) continue;
    const std::string here = deck.text("reg", name, r), there = deck.text("fem", name, r);
    if (here == there) continue;
    diagnostics.add(
        deck.remark(Severity::error, "reg", name, {r, 1},
                    fmt::format("region {} has two of it: {} = '{}' here and '{}' in $fem", r, name, here, there),
                    "leave one of them away"));
  }
}

}  // namespace tether
