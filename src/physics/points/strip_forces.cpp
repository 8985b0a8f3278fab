// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/strip_forces.hpp"

#include <cmath>
#include <vector>

#include "physics/points/point_laws.hpp"

namespace tether::mpm {
namespace {

/// Slope across of what a pair of points, at eta and 1 - eta, gives to a row of nodes, times h and a half. Of forces
/// across, what ghosts have is folded with its sign turned: by splines the upper row has 1 from the lower point, whose
/// ghost is beyond the lower wall, and 2 eta from the upper one.
double slope_across(const Scene& scene, std::size_t number) {
  if (scene.method.kernel == Kernel::linear) return 1;
  const Strip& strip = *scene.strip;
  const double h = strip.across == 1 ? scene.grid.dy : scene.grid.dx;
  return 1 - std::abs(strip.place[number] - strip.middle) / h;
}

}  // namespace

void put_forces_across(const State& state, const Scene& scene, const StepSet& set, const Order& order,
                       NodeSumsRow& sums) {
  const Strip& strip = *scene.strip;
  const bool upright = strip.across == 1;
  const Points& P = state.points;
  std::vector<double> slopes(strip.first.size(), 0.0);  // mean of the points abreast
  for (std::size_t p = 0; p < strip.points(); ++p)
    slopes[strip.row[p]] += slope_across(scene, p) / strip.abreast[strip.row[p]];
  const double h = upright ? scene.grid.dy : scene.grid.dx;
  std::vector<double> of_slots(P.size()), forces(state.grid.frame.shape.nodes(), 0.0);
  for (std::size_t k = 0; k < order.slots.size(); ++k) {
    const std::size_t p = order.slots[k];
    const double volume =
        std::visit([&](const auto& law) { return law_volume(law, P, p); }, scene.bodies[order.body_of(k)].material);
    of_slots[p] = volume * (upright ? P.syy[p] : P.sxx[p]) * slopes[k] * 2 / (h * P.mass[p]);
  }
  set.map_quantity(state, of_slots, forces, upright ? Parity::of_y : Parity::of_x);
  const Frame& frame = state.grid.frame;
  for (std::size_t k = 0; k < frame.deck.nodes(); ++k) {
    const std::size_t n = frame.of_deck(k), j = k / static_cast<std::size_t>(frame.deck.nx);
    const bool low = upright ? j == 0 : k % static_cast<std::size_t>(frame.deck.nx) == 0;
    sums[n].force[strip.across] = low ? forces[n] : -forces[n];
  }
}

}  // namespace tether::mpm
