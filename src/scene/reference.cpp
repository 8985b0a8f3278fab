// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reference.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tether {
namespace {

template <class Law>
auto count_bodies(const Scene& scene) {
  return std::count_if(scene.bodies.begin(), scene.bodies.end(),
                       [](const Body& body) { return std::holds_alternative<Law>(body.material); });
}

/// Whether the point tracked last is the last of the string: the mass.
bool tracks_its_end(const Scene& scene, const Body& string) {
  return !scene.tracked.empty() && scene.tracked.back() == string.first + string.count - 1;
}

bool begins_at_rest(const Scene& scene, const Body& string) {
  for (std::size_t p = string.first; p < string.first + string.count; ++p) {
    if (scene.points.vx[p] != 0 || scene.points.vy[p] != 0) return false;
  }
  return true;
}

/// What the scene lacks for the solution; empty where it has all.
std::string lacks(ReferenceKind kind, const Scene& scene) {
  const Body* string = count_bodies<Uniaxial>(scene) == 1 ? find_body<Uniaxial>(scene) : nullptr;
  const bool tracked = string && tracks_its_end(scene, *string);
  switch (kind) {
    case ReferenceKind::riemann:
      return count_bodies<IdealGas>(scene) == 2 && scene.bodies.size() == 2
                 ? ""
                 : "two regions of gas, left and right, and nothing else";
    case ReferenceKind::spring:
    case ReferenceKind::string:
    case ReferenceKind::pendulum:
      return tracked && begins_at_rest(scene, *string) && scene.gravity < 0
                 ? ""
                 : "a string from a particle file that begins at rest, its last point tracked, and gravc < 0";
    case ReferenceKind::piston:
      return tracked && count_bodies<LinearFluid>(scene) == 1
                 ? ""
                 : "a linear fluid, a spring from a particle file, its last point tracked";
    case ReferenceKind::none:
      break;
  }
  return "";
}

}  // namespace

ReferenceKind reference_kind(const std::string& name) {
  return name == "riemann"    ? ReferenceKind::riemann
         : name == "spring"   ? ReferenceKind::spring
         : name == "string"   ? ReferenceKind::string
         : name == "pendulum" ? ReferenceKind::pendulum
         : name == "piston"   ? ReferenceKind::piston
                              : ReferenceKind::none;
}

ReferenceKind reference_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const std::string name = deck.text("reference", "solution");
  const ReferenceKind kind = reference_kind(name);
  const std::string missing = lacks(kind, scene);
  if (!missing.empty() && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark(Severity::error, "reference", "solution", {1, 1},
                                fmt::format("the solution '{}' needs {}", name, missing),
                                "leave $reference out, or complete the deck"));
  }
  return kind;
}

}  // namespace tether
