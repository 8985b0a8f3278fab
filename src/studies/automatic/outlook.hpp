// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "studies/automatic/cost_law.hpp"
#include "studies/automatic/posterior.hpp"
#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// Why a run has no value: its scene cannot be built, it ended badly, it ended well and does not show the number, or it
/// never writes what that is read off.
enum class NoValue { scene, run, number, file };

/// A run of the search.
struct Trial {
  Resolution at;                ///< that it has: counts of cells are whole numbers, and a limit may cut its steps
  Resolution wanted;            ///< the one that was asked for
  std::optional<double> value;  ///< what was read off it
  double seconds = 0;           ///< of the processor
  NoValue why = NoValue::run;   ///< it has none, where it has none
  std::size_t run = 0;          ///< its place among all runs that were made
};

/// What a search is after.
struct Aim {
  double tolerance = 0;                                     ///< relative, of the number that is read off
  Orders theory;                                            ///< what cannot be made finer has none
  Resolution coarsest;                                      ///< where it begins
  Resolution powers;                                        ///< of the cost in both, as expected
  bool nested = false;                                      ///< cells are to be whole parts of the deck's, or halves
  double budget = std::numeric_limits<double>::infinity();  ///< seconds of the processor
};

/// Steps are cut by a limit where they are finer than asked for by this factor.
constexpr double is_cut = 1.02;

/// The chance with which the bound of an error holds.
constexpr double promise = 0.97;

/// Returns what was read off the runs of a search, each resolution once.
std::vector<Sample> samples_of(const std::vector<Trial>& trials);

/// What the runs that were made say of those that were not: what they cost, whether they meet the tolerance, what they
/// say of the limit. The references must outlive it.
class Outlook {
 public:
  /// Throws std::invalid_argument where no run ended well.
  Outlook(const Aim& aim, const std::vector<Trial>& trials, double scatter);

  const Posterior& posterior() const { return posterior_; }
  double seconds(const Resolution& at) const { return law_.seconds(as_run(at)); }
  /// Returns whether it was not asked for before, is no run that was made since a limit cuts the steps of both to the
  /// same, and is not known to fail.
  bool is_new(const Resolution& at) const;
  /// The cheapest resolution that is expected to meet the tolerance; none up to 2^10 times the coarsest.
  std::optional<Resolution> cheapest_expected() const;
  /// The cheapest of the new runs that say nearly as much of the limit as the one that says most; none where all fail.
  std::optional<Resolution> most_informing() const;
  /// The resolution, but no finer than twice the finest that was run: what is expected far away is found wrong early.
  Resolution within_reach(const Resolution& at) const;

 private:
  bool is_known_to_fail(const Resolution& at) const;
  double cut_to(double space) const;
  Resolution as_run(const Resolution& wanted) const {
    return {wanted.space, std::max(wanted.time, cut_to(wanted.space))};
  }
  std::vector<Resolution> in_reach() const;
  std::vector<double> spaces() const;

  const Aim& aim_;
  const std::vector<Trial>& trials_;
  Posterior posterior_;
  CostLaw law_;
  Resolution finest_;        // cells and steps of any run that ended well
  double most_seconds_ = 0;  // of a run
};

}  // namespace tether::automatic
