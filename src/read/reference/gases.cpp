// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "read/reference/reference.hpp"

namespace tether {
namespace {

/// How much the second moment of a quarter of a cylinder, given as points, may be above that of the exact shape.
constexpr double roundness = 0.03;

/// Returns whether the scene is a quarter of one with the lower left corner as its centre, at rest, and nothing pulls
/// at it.
bool is_resting_quarter(const Scene& scene) {
  const bool at_rest = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const Body& body) { return begins_at_rest(scene, body); });
  return scene.geometry == Geometry::plane && mirrors(scene.walls.left) && mirrors(scene.walls.bottom) && at_rest &&
         scene.gravity == 0;
}

/// Returns whether it is a quarter of a disc. Of all shapes of one area the disc has the least second moment, a quarter
/// of one with R^2 = 4 A/pi: R^2/2 its area.
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

/// Returns whether a membrane's ends are within a cell of the two axes, one of each, and nothing stretched it before.
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
  if (gases < 1 || count_bodies<Membrane>(scene) != 1 || scene.bodies.size() != gases + 1) return false;
  return is_resting_quarter(scene) && spans_the_quarter(scene, *find_body<Membrane>(scene)) && scene.ambient == 0;
}

bool is_one_kind_of_gas(const Scene& scene) {
  double gm1 = 0;
  for (const Body& body : scene.bodies) {
    const auto* gas = std::get_if<IdealGas>(&body.material);
    if (!gas) continue;
    if (gm1 != 0 && gas->gm1 != gm1) return false;
    gm1 = gas->gm1;
  }
  return true;
}

/// A region of the tube: a slab from the bottom to the top.
struct Slab {
  double low = 0, high = 0;  // ends in x, half a spacing outside its points [length]
  bool whole = false;        // its points' volume is that of the slab
  bool uniform = true;       // one velocity, along the tube

  Slab(const Scene& scene, const Body& body) {
    const PointSet& P = scene.points;
    std::set<double> columns;
    double volume = 0;
    for (std::size_t p = body.first; p < body.first + body.count; ++p) {
      columns.insert(P.x[p]);
      volume += P.volume[p];
      uniform = uniform && P.vy[p] == 0 && P.vx[p] == P.vx[body.first];
    }
    const double spacing =
        (*columns.rbegin() - *columns.begin()) / std::max(1.0, static_cast<double>(columns.size()) - 1);
    low = *columns.begin() - spacing / 2, high = *columns.rbegin() + spacing / 2;
    const double expected = (high - low) * (scene.grid.y1 - scene.grid.y0);
    whole = std::abs(volume - expected) < 0.02 * expected + scene.grid.dx * (scene.grid.y1 - scene.grid.y0);
  }
};

std::string lacks_of_slabs(const Scene& scene) {
  Slab left(scene, scene.bodies[0]), right(scene, scene.bodies[1]);
  if (left.low > right.low) std::swap(left, right);
  const double both = std::min(left.high, right.high) - right.low;
  const double narrower = std::min(left.high - left.low, right.high - right.low);
  if (both > std::min(scene.grid.dx, 0.5 * narrower)) {
    return fmt::format(
        "regions that lie side by side in x, one left of the other: here both are from x = {:.6g} to {:.6g}", right.low,
        right.low + both);
  }
  if (!left.uniform || !right.uniform) return "regions that move along the tube alone (vry = 0)";
  if (!left.whole || !right.whole) return "regions that fill the tube from the bottom wall to the top wall";
  if (std::abs(right.low - left.high) > scene.grid.dx) return "regions that meet: here they are a cell or more apart";
  return "";
}

}  // namespace

std::string lacks_for_riemann(const Scene& scene) {
  if (count_bodies<IdealGas>(scene) != 2 || scene.bodies.size() != 2) {
    return "two regions of gas, left and right, and nothing else";
  }
  if (scene.geometry != Geometry::plane) return "a plane tube, not one about an axis";
  if (scene.gravity != 0) return "gravc = 0";
  if (std::get<IdealGas>(scene.bodies[0].material).mu != 0) return "gas without viscosity (mu = 0)";
  if (!is_one_kind_of_gas(scene)) return "one gm1 for both gases";
  if (!mirrors(scene.walls.bottom) || !mirrors(scene.walls.top)) {
    return "a bottom and a top wall along which gas slips (wb and wt of 4 or 6)";
  }
  return lacks_of_slabs(scene);
}

std::string lacks_for_radial_gas(const Scene& scene) {
  return has_radial_gas(scene) ? ""
                               : "a quarter of a cylinder of gas about the lower left corner, at rest and without "
                                 "viscosity, walls left and below that mirror, gravc = 0 and nothing else";
}

std::string lacks_for_thin_ring(const Scene& scene) {
  if (!has_thin_ring(scene)) {
    return "one unstressed membrane from the left to the bottom wall, both of which mirror, gas "
           "inside, all at rest, gravc = 0, pambient = 0 and nothing else";
  }
  return is_one_kind_of_gas(scene) ? "" : "one gm1 for all gases";
}

}  // namespace tether
