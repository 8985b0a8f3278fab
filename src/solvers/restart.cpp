// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/diagnostics.hpp"
#include "deck/elements.hpp"
#include "deck/reader.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

constexpr std::array<std::string_view, 3> may_differ{"tmax", "iout", "tiout"};  // of $in

bool must_agree(const Variable& variable) {
  const bool free = std::find(may_differ.begin(), may_differ.end(), variable.name) != may_differ.end();
  return variable.effect == Effect::used && !(variable.group == "in" && free);
}

std::string text_of(const Deck& deck, const Variable& variable, Subscript at) {
  if (!deck.given(variable.group, variable.name, at[0], at[1])) return "not given";
  return value_text(deck.value(variable.group, variable.name, at[0], at[1]));
}

/// Adds an error for each element of a variable that is not the same in both decks.
void compare(const Deck& before, const Deck& now, const Variable& variable, Diagnostics& diagnostics) {
  std::set<Subscript> elements;
  for (const Deck* deck : {&before, &now}) {
    for (const Subscript at : deck->given_elements(variable.group, variable.name)) elements.insert(at);
  }
  for (const Subscript at : elements) {
    const auto then = text_of(before, variable, at), here = text_of(now, variable, at);
    if (then == here) continue;
    diagnostics.error({}, "",
                      fmt::format("{}.{} was {} in the run of the checkpoint and is {} in the deck", variable.group,
                                  element_name(variable, at), then, here));
  }
}

void check_same_run(const std::string& checkpoint_deck, const std::string& deck) {
  Diagnostics ignored, differences;
  const Deck before = read_deck(checkpoint_deck, "checkpoint", {}, ignored), now = read_deck(deck, "deck", {}, ignored);
  for (const Variable& variable : variables()) {
    if (must_agree(variable)) compare(before, now, variable, differences);
  }
  if (before.trailer().text != now.trailer().text) {
    differences.error({}, "", "the particle data are not those of the checkpoint's run");
  }
  if (differences.has_errors()) {
    differences.error({}, "", "a restart goes on with the same deck", "only in.tmax, in.iout and in.tiout may differ");
  }
  differences.throw_if_errors();
}

/// There must be something left to do, or at least nothing to undo.
void check_end(const Checkpoint& checkpoint, const std::string& deck_effective) {
  Diagnostics ignored;
  const Deck deck = read_deck(deck_effective, "deck", {}, ignored);
  if (!deck.given("in", "tmax") || checkpoint.time <= deck.real("in", "tmax")) return;
  throw InputError(
      fmt::format("the checkpoint is of t = {:.6g}, behind tmax = {:.6g}", checkpoint.time, deck.real("in", "tmax")),
      "give the run's own tmax, or a later one");
}

}  // namespace

Checkpoint checkpoint_for(const std::filesystem::path& path, const std::string& deck_effective) {
  Checkpoint checkpoint = read_checkpoint_or_offer(path);
  check_same_run(checkpoint.deck_effective, deck_effective);
  check_end(checkpoint, deck_effective);
  return checkpoint;
}

}  // namespace tether
