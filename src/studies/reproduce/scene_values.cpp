// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/scene_values.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/hung_string.hpp"
#include "reference/riemann_tube.hpp"

namespace tether::published {
namespace {

struct SceneValue {
  const char* name;
  double (*of)(const Scene& scene);
};

RiemannSolution tube(const Scene& scene) { return riemann_tube(scene).solution; }

/// Mass through the shock: rho1 s = rho2 (s - u).
double shock_speed(const Scene& scene) {
  const RiemannSolution solution = tube(scene);
  const StarRegion& star = solution.star;
  return star.density_right * star.velocity / (star.density_right - solution.problem.right.density);
}

/// E A over what is between a string's first and last point, as 5.5.2 of the thesis counts it.
double stiffness_between_points(const Scene& scene) {
  const HungString string = hung_string(scene);
  const PointSet& P = scene.points;
  return string.stiffness * string.length / std::hypot(P.x.back() - P.x.front(), P.y.back() - P.y.front());
}

/// E A over what is between the wall and the fluid, the spring's length in Fig. 45 of the thesis.
double stiffness_beyond_fluid(const Scene& scene) {
  const Piston piston = piston_of(scene);
  return piston.spring_stiffness * hung_string(scene).length / (scene.grid.y1 - scene.grid.y0 - piston.fluid_length);
}

double period_without_fluid(const Scene& scene) {
  const Piston piston = piston_of(scene);
  return 2 * std::numbers::pi * std::sqrt(piston.mass / piston.spring_stiffness);
}

constexpr std::array values{
    SceneValue{"shock_speed", shock_speed},
    SceneValue{"contact_speed", [](const Scene& scene) { return tube(scene).star.velocity; }},
    SceneValue{"shocked_density", [](const Scene& scene) { return tube(scene).star.density_right; }},
    SceneValue{"shocked_pressure", [](const Scene& scene) { return tube(scene).star.pressure; }},
    SceneValue{"right_density", [](const Scene& scene) { return tube(scene).problem.right.density; }},
    SceneValue{"right_pressure", [](const Scene& scene) { return tube(scene).problem.right.pressure; }},
    SceneValue{"diaphragm", [](const Scene& scene) { return tube(scene).problem.diaphragm; }},
    SceneValue{"string_slack", [](const Scene& scene) { return hung_string(scene).slack; }},
    SceneValue{"string_stiffness", stiffness_between_points},
    SceneValue{"piston_stiffness", stiffness_beyond_fluid},
    SceneValue{"piston_period", [](const Scene& scene) { return piston_of(scene).period(); }},
    SceneValue{"piston_frequency", [](const Scene& scene) { return piston_of(scene).frequency(); }},
    SceneValue{"piston_period_without_fluid", period_without_fluid},
};

struct Modulus {
  const Body& body;
  double operator()(const PlaneElastic& law) const { return law.E; }
  double operator()(const FiniteElastic& law) const { return law.E; }
  double operator()(const Membrane& law) const { return law.E; }
  double operator()(const LinearFluid& law) const { return law.beta; }
  double operator()(const IdealGas&) const { return body.specific_energy; }
};

}  // namespace

std::vector<std::string> scene_value_names() {
  std::vector<std::string> names;
  for (const SceneValue& value : values) names.emplace_back(value.name);
  return names;
}

double scene_value(const Scene& scene, const std::string& name) {
  for (const SceneValue& value : values) {
    if (name == value.name) return value.of(scene);
  }
  throw std::out_of_range(name);
}

double modulus_of(const Scene& scene, int body) {
  if (body < 1 || static_cast<std::size_t>(body) > scene.bodies.size()) return std::numeric_limits<double>::quiet_NaN();
  const Body& it = scene.bodies[static_cast<std::size_t>(body) - 1];
  return std::visit(Modulus{it}, it.material);
}

}  // namespace tether::published
