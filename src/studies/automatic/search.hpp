// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/automatic/cost_law.hpp"
#include "studies/automatic/posterior.hpp"
#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// A run of the search. `at` is the resolution that it has: counts of cells are whole numbers.
struct Trial {
  Resolution at;
  Resolution wanted;            ///< the one that was asked for
  std::optional<double> value;  ///< none where it failed, or does not show the number
  double seconds = 0;           ///< of the processor
};

/// What a search is after.
struct Aim {
  double tolerance = 0;                                     ///< relative, of the number that is read off
  Orders theory;                                            ///< what cannot be made finer has none
  Resolution coarsest;                                      ///< where it begins
  Resolution powers;                                        ///< of the cost in both, as expected
  double budget = std::numeric_limits<double>::infinity();  ///< seconds of the processor
};

/// The setting that was found: the cheapest run that was made whose value is, with the chance `promise`, as near the
/// limit as asked for.
struct Setting {
  std::size_t trial = 0;  ///< its place among the trials
  double error = 0;       ///< estimated: its distance from the mean of the limit, over that
  double bound = 0;       ///< what it is within, with that chance
};

/// The chance with which the bound of an error holds.
constexpr double promise = 0.97;
/// Levels that an error is estimated from at the least.
constexpr std::size_t levels_in_space = 3, levels_in_time = 2, levels_in_time_alone = 3;

/// Looks for the cheapest resolution that meets a tolerance, from coarse runs to fine ones. Knows nothing of how runs
/// are made: whoever makes them takes the resolutions from next() and hands back what they came to.
class Search {
 public:
  explicit Search(const Aim& aim);

  /// The resolutions to run next; none when it is over. Runs of an earlier answer must have been taken.
  std::vector<Resolution> next();
  /// Takes what a run came to.
  void take(const Trial& trial);
  /// Takes how far values lie apart that should be equal, over them, from runs whose steps differ by little.
  void take_scatter(double scatter) { scatter_ = scatter; }
  /// The resolution whose steps are to be varied a little, to see whether the number scatters; none before it is run.
  std::optional<Resolution> to_vary() const;

  const std::vector<Trial>& trials() const { return trials_; }
  const std::optional<Setting>& found() const { return found_; }
  /// Why nothing was found; empty where something was.
  const std::string& why_not() const { return why_not_; }
  /// Throws std::logic_error before the first run that ended well.
  Posterior posterior() const;
  double scatter() const { return scatter_; }
  double seconds() const;

 private:
  std::vector<Sample> samples() const;
  std::vector<Resolution> first_ones() const;
  std::vector<Resolution> begin_finer();
  std::size_t levels(double Resolution::*part) const;
  bool has_levels() const;
  void look(const Posterior& posterior);
  std::optional<Resolution> cheapest_expected(const Posterior& posterior, const CostLaw& law) const;
  std::optional<Resolution> most_informing(const Posterior& posterior, const CostLaw& law) const;
  Resolution finest() const;
  CostLaw law() const;
  bool is_known_to_fail(const Resolution& at) const;
  bool was_wanted(const Resolution& at) const;
  bool has_own_size() const;
  bool agrees_by_chance_perhaps(const Posterior& posterior) const;
  Resolution beside_the_levels() const;
  std::optional<Resolution> decide(const Posterior& posterior, const CostLaw& law);
  std::vector<Resolution> end(const std::string& why);

  Aim aim_;
  std::vector<Trial> trials_;
  std::vector<Resolution> wanted_, failed_;
  std::optional<Setting> found_;
  std::string why_not_;
  double scatter_ = 0;
};

}  // namespace tether::automatic
