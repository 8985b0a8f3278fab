// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "run/request.hpp"
#include "studies/runs/scheduler.hpp"

namespace tether {

/// The first parts of a line, a comma between them, as many as fit into so many columns; the first one is cut if it
/// must.
std::string fitting(const std::vector<std::string>& parts, std::size_t width);

/// A line that rewrites itself on a terminal, a plain line now and then otherwise; on stderr.
class ProgressLine {
 public:
  /// Makes the line of a deck, whose file's name begins it.
  ProgressLine(const std::string& deck, bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void operator()(const Progress& progress);
  void operator()(const SweepProgress& progress);
  /// Ends the line so that other text can follow.
  void clear();

 private:
  bool is_due(double wall_seconds);
  void show(const std::vector<std::string>& parts);

  std::string name_;
  bool quiet_, terminal_;
  bool open_ = false;
  double last_ = 0;  // wall seconds at the last line
};

}  // namespace tether
