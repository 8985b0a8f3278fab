// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/make_elements.hpp"

#include "physics/solids/elements_dilatation.hpp"
#include "physics/solids/elements_fields.hpp"
#include "physics/solids/elements_forces.hpp"
#include "physics/solids/elements_integrals.hpp"

namespace tether::fem {
namespace {

/// Length or area of a side of the reference shape by its map's derivative at s.
template <class Side>
double side_measure(const Mesh& mesh, const int* side, const std::array<double, Side::dim>& s) {
  const auto G = Side::gradients(s);
  const auto dim = static_cast<std::size_t>(mesh.dim());
  Eigen::Matrix<double, 3, Side::dim> tangents = Eigen::Matrix<double, 3, Side::dim>::Zero();
  for (int a = 0; a < Side::nodes; ++a) {
    for (std::size_t i = 0; i < dim; ++i) {
      for (int k = 0; k < Side::dim; ++k) {
        tangents(static_cast<int>(i), k) += mesh.x[static_cast<std::size_t>(side[a]) * dim + i] *
                                            G[static_cast<std::size_t>(a) * Side::dim + static_cast<std::size_t>(k)];
      }
    }
  }
  return std::sqrt((tangents.transpose() * tangents).determinant());
}

}  // namespace

std::unique_ptr<Elements> make_elements(const Solids& solids, Team& team) {
  return with_shapes(solids.mesh.kind, [&](auto shapes) -> std::unique_ptr<Elements> {
    using Shapes = decltype(shapes);
    return std::make_unique<ElementsOfShape<Shapes::dim>>(table_of<Shapes>(), solids, team);
  });
}

std::vector<double> side_areas(const Mesh& mesh, const Sides& sides) {
  std::vector<double> areas(mesh.node_count(), 0.0);
  with_shapes(mesh.kind, [&](auto shapes) {
    using Side = typename decltype(shapes)::Side;
    for (std::size_t first = 0; first < sides.size(); first += static_cast<std::size_t>(Side::nodes)) {
      for (int k = 0; k < Side::mass_points; ++k) {
        const auto s = Side::mass_place(k);
        const auto N = Side::values(s);
        const double area = Side::mass_weight(k) * side_measure<Side>(mesh, &sides[first], s);
        for (std::size_t a = 0; a < N.size(); ++a) areas[static_cast<std::size_t>(sides[first + a])] += area * N[a];
      }
    }
  });
  return areas;
}

std::vector<double> load_parts(const Load& load, const Mesh& mesh, const Elements& elements) {
  if (load.region >= 0) return elements.volumes(load.region);
  std::vector<double> parts = side_areas(mesh, load.sides);
  for (const int node : load.nodes) parts[static_cast<std::size_t>(node)] = 1;
  return parts;
}

}  // namespace tether::fem
