// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/spring.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace tether {
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

}  // namespace tether
