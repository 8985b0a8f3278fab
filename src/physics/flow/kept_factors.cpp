// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/kept_factors.hpp"

#include <cmath>

namespace tether::fem {
namespace {

/// Corrections that cost as much as new factors and the two corrections that these take: with more to come by the old
/// ones, new factors are cheaper. Measured on Q2Q1 meshes of 5,000 to 40,000 unknowns.
constexpr double corrections_of_a_factorisation = 6;

}  // namespace

void KeptFactors::begin_step(bool another) {
  if (another) there_ = false;
  new_ = slow_ = false;
}

void KeptFactors::made(bool done, bool lasting) {
  new_ = done;
  there_ = done && lasting;
}

bool KeptFactors::lead_on(double ratio, double left) {
  const bool worse = !(ratio < 1);
  if (worse && !new_) {
    there_ = false;
    return false;
  }
  new_ = false;
  slow_ = worse || std::log(left) / -std::log(ratio) > corrections_of_a_factorisation;
  return true;
}

}  // namespace tether::fem
