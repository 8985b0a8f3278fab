// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "studies/assignment.hpp"
#include "studies/history_value.hpp"

namespace tether {

/// Where a bisection looks, and how close it goes: until the interval is as short as tolerance times the larger of
/// low and high in size.
struct Interval {
  double low = 0, high = 0, tolerance = 0;
};

constexpr const char* exit_code_key = "exit_code";

/// What of a run is looked at, and the bounds between which it holds.
struct Criterion {
  std::string key;  ///< exit_code_key, or a key of summary.txt
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();

  /// Not for what is not a number.
  bool holds(double value) const { return value >= at_least && value <= at_most; }
};

/// The largest value for which something holds, by halving an interval at whose lower end it holds and at whose upper
/// end it does not.
class Bisection {
 public:
  explicit Bisection(const Interval& interval) : interval_(interval) {}

  /// The values to look at next: at first both ends, then, when both were looked at, a middle; nothing at the end.
  std::vector<double> next() const;
  /// Takes what was seen at one of them.
  void take(double value, bool holds);

  /// "found"; "both ends hold", "both ends fail" or "fails at the lower end alone": then nothing was found; "not yet".
  std::string verdict() const;
  bool found() const { return verdict() == "found"; }
  /// Largest value at which it held, smallest at which it did not; not numbers where there was none.
  double holds() const { return holds_; }
  double fails() const { return fails_; }

 private:
  bool ends_differ() const { return low_holds_ == true && high_holds_ == false; }

  Interval interval_;
  std::optional<bool> low_holds_, high_holds_;
  double holds_ = std::numeric_limits<double>::quiet_NaN(), fails_ = holds_;
};

enum class Mode { grid, ensemble, bisect, chart, map };

template <>
inline constexpr std::array<Word<Mode>, 5> words<Mode>{{{Mode::grid, "grid"},
                                                        {Mode::ensemble, "ensemble"},
                                                        {Mode::bisect, "bisect"},
                                                        {Mode::chart, "chart"},
                                                        {Mode::map, "map"}}};

/// A deck value and the values that it takes in turn.
struct StudyAxis {
  std::string variable;                ///< the name of its column, "in.nx"
  std::vector<std::string> overrides;  ///< one a value: "in.nx=51"
  std::vector<Cell> cells;             ///< the values
  std::size_t leader = 0;              ///< the axis that it moves along with; itself where it moves alone
};

/// What an ensemble or a bisection varies.
struct Varied {
  std::string variable;  ///< the name of its column
  std::string group, name;
  Subscript at{1, 1};
};

/// A base deck: decks(number), its path and its text.
struct BaseDeck {
  int number = 1;
  std::string file, text;
};

/// A value of the runs' histories, and which text of $study wants it.
struct WantedValue {
  HistoryValue value;
  TextVariable variable;  ///< quantities or criterion
  int number = 1;         ///< quantities(number)
};

/// What a study deck says. Its axes, sets and quantities suit the table of variables and the decks.
struct Study {
  std::string file, text, title;
  Mode mode = Mode::grid;
  std::vector<BaseDeck> decks;
  std::vector<StudyAxis> axes;
  std::vector<std::string> sets;
  std::vector<std::string> quantities;      ///< their columns: keys of summary.txt, names of values of the history
  std::vector<WantedValue> history_values;  ///< those of quantities and criterion
  std::string order;                        ///< column for observed orders; empty for none
  Varied vary;
  double fraction = 0;
  int runs = 0;
  std::vector<double> own_values;  ///< ensemble: the varied value as each combination has it, a combination each
  Interval interval;
  Criterion criterion;
  std::size_t coarse = 1;  ///< map: every how-manieth value of an axis is run, whatever the others come to

  /// Returns whether a value is halved to where the criterion ends to hold.
  bool bisects() const { return mode == Mode::bisect || (mode == Mode::map && !vary.variable.empty()); }
};

/// The axes that move by themselves.
std::vector<std::size_t> leading_axes(const Study& study);

}  // namespace tether
