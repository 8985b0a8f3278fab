// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/assignment.hpp"
#include "studies/reproduce/problem.hpp"

namespace tether::published {

/// A printed text taken apart; where there are mistakes, the rest means nothing.
struct ReadPrinted {
  std::vector<Printed> values;
  std::optional<double> upper_bound;
  std::vector<Mistake> mistakes;
};

/// Numbers as a deck notes what a source prints: "0.0071 (Table 3)", whose band is half a unit of its last digit;
/// "6 +- 3 % (Box 10)" or "0 +- 0.5 (7.5.2)" with a band of its own; "= 0.05 (Box 2)" for what states the problem and
/// is exact; "19.8 (Table 1) or 18.44 (Box 7)" where the source contradicts itself; "< 0.005 (4.1)" for an upper bound,
/// which stands alone.
ReadPrinted read_printed(const std::string& text);

/// A tolerance taken apart: "2 %" of what is compared with, or "0.015" in the quantity's own unit.
struct ReadTolerance {
  Tolerance tolerance;
  std::vector<Mistake> mistakes;
};
ReadTolerance read_tolerance(const std::string& text);

}  // namespace tether::published
