// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "reference/thin_ring.hpp"
#include "results/compare_parts.hpp"

namespace tether {
namespace {

double distance(const PointSet& points, std::size_t p, std::size_t q) {
  return std::hypot(points.x[q] - points.x[p], points.y[q] - points.y[p]);
}

/// The membrane of a quarter: a chain of points between the bottom wall and the left one.
struct Chain {
  std::size_t first, last;           // in the scene
  std::size_t at_bottom, at_left;    // its ends
  double length = 0, thickness = 0;  // from wall to wall; of the points between the ends

  Chain(const Scene& scene, const Body& body) : first(body.first), last(body.first + body.count - 1) {
    const PointSet& P = scene.points;
    at_bottom = first, at_left = last;
    if (P.y[last] < P.y[first]) std::swap(at_bottom, at_left);
    for (std::size_t p = first; p < last; ++p) length += distance(P, p, p + 1);
    // A point between two others stands for half the way to either: its volume is thickness times that.
    const double between = length - (distance(P, first, first + 1) + distance(P, last - 1, last)) / 2;
    double volume = 0;
    for (std::size_t p = first + 1; p < last; ++p) volume += P.volume[p];
    thickness = volume / between;
    length += P.y[at_bottom] - scene.grid.y0 + P.x[at_left] - scene.grid.x0;
  }
};

ThinRing ring_of(const Scene& scene, const Body& body, const Chain& chain) {
  const auto& law = std::get<Membrane>(body.material);
  ThinRing ring{chain.length, chain.thickness, law.E, law.kind == Membrane::Kind::plane_stress ? law.nu : 0, 0, 0};
  for (const Body& gas : scene.bodies) {
    if (&gas == &body) continue;
    ring.gm1 = std::get<IdealGas>(gas.material).gm1;
    for (std::size_t p = gas.first; p < gas.first + gas.count; ++p) {
      ring.internal_energy += scene.points.mass[p] * gas.specific_energy;
    }
  }
  return ring;
}

double radius_of(const Scene& scene, const Snapshot& last, std::size_t p) {
  return std::hypot(values_of(last, "x")[p] - scene.grid.x0, values_of(last, "y")[p] - scene.grid.y0);
}

/// Mean over the gas points: one point's pressure scatters about it.
double mean_pressure(const Snapshot& last, const Chain& chain) {
  const auto& pressure = values_of(last, "pressure");
  double sum = 0, count = 0;
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (p < chain.first || p > chain.last) sum += pressure[p], count += 1;
  }
  return sum / count;
}

/// Mean over the membrane points of the stress along the tangent, the trace of sigma_1' t (x) t.
double mean_tangent_stress(const Snapshot& last, const Chain& chain) {
  const auto &sxx = values_of(last, "sxx"), &syy = values_of(last, "syy");
  double sum = 0;
  for (std::size_t p = chain.first; p <= chain.last; ++p) sum += sxx[p] + syy[p];
  return sum / static_cast<double>(chain.last - chain.first + 1);
}

}  // namespace

Comparison compare_thin_ring(const Scene& scene, const Snapshot& last) {
  const Body& body = *find_body<Membrane>(scene);
  const Chain chain(scene, body);
  const RingAtRest exact = ring_at_rest(ring_of(scene, body, chain));
  return {{relative_merit("radius_x", radius_of(scene, last, chain.at_bottom), exact.radius),
           relative_merit("radius_y", radius_of(scene, last, chain.at_left), exact.radius),
           relative_merit("pressure", mean_pressure(last, chain), exact.pressure),
           relative_merit("stress", mean_tangent_stress(last, chain), exact.hoop_stress)},
          {}};
}

}  // namespace tether
