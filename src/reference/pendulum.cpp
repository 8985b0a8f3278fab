// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pendulum.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tether {

double Pendulum::modulus() const {
  if (!(std::abs(start_angle) < std::numbers::pi)) {
    throw std::domain_error("pendulum: the angle at the start must be between -pi and pi");
  }
  return std::sin(start_angle / 2);
}

double Pendulum::swing_length() const { return length * (1 + stretch) * (1 + string_part / 3) / (1 + string_part / 2); }

double Pendulum::period() const { return 4 * std::sqrt(swing_length() / gravity) * boost::math::ellint_1(modulus()); }

double Pendulum::angle(double t) const {
  // Jacobi's sn is even in k; Boost wants k >= 0, and the sign of theta0 stands in front.
  const double k = modulus();
  const double phase = boost::math::ellint_1(k) + std::sqrt(gravity / swing_length()) * t;
  return 2 * std::asin(k * boost::math::jacobi_sn(std::abs(k), phase));
}

}  // namespace tether
