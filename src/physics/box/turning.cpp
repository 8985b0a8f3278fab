// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/turning.hpp"

#include <cmath>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"

namespace tether::coupled {
namespace {

/// How a region turns about its centre of mass.
struct Turn {
  double mass = 0, squares = 0, moving = 0;  ///< squares: of the distances from it by mass; moving: all its energy
  double rate = 0;                           ///< as if it were as wide about all axes as it is [1/time]

  double energy() const { return 0.5 * squares * rate * rate; }
};

Turn turn_of(const std::vector<double>& masses, int dim, std::span<const double> q, std::span<const double> u) {
  Turn turn;
  Vec<3> middle{}, momentum{}, angular{};
  for (std::size_t n = 0; n < masses.size(); ++n) {
    if (masses[n] == 0) continue;
    const Vec<3> x = place_of(q, static_cast<int>(n), dim), v = place_of(u, static_cast<int>(n), dim);
    const Vec<3> spin = cross(x, v);
    turn.mass += masses[n], turn.squares += masses[n] * dot(x, x), turn.moving += 0.5 * masses[n] * dot(v, v);
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] += masses[n] * x[i], momentum[i] += masses[n] * v[i], angular[i] += masses[n] * spin[i];
  }
  const Vec<3> of_centre = cross(middle, momentum);
  for (std::size_t i = 0; i < 3; ++i) angular[i] -= of_centre[i] / turn.mass;
  turn.squares -= dot(middle, middle) / turn.mass;
  if (turn.squares > 0) turn.rate = std::sqrt(dot(angular, angular)) / turn.squares;
  return turn;
}

}  // namespace

double gain_by_turning(const fem::SolidSystem& system, std::span<const double> q, std::span<const double> u, double h) {
  double moving = 0, gained = 0;
  for (std::size_t r = 0; r < system.region_weights.size(); ++r) {
    const Turn turn = turn_of(system.region_weights[r], system.dim(), q, u);
    moving += turn.moving;
    if (!(turn.rate > 0)) continue;
    const double radius = std::sqrt(turn.squares / turn.mass);
    gained += turn.energy() * linear_gain(system.solids.regions[r], turn.rate, radius, h);
  }
  return moving > 0 ? gained / moving : 0;
}

}  // namespace tether::coupled
