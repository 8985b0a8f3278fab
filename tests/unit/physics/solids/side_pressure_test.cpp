// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/side_pressure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "physics/solids/make_elements.hpp"
#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

// A pressure that follows the sides that it pushes against.

namespace tether::fem {
namespace {

using namespace support;

constexpr std::array rules{StressAt::gradient, StressAt::middle, StressAt::end};

std::vector<Solids> blocks_of_every_kind() {
  std::vector<Solids> all;
  for (const ElementRow& row : element_rows)
    all.push_back(skew_block({row.kind, Dilatation::point}, neo_hookean(), {2, 2, 2}));
  return all;
}

std::vector<double> forces(const SidePressure& pressure, StressAt rule, std::span<const double> q0,
                           std::span<const double> q1) {
  std::vector<double> f(q0.size(), 0.0);
  pressure.add_forces(rule, q0, q1, 1, f);
  return f;
}

/// int x . n da / dim over the boundary, by the forces of a pressure there.
double volume_of(const Solids& solids, const SidePressure& pressure, std::span<const double> q) {
  const std::vector<double> f = forces(pressure, StressAt::end, q, q);
  double volume = 0;
  for (std::size_t k = 0; k < f.size(); ++k) volume -= q[k] * f[k] / solids.mesh.dim();
  return volume;
}

/// Its work is the volume that the body gives up, however far it goes, if the force is the one between both shapes.
TEST(SidePressure, WorksByTheVolume) {
  for (const Solids& solids : blocks_of_every_kind()) {
    SCOPED_TRACE(element_name(solids.mesh.kind));
    const std::vector<double> q0 = shaken(solids.mesh, 1, 0.1), q1 = shaken(solids.mesh, 2, 0.1);
    const SidePressure pressure(solids.mesh, boundary_of(solids.mesh));
    const std::vector<double> f = forces(pressure, StressAt::gradient, q0, q1);
    double work = 0;
    for (std::size_t k = 0; k < f.size(); ++k) work += f[k] * (q1[k] - q0[k]);
    EXPECT_NEAR(work, volume_of(solids, pressure, q0) - volume_of(solids, pressure, q1), 1e-13);
    const double at_start = make_elements(solids, alone())->shape(solids.mesh.x).of_region[0];
    EXPECT_NEAR(volume_of(solids, pressure, solids.mesh.x), at_start, 1e-13);
  }
}

/// All around a body it has no sum and no moment.
TEST(SidePressure, AllAroundABodyIsInBalance) {
  for (const Solids& solids : blocks_of_every_kind()) {
    SCOPED_TRACE(element_name(solids.mesh.kind));
    const std::vector<double> q = shaken(solids.mesh, 3, 0.1);
    const std::vector<double> f = forces(SidePressure(solids.mesh, boundary_of(solids.mesh)), StressAt::end, q, q);
    const auto dim = static_cast<std::size_t>(solids.mesh.dim());
    for (std::size_t i = 0; i < dim; ++i) {
      double sum = 0, moment = 0;
      for (std::size_t n = 0; n < f.size(); n += dim) {
        const std::size_t j = (i + 1) % dim;
        sum += f[n + i], moment += q[n + i] * f[n + j] - q[n + j] * f[n + i];
      }
      EXPECT_NEAR(sum, 0, 1e-13);
      EXPECT_NEAR(moment, 0, 1e-13);
    }
  }
}

/// On one side of the shape at the start it is pressure times area, against the outward normal.
TEST(SidePressure, PushesAgainstTheSide) {
  for (const Solids& solids : blocks_of_every_kind()) {
    SCOPED_TRACE(element_name(solids.mesh.kind));
    const std::vector<double>& x = solids.mesh.x;
    const std::vector<double> f =
        forces(SidePressure(solids.mesh, solids.mesh.sides.at("1.right")), StressAt::end, x, x);
    const std::size_t dim = static_cast<std::size_t>(solids.mesh.dim());
    const double depth = dim == 3 ? 1.1 : 1;
    double fx = 0, fy = 0;
    for (std::size_t k = 0; k < f.size(); k += dim) fx += f[k], fy += f[k + 1];
    EXPECT_NEAR(fx, -depth * (1.4 - 0.3), 1e-13);
    EXPECT_NEAR(fy, depth * (2.2 - 2.0), 1e-13);
  }
}

/// The derivative of the force by central differences, which are exact: the force is of degree 1 or 2 in the places.
TEST(SidePressure, HasItsTangent) {
  for (const Solids& solids : blocks_of_every_kind()) {
    const Mesh& mesh = solids.mesh;
    const SidePressure pressure(mesh, mesh.sides.at("1.right"));
    const NodalPattern pattern(mesh.dim(), mesh.node_count(), mesh.nodes, node_count_of(mesh.kind));
    const std::vector<double> q0 = shaken(mesh, 4, 0.1), q1 = shaken(mesh, 5, 0.1), way = shaken(mesh, 6, 1);
    for (const StressAt rule : rules) {
      SCOPED_TRACE(element_name(mesh.kind));
      SparseMatrix K = pattern.matrix();
      pressure.add_tangent(rule, q0, q1, 1, pattern, K);
      std::vector<double> low = q1, high = q1, change(q1.size()), by_tangent(q1.size());
      for (std::size_t k = 0; k < q1.size(); ++k) {
        change[k] = way[k] - mesh.x[k];
        low[k] -= 0.5 * change[k], high[k] += 0.5 * change[k];
      }
      K.multiply(change, by_tangent);
      const std::vector<double> f0 = forces(pressure, rule, q0, low), f1 = forces(pressure, rule, q0, high);
      for (std::size_t k = 0; k < q1.size(); ++k) EXPECT_NEAR(f1[k] - f0[k], by_tangent[k], 1e-13);
    }
  }
}

}  // namespace
}  // namespace tether::fem
