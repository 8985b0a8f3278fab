// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include <span>
#include <vector>

#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// What was read off a run.
struct Sample {
  Resolution at;
  double value = 0;
};

/// What values at several resolutions say of the one at none: Richardson's extrapolation, with its doubt.
///
/// A value is taken as Q(h, k) = Q + a h^p + b k^q + noise, with h and k the sizes of cells and steps over those of the
/// coarsest run that follows the law. The noise stands for all that is no power: grids that are not aligned, contacts
/// that fall between two steps. Its size falls as a power of the refinement, too, of 0 to 2. What p, q, that power and
/// the size of the noise are is open, and so is from which level on the law holds, where four levels are known or more:
/// each set of these is a hypothesis, whose Q, a and b are Gaussian given the values (linear regression), and whose
/// weight is its likelihood times how near its orders are to theory's. So an order that the values do not bear out,
/// signs that change and levels that agree by chance all widen the bound, in place of a rule for each.
class Posterior {
 public:
  /// `scatter`: how far values of one resolution lie apart that should be equal (chaos), relative. Throws
  /// std::invalid_argument for no sample.
  Posterior(std::span<const Sample> samples, const Orders& theory, double scatter);

  /// Returns whether a run of that resolution, not made yet, has a value within `tolerance` (relative) of the limit
  /// with the chance `promised`, or more.
  bool meets(const Resolution& at, double tolerance, double promised) const;
  /// The chance that this value of a run that was made is.
  double chance_of(double value, double tolerance) const;
  /// The tolerance (relative) that this value meets with that chance; infinite where none up to 1e6 is.
  double bound(double value, double chance) const;
  /// The mean of what the values lead to.
  double limit() const { return limit_; }
  /// Returns what a run there is expected to say of the limit: the squared correlation of its value with that, which is
  /// the part of the limit's variance that the run would take away.
  double informs(const Resolution& at) const;
  /// The mean orders; none where no two resolutions differ there.
  Orders orders() const { return orders_; }

 private:
  static constexpr int most_terms = 3;  // Q, a, b
  using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_terms, most_terms>;

  /// p, q and the noise of one hypothesis, and what it makes of the values, relative to scale_: the mean and the
  /// covariance of Q - origin, a, b.
  struct Hypothesis {
    double p = 1, q = 1, noise = 0, noise_order = 0;
    double first_level = 0;  ///< coarser cells (steps, where there are no cells) follow no law, and say nothing
    Resolution coarsest;     ///< cells and steps, each, of the levels that follow the law
    double weight = 0;
    Terms mean = {};
    Square covariance = {};
  };

  std::vector<double> possible_first_levels(std::span<const Sample> samples) const;
  Resolution coarsest_lawful(std::span<const Sample> samples, double first_level) const;
  void add_hypotheses(std::span<const Sample> samples, const Orders& theory, double first_level);
  Terms basis(const Hypothesis& h, const Resolution& at) const;
  double level_of(const Resolution& at) const { return has_space_ ? at.space : at.time; }
  bool is_lawless(const Hypothesis& h, const Resolution& at) const;
  double chance_at(const Hypothesis& h, const Resolution& at, double tolerance) const;
  double noise_variance(const Hypothesis& h, const Resolution& at) const;
  Terms prior_variances() const;
  /// Fills in mean, covariance and, as a logarithm, weight.
  void regress(Hypothesis& h, std::span<const Sample> samples, const Orders& theory) const;
  void normalise();

  double scatter_ = 0, scale_ = 1, origin_ = 0, limit_ = 0;
  bool in_space_ = false, in_time_ = false, has_space_ = false, has_time_ = false;
  std::vector<Hypothesis> hypotheses_;
  Orders orders_;
};

}  // namespace tether::automatic
