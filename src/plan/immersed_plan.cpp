// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/immersed_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.hpp"
#include "grid/point_finder.hpp"

namespace tether {
namespace {

/// Distance of nodes over the fluid's from which it is reported. Of a flap of one biquadratic element across the tip's
/// way, over that at 1.0, is .99 at 1.5, .77 at 1.74, .63 at 1.78, .30 at 2.05.
constexpr double told_ratio = 1.7;

std::array<double, 2> place(const Mesh& mesh, int n) { return {mesh.x[2 * at(n)], mesh.x[2 * at(n) + 1]}; }

/// An edge of an element from corner to corner.
using Edge = std::array<double, 2>;

std::array<Edge, 4> edges_of(const Mesh& mesh, std::size_t e) {
  const int order = order_of(mesh.kind), row = order * (order + 1);
  const std::array<int, 4> box{0, order, row + order, row}, simplex{0, 1, 2, 0};
  const auto& corners = is_simplex(mesh.kind) ? simplex : box;
  std::array<Edge, 4> edges;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto a = place(mesh, mesh.element(e)[corners[k]]), b = place(mesh, mesh.element(e)[corners[(k + 1) % 4]]);
    edges[k] = {b[0] - a[0], b[1] - a[1]};
  }
  return edges;
}

double length_of(const Edge& edge) { return std::hypot(edge[0], edge[1]); }

/// How long a quadrilateral is along an edge of another element: by its mean sides a and b, of which the edge is s a +
/// t b, the length over |(s, t)|.
double length_along(const std::array<Edge, 4>& sides, const Edge& edge) {
  const Edge a{0.5 * (sides[0][0] - sides[2][0]), 0.5 * (sides[0][1] - sides[2][1])};
  const Edge b{0.5 * (sides[1][0] - sides[3][0]), 0.5 * (sides[1][1] - sides[3][1])};
  const double area = a[0] * b[1] - a[1] * b[0];
  const double s = (edge[0] * b[1] - edge[1] * b[0]) / area, t = (a[0] * edge[1] - a[1] * edge[0]) / area;
  return length_of(edge) / std::hypot(s, t);
}

std::array<double, 2> middle(const Mesh& mesh, std::size_t e) {
  const int count = node_count_of(mesh.kind);
  std::array<double, 2> sum{};
  for (int a = 0; a < count; ++a) {
    for (std::size_t i = 0; i < 2; ++i) sum[i] += place(mesh, mesh.element(e)[a])[i] / count;
  }
  return sum;
}

}  // namespace

ImmersedSpacing coarsest_spacing(const Flow& flow, const Solids& solids) {
  const PointFinder finder(flow.mesh);
  ImmersedSpacing worst;
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    const auto found = finder.find(middle(solids.mesh, e));
    if (!found) continue;
    const auto sides = edges_of(flow.mesh, at(found->element));
    for (const Edge& edge : edges_of(solids.mesh, e)) {
      if (length_of(edge) == 0) continue;
      const ImmersedSpacing here{solids.mesh.region[e], length_of(edge) / order_of(solids.mesh.kind),
                                 length_along(sides, edge) / order_of(flow.mesh.kind)};
      if (here.ratio() > worst.ratio()) worst = here;
    }
  }
  return worst;
}

std::string immersed_warning(const Flow& flow, const Solids& solids) {
  const ImmersedSpacing worst = coarsest_spacing(flow, solids);
  if (worst.ratio() <= told_ratio) return "";
  const int of_solid = order_of(solids.mesh.kind), of_fluid = order_of(flow.mesh.kind);
  return fmt::format(
      "{}: its {} elements are up to {:.3g} long in a fluid of elements {:.3g} long there, their nodes {:.3g} times as "
      "far apart as the fluid's: the fluid goes through between them and the body moves too little; elements of {:.3g} "
      "or less stop it",
      solids.regions[at(worst.region)].name, element_name(solids.mesh.kind), of_solid * worst.of_solid,
      of_fluid * worst.of_fluid, worst.ratio(), of_solid * worst.of_fluid);
}

}  // namespace tether
