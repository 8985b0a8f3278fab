// SPDX-License-Identifier: GPL-3.0-or-later
// The gas on open edges: what is seen inside, what the Riemann problem with the outside makes of it, and the points of
// the strips that carry it.
#include <algorithm>
#include <cmath>

#include "solvers/mpm/strips.hpp"

#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// Cells before an edge over which the gas inside is averaged.
constexpr double seen_cells = 2;
/// Cells of a strip that reach the points inside; those further out may lack mass, and their density is the edge's.
constexpr double whole_cells = 3;

}  // namespace

/// Means over the gas within two cells of the edge, for each cell along it: density by volume, velocity by mass,
/// pressure by volume. Where no gas is left it stays what it was.
void Strips::look_inside(const BodyPoints& bodies, const Scene& scene) {
  const Points& P = bodies.points;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!edges_.of[k].open()) continue;
    Cells& cells = cells_[k];
    sums_.assign(cells.body.size(), {});
    for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
      if (!std::holds_alternative<IdealGas>(scene.bodies[b].material)) continue;
      for_points(bodies.ranges[b], [&](std::size_t p) {
        const double distance = inward(k, P.x[p], P.y[p]);
        if (distance >= seen_cells * cell_across(k) || holds(P.x[p], P.y[p])) return;
        Sums& sum = sums_[cell_of(k, k < 2 ? P.y[p] : P.x[p])];
        sum.mass += P.mass[p], sum.own += P.mass[p], sum.volume += P.mass[p] / P.rho[p];
        sum.energy += P.mass[p] * P.energy[p];
        sum.px += P.mass[p] * P.vx[p], sum.py += P.mass[p] * P.vy[p];
      });
      for (std::size_t c = 0; c < sums_.size(); ++c) {
        if (sums_[c].own > sums_[c].largest) sums_[c].largest = sums_[c].own, cells.body[c] = static_cast<int>(b);
        sums_[c].own = 0;
      }
    }
    for (std::size_t c = 0; c < sums_.size(); ++c) {
      const Sums& sum = sums_[c];
      if (sum.mass == 0) continue;
      const double x = sum.px / sum.mass, y = sum.py / sum.mass, across = k < 2 ? x : y;
      cells.density[c] = sum.mass / sum.volume, cells.pressure[c] = gm1_ * sum.energy / sum.volume;
      cells.across[c] = low(k) ? across : -across, cells.along[c] = k < 2 ? y : x;
    }
  }
  find_gas_on_edges();
}

EdgeGas Strips::outside(std::size_t k, const EdgeGas& inside) const {
  const Edge& edge = edges_.of[k];
  const double pressure = gm1_ * edge.density * edge.energy;
  if (edge.kind == EdgeKind::outflow) return {edge.density, inside.across, inside.along, pressure};
  const double across = k < 2 ? edge.u : edge.v;
  return {edge.density, low(k) ? across : -across, k < 2 ? edge.v : edge.u, pressure};
}

void Strips::find_gas_on_edges() {
  for (std::size_t k = 0; k < 4; ++k) {
    Cells& cells = cells_[k];
    for (std::size_t c = 0; c < cells.body.size(); ++c) {
      const EdgeGas inside{cells.density[c], cells.across[c], cells.along[c], cells.pressure[c]};
      cells.on_edge[c] = gas_on_edge(edges_.of[k], outside(k, inside), inside, 1 + gm1_);
    }
  }
}

/// Linear between the middles of cells, where both have gas.
EdgeGas Strips::on_edge(std::size_t k, double along) const {
  const Cells& cells = cells_[k];
  const std::size_t here = cell_of(k, along);
  const double place = (along - first_along(k)) / cell_along(k) - (static_cast<double>(here) + 0.5);
  const std::size_t next = place < 0 ? (here == 0 ? here : here - 1) : std::min(here + 1, cells.body.size() - 1);
  const EdgeGas &a = cells.on_edge[here], &b = cells.on_edge[next];
  if (next == here || !(a.density > 0) || !(b.density > 0)) return a;
  const double s = std::min(1.0, std::abs(place));
  const auto mean = [s](double of_a, double of_b) { return of_a + s * (of_b - of_a); };
  return {mean(a.density, b.density), mean(a.across, b.across), mean(a.along, b.along), mean(a.pressure, b.pressure)};
}

/// A point's energy makes the pressure on the edge. Where splines find the density at the nodes and the stress comes
/// first, as in the robust set, it does so with that density; else it is the energy on the edge itself. For by linear
/// shape functions nodes feel V_p p = m_p (gamma - 1) i, in which the density drops out: a strip whose V_p p followed
/// the pressure on the edge would be gamma / (gamma - 1) times as stiff as the gas before it, and pump. Motions would
/// grow by 0.3 to 0.5 c / dx, out of rounding.
StepFindings Strips::set_strips(const BodyPoints& bodies, const Scene& scene) const {
  StepFindings found;
  Points& P = bodies.points;
  const bool robust = scene.method.kernel == Kernel::bspline && scene.method.order == StressOrder::usf;
  for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
    const auto* law = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!law) continue;
    found = find_at_points(bodies.ranges[b], found, [&](std::size_t p, StepFindings& sum) {
      const int edge = edge_of(P.x[p], P.y[p]);
      if (edge == inside_) return;
      const auto k = static_cast<std::size_t>(edge % corner_);
      const EdgeGas gas = on_edge(k, k < 2 ? P.y[p] : P.x[p]);
      const double across = low(k) ? gas.across : -gas.across;
      P.vx[p] = k < 2 ? across : gas.along, P.vy[p] = k < 2 ? gas.along : across;
      P.vxx[p] = P.vyx[p] = P.vxy[p] = P.vyy[p] = 0;
      const bool by_nodes = law->rule == DensityRule::grid && robust;
      const bool fresh = edges_.of[k].kind == EdgeKind::inflow && gas.across > 0;
      const bool whole = -inward(k, P.x[p], P.y[p]) < whole_cells * cell_across(k);
      const double density = by_nodes && whole && !fresh ? P.rho[p] : gas.density;
      P.energy[p] = density > 0 ? gas.pressure / (gm1_ * density) : 0;
      const double pressure = by_nodes ? gas.pressure : gm1_ * P.rho[p] * P.energy[p];
      P.sxx[p] = P.syy[p] = -pressure, P.sxy[p] = 0;
      if (geometry_ == Geometry::axisymmetric) P.szz[p] = -pressure;
      const double c_squared = law->sound_speed_squared(P.energy[p]);
      sum.c_squared_max = std::max(sum.c_squared_max, c_squared);
      sum.wave_max = std::max(sum.wave_max, std::sqrt(c_squared) + std::hypot(P.vx[p], P.vy[p]));
    });
  }
  return found;
}

}  // namespace tether::mpm
