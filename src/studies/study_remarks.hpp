// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "studies/assignment.hpp"

namespace tether {

/// Tells of mistakes at the places of a study deck's values.
class StudyRemarks {
 public:
  /// The references must outlive this.
  StudyRemarks(const Deck& deck, Diagnostics& diagnostics) : deck_(deck), diagnostics_(diagnostics) {}

  /// At $study name(k), else at $study.
  void error(const std::string& name, int k, const std::string& message, const std::string& hint = {});
  /// Those of the text that stands in name(k), each at its column where the deck has the text on one line.
  void tell(const std::string& name, int k, const std::vector<Mistake>& mistakes);

 private:
  void add(Diagnostic remark);

  const Deck& deck_;
  Diagnostics& diagnostics_;
};

}  // namespace tether
