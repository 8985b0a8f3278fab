// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hung_string.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "model/bars.hpp"

namespace tether {
namespace {

/// The fluid's rows of points lie half a spacing inside its ends; its area is its volume over its length.
struct FluidColumn {
  double length, area;

  FluidColumn(const Scene& scene, const Body& fluid) {
    const PointSet& P = scene.points;
    std::set<double> rows;
    double volume = 0;
    for (std::size_t p = fluid.first; p < fluid.first + fluid.count; ++p) {
      rows.insert(P.y[p]);
      volume += P.volume[p];
    }
    const double n = static_cast<double>(rows.size());
    length = (*rows.rbegin() - *rows.begin()) * n / (n - 1);
    area = volume / length;
  }
};

}  // namespace

HungString hung_string(const Scene& scene) {
  const Body& body = *find_body<Membrane>(scene);
  const PointSet& P = scene.points;
  const double E = std::get<Membrane>(body.material).E;
  const std::size_t first = body.first, last = body.first + body.count - 1;
  const std::size_t inner = body.count > 2 ? first + 1 : first;  // a pinned end may stand for half a piece
  const auto end = held_end(scene, body);
  HungString string;
  string.x = end ? end->x : P.x[first], string.y = end ? end->y : P.y[first];
  string.length = std::hypot(P.x[last] - string.x, P.y[last] - string.y);
  const double spacing =
      std::hypot(P.x[last] - P.x[first], P.y[last] - P.y[first]) / static_cast<double>(body.count - 1);
  string.stiffness = E * P.volume[inner] / spacing / string.length;
  string.mass = P.mass[last];
  string.string_mass = P.mass[inner] / spacing * string.length;
  for (std::size_t p = first; p <= last; ++p) string.slack += spacing * std::max(0.0, -(P.sxx[p] + P.syy[p]) / E);
  return string;
}

SpringMass spring_of(const Scene& scene) {
  const HungString string = hung_string(scene);
  return {string.mass, string.stiffness, -scene.gravity, string.string_mass};
}

StringBounce string_bounce_of(const Scene& scene) {
  const HungString string = hung_string(scene);
  return {string.mass, string.stiffness, -scene.gravity, string.slack};
}

Pendulum pendulum_of(const Scene& scene) {
  const HungString string = hung_string(scene);
  const Body& body = *find_body<Membrane>(scene);
  const std::size_t last = body.first + body.count - 1;
  return {.length = string.length,
          .gravity = -scene.gravity,
          .start_angle = std::atan2(scene.points.x[last] - string.x, string.y - scene.points.y[last]),
          .string_part = string.string_mass / string.mass,
          .stretch = string.mass * -scene.gravity / (string.stiffness * string.length)};
}

Piston piston_of(const Scene& scene) {
  const HungString spring = hung_string(scene);
  const Body& fluid = *find_body<LinearFluid>(scene);
  const FluidColumn column(scene, fluid);
  return {.mass = spring.mass,
          .spring_stiffness = spring.stiffness,
          .area = column.area,
          .fluid_length = column.length,
          .fluid_density = fluid.density,
          .bulk_modulus = std::get<LinearFluid>(fluid.material).beta};
}

}  // namespace tether
