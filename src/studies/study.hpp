// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "studies/assignment.hpp"
#include "studies/bisection.hpp"
#include "studies/history_value.hpp"

namespace tether {

enum class Mode { grid, ensemble, bisect };

/// A deck value and the values that it takes in turn.
struct Axis {
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
  std::string variable;  ///< "quantities" or "criterion"
  int number = 1;        ///< quantities(number)
};

/// What a study deck says. Its axes, sets and quantities suit the table of variables and the decks.
struct Study {
  std::string file, text, title;
  Mode mode = Mode::grid;
  std::vector<BaseDeck> decks;
  std::vector<Axis> axes;
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
};

}  // namespace tether
