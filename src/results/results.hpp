// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "base/process.hpp"
#include "fields/column_text.hpp"

namespace tether {

/// What a part of a run took: "assembly", "solve" ...
struct CostPart {
  std::string name;
  Seconds taken;
};

/// A history kept in memory, for figures of merit that need the whole of it.
struct History {
  HistoryLayout layout;
  std::vector<Record> records;
  /// One flat column by name; throws std::out_of_range where there is none.
  std::vector<double> column(const std::string& name) const;
};

/// Attributes that every NetCDF file carries.
struct Provenance {
  std::string title;        ///< the deck's header lines
  std::string command;      ///< the command line, for `history`
  std::string deck_text;    ///< the deck as read
  std::string deck_sha256;  ///< of deck_text
  Units units = Units::none;
  std::string run_sha256 = {};  ///< of deck.effective: the same for all files of a run
};

/// `key = value` lines of summary.txt, in order.
using Summary = std::vector<std::pair<std::string, std::string>>;

/// Columns of numbers over a common first column, for the exact solution (`reference.txt`).
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};

/// Arrays of numbers by name: a solver's whole state as plain data. Integers up to 2^53 stand in it exactly.
using SavedState = std::map<std::string, std::vector<double>>;

/// Takes the parts of a state in. A path lists its parts once, in a function over saver and restorer alike, so that the
/// two cannot part company:
///   template <class Exchange> void exchange(Exchange& with, State& state) { with("x", state.x); ... }
class StateSaver {
 public:
  template <class Number>
  void operator()(const char* name, const Number& number) {
    saved_[name] = {static_cast<double>(number)};
  }
  template <class Number, class Allocator>
  void operator()(const char* name, const std::vector<Number, Allocator>& array) {
    std::vector<double>& saved = saved_[name];
    saved.clear();
    for (const Number& number : array) saved.push_back(static_cast<double>(number));
  }
  /// An array whose length changes while a scene runs.
  template <class Number, class Allocator>
  void list(const char* name, const std::vector<Number, Allocator>& array) {
    (*this)(name, array);
  }
  SavedState take() { return std::move(saved_); }

 private:
  SavedState saved_;
};

/// The array of that name; throws FileError where there is none.
const std::vector<double>& saved_array(const SavedState& saved, const std::string& name);
/// Returns the same, of which the scene has so many numbers; throws FileError where it is of another length.
const std::vector<double>& saved_array(const SavedState& saved, const std::string& name, std::size_t length);

/// Gives the parts of a state back. Throws FileError where a part is missing or does not have the scene's length.
class StateRestorer {
 public:
  explicit StateRestorer(const SavedState& saved) : saved_(saved) {}

  template <class Number>
  void operator()(const char* name, Number& number) {
    number = static_cast<Number>(saved_array(saved_, name, 1).front());
  }
  template <class Number, class Allocator>
  void operator()(const char* name, std::vector<Number, Allocator>& array) {
    copy(saved_array(saved_, name, array.size()), array);
  }
  template <class Number, class Allocator>
  void list(const char* name, std::vector<Number, Allocator>& array) {
    const auto& from = saved_array(saved_, name);
    array.resize(from.size());
    copy(from, array);
  }

 private:
  template <class Number, class Allocator>
  static void copy(const std::vector<double>& from, std::vector<Number, Allocator>& to) {
    std::transform(from.begin(), from.end(), to.begin(), [](double value) { return static_cast<Number>(value); });
  }
  const SavedState& saved_;
};

}  // namespace tether
