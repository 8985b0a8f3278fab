// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "studies/assignment.hpp"
#include "studies/study.hpp"

namespace tether {

/// Reports mistakes at the places of a group's values.
class StudyRemarks {
 public:
  /// The references must outlive this.
  StudyRemarks(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  /// At name(k), else at its group.
  void error(AnyVariable name, int k, const std::string& message, const std::string& hint = {}) {
    error(name, Subscript{k, 1}, message, hint);
  }
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint = {});
  /// Those of the text that stands in name(k), each at its column where the deck has the text on one line.
  void tell(TextVariable name, int k, const std::vector<Mistake>& mistakes) { tell(name, Subscript{k, 1}, mistakes); }
  void tell(TextVariable name, Subscript at, const std::vector<Mistake>& mistakes);

 private:
  void add(Diagnostic remark);

  const Deck& deck_;
  Diagnostics& diagnostics_;
};

// What is checked of a study as a whole, before its first run; mistakes are reported at the study deck's places.

/// Checks that what its mode needs is there, and nothing that only other modes know.
void check_mode(const Deck& deck, Mode mode, StudyRemarks& remarks);

/// The base decks read with the values of the first combination (the decks' own mistakes go into `diagnostics`), and
/// the quantities, the criterion and the order are what their runs write.
void check_decks(const Deck& deck, const Study& study, StudyRemarks& remarks, Diagnostics& diagnostics);

/// The columns of the history that a study wants are those of some of its runs: their scenes are built, without a step,
/// until each column was found; of many runs those along the edges of the axes. Where that cannot be known (a scene
/// that cannot be built, more than 400 to build), nothing is reported; the runs will show.
void check_columns(const Study& study, StudyRemarks& remarks);

}  // namespace tether
