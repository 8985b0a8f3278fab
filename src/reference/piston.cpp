// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/piston.hpp"

#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace tether {

double Piston::sound_speed() const { return std::sqrt(bulk_modulus / fluid_density); }

double Piston::frequency() const {
  // With z = omega L/c, (6.2) is m (c z/L)^2 - K - (beta A/L) z cot z = 0. Times sin(z)/z it has no pole, is negative
  // at z = 0 and positive at z = pi, and has one root between, since z cot z falls.
  const double to_omega = sound_speed() / fluid_length;
  const double fluid_stiffness = bulk_modulus * area / fluid_length;
  const auto balance = [&](double z) {
    const double omega = to_omega * z;
    return (mass * omega * omega - spring_stiffness) * boost::math::sinc_pi(z) - fluid_stiffness * std::cos(z);
  };
  std::uintmax_t steps = 1000;
  const boost::math::tools::eps_tolerance<double> full(std::numeric_limits<double>::digits - 2);
  const auto [low, high] = boost::math::tools::toms748_solve(balance, 0.0, std::numbers::pi, full, steps);
  return to_omega * (low + high) / 2;
}

double Piston::period() const { return 2 * std::numbers::pi / frequency(); }

}  // namespace tether
