// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oscillators.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
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

namespace {

using std::numbers::pi;

/// Modes that are summed; the stretches fall like 1/n^4 where the mass is heavy and 1/n^3 where it is light.
constexpr int mode_count = 60;
/// Places in half a period at which the lowest one is looked for.
constexpr int places = 1000;

/// The root of z tan(z) = ratio between n pi and n pi + pi/2: of z sin(z) - ratio cos(z), which has no pole.
double root(double ratio, int n) {
  const auto mismatch = [ratio](double z) { return z * std::sin(z) - ratio * std::cos(z); };
  std::uintmax_t steps = 1000;
  const boost::math::tools::eps_tolerance<double> full(std::numeric_limits<double>::digits - 2);
  const auto [low, high] = boost::math::tools::toms748_solve(mismatch, n * pi, (n + 0.5) * pi, full, steps);
  return (low + high) / 2;
}

}  // namespace

double SpringMass::frequency() const { return modes().front().frequency; }
double SpringMass::period() const { return 2 * pi / frequency(); }
double SpringMass::static_stretch() const { return (mass + spring_mass / 2) * gravity / stiffness; }

double SpringMass::position(double t) const { return positions({t}).front(); }

std::vector<double> SpringMass::positions(const std::vector<double>& times) const {
  const auto all = modes();
  std::vector<double> y;
  for (const double t : times) {
    double stretch = 0;
    for (const auto& [omega, part] : all) stretch += part * (1 - std::cos(omega * t));
    y.push_back(-stretch);
  }
  return y;
}

double SpringMass::largest_drop(double until) const {
  if (std::isinf(until)) {
    double lowest = 0;
    for (const auto& [omega, part] : modes()) lowest += 2 * std::max(0.0, part);
    return lowest;
  }
  const double half = period() / 2;
  if (spring_mass == 0) return until < half ? -position(until) : 2 * static_stretch();
  const auto count = static_cast<std::size_t>(std::ceil(until / half * places));
  std::vector<double> times{until};
  for (std::size_t k = 0; k < count; ++k) times.push_back(until * static_cast<double>(k) / static_cast<double>(count));
  const auto y = positions(times);
  return -*std::min_element(y.begin(), y.end());
}

/// A mode's share of the pull of gravity, integral of rho A phi + m phi(L), over its mass, integral of rho A phi^2 +
/// m phi(L)^2, is 4/(2 z + sin(2 z)), since m sin(z) = M_s cos(z)/z.
std::vector<SpringMass::Mode> SpringMass::modes() const {
  if (spring_mass == 0) return {{std::sqrt(stiffness / mass), mass * gravity / stiffness}};
  std::vector<Mode> modes;
  for (int n = 0; n < mode_count; ++n) {
    const double z = root(spring_mass / mass, n), omega = z * std::sqrt(stiffness / spring_mass);
    const double share = 4 / (2 * z + std::sin(2 * z));
    modes.push_back({omega, std::sin(z) * share * gravity / (omega * omega)});
  }
  return modes;
}

double StringBounce::frequency() const { return std::sqrt(stiffness / mass); }
double StringBounce::static_stretch() const { return mass * gravity / stiffness; }

/// The string is taut at m g/k above the static place, with the speed sqrt(2 g s) of the fall.
double StringBounce::amplitude() const {
  return std::hypot(static_stretch(), std::sqrt(2 * gravity * slack) / frequency());
}

double StringBounce::taut_time() const { return std::sqrt(2 * slack / gravity); }

/// Depth below the static place is amplitude cos(omega (t - lowest_time)), and -m g/k when the string is taut.
double StringBounce::lowest_time() const {
  return taut_time() + std::acos(-static_stretch() / amplitude()) / frequency();
}

double StringBounce::slack_again_time() const { return 2 * lowest_time() - taut_time(); }
double StringBounce::apex_time() const { return 2 * lowest_time(); }
double StringBounce::largest_drop() const { return slack + static_stretch() + amplitude(); }

double StringBounce::position(double t) const {
  // The motion is the same forwards and backwards from every lowest point, so half a period shows all.
  const double since_lowest = std::abs(std::fmod(t, apex_time()) - lowest_time());
  if (since_lowest >= lowest_time() - taut_time()) {
    const double from_apex = lowest_time() - since_lowest;
    return -gravity * from_apex * from_apex / 2;
  }
  return -(slack + static_stretch() + amplitude() * std::cos(frequency() * since_lowest));
}

}  // namespace tether
