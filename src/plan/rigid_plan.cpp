// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/rigid_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/rigid.hpp"

namespace tether {
namespace {

/// What a step costs on a machine of 2020's make; only for the estimate [s].
constexpr double seconds_per_reduced_step = 1.5e-6, seconds_per_constrained_step = 8e-6;

std::string text_of(const Eigen::Vector3d& place) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]);
}

std::string form_reason(const Rigid& rigid) {
  if (rigid.form == RigidForm::constrained)
    return fmt::format("six{}, with a multiplier each", rigid.pin ? " and three of the pin" : "");
  return fmt::format("in their null space: {} unknowns, no multipliers", rigid.unknowns());
}

std::string point_reason(const Rigid& rigid) {
  return rigid.point ? "reference point " + text_of(*rigid.point) : "reference point at the centre of mass";
}

bool is_orthonormal(const Eigen::Matrix3d& d) { return (d.transpose() * d).isIdentity(1e-12); }

/// "1 on sides or in volumes, 2 torques, 1 at points", or "" where nothing acts.
std::string loads_reason(const Solids& solids, const Rigid& rigid) {
  const auto turning = static_cast<std::size_t>(
      std::count_if(rigid.forces.begin(), rigid.forces.end(), [](const RigidForce& force) { return force.turning; }));
  std::string text;
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(solids.loads.size(), "dead on sides or in volumes");
  add(rigid.torques.size(), "by torques");
  add(rigid.forces.size() - turning, "dead at points");
  add(turning, "at points that turn with the body");
  return text;
}

}  // namespace

std::vector<Term> rigid_terms(const Scene& scene) {
  const Rigid& rigid = *scene.rigid();
  const Solids& solids = *scene.solids();
  const std::string loads = loads_reason(solids, rigid);
  const char* kind = is_orthonormal(rigid.directors) ? "orthonormal" : "skew";
  return {
      {"inertia", true, "of the mesh, as it turns; mid-point rule: keeps energy and momenta"},
      {"frame", true, fmt::format("{}, directors {}", point_reason(rigid), kind)},
      {"constraints", true, form_reason(rigid)},
      {"gravity", scene.gravity != 0,
       scene.gravity != 0 ? fmt::format("gravc = {:.6g} in y", scene.gravity) : "gravc = 0"},
      {"loads", !loads.empty(), loads.empty() ? "none given" : loads},
      {"pin", rigid.pin.has_value(), rigid.pin ? "at " + text_of(*rigid.pin) : "none given: the body is free"},
      {"strain", false, "the body is rigid: laws of its regions have no effect"},
      {"damping", false, "a rigid body has none"},
      {"contact", false, "bodies on a mesh do not meet, and walls do not stop them"},
      {"third dimension", true, "the body moves in space"},
  };
}

Cost rigid_cost(const Scene& scene, const StepRule& rule) {
  const bool reduced = scene.rigid()->form == RigidForm::reduced;
  Cost cost;
  cost.steps = std::ceil(scene.clock.tmax / rule.first_step() * (1 - 1e-9));
  cost.point_steps = cost.steps;
  cost.megabytes = 1e-6 * static_cast<double>(sizeof(double) * (20 * scene.solids()->mesh.x.size()));
  cost.seconds = cost.steps * (reduced ? seconds_per_reduced_step : seconds_per_constrained_step);
  return cost;
}

std::string rigid_head(const Scene& scene) {
  const Mesh& mesh = scene.solids()->mesh;
  std::string text =
      fmt::format("path: fem (rigid body)\nmesh: {} elements {}, {} nodes, for mass and shape\nunknowns: {}\n",
                  mesh.element_count(), element_name(mesh.kind), mesh.node_count(), scene.rigid()->unknowns());
  for (const SolidRegion& region : scene.solids()->regions)
    text += fmt::format("{}: density {:.4g}\n", region.name, region.density);
  return text;
}

}  // namespace tether
