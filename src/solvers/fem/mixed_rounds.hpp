// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

namespace tether::fem {

/// Anderson's mixing of rounds q1 = G(q0) that are to end where q stays (D. G. Anderson, J. ACM 12 (1965) 547-560): the
/// next q0 is the sum of the last q1, parts of which add up to 1, whose ways q1 - q0 add up to the least. Rounds whose
/// ways fall by a half, or grow, so fall by a tenth and more each.
class MixedRounds {
 public:
  /// The next start after a round from q0 to q1, all of the same length.
  std::vector<double> next(std::span<const double> q0, std::span<const double> q1);

 private:
  std::deque<Eigen::VectorXd> ends_, ways_;
};

}  // namespace tether::fem
