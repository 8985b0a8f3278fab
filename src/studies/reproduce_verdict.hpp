// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce_problem.hpp"

namespace tether::published {

/// What a method's runs of a problem came to.
struct MethodResult {
  std::vector<RunFiles> files;  ///< of the runs that ended well
  std::size_t runs = 0;         ///< of all
  std::string failure;          ///< why the first that failed did; empty where none did
};

/// A quantity over a method's runs.
struct Measured {
  std::vector<double> values;  ///< of the runs that show it
  std::size_t runs = 0;
  std::string failure;  ///< why there are fewer values than runs

  /// Not a number where most runs do not show it: what the others show would not be typical.
  double median() const;
  /// Standard deviation (n - 1) of the values; not a number for fewer than two.
  double spread() const;
};

/// The quantity of each run; a reading that does not find its file is a run that does not show it.
Measured measure(const Quantity& quantity, const MethodResult& result);

/// What a value is compared with.
struct Target {
  double value = 0;
  std::string name;  ///< "exact", or where the thesis prints it
};

/// The exact value, else the printed one that is nearest to `value`; nothing where there is neither.
std::optional<Target> target_of(const Quantity& quantity, double value);

struct Verdict {
  std::string text;    ///< "agrees within 1 %", "differs by 3.2 %", "reported", "no value: why"
  bool fails = false;  ///< it is judged, and does not agree
};

/// Of one method, whose tolerance is given where it is judged.
Verdict verdict_on(const Quantity& quantity, const Measured& measured, const std::optional<Tolerance>& tolerance);

}  // namespace tether::published
