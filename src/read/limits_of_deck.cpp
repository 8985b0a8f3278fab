// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/limits_of_deck.hpp"

#include <fmt/format.h>

namespace tether {
namespace {

/// Beyond what the decks here reach where they are right, and before what they were found to reach where they are not.
constexpr Limits default_limits{.quality = {0.1, 0.001},
                                .volume = {0.5, 0.05},
                                .energy_step = {0.5, 100},
                                .energy_growth = {0.05, 100},
                                .splitting = {1, 100},
                                .cfl = {4, 0}};

/// Reads one limit; `low` says that smaller numbers are worse.
Limit limit_of(const Deck& deck, const char* name, Limit limit, bool low, Diagnostics& diagnostics) {
  if (deck.given("limits", name, 1)) limit.warn = deck.real("limits", name, 1);
  if (deck.given("limits", name, 2)) limit.stop = deck.real("limits", name, 2);
  const bool wrong = limit.warn != 0 && limit.stop != 0 && (low ? limit.stop > limit.warn : limit.stop < limit.warn);
  if (wrong)
    diagnostics.add(
        deck.remark(Severity::error, "limits", name, {deck.given("limits", name, 2) ? 2 : 1, 1},
                    fmt::format("{}: the run stops at {:.6g}, before it warns at {:.6g}", name, limit.stop, limit.warn),
                    "the first number warns, the second stops; 0 switches off"));
  return limit;
}

}  // namespace

Limits limits_of(const Deck& deck, Diagnostics& diagnostics) {
  Limits limits = default_limits;
  const auto read = [&](const char* name, Limit& limit, bool low) {
    limit = limit_of(deck, name, limit, low, diagnostics);
  };
  read("quality", limits.quality, true);
  read("volume", limits.volume, true);
  read("energy_step", limits.energy_step, false);
  read("energy_growth", limits.energy_growth, false);
  read("splitting", limits.splitting, false);
  read("cfl", limits.cfl, false);
  return limits;
}

}  // namespace tether
