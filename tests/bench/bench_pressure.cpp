// SPDX-License-Identifier: GPL-3.0-or-later
// What the linear systems of a fluid and a solid in a box of cells cost: the pressures alone by conjugate gradients
// with multigrid, to 1e-10, and how that grows from box to box; pressures and the solid's velocities at once by direct
// factors, when the body has not moved since the matrix before and when it has, by a third of a cell; and by BiCGSTAB,
// whose time has its incomplete factors.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>

#include "algebra/krylov.hpp"
#include "algebra/multigrid.hpp"
#include "algebra/quasidefinite_solver.hpp"
#include "unit/algebra/pressure_matrices.hpp"

namespace {

using namespace tether;

constexpr double tolerance = 1e-10;
constexpr int repeats = 3;  // of which the quickest counts

/// Of the process, so that others on the machine do not count [s].
double seconds_of(const auto& work) {
  const auto from = std::clock();
  work();
  return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
}

std::vector<double> right_side(std::int64_t n) {
  std::vector<double> b(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(1.3 * static_cast<double>(i * i));
  return b;
}

/// Returns the seconds of a solution.
double measure_multigrid(const BodyInBox& box, double added, double before) {
  const SparseMatrix A = BodyMatrices(box).pressures(added);
  const std::vector<double> b = right_side(A.n);
  Team team;
  AggregationMultigrid multigrid(team);
  std::vector<double> x(b.size());
  double set_up = 1e300, solve = 1e300;
  KrylovResult result;
  for (int k = 0; k < repeats; ++k) {
    set_up = std::min(set_up, seconds_of([&] { multigrid.set_up(A); }));
    x.assign(b.size(), 0.0);
    solve = std::min(solve, seconds_of([&] {
                       result = pcg(
                           team, [&](auto v, auto y) { multiply_symmetric(team, A, v, y); },
                           [&](auto r, auto z) { multigrid.precondition(r, z); }, b, x, tolerance, 500);
                     }));
  }
  const double order = before > 0 ? std::log(solve / before) / (box.dim * std::log(2.0)) : 0;
  fmt::print("{}D {:4} {:9} {:7} {:6} {:6} {:7} {:8.2f} {:10.4f} {:9.4f} {:6.2f}{}\n", box.dim, box.cells, A.n,
             box.ratio, added, result.iterations, multigrid.levels(), multigrid.complexity(), set_up, solve, order,
             result.converged ? "" : " not solved");
  return solve;
}

void measure_both(BodyInBox box) {
  const SparseMatrix K = BodyMatrices(box).coupled(1, 10);
  box.shift = 0.3 / box.cells;
  const SparseMatrix moved = BodyMatrices(box).coupled(1, 10);
  QuasidefiniteSolver solver;
  std::vector<double> b = right_side(K.n);
  const double first = seconds_of([&] { solver.factorise(K); }), same = seconds_of([&] { solver.factorise(K); });
  const double next = seconds_of([&] { solver.factorise(moved); });
  const double solve = seconds_of([&] { solver.solve(b, b); });
  b = right_side(K.n);
  std::vector<double> x(b.size(), 0.0);
  KrylovResult result;
  const double krylov = seconds_of([&] { result = bicgstab(K, b, x, tolerance, 2000); });
  fmt::print("{}D {:4} {:9} {:12.4g} {:6} {:8.4f} {:8.4f} {:8.4f} {:8.4f} {:6} {:10.4f}{}\n", box.dim, box.cells, K.n,
             solver.factor_nonzeros(), solver.orders(), first, same, next, solve, result.iterations, krylov,
             result.converged ? "" : " not solved");
}

}  // namespace

/// bench_pressure [MOST_UNKNOWNS]
int main(int count, char** words) {
  const double most = count > 1 ? std::atof(words[1]) : 3e5;
  fmt::print("{:7} {:>9} {:>7} {:>6} {:>6} {:>7} {:>8} {:>10} {:>9} {:>6}\n", "cells", "unknowns", "weights", "added",
             "steps", "levels", "entries", "set-up s", "solve s", "order");
  for (const auto& [ratio, added] : {std::pair{1.0, 0.0}, {100.0, 0.0}, {1.0, 10.0}}) {
    for (int dim = 2; dim <= 3; ++dim) {
      double before = 0;
      for (int cells = dim == 2 ? 32 : 16; std::pow(cells, dim) <= most; cells *= 2)
        before = measure_multigrid({dim, cells, 0, true, ratio}, added, before);
    }
  }
  fmt::print("\n{:7} {:>9} {:>12} {:>6} {:>8} {:>8} {:>8} {:>8} {:>6} {:>10}\n", "cells", "unknowns", "factor",
             "orders", "first s", "same s", "moved s", "solve s", "steps", "BiCGSTAB s");
  for (int dim = 2; dim <= 3; ++dim) {
    for (int cells = dim == 2 ? 32 : 8; std::pow(cells, dim) <= std::min(most, dim == 2 ? 7e4 : 4e4); cells *= 2)
      measure_both({dim, cells, 0, true, 1});
  }
}
