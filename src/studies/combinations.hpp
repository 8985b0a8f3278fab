// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/border_search.hpp"
#include "studies/runs/run_record.hpp"
#include "studies/study.hpp"

namespace tether {

/// One of the base decks with one value of each axis.
struct Combination {
  std::size_t deck = 0;
  std::vector<std::size_t> values;  ///< for each axis the number of its value
};

/// One run of a study: a combination, the how-manieth of its runs it is, and, in an ensemble or a bisection, the value
/// that is varied.
struct Variant {
  std::size_t combination = 0;
  std::size_t number = 0;
  std::optional<double> varied;
};

/// Number of combinations; linked axes count once.
double count_combinations(const Study& study);

/// All of them in the table's order: axis 1 fastest, as in a Fortran array, decks slowest.
std::vector<Combination> combinations(const Study& study);

/// A value of one leading axis, with all other axes at their first values, or at their last ones; linked axes move
/// along.
Combination on_edge(const Study& study, std::size_t deck, std::size_t axis, std::size_t value, bool others_last);

/// The --set of a combination's run: those that all share, those of the axes, and the varied value's.
std::vector<std::string> overrides_of(const Study& study, const Combination& combination, std::optional<double> varied);

/// The deck of a run as the reader gives it; its remarks are left to those who run it.
Deck read_deck(const Study& study, const Combination& combination, std::optional<double> varied = {});

/// The factors of an ensemble, evenly from 1 - fraction to 1 + fraction, both included.
std::vector<double> ensemble_factors(double fraction, int runs);

/// A run of a study that has come to an end, well or not.
struct FinishedRun {
  Variant variant;
  RunRecord record;
  bool reused = false;                   ///< it had been run before
  std::map<std::string, double> values;  ///< of its summary.txt, and the study's of history.txt; none where it failed
  std::map<std::string, std::string> lacking = {};  ///< columns that its history.txt has not; what may have been meant

  bool failed() const { return record.ending.exit_code != exit_done; }
  /// Returns whether it came to its end or diverged. A full disk, a kill or a scene that cannot be built say nothing of
  /// a criterion.
  bool decides() const { return !failed() || record.ending.exit_code == exit_run; }
  /// Returns whether it meets the criterion. None where it says nothing of it: it ended well and has no such number, or
  /// in a way that is no fault of the scene.
  std::optional<bool> meets(const Criterion& criterion) const {
    const double found = value(criterion.key);
    if (!decides() || (!failed() && std::isnan(found))) return std::nullopt;
    return criterion.holds(found);
  }
  /// One of them, or exit_code; not a number where the run has none of that name.
  double value(const std::string& key) const {
    if (key == exit_code_key) return record.ending.exit_code;
    const auto found = values.find(key);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
};

/// Which runs a study wants, by its mode: a run of each combination (grid), several of each (ensemble), one after
/// the other of each (bisect, or map), or those along the border between combinations (map). Knows nothing of how they
/// are run.
class Sequences {
 public:
  explicit Sequences(const Study& study);

  /// Those that can be run at once.
  std::vector<Variant> first();
  /// Those that are wanted now that this run has ended.
  std::vector<Variant> after(const FinishedRun& run);

  /// One a combination, where the study bisects.
  const std::vector<Bisection>& bisections() const { return bisections_; }
  /// Returns, for each combination of a map that is followed along its border, the one whose run decides it.
  std::vector<std::optional<std::size_t>> deciding() const;

 private:
  void add(std::vector<Variant>& wanted, std::size_t combination, std::optional<double> varied);
  std::vector<Variant> next(std::size_t combination);
  std::vector<Variant> along_borders();

  const Study& study_;
  std::vector<std::size_t> numbers_;  // runs wanted so far, a combination
  std::vector<Bisection> bisections_;
  std::vector<BorderSearch> searches_;  // one a deck
};

}  // namespace tether
