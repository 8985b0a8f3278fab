// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/assignment.hpp"

namespace tether {

/// Guesses what a user may have meant by a name that is none of these: the nearest one, or else all of them.
std::string meant(const std::string& name, const std::vector<std::string>& known);

/// What a function makes of a column of history.txt: a study writes it as 'max(body_y_3)'.
struct HistoryValue {
  std::string function;  ///< "max"
  std::string column;    ///< "body_y_3"
  int at = 1;            ///< where the column's name stands in the text, from 1

  /// Returns the name of its column in a table, which CSV, NetCDF and those who read them take without quotes.
  std::string name() const { return function + "_" + column; }
  std::string meaning() const;
};

/// Returns whether a text is meant as one: it has a bracket, which no key of summary.txt has.
bool is_history_value(const std::string& text);

/// A text taken apart; where there are mistakes, the rest means nothing.
struct ReadHistoryValue {
  HistoryValue value;
  std::vector<Mistake> mistakes;
};
ReadHistoryValue read_history_value(const std::string& text);

/// Its number, of the records of a run. Not a number where there is no record, or one whose cell is none.
double number_of(const HistoryValue& value, const std::vector<double>& times, const std::vector<double>& column);

/// What a history.txt says of some values.
struct HistoryNumbers {
  std::map<std::string, double> values;        ///< by the names of the values
  std::map<std::string, std::string> lacking;  ///< columns that are not there, and what may have been meant
};

/// Throws FileError where the file cannot be read.
HistoryNumbers read_history_numbers(const std::filesystem::path& path, const std::vector<HistoryValue>& values);

}  // namespace tether
