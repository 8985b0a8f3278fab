// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tether {
namespace {

/// How much the second moment of a quarter of a cylinder, given as points, may be above that of the exact shape.
constexpr double roundness = 0.03;

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

/// Whether the scene is a quarter of one with the lower left corner as its centre, at rest, and nothing pulls at it.
bool is_resting_quarter(const Scene& scene) {
  const bool at_rest = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const Body& body) { return begins_at_rest(scene, body); });
  return scene.geometry == Geometry::plane && mirrors(scene.walls.left) && mirrors(scene.walls.bottom) && at_rest &&
         scene.gravity == 0;
}

/// Of all shapes of one area the disc has the least second moment, a quarter of one with R^2 = 4 A/pi: R^2/2 its area.
bool is_quarter_disc(const Scene& scene, const Body& body) {
  const PointSet& P = scene.points;
  double area = 0, moment = 0;
  for (std::size_t p = body.first; p < body.first + body.count; ++p) {
    const double x = P.x[p] - scene.grid.x0, y = P.y[p] - scene.grid.y0;
    area += P.volume[p], moment += P.volume[p] * (x * x + y * y);
  }
  return moment / area < (1 + roundness) * 2 * area / std::numbers::pi;
}

bool has_radial_gas(const Scene& scene) {
  if (scene.bodies.size() != 1 || count_bodies<IdealGas>(scene) != 1) return false;
  const Body& gas = scene.bodies.front();
  return std::get<IdealGas>(gas.material).mu == 0 && is_resting_quarter(scene) && is_quarter_disc(scene, gas);
}

/// Whether a membrane's ends are within a cell of the two axes, one of each, and nothing stretched it before.
bool spans_the_quarter(const Scene& scene, const Body& membrane) {
  const PointSet& P = scene.points;
  const std::size_t first = membrane.first, last = membrane.first + membrane.count - 1;
  const auto at_left = [&](std::size_t p) { return P.x[p] - scene.grid.x0 < scene.grid.dx; };
  const auto at_bottom = [&](std::size_t p) { return P.y[p] - scene.grid.y0 < scene.grid.dy; };
  for (std::size_t p = first; p <= last; ++p) {
    if (P.sxx[p] != 0 || P.syy[p] != 0 || P.sxy[p] != 0) return false;
  }
  return (at_left(first) && at_bottom(last)) || (at_bottom(first) && at_left(last));
}

bool has_thin_ring(const Scene& scene) {
  const auto gases = count_bodies<IdealGas>(scene);
  if (gases < 1 || count_bodies<Membrane>(scene) != 1 || scene.bodies.size() != static_cast<std::size_t>(gases) + 1) {
    return false;
  }
  return is_resting_quarter(scene) && spans_the_quarter(scene, *find_body<Membrane>(scene)) && scene.ambient == 0;
}

/// What the scene lacks for the solution; empty where it has all.
std::string lacks(ReferenceKind kind, const Scene& scene) {
  const Body* string = count_bodies<Membrane>(scene) == 1 ? find_body<Membrane>(scene) : nullptr;
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
    case ReferenceKind::radial_gas:
      return has_radial_gas(scene) ? ""
                                   : "a quarter of a cylinder of gas about the lower left corner, at rest and without "
                                     "viscosity, walls left and below that mirror, gravc = 0 and nothing else";
    case ReferenceKind::thin_ring:
      return has_thin_ring(scene)
                 ? ""
                 : "one unstressed membrane from the left to the bottom wall, both of which mirror, gas "
                   "inside, all at rest, gravc = 0, pambient = 0 and nothing else";
    case ReferenceKind::none:
      break;
  }
  return "";
}

}  // namespace

ReferenceKind reference_kind(const std::string& name) {
  return name == "riemann"      ? ReferenceKind::riemann
         : name == "spring"     ? ReferenceKind::spring
         : name == "string"     ? ReferenceKind::string
         : name == "pendulum"   ? ReferenceKind::pendulum
         : name == "piston"     ? ReferenceKind::piston
         : name == "radial-gas" ? ReferenceKind::radial_gas
         : name == "thin-ring"  ? ReferenceKind::thin_ring
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
