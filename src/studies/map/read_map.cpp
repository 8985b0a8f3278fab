// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/map/read_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "studies/read_study.hpp"
#include "studies/reading_checks.hpp"
#include "studies/study_checks.hpp"

namespace tether::map {
namespace {

/// What a map wants of its study; every mistake becomes a remark at its place.
class MapReader {
 public:
  MapReader(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), remarks_(deck, diagnostics) {}

  Map read() {
    map_.study = study_of(deck_, diagnostics_);
    if (map_.study.mode != Mode::map) {
      remarks_.error("study.mode", 1, "this study is no map", "mode='map' makes it one; tether sweep runs others");
      return std::move(map_);
    }
    check_axes();
    check_interval();
    if (!diagnostics_.has_errors()) check_scenes();
    if (diagnostics_.has_errors() && written_.columns.empty()) return std::move(map_);  // names cannot be judged
    if (deck_.given("study.theory")) map_.theory = checked_reading(deck_, "study.theory", written_, remarks_);
    return std::move(map_);
  }

 private:
  void check_axes() {
    const auto given = deck_.given_elements("study.axis");
    const auto leading = leading_axes(map_.study);
    if (leading.size() > 2)
      return remarks_.error("study.axis", given.back()[0],
                            fmt::format("a map has one or two axes, this one {}", leading.size()),
                            "linked(3)=1 lets axis 3 move along with axis 1");
    const bool bare = given.empty() && !deck_.given("study.vary");
    if (bare) remarks_.error("study.mode", 1, "a map without vary needs an axis", "axis(1)='in.tstep=.01,.02,.03'");
    if (given.empty() || map_.study.bisects() || diagnostics_.has_errors()) return;
    if (border_axes(map_.study).empty())
      remarks_.error("study.axis", given.front()[0], "no axis has several numbers, between which a border could lie");
    for (const std::size_t a : leading) check_order(given[a][0], map_.study.axes[a]);
  }

  /// Neighbours on a map are neighbours in value.
  void check_order(int number, const StudyAxis& axis) {
    for (std::size_t k = 2; k < axis.cells.size(); ++k) {
      if (!std::holds_alternative<double>(axis.cells[k])) return;
      const double first = std::get<double>(axis.cells[k - 2]), second = std::get<double>(axis.cells[k - 1]);
      if ((second > first) != (std::get<double>(axis.cells[k]) > second))
        return remarks_.error(
            "study.axis", number,
            fmt::format("{} turns back after {}: values of a map's axis rise, or fall", axis.variable, second));
    }
  }

  void check_interval() {
    const bool varies = deck_.given("study.vary");
    for (const AnyVariable end : Variables{"study.low", "study.high"}) {
      if (varies && !deck_.given(end))
        remarks_.error("study.vary", 1, fmt::format("a map with vary needs {}", end.name()));
    }
    for (const AnyVariable name : Variables{"study.low", "study.high", "study.tolerance"}) {
      if (!varies && deck_.given(name)) remarks_.error(name, 1, fmt::format("{} is for a map with vary", name.name()));
    }
    if (varies && deck_.given("study.coarse")) remarks_.error("study.coarse", 1, "coarse is for a map without vary");
  }

  /// Each value of each axis in a scene of its own; an axis' mistakes are those of its first value that has some.
  void check_scenes() {
    const auto given = deck_.given_elements("study.axis");
    for (std::size_t d = 0; d < map_.study.decks.size(); ++d) {
      const Combination first{d, std::vector<std::size_t>(map_.study.axes.size(), 0)};
      check_scene(first, low_end(), "study.decks", map_.study.decks[d].number);
      if (map_.study.bisects()) check_scene(first, map_.study.interval.high, "study.high", 1);
      if (diagnostics_.has_errors()) return;
      for (const std::size_t a : leading_axes(map_.study)) {
        if (check_axis(d, a, given[a][0], false)) check_axis(d, a, given[a][0], true);
      }
    }
  }

  /// The other axis stands at its first value, or at its last one.
  bool check_axis(std::size_t deck, std::size_t axis, int number, bool at_the_end) {
    for (std::size_t v = 0; v < map_.study.axes[axis].cells.size(); ++v) {
      const Combination at = on_edge(map_.study, deck, axis, v, at_the_end);
      if (!check_scene(at, low_end(), "study.axis", number)) return false;
    }
    return true;
  }

  std::optional<double> low_end() const {
    return map_.study.bisects() ? std::optional(map_.study.interval.low) : std::nullopt;
  }

  bool check_scene(const Combination& at, std::optional<double> varied, AnyVariable name, int number) {
    const Ending ending = try_scene(map_.study.file, read_deck(map_.study, at, varied), &written_);
    if (ending.exit_code == exit_done) return true;
    remarks_.error(name, number, fmt::format("this cannot be run:\n{}", ending.message),
                   fmt::format("{}", fmt::join(overrides_of(map_.study, at, varied), " ")));
    return false;
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  StudyRemarks remarks_;
  Map map_;
  Written written_;  // by a run of each value of each axis
};

}  // namespace

Map read_map(const std::string& file) {
  Diagnostics diagnostics;
  const Deck deck = read_study_deck(file, diagnostics);
  Map map = MapReader(deck, diagnostics).read();
  diagnostics.throw_if_errors();
  return map;
}

}  // namespace tether::map
