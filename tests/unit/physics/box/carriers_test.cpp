// SPDX-License-Identifier: GPL-3.0-or-later
// The map of bodies whose sides have more nodes than their facets: on a grid it is made of the element's own functions,
// on a mesh of its facets.
#include <gtest/gtest.h>

#include <cmath>

#include "grid/block_mesh.hpp"
#include "physics/solids/make_elements.hpp"
#include "unit/physics/box/bodies_support.hpp"
#include "unit/physics/box/mesh_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

class Carried : public testing::TestWithParam<ElementKind> {
 protected:
  int dim() const { return dimension_of(GetParam()); }
  /// A slanted block of 2 x 2 (x 2) elements, or of what these are parted into.
  Mesh block() const {
    const std::array<Vec<2>, 4> corners{{{0.3, 0.32}, {0.71, 0.28}, {0.74, 0.66}, {0.33, 0.7}}};
    Block block;
    for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
    block.cells = {2, 2, 2};
    block.z_low = 0.31, block.z_high = 0.72;
    std::vector<MeshFlaw> flaws;
    return mesh_of_blocks({block}, GetParam(), flaws);
  }
  Surroundings about(const Mesh& mesh) const {
    Coupled coupled = fluid_in_box(dim(), dim() == 2 ? 20 : 12);
    coupled.coupling = coupling_of(CouplingMode::cut_cell);
    return Surroundings(coupled, mesh);
  }
};
INSTANTIATE_TEST_SUITE_P(Coupled, Carried,
                         testing::Values(ElementKind::quad4, ElementKind::quad9, ElementKind::tri3, ElementKind::tri6,
                                         ElementKind::hex8, ElementKind::hex27, ElementKind::tet4, ElementKind::tet10));

/// A place's parts of its carriers sum to one, and are those of the place.
TEST_P(Carried, PlacesAreTheirCarriersPlaces) {
  const Mesh mesh = block();
  const SolidSurface surface = surface_of(mesh);
  const Vec<3> share = dim() == 2 ? Vec<3>{0.3, 0.7, 0} : Vec<3>{0.2, 0.5, 0.3};
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const CarrierShares parts = surface.carried(s, share);
    Vec<3> by_nodes{}, by_carriers{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t a = 0; a < at(dim()); ++a)
        by_nodes[i] += share[a] * place_of(mesh.x, surface.side(s)[a], dim())[i];
      for (std::size_t a = 0; a < surface.carriers(s).size(); ++a)
        by_carriers[i] += parts[a] * place_of(mesh.x, surface.carriers(s)[a], dim())[i];
      EXPECT_NEAR(by_nodes[i], by_carriers[i], 1e-14);
    }
    for (const double part : parts) sum += part;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

/// Of a constant pressure on straight sides: on each node what its function has of the area. Points of quadrature that
/// are exact to order 2 on each piece do it to rounding, but for faces whose functions are of order 2 in both
/// directions.
TEST_P(Carried, AConstantPressurePressesByTheElementsOwnFunctions) {
  const Mesh mesh = block();
  const Surroundings here = about(mesh);
  const std::vector<double> forces = transposed_product(here.map.B, std::vector<double>(here.numbers.cell.size(), 3));
  std::vector<double> expected(mesh.x.size(), 0.0);
  const SolidSurface& surface = here.surface;
  for (std::size_t s = 0; s < surface.side_count(); s += surface.parting.size()) {
    Vec<3> normal = area_of_side(surface, s, mesh.x);
    const double size = std::sqrt(dot(normal, normal));
    const auto carriers = surface.carriers(s);
    const std::vector<double> areas = fem::side_areas(mesh, Sides(carriers.begin(), carriers.end()));
    for (const int node : carriers) {
      for (std::size_t i = 0; i < at(dim()); ++i)
        expected[at(node * dim()) + i] -= 3 * areas[at(node)] * normal[i] / size;
    }
  }
  const double within = GetParam() == ElementKind::hex27 ? 2e-6 : 1e-13;
  for (std::size_t k = 0; k < forces.size(); ++k) EXPECT_NEAR(forces[k], expected[k], within);
}

/// A field that is linear in the place makes the same flux into every cell, whatever carries it: that of the facets.
TEST_P(Carried, LinearFieldsMakeTheFluxOfTheFacets) {
  const Mesh mesh = block();
  const Surroundings here = about(mesh);
  std::vector<double> u(mesh.x.size());
  const auto d = at(dim());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const std::size_t node = k / d, i = k % d;
    u[k] = 0.4 + 0.3 * mesh.x[node * d + (i + 1) % d] - 0.2 * mesh.x[k];
  }
  const std::vector<double> flux = product(here.map.B, u);
  double sum = 0, rate = 0;
  for (const double value : flux) sum += value;
  for (std::size_t s = 0; s < here.surface.side_count(); ++s) {
    const Vec<3> area = area_of_side(here.surface, s, mesh.x);
    for (const int node : here.surface.side(s)) {
      for (std::size_t i = 0; i < d; ++i) rate += u[at(node) * d + i] * area[i] / dim();
    }
  }
  EXPECT_NEAR(sum, -rate, 1e-13);
}

/// On a mesh any motion of the nodes makes the flux by which the facets' volume changes, whatever sides do between
/// their nodes: else the volume term would act on another volume than it measures, and bodies could swell by it.
TEST_P(Carried, FluxesOnAMeshAreTheRateOfTheFacetsVolume) {
  const Mesh mesh = block();
  const Flowing here(box_of(0.2, dim()), mesh);
  const std::vector<double> u = random_numbers(mesh.x.size(), 3);
  double sum = 0;
  for (const double flux : product(here.flow.map().B, u)) sum += flux;
  const auto volume = [&](double time) {
    std::vector<double> q = mesh.x;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += time * u[k];
    return enclosed_volumes(here.surface, q)[0];
  };
  constexpr double h = 1e-5;
  EXPECT_NEAR(sum, -(volume(h) - volume(-h)) / (2 * h), 1e-8);
}

}  // namespace
}  // namespace tether::coupled
