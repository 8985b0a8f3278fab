// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/thin_ring.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "base/numbers.hpp"

namespace tether {
namespace {

using std::numbers::pi;

void check(const ThinRing& ring) {
  for (const double value : {ring.length, ring.thickness, ring.young, ring.gm1, ring.internal_energy}) {
    if (!is_positive(value)) throw std::domain_error("thin ring: its numbers must be positive and finite");
  }
  if (!(ring.poisson > -1 && ring.poisson <= 0.5)) {
    throw std::domain_error("thin ring: Poisson's ratio must be between -1 and 1/2");
  }
}

RingAtRest stretched(const ThinRing& ring, double strain) {
  const double radius = 2 * ring.length / pi * std::exp(strain);
  const double stress = ring.young * strain / (1 - ring.poisson * ring.poisson);  // (5.15)
  const double strain_energy = stress * strain * ring.length * ring.thickness / 2;
  const double area = pi * radius * radius / 4;
  const double pressure = ring.gm1 * (ring.internal_energy - strain_energy) / area;  // (4.4)
  return {radius, pressure, stress, strain_energy};
}

/// Returns what the pressure pulls along the ring beyond the ring's tension [force].
double excess(const ThinRing& ring, double strain) {
  const RingAtRest now = stretched(ring, strain);
  return now.pressure * now.radius - now.hoop_stress * ring.thickness * std::exp(-strain);
}

}  // namespace

RingAtRest ring_at_rest(const ThinRing& ring) {
  check(ring);
  // Tension sigma t exp(-eps) has its largest value at eps = 1, while p r falls throughout.
  if (excess(ring, 1) > 0) throw std::domain_error("thin ring: the gas stretches it without end");
  std::uintmax_t steps = 1000;
  const boost::math::tools::eps_tolerance<double> full(std::numeric_limits<double>::digits - 2);
  const auto [low, high] =
      boost::math::tools::toms748_solve([&ring](double strain) { return excess(ring, strain); }, 0.0, 1.0, full, steps);
  return stretched(ring, (low + high) / 2);
}

}  // namespace tether
