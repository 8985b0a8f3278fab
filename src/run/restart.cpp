// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <system_error>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "deck/elements.hpp"
#include "deck/reader.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

constexpr std::array<std::string_view, 3> may_differ{"tmax", "iout", "tiout"};  // of $in

/// The switch that adds a column to the history.
constexpr int angle_switch = 38;

bool must_agree(const Variable& variable, Subscript at) {
  const bool free = std::find(may_differ.begin(), may_differ.end(), variable.name) != may_differ.end();
  const bool columns = variable.name == "iout" && at[0] == angle_switch;
  return variable.effect == Effect::used && variable.group != "limits" && (variable.group != "in" || !free || columns);
}

std::string text_of(const Deck& deck, const Variable& variable, Subscript at) {
  const bool any = deck.given(AnyVariable(variable), at[0], at[1]) || !variable.fallback.empty();
  return any ? value_text(deck.value(AnyVariable(variable), at[0], at[1])) : "not given";
}

/// Loads of statics without a table grow until tmax: another one would change what they were.
bool ends_a_ramp(const Deck& now, const Variable& variable) {
  return variable.group == "in" && variable.name == "tmax" && now.logical("fem.static");
}

/// Adds an error for each element of a variable that is not the same in both decks.
void compare(const Deck& before, const Deck& now, const Variable& variable, Diagnostics& diagnostics) {
  std::set<Subscript> elements;
  for (const Deck* deck : {&before, &now}) {
    for (const Subscript at : deck->given_elements(AnyVariable(variable))) elements.insert(at);
  }
  for (const Subscript at : elements) {
    const auto then = text_of(before, variable, at), here = text_of(now, variable, at);
    if (then == here || !(must_agree(variable, at) || ends_a_ramp(now, variable))) continue;
    diagnostics.error({}, "",
                      fmt::format("{}.{} was {} in the run of the checkpoint and is {} in the deck", variable.group,
                                  element_name(variable, at), then, here));
  }
}

void check_same_run(const std::string& checkpoint_deck, const std::string& deck) {
  Diagnostics ignored, differences;
  const Deck before = read_deck(checkpoint_deck, "checkpoint", {}, ignored), now = read_deck(deck, "deck", {}, ignored);
  for (const Variable& variable : variables()) compare(before, now, variable, differences);
  if (before.trailer().text != now.trailer().text) {
    differences.error({}, "", "the particle data are not those of the checkpoint's run");
  }
  if (differences.has_errors()) {
    differences.error({}, "", "a restart goes on with the same deck",
                      "only in.tmax, in.iout but 38, and in.tiout may differ");
  }
  differences.throw_if_errors();
}

/// There must be something left to do, or at least nothing to undo.
void check_end(const Checkpoint& checkpoint, const std::string& deck_effective) {
  Diagnostics ignored;
  const Deck deck = read_deck(deck_effective, "deck", {}, ignored);
  if (!deck.given("in.tmax") || checkpoint.time <= deck.real("in.tmax")) return;
  throw InputError(
      fmt::format("the checkpoint is of t = {:.6g}, after tmax = {:.6g}", checkpoint.time, deck.real("in.tmax")),
      "give the run's own tmax, or a later one");
}

/// The newest whole checkpoint of this deck beside a damaged one; "" where there is none.
std::string offer_beside(const std::filesystem::path& damaged, const std::string& deck_effective) {
  const bool is_folder = std::filesystem::is_directory(damaged);
  const auto parent = is_folder ? damaged : damaged.parent_path();
  for (const auto& path : checkpoints_in(parent.empty() ? "." : parent)) {
    try {
      const Checkpoint checkpoint = read_checkpoint(path);
      check_same_run(checkpoint.deck_effective, deck_effective);
      return fmt::format("; {} is whole, of t = {:.6g}: --restart {}", path.filename().string(), checkpoint.time,
                         (parent / path.filename()).string());
    } catch (const FileError&) {
      continue;
    } catch (const InputError&) {
      continue;
    }
  }
  return "";
}

Checkpoint read_or_offer(const std::filesystem::path& path, const std::string& deck_effective) {
  try {
    if (std::filesystem::is_directory(path)) throw FileError(fmt::format("{}: is a folder", path.string()));
    return read_checkpoint(path);
  } catch (const FileError& error) {
    throw FileError(error.what() + offer_beside(path, deck_effective));
  }
}

bool there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// Returns whether it is whole, and no run of this deck goes on from it.
bool is_foreign(const std::filesystem::path& checkpoint, const std::string& deck_effective) {
  try {
    check_same_run(read_checkpoint(checkpoint).deck_effective, deck_effective);
    return false;
  } catch (const FileError&) {
    return false;
  } catch (const InputError&) {
    return true;
  }
}

}  // namespace

EarlierRun earlier_run(const std::filesystem::path& folder, const std::string& deck_effective) {
  EarlierRun earlier;
  for (const auto& checkpoint : checkpoints_in(folder)) {
    if (is_foreign(checkpoint, deck_effective)) earlier.foreign_checkpoints.push_back(checkpoint);
  }
  const auto deck = folder / "deck.effective";
  if (there(deck) || there(folder / "summary.txt")) {
    const bool same = there(deck) && read_file(deck) == deck_effective;
    earlier.text = fmt::format("the results of an earlier run in {} are replaced: a run of {}, which {} to its end",
                               folder.string(), same ? "this deck" : "another deck, or with other values",
                               there(folder / "summary.txt") ? "came" : "did not come");
  }
  if (!earlier.foreign_checkpoints.empty()) {
    earlier.text += fmt::format("{}checkpoints of another deck are removed from {}:", earlier.text.empty() ? "" : "; ",
                                folder.string());
    for (const auto& checkpoint : earlier.foreign_checkpoints) earlier.text += " " + checkpoint.filename().string();
  }
  return earlier;
}

Checkpoint checkpoint_for(const std::filesystem::path& path, const std::string& deck_effective) {
  Checkpoint checkpoint = read_or_offer(path, deck_effective);
  check_same_run(checkpoint.deck_effective, deck_effective);
  check_end(checkpoint, deck_effective);
  return checkpoint;
}

}  // namespace tether
