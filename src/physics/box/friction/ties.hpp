// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/small_factors.hpp"
#include "physics/box/friction/strain_rates.hpp"

namespace tether::coupled {

/// A preconditioner of (M + h K) that has the diagonal of it and, whole, the squares that tie velocities together:
/// those next to a surface that is near, of faces and the nodes that they stick to. They are so stiff that with the
/// diagonal alone conjugate gradients find what is free in them last; their factors are as sparse as the surface.
class Ties {
 public:
  /// `free` are the unknowns that friction changes, `diagonal` their numbers of M + h K; `unknowns` how many there are
  /// in all.
  Ties(const StrainRates& rates, std::span<const std::size_t> free, std::span<const double> diagonal,
       std::size_t unknowns);

  /// z = P^-1 r, of the free unknowns.
  void solve(std::span<const double> r, std::span<double> z);

 private:
  std::vector<double> inverse_;    // of the diagonal, of each free unknown
  std::vector<std::size_t> tied_;  // of the free ones, in the order of the factors' unknowns
  Eigen::VectorXd right_, found_;
  SmallFactors factors_;
};

}  // namespace tether::coupled
