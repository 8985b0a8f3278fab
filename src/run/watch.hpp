// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "physics/solver.hpp"
#include "results/results.hpp"
#include "results/summary_keys.hpp"

namespace tether {

/// Looks after each record, or each step, at the numbers by which a run that goes wrong is known: those of the scene's
/// limits that the history has columns for. The first time that one is passed is reported, and beyond reason the run
/// ends.
class Watch {
 public:
  Watch(const Scene& scene, const HistoryLayout& layout);

  /// The solver is asked for places alone. Throws RunError.
  void look(const Record& record, const Solver& solver);
  /// Returns what was passed since the last call.
  std::vector<std::string> take_messages();
  /// The worst of each number so far.
  Summary summary() const;

  std::vector<double> save() const;
  /// `first` is the history's first record.
  void restore(const std::vector<double>& saved, const Record& first);

 private:
  /// A number that is watched.
  struct Number {
    const char* name = "";               // in $limits
    std::optional<SummaryKey> key = {};  // of the worst in summary.txt
    const char* what = "";               // for people
    const char* cause = "";              // why it may be so
    Limit limit = {};
    Failure failure = Failure::diverges;  // of the run that passes it
    bool low = false;                     // smaller ones are worse
    std::vector<std::size_t> from = {};   // the columns, of which the worst counts
    double worst = 0;
    bool told = false;
  };
  using Place = std::function<std::string()>;  // for a message
  /// A column that goes into the balance of the energy.
  struct Term {
    std::size_t column = 0;
    double sign = 0;
  };

  void watch_energy(const Scene& scene);
  void judge(Number& number, double value, double time, const Place& where);
  void look_at_volumes(const Record& record);
  void look_at_energy(const Record& record);
  double kept_energy(const Record& record) const;
  double booked_energy(const Record& record) const;
  double largest_energy(const Record& record) const;
  double rest_energy(const Record& record) const;

  double cell_;                       // [length]
  std::size_t mass_ = 0, total_ = 0;  // columns
  std::vector<std::size_t> energies_;
  std::size_t potential_ = 0, pressure_ = 0;  // the latter 0 where there is none
  std::vector<Term> booked_;
  bool keeps_books_ = true;      // so that a rise means something
  std::vector<Number> numbers_;  // of columns
  Number volume_, energy_step_, energy_growth_;
  std::vector<std::size_t> bodies_;  // of the columns of volume_, from 0
  Record first_;                     // that was looked at
  bool looked_ = false;
  double balance_ = 0, largest_ = 0, booked_before_ = 0;  // of the energy, at the last look
  std::vector<std::string> messages_;
};

}  // namespace tether
