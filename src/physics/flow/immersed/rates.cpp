// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/rates.hpp"

#include <algorithm>

#include "physics/flow/plane_elements.hpp"

namespace tether::fem {
namespace {

/// Of an element at a point of quadrature: values of its functions, place, dv/dt, and the volume at the start.
struct PointRate {
  const PlaneNumbers& N;
  Vec<2> place, acceleration;
  double weight = 0;
};

/// Calls f with each of them.
template <class Function>
void for_points(const Mesh& mesh, const PlaneShape& shape, std::size_t e, const BodyMotion& motion, const Function& f) {
  const PlaneVectors at_start = gathered(mesh, e, mesh.x), places = gathered(mesh, e, motion.places);
  const PlaneVectors velocities = gathered(mesh, e, motion.velocities), rates = gathered(mesh, e, motion.rates);
  for (const PlanePoint& at : shape.mass_points) {
    const PlaneVectors G = plane_map(shape.nodes, places, at).gradients;
    const Vec<2> u = mean(shape.nodes, at.N, velocities), rate = mean(shape.nodes, at.N, rates);
    const Vec<2> carried = product(slopes(shape.nodes, velocities, G), u);
    f(PointRate{at.N,
                mean(shape.nodes, at.N, places),
                {rate[0] + carried[0], rate[1] + carried[1]},
                plane_map(shape.nodes, at_start, at).determinant * at.weight});
  }
}

/// <grad N_A, sigma> of element e, whose first point of quadrature is the first of these stresses.
void add_stress(const Mesh& mesh, const PlaneShape& shape, std::size_t e, std::span<const double> x,
                const std::array<double, 3>* stress, std::span<double> f) {
  const PlaneVectors places = gathered(mesh, e, x);
  for (const PlanePoint& at : shape.points) {
    const PlaneMap map = plane_map(shape.nodes, places, at);
    const auto& [xx, yy, xy] = *stress++;
    const double volume = map.determinant * at.weight;
    for (std::size_t a = 0; a < shape.nodes; ++a) {
      const Vec<2>& G = map.gradients[a];
      double* to = &f[2 * static_cast<std::size_t>(mesh.element(e)[a])];
      to[0] += volume * (xx * G[0] + xy * G[1]), to[1] += volume * (xy * G[0] + yy * G[1]);
    }
  }
}

}  // namespace

std::vector<BodyRates> body_rates(const Mesh& mesh, const BodyMotion& motion) {
  std::vector<BodyRates> bodies(static_cast<std::size_t>(1 + *std::ranges::max_element(mesh.region)));
  const PlaneShape shape = plane_shape(mesh.kind);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    BodyRates& body = bodies[static_cast<std::size_t>(mesh.region[e])];
    for_points(mesh, shape, e, motion, [&](const PointRate& at) {
      body.volume += at.weight;
      for (std::size_t i = 0; i < 2; ++i) {
        body.centre[i] += at.weight * at.place[i];
        body.acceleration[i] += at.weight * at.acceleration[i];
      }
    });
  }
  for (BodyRates& body : bodies) {
    for (double& number : body.centre) number /= body.volume;
  }
  return bodies;
}

void add_body_inertia(const Mesh& mesh, const BodyMotion& motion, int region, double density, double gravity,
                      std::span<double> f) {
  const PlaneShape shape = plane_shape(mesh.kind);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.region[e] != region) continue;
    for_points(mesh, shape, e, motion, [&](const PointRate& at) {
      const double mass = density * at.weight;
      for (std::size_t a = 0; a < shape.nodes; ++a) {
        double* to = &f[2 * static_cast<std::size_t>(mesh.element(e)[a])];
        to[0] += mass * at.N[a] * at.acceleration[0], to[1] += mass * at.N[a] * (at.acceleration[1] - gravity);
      }
    });
  }
}

std::vector<Vec<2>> body_points(const Mesh& mesh, std::span<const double> x) {
  std::vector<Vec<2>> points;
  const PlaneShape shape = plane_shape(mesh.kind);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const PlaneVectors places = gathered(mesh, e, x);
    for (const PlanePoint& at : shape.points) points.push_back(mean(shape.nodes, at.N, places));
  }
  return points;
}

void add_body_stress(const Mesh& mesh, std::span<const double> x, int region,
                     std::span<const std::array<double, 3>> stress, std::span<double> f) {
  const PlaneShape shape = plane_shape(mesh.kind);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.region[e] == region) add_stress(mesh, shape, e, x, &stress[e * shape.points.size()], f);
  }
}

}  // namespace tether::fem
