// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce/problem.hpp"

namespace tether::published {

/// What a method's runs of a problem came to.
struct MethodResult {
  std::vector<RunFiles> files;  ///< of the runs that ended well
  std::size_t runs = 0;         ///< of all
  std::string failure;          ///< why the first that failed did; empty where none did
  std::vector<RunFiles> begun;  ///< of all that began, which have their deck at least
  bool is_finished = true;      ///< false where one is still to be run
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
Measured measure(const PublishedQuantity& quantity, const MethodResult& result);

/// How a comparison came out, the worst last.
enum class Standing { reported, agrees, undecided, differs };

struct Verdict {
  std::string text;  ///< "agrees with Table 3 within 2.3 %"
  Standing standing = Standing::reported;
};

/// What a row is judged by: the exact value of the deck that ran, not a number where there is none.
struct Judgement {
  Verdict thesis, robust;  ///< of either method, empty where it has no runs
  Verdict theory;          ///< of the exact value against the theory of the source
  Verdict missing;         ///< that the runs do not show the exact value
  double exact = 0;

  Standing standing() const;  ///< the worst
  /// `first` is the word for the first method.
  std::string text(const std::string& first = "thesis") const;
};

/// Runs of a chaotic case agree with a number where their median is within the band and their standard deviation is no
/// larger than the band: what differs from run to run by more than that can be near a number by chance, and is
/// "undecided". The band of a printed value is that of its digits and, beyond it, the standard deviation: the thesis
/// printed one run of its own. The standard deviation has to be within the digits alone.
Verdict compare_with(const Measured& measured, const Printed& target, bool judged, bool one_of_many);

/// All comparisons of a row. A method without a value where it is judged differs.
Judgement judge(const PublishedQuantity& quantity, const MethodResult& thesis, const MethodResult& robust);

/// The exact value of the deck that ran, of the first run that has one; not a number where there is none.
double exact_of(const PublishedQuantity& quantity, const MethodResult& method);

}  // namespace tether::published
