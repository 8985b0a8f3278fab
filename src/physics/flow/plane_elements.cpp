// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/plane_elements.hpp"

#include <algorithm>

#include "grid/shapes.hpp"

namespace tether::fem {
namespace {

template <class Shapes>
PlanePoint point_of(const Vec<2>& s, double weight) {
  static_assert(std::size_t{Shapes::nodes} <= most_plane_nodes);
  PlanePoint at{s, weight, {}, {}};
  std::ranges::copy(Shapes::values(s), at.N.begin());
  const auto slopes = Shapes::gradients(s);
  for (std::size_t a = 0; 2 * a < slopes.size(); ++a) at.slopes[a] = {slopes[2 * a], slopes[2 * a + 1]};
  return at;
}

}  // namespace

PlanePoint plane_point(ElementKind kind, const Vec<2>& s) {
  return with_shapes<2>(kind, [&]<class Shapes>(const Shapes&) { return point_of<Shapes>(s, 0); });
}

PlaneShape plane_shape(ElementKind kind) {
  return with_shapes<2>(kind, []<class Shapes>(const Shapes&) {
    PlaneShape shape{std::size_t{Shapes::nodes}};
    for (int k = 0; k < Shapes::points; ++k)
      shape.points.push_back(point_of<Shapes>(Shapes::place(k), Shapes::weight(k)));
    for (int k = 0; k < Shapes::mass_points; ++k)
      shape.mass_points.push_back(point_of<Shapes>(Shapes::mass_place(k), Shapes::mass_weight(k)));
    return shape;
  });
}

std::vector<PlaneSidePoint> plane_side_points(ElementKind kind) {
  return with_shapes<2>(kind, []<class Shapes>(const Shapes&) {
    using Side = typename Shapes::Side;
    std::vector<PlaneSidePoint> points;
    for (int k = 0; k < Side::points; ++k) {
      const auto slopes = Side::gradients(Side::place(k));
      points.push_back({Side::place(k)[0], Side::weight(k), {slopes.begin(), slopes.end()}});
    }
    return points;
  });
}

PlaneVectors gathered(const Mesh& mesh, std::size_t e, std::span<const double> numbers) {
  PlaneVectors of_nodes;
  for (int a = 0; a < node_count_of(mesh.kind); ++a) {
    const double* of_node = &numbers[2 * at(mesh.element(e)[a])];
    of_nodes[at(a)] = {of_node[0], of_node[1]};
  }
  return of_nodes;
}

PlaneMap plane_map(std::size_t nodes, const PlaneVectors& places, const PlanePoint& point) {
  Values<4> J{};  // dx_i / ds_j
  for (std::size_t a = 0; a < nodes; ++a) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) J[2 * i + j] += places[a][i] * point.slopes[a][j];
    }
  }
  PlaneMap map;
  map.determinant = invert(J);
  map.to_reference = {{{J[0], J[1]}, {J[2], J[3]}}};
  for (std::size_t a = 0; a < nodes; ++a) {
    const Vec<2>& S = point.slopes[a];
    map.gradients[a] = {S[0] * J[0] + S[1] * J[2], S[0] * J[1] + S[1] * J[3]};
  }
  return map;
}

}  // namespace tether::fem
