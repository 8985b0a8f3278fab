// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "algebra/krylov.hpp"
#include "algebra/two_level.hpp"
#include "loops/thread_team.hpp"
#include "unit/physics/box/mesh_support.hpp"

// A fluid on tetrahedra about bodies, in the unit cube.

namespace tether::coupled {
namespace {

using support::Flowing, support::box_of;
using Values = std::vector<double>;

/// At rest pressures balance gravity to the last digits, and hold a body by the weight of the fluid that it displaces.
TEST(SpaceMesh, RestsAndFloats) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Values at = support::random_numbers(4, seed);
    const Mesh body =
        support::solid_block(3, 2, {0.5 + 0.1 * at[0], 0.5 + 0.1 * at[1], 0.5 + 0.1 * at[2]}, 0.3, 2 * at[3]);
    const Vec<3> gravity{0.3, -0.8, 0};
    Flowing flowing(box_of(0.17, 3), body, gravity);
    flowing.flow.add_forces({}, 1, flowing.state.v);
    const Values p = flowing.project();
    EXPECT_LT(flowing.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-11) << seed;
    const Values force = support::transposed_product(flowing.flow.map().B, p);
    const double volume = enclosed_volumes(flowing.surface, body.x)[0];
    for (std::size_t a = 0; a < 3; ++a) {
      double sum = 0;
      for (std::size_t k = a; k < force.size(); k += 3) sum += force[k];
      EXPECT_NEAR(sum, -volume * gravity[a], 1e-11) << seed;
    }
  }
}

/// Conjugate gradients with two levels find pressures in so many iterations; in films, too.
TEST(SpaceMesh, TwoLevelsFindPressuresSoon) {
  for (const double low : {0.2, 1e-2, 1e-3, 1e-4}) {
    for (const double size : {0.11, 0.068}) {
    const Mesh plate = support::lattice(3, {6, 2, 6}, support::all, [&](const Vec<3>& s) {
      return Vec<3>{0.2 + 0.6 * s[0], low + 0.12 * s[1], 0.2 + 0.6 * s[2]};
    });
    const Flowing flowing(box_of(size, 3), plate);
    const SparseMatrix L = flowing.flow.pressure_matrix(1);
    SymmetricRows rows = rows_of(L);
    rows.diagonal[0] *= 2;
    ThreadTeam team(1);
    TwoLevelPreconditioner levels;
    ASSERT_TRUE(levels.set_up(rows, *flowing.flow.coarse_pressures()));
    Values r = support::random_numbers(static_cast<std::size_t>(L.n), 3), x(r.size(), 0.0);
    const KrylovResult result = pcg(
        team, [&](std::span<const double> v, std::span<double> y) { rows.multiply(team, v, y); },
        [&](std::span<const double> v, std::span<double> z) { levels.precondition(v, z); }, r, x, 1e-8, 300);
    printf("gap %g size %g cells %zu iterations %d stiff %zu\n", low, size, flowing.mesh().cells(), result.iterations, flowing.flow.coarse_pressures()->stiff.size());
    EXPECT_LE(result.iterations, 45) << low;
    }
  }
}

}  // namespace
}  // namespace tether::coupled
