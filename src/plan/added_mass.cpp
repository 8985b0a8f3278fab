// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/added_mass.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/ways_across.hpp"
#include "model/coupled.hpp"
#include "model/solids.hpp"

namespace tether {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Length or area of a side, by its facets.
double area_of_side(const Mesh& mesh, const int* side) {
  const int edges = mesh.dim() - 1;
  double area = 0;
  for (const auto& facet : facets_of_side(mesh.kind)) {
    Eigen::MatrixXd e(mesh.dim(), edges);
    for (int a = 0; a < edges; ++a) {
      for (int i = 0; i < mesh.dim(); ++i)
        e(i, a) = mesh.x[at(side[facet[at(a + 1)]] * mesh.dim() + i)] - mesh.x[at(side[facet[0]] * mesh.dim() + i)];
    }
    area += std::sqrt((e.transpose() * e).determinant()) / edges;
  }
  return area;
}

/// A connected part of the mesh.
struct BodyOfMesh {
  Vec<3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  double mass = 0, surface_mass = 0, surface = 0;
  double modulus = infinity;  ///< the smallest of its regions [stress]
  double volume = 0;
};

/// Masses of the nodes, each element's shared equally among its own.
std::vector<double> masses_of(const Solids& solids, const std::vector<int>& part, std::vector<BodyOfMesh>& bodies) {
  const Mesh& mesh = solids.mesh;
  const int count = node_count_of(mesh.kind);
  std::vector<double> mass(mesh.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const SolidRegion& region = solids.regions[at(mesh.region[e])];
    BodyOfMesh& body = bodies[at(part[at(mesh.element(e)[0])])];
    const double volume = volume_of_element(mesh, e);
    body.volume += volume, body.mass += region.density * volume;
    body.modulus = std::min(body.modulus, std::visit([](const auto& law) { return law.stiffness(); }, region.law));
    for (int a = 0; a < count; ++a) mass[at(mesh.element(e)[a])] += region.density * volume / count;
  }
  return mass;
}

/// Nodes that supports hold in all directions.
std::vector<bool> held_nodes(const Solids& solids) {
  const auto dim = at(solids.mesh.dim());
  std::vector<bool> fixed(solids.mesh.x.size(), false), held(solids.mesh.node_count(), true);
  for (const Support& support : solids.supports) {
    for (const int node : support.nodes) {
      for (std::size_t i = 0; i < dim; ++i) fixed[at(node) * dim + i] = fixed[at(node) * dim + i] || support.fixed[i];
    }
  }
  for (std::size_t k = 0; k < fixed.size(); ++k) held[k / dim] = held[k / dim] && fixed[k];
  return held;
}

std::vector<BodyOfMesh> bodies_of(const Solids& solids) {
  const Mesh& mesh = solids.mesh;
  const std::vector<int> part = parts_of(mesh);
  std::vector<BodyOfMesh> bodies(at(count_parts(mesh)));
  std::vector<double> mass = masses_of(solids, part, bodies);
  const std::vector<bool> held = held_nodes(solids);
  const Sides boundary = boundary_of(mesh);
  const int per_side = side_node_count_of(mesh.kind);
  for (std::size_t s = 0; s < boundary.size(); s += at(per_side)) {
    const int* side = &boundary[s];
    if (std::all_of(side, side + per_side, [&](int n) { return held[at(n)]; })) continue;
    BodyOfMesh& body = bodies[at(part[at(side[0])])];
    body.surface += area_of_side(mesh, side);
    for (int a = 0; a < per_side; ++a) body.surface_mass += std::exchange(mass[at(side[a])], 0.0);
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    for (int i = 0; i < mesh.dim() && part[n] >= 0; ++i) {
      BodyOfMesh& body = bodies[at(part[n])];
      const double x = mesh.x[n * at(mesh.dim()) + at(i)];
      body.low[at(i)] = std::min(body.low[at(i)], x), body.high[at(i)] = std::max(body.high[at(i)], x);
    }
  }
  return bodies;
}

/// The box's cross-section across an axis, per unit depth in the plane.
double section(const StaggeredGrid& grid, int axis) {
  double area = 1;
  for (int i = 0; i < grid.dim; ++i) area *= i == axis ? 1 : grid.high(i) - grid.low[at(i)];
  return area;
}

/// D/A of the way to the nearest opening, infinite where there is none [length/area].
double way_out(const Coupled& coupled, const BodyOfMesh& body) {
  const StaggeredGrid& grid = coupled.grid;
  double least = infinity;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto i = at(axis);
    const auto consider = [&](double gap) { least = std::min(least, std::max(gap, grid.d[i]) / section(grid, axis)); };
    if (!is_wall(coupled.sides[2 * i])) consider(body.low[i] - grid.low[i]);
    if (!is_wall(coupled.sides[2 * i + 1])) consider(grid.high(axis) - body.high[i]);
  }
  for (const Box<3>& empty : coupled.voids) {
    int across = 0;
    double gap = -infinity;
    for (int axis = 0; axis < grid.dim; ++axis) {
      const double beside =
          std::max(empty.low[at(axis)] - body.high[at(axis)], body.low[at(axis)] - empty.high[at(axis)]);
      if (beside > gap) gap = beside, across = axis;
    }
    least = std::min(least, std::max(gap, grid.d[at(across)]) / section(grid, across));
  }
  return least;
}

/// A flat plate's, of the body's two greatest extents.
double added_broadside(double density, const BodyOfMesh& body, int dim) {
  Vec<3> extent{};
  for (std::size_t i = 0; i < at(dim); ++i) extent[i] = body.high[i] - body.low[i];
  std::sort(extent.rbegin(), extent.rend());
  const double chord = dim == 2 ? extent[0] : extent[1], length = dim == 2 ? 1 : extent[0];
  return density * std::numbers::pi / 4 * chord * chord * length;
}

/// Adds what resists in a step: a mass, and damping and stiffness over it.
void add_resistance(const Scene& scene, double mass, double damping, double stiffness, SplittingEstimate& estimate) {
  const double h = scene.clock.tstep;
  const bool paper = scene.coupled()->integrator == CoupledIntegrator::paper;
  estimate.mass = mass;
  estimate.damping = paper ? damping * h / 2 : 0;
  estimate.inertia = mass + (paper ? damping * h + stiffness * h * h / 4 : damping * h / 2);
}

SplittingEstimate broadside(const Scene& scene, const BodyOfMesh& body) {
  SplittingEstimate estimate;
  estimate.added = added_broadside(scene.coupled()->density, body, scene.coupled()->grid.dim);
  add_resistance(scene, body.mass, scene.solids()->alpha * body.mass, 0, estimate);
  return estimate;
}

/// The surface's nodes stand for a layer of half an element; strain is over a whole one. Of masses shared equally among
/// nodes a surface feels 1/sqrt(3) when the nodes further in give way, as in a chain of linear elements.
SplittingEstimate swelling(const Scene& scene, const BodyOfMesh& body) {
  const Solids& solids = *scene.solids();
  SplittingEstimate estimate;
  estimate.motion = BodyMotion::swelling;
  estimate.added = scene.coupled()->density * body.surface * body.surface * way_out(*scene.coupled(), body);
  const double layer = 2 * body.surface_mass / (body.mass / body.volume * body.surface);
  const double stiffness = body.modulus * body.surface / layer, mass = body.surface_mass / std::numbers::sqrt3;
  add_resistance(scene, mass, solids.alpha * mass + solids.beta * stiffness, stiffness, estimate);
  return estimate;
}

}  // namespace

std::optional<SplittingEstimate> splitting_estimate(const Scene& scene) {
  if (!scene.solids()) return std::nullopt;
  std::optional<SplittingEstimate> worst;
  int number = 0;
  for (const BodyOfMesh& body : bodies_of(*scene.solids())) {
    ++number;
    for (SplittingEstimate estimate : {broadside(scene, body), swelling(scene, body)}) {
      // The repair of areas takes the outflow of a closed region out of splitting's wall velocities.
      if (std::isinf(estimate.added) && scene.coupled()->area_repair) continue;
      estimate.body = number;
      if (!worst || estimate.added * worst->resists() > worst->added * estimate.resists()) worst = estimate;
    }
  }
  return worst;
}

std::string estimate_text(const SplittingEstimate& estimate) {
  const std::string motion = estimate.motion == BodyMotion::broadside
                                 ? fmt::format("body {} as a whole", estimate.body)
                                 : fmt::format("body {}'s surface outwards", estimate.body);
  if (std::isinf(estimate.added)) return fmt::format("moving {}, fluid has no way out", motion);
  const std::string mass = fmt::format("moving {}, the added mass {:.3g} is {} m + c h/2 = {:.3g}", motion,
                                       estimate.added, estimate.holds() ? "below" : "above", estimate.resists());
  return estimate.holds() ? mass
                          : fmt::format("{}, and errors grow about {:.3g} times a step", mass, estimate.growth());
}

}  // namespace tether
