// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/outputs.hpp"

#include <fmt/format.h>

#include <initializer_list>

namespace tether {
namespace {

/// Records of a history whose interval the deck does not give.
constexpr double default_records = 200;

/// The shortest interval of the switches that are on; 0 where none is.
double shortest(const Deck& deck, std::initializer_list<int> switches, Diagnostics& diagnostics) {
  double interval = 0;
  for (const int k : switches) {
    if (deck.integer("in", "iout", k) != 1) continue;
    if (!deck.given("in", "tiout", k)) {
      diagnostics.add(deck.remark(Severity::error, "in", "iout", {k, 1},
                                  fmt::format("iout({})=1 needs its interval tiout({})", k, k), "give it, or write 0"));
      continue;
    }
    const double given = deck.real("in", "tiout", k);
    if (interval == 0 || given < interval) interval = given;
  }
  return interval;
}

/// Switches that are on but write nothing: numbers without a meaning.
void warn_of_idle_switches(const Deck& deck, Diagnostics& diagnostics) {
  for (const Subscript at : deck.given_elements("in", "iout")) {
    const int k = at[0];
    const bool writes = k == 13 || (k >= 30 && k <= 41);
    if (writes || deck.integer("in", "iout", k) != 1) continue;
    diagnostics.add(deck.remark(Severity::warning, "in", "iout", at, fmt::format("iout({})=1 writes nothing", k),
                                "13 and 30 to 41 have a meaning"));
  }
}

}  // namespace

OutputIntervals outputs_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  OutputIntervals outputs;
  warn_of_idle_switches(deck, diagnostics);
  outputs.history = shortest(deck, {33, 34, 38}, diagnostics);
  outputs.points = shortest(deck, {13, 32, 35, 36, 40}, diagnostics);
  outputs.grid = shortest(deck, {30, 31, 37, 39}, diagnostics);
  outputs.checkpoint = shortest(deck, {41}, diagnostics);
  if (outputs.history == 0) outputs.history = scene.clock.tmax / default_records;
  outputs.tracked_angle = deck.integer("in", "iout", 38) == 1 && scene.tracked.size() >= 2;
  return outputs;
}

}  // namespace tether
