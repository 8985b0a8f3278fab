// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "algebra/krylov.hpp"
#include "algebra/multigrid.hpp"
#include "loops/thread_team.hpp"
#include "unit/algebra/pressure_matrices.hpp"

namespace tether {
namespace {

struct Found {
  int iterations = 0;
  std::vector<double> x;
};

Found solve(Team& team, const SparseMatrix& A, const std::vector<double>& b) {
  AggregationMultigrid multigrid(team);
  EXPECT_TRUE(multigrid.set_up(A));
  std::vector<double> x(b.size(), 0.0);
  const KrylovResult result = pcg(
      team, [&](auto v, auto y) { multiply_symmetric(team, A, v, y); },
      [&](auto r, auto z) { multigrid.precondition(r, z); }, b, x, 1e-10, 200);
  EXPECT_TRUE(result.converged);
  return {result.iterations, x};
}

/// Slabs are swept out of order, by whoever is free.
TEST(SharedMultigrid, HasTheSameBitsOnAnyNumberOfThreads) {
  const SparseMatrix A = BodyMatrices({3, 24, 0.01, true, 1}).pressures(1);
  std::vector<double> b(static_cast<std::size_t>(A.n));
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(1.3 * static_cast<double>(i * i));
  Team one;
  const Found expected = solve(one, A, b);
  for (const int threads : {2, 3, 8}) {
    ThreadTeam team(threads);
    const Found found = solve(team, A, b);
    EXPECT_EQ(found.iterations, expected.iterations) << threads;
    EXPECT_EQ(found.x, expected.x) << threads;
  }
}

}  // namespace
}  // namespace tether
