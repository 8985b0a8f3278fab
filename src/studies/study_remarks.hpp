// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "studies/assignment.hpp"

namespace tether {

/// Reports mistakes at the places of a group's values.
class StudyRemarks {
 public:
  /// The references must outlive this.
  StudyRemarks(const Deck& deck, Diagnostics& diagnostics, std::string_view group = study_group)
      : deck_(deck), diagnostics_(diagnostics), group_(group) {}

  /// At the group's name(k), else at the group.
  void error(const std::string& name, int k, const std::string& message, const std::string& hint = {});
  /// Those of the text that stands in name(k), each at its column where the deck has the text on one line.
  void tell(const std::string& name, int k, const std::vector<Mistake>& mistakes);

 private:
  void add(Diagnostic remark);

  const Deck& deck_;
  Diagnostics& diagnostics_;
  std::string_view group_;
};

}  // namespace tether
