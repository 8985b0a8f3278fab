// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/outputs.hpp"

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

}  // namespace

OutputIntervals outputs_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  OutputIntervals outputs;
  outputs.history = shortest(deck, {33, 34, 38}, diagnostics);
  outputs.points = shortest(deck, {13, 32, 35, 36, 40}, diagnostics);
  outputs.grid = shortest(deck, {30, 31, 37, 39}, diagnostics);
  if (outputs.history == 0) outputs.history = scene.clock.tmax / default_records;
  outputs.tracked_angle = deck.integer("in", "iout", 38) == 1 && scene.tracked.size() >= 2;
  return outputs;
}

}  // namespace tether
