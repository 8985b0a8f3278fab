// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/automatic/outlook.hpp"
#include "studies/automatic/posterior.hpp"
#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// The setting that was found: the cheapest run that was made whose value is, with the chance `promise`, as near the
/// limit as asked for.
struct Setting {
  Trial trial;
  double error = 0;  ///< estimated: its distance from the mean of the limit, over that
  double bound = 0;  ///< what it is within, with that chance
};

/// Levels that an error is estimated from at the least.
constexpr std::size_t levels_in_space = 3, levels_in_time = 2, levels_in_time_alone = 3;

/// Looks for the cheapest resolution that meets a tolerance, from coarse runs to fine ones. Knows nothing of how runs
/// are made: whoever makes them takes the resolutions from next() and hands back what they came to.
class Search {
 public:
  explicit Search(const Aim& aim) : aim_(aim) {}

  /// The resolutions to run next; none when it is over. Runs of an earlier answer must have been taken. `spent`:
  /// seconds of the processor that went from the budget so far.
  std::vector<Resolution> next(double spent);
  /// Takes what a run came to.
  void take(const Trial& trial) { trials_.push_back(trial); }
  /// Has the search go on for a smaller tolerance.
  void tighten(double tolerance) { aim_.tolerance = tolerance, found_.reset(); }
  /// Takes how far values lie apart that should be equal, over them.
  void take_scatter(double scatter) { scatter_ = scatter; }

  const std::vector<Trial>& trials() const { return trials_; }
  /// None before the search is over, or where nothing can be promised.
  const std::optional<Setting>& found() const { return found_; }
  /// Why nothing was found; empty where something was.
  const std::string& why_not() const { return why_not_; }
  /// None before the first run that ended well.
  std::optional<Posterior> posterior() const;
  double scatter() const { return scatter_; }
  /// Returns whether the search is over since the deck's own cells and steps, and finer ones, fail: not for want of
  /// budget.
  bool own_size_fails() const { return own_size_fails_; }
  /// Returns whether a run with the deck's own cells and steps, or finer ones, ended well: what they resolve may be
  /// seen by no coarser one.
  bool has_own_size() const;

 private:
  std::vector<Resolution> first_ones() const;
  std::vector<Resolution> begin_finer();
  std::vector<Resolution> end(const std::string& why);
  std::size_t levels(double Resolution::*part) const;
  bool has_levels() const;
  std::optional<Setting> cheapest_that_meets(const Posterior& posterior) const;
  std::optional<Resolution> decide(const Outlook& outlook, const std::optional<Setting>& best, bool is_doubtful) const;
  std::optional<Resolution> own_size(const Outlook& outlook) const;
  bool agree_perhaps_by_chance(const Posterior& posterior) const;
  bool error_falls() const;
  std::string what_is_known(const Posterior& posterior, bool is_doubtful) const;

  Aim aim_;
  std::vector<Trial> trials_;
  std::optional<Setting> found_;
  std::string why_not_;
  double scatter_ = 0;
  bool own_size_fails_ = false;
};

}  // namespace tether::automatic
