// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/system.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/krylov.hpp"
#include "algebra/quasidefinite_solver.hpp"
#include "algebra/sparse_solver.hpp"
#include "base/diagnostics.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/schur_complement.hpp"

namespace tether::coupled {
namespace {

[[noreturn]] void refuse(double time, const std::string& what, Failure failure = Failure::diverges) {
  throw RunError(fmt::format("t = {:.9g}: {}", time, what), failure);
}

/// Reduced equations that have a solution.
ReducedEquations balanced(const CoupledEquations& equations, double time, std::span<const double> u) {
  ReducedEquations with = reduced(equations, u);
  if (with.unbalanced >= 0)
    refuse(time,
           fmt::format("{:.4g} flows out of closed region {} of the fluid, whose walls do not yield: likely cause, "
                       "jets or moved supports whose flux does not cancel, or a liquid that fills all that there is",
                       with.flux, with.unbalanced + 1));
  return with;
}

}  // namespace

struct CoupledSystem::Parts {
  Parts(int dim, Team& team) : schur(dim, team) {}
  QuasidefiniteSolver both, solids, fluid;
  SparseSolver corrections;
  SchurComplement schur;
};

CoupledSystem::CoupledSystem(const Coupled& scene, Team& team)
    : scene_(scene),
      direct_(systems_of(scene) == Systems::direct),
      parts_(std::make_unique<Parts>(scene.grid.dim, team)) {}

CoupledSystem::~CoupledSystem() = default;

void CoupledSystem::solve(const CoupledEquations& equations, double time, std::span<double> u, std::span<double> p) {
  const Stopwatch watch(cost_.solve);
  ++cost_.solves;
  if (scene_.coupling.two_maps) return solve_as_the_paper(equations, time, u, p);
  if (direct_) return solve_directly(equations, time, u, p);
  solve_by_gradients(equations, time, u, p);
}

/// Without K' made convex A may be indefinite: that is reported, once, and the run continues to show what comes of it.
void CoupledSystem::check_pivots(std::int64_t expected, double time) {
  const std::int64_t found = parts_->both.negative_pivots();
  if (found == expected) return;
  const std::string what =
      fmt::format("the coupled matrix has {} negative pivots, not one for each of {} pressures", found, expected);
  if (scene_.convex) refuse(time, what + ": likely cause, numbers of the solids that rounding has eaten");
  if (messages_.empty())
    messages_.push_back(
        fmt::format("t = {:.6g}: {}: K' is not convex, and some motions of the solids grow", time, what));
}

/// In a closed region L does not feel a constant pressure, so that factors in any order need not exist. So its first
/// pressure is set to zero, and the constant c, which the solids feel by S, the sum of the region's rows, is found
/// after the others: [K, S; S^T, 0] [x; c] = [k; sum of r].
void CoupledSystem::solve_directly(const CoupledEquations& equations, double time, std::span<double> u,
                                   std::span<double> p) {
  const ReducedEquations with = balanced(equations, time, u);
  const std::vector<std::uint8_t> first = first_pressures(equations, equations.closed);
  if (!equations.same_matrices && !parts_->both.factorise(matrix_by_cells(equations, first)))
    refuse(time, "the coupled matrix is singular: likely cause, values that ran away");
  check_pivots(static_cast<std::int64_t>(equations.cells), time);
  std::vector<double> x(with.b);
  x.resize(with.b.size() + equations.cells, 0.0);
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (first[k] == 0) x[u.size() + equations.cell[k]] = with.r[k];
  }
  parts_->both.solve(x, x);
  const RegionConstants border(equations, with);
  const std::vector<double> c = border.found(parts_->both, x);
  std::copy_n(x.begin(), u.size(), u.begin());
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = x[u.size() + equations.cell[k]];
  border.constants().add(c, p);
  cost_.factor_nonzeros = parts_->both.factor_nonzeros();
}

void CoupledSystem::solve_by_gradients(const CoupledEquations& equations, double time, std::span<double> u,
                                       std::span<double> p) {
  const ReducedEquations with = balanced(equations, time, u);
  const KrylovResult result = parts_->schur.solve(equations, with, scene_.tolerance, u, p);
  cost_.iterations += result.iterations;
  if (!result.converged)
    refuse(time,
           fmt::format("conjugate gradients do not converge in {} iterations: solver='direct' of $coupled needs "
                       "none; likely cause, values that ran away",
                       result.iterations),
           Failure::does_not_converge);
}

void CoupledSystem::check_balance(const CoupledEquations& equations, double time, std::span<const double> u) {
  balanced(equations, time, u);
}

bool CoupledSystem::correct(const CoupledEquations& equations, double tolerance, std::span<double> u,
                            std::span<double> p) {
  const Stopwatch watch(cost_.solve);
  ++cost_.solves;
  const ReducedEquations with = reduced(equations, u);
  if (direct_) return correct_directly(equations, with, u, p);
  const KrylovResult result = parts_->schur.solve(equations, with, tolerance, u, p);
  cost_.iterations += result.iterations;
  return result.converged;
}

bool CoupledSystem::correct_directly(const CoupledEquations& equations, const ReducedEquations& with,
                                     std::span<double> u, std::span<double> p) {
  SparseMatrix K = whole_matrix(equations, with.pinned);
  const std::vector<double> scales = scales_of(K);
  scale(K, scales);
  if (!parts_->corrections.factorise(K, Definite::general)) return false;
  std::vector<double> x(with.b);
  x.insert(x.end(), with.r.begin(), with.r.end());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] /= scales[k];
  parts_->corrections.solve(x, x);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = x[k] / scales[k];
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = x[u.size() + k] / scales[u.size() + k];
  cost_.factor_nonzeros = parts_->corrections.factor_nonzeros();
  return true;
}

void CoupledSystem::solve_as_the_paper(const CoupledEquations& equations, double time, std::span<double> u,
                                       std::span<double> p) {
  constexpr int most = 2000;
  const ReducedEquations with = balanced(equations, time, u);
  SparseMatrix K = whole_matrix(equations, with.pinned);
  const std::vector<double> scales = scales_of(K);
  scale(K, scales);
  std::vector<double> right(with.b), x(u.begin(), u.end());
  right.insert(right.end(), with.r.begin(), with.r.end());
  x.insert(x.end(), p.begin(), p.end());
  for (std::size_t k = 0; k < x.size(); ++k) right[k] /= scales[k], x[k] *= scales[k];
  const KrylovResult result = bicgstab(K, right, x, scene_.tolerance, most);
  cost_.iterations += result.iterations;
  if (!result.converged) solve_by_lu(K, right, time, result.iterations, x);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = x[k] / scales[k];
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = with.pinned[k] != 0 ? 0 : x[u.size() + k] / scales[u.size() + k];
}

/// Finds by factors of the same matrix what BiCGSTAB does not find, unless the matrix is singular. The residual is
/// taken off until it falls no more.
void CoupledSystem::solve_by_lu(const SparseMatrix& K, std::span<const double> right, double time, int iterations,
                                std::span<double> x) {
  constexpr int most_corrections = 5;
  if (cost_.lu_solves++ == 0)
    messages_.push_back(
        fmt::format("t = {:.6g}: BiCGSTAB does not converge in {} iterations: this system, and others like it, are "
                    "solved by factors (lu_solutions of summary.txt counts them)",
                    time, iterations));
  SparseSolver lu;  // anew each time: what it kept would make a run that goes on differ from its restart
  if (!lu.factorise(with_symmetric_pattern(K), Definite::general))
    refuse(time,
           "the coupled matrix is singular: likely cause, values that ran away, or a part of the fluid that "
           "mode='paper' joins to nothing; mode='cut-cell' of $coupled may do");
  std::vector<double> residual(right.begin(), right.end()), change(x.size());
  std::fill(x.begin(), x.end(), 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_corrections && norm(residual) < 0.5 * least; ++k) {
    least = norm(residual);
    lu.solve(residual, change);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += change[i];
    K.multiply(x, residual);
    for (std::size_t i = 0; i < x.size(); ++i) residual[i] = right[i] - residual[i];
  }
  cost_.factor_nonzeros = lu.factor_nonzeros();
  if (!std::isfinite(norm(residual))) refuse(time, "the coupled system has no finite solution: values that ran away");
}

void CoupledSystem::solve_solids(const CoupledEquations& equations, double time, std::span<double> u,
                                 std::span<const double> p) {
  const Stopwatch watch(cost_.solve);
  ++cost_.solves;
  CoupledEquations alone = equations;
  std::vector<double> forces(equations.b.begin(), equations.b.end());
  add_transposed_product(equations.B, 1, p, forces);
  alone.b = forces;
  const ReducedEquations with = reduced(alone, u);
  if (!equations.same_matrices && !parts_->solids.factorise(held_matrix(equations.A, equations.held)))
    refuse(time, "the solids' matrix is singular: likely cause, values that ran away");
  parts_->solids.solve(with.b, u);
  cost_.factor_nonzeros = parts_->solids.factor_nonzeros();
}

void CoupledSystem::solve_fluid(const CoupledEquations& equations, double time, std::span<const double> u,
                                std::span<double> p) {
  const Stopwatch watch(cost_.solve);
  std::vector<double> right(equations.r.begin(), equations.r.end());
  add_product(equations.flux, 1, u, right);
  std::vector<double> weight(p.size(), 1.0);
  if (scene_.area_repair) weight = areas_seen(equations.B);
  balance(equations, weight, right);
  for (double& value : right) value = -value;
  solve_pressures(equations, time, scene_.tolerance, first_pressures(equations, equations.loose), right, p);
}

void CoupledSystem::solve_sources(const CoupledEquations& equations, double time, double tolerance,
                                  std::span<double> p) {
  const Stopwatch watch(cost_.solve);
  std::vector<double> right(equations.r.begin(), equations.r.end());
  balance(equations, std::vector<double>(p.size(), 1.0), right);
  solve_pressures(equations, time, tolerance, first_pressures(equations, equations.loose), right, p);
}

/// L p = right, 0 where pressures are pinned.
void CoupledSystem::solve_pressures(const CoupledEquations& equations, double time, double tolerance,
                                    std::span<const std::uint8_t> pinned, std::span<double> right,
                                    std::span<double> p) {
  for (std::size_t k = 0; k < p.size(); ++k) right[k] = pinned[k] != 0 ? 0 : right[k];
  if (direct_) {
    if (!equations.same_matrices && !parts_->fluid.factorise(pressures_by_cells(equations, pinned)))
      refuse(time, "the pressures' matrix is singular: likely cause, values that ran away");
    std::vector<double> x(equations.cells, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) x[equations.cell[k]] = right[k];
    parts_->fluid.solve(x, x);
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = x[equations.cell[k]];
    cost_.factor_nonzeros += parts_->fluid.factor_nonzeros();
    return;
  }
  const KrylovResult result = parts_->schur.solve_pressures(equations, pinned, right, tolerance, p);
  cost_.iterations += result.iterations;
  if (!result.converged)
    refuse(time, "conjugate gradients do not converge for the pressures", Failure::does_not_converge);
}

void CoupledSystem::let_go() { parts_->schur.let_go(); }

const char* CoupledSystem::solver_name() const {
  if (scene_.coupling.two_maps) return "bicgstab";
  return direct_ ? "direct" : "krylov";
}

/// Each solver's: how many unknowns, the nonzeros that it was found for, and the order.
std::vector<double> CoupledSystem::orders() const {
  std::vector<double> numbers;
  for (const QuasidefiniteSolver* solver : {&parts_->both, &parts_->solids, &parts_->fluid}) {
    const EliminationOrder& order = solver->order();
    numbers.push_back(static_cast<double>(order.unknowns.size()));
    numbers.push_back(order.nonzeros);
    numbers.insert(numbers.end(), order.unknowns.begin(), order.unknowns.end());
  }
  return numbers;
}

void CoupledSystem::keep_orders(std::span<const double> numbers) {
  std::size_t next = 0;
  for (QuasidefiniteSolver* solver : {&parts_->both, &parts_->solids, &parts_->fluid}) {
    if (numbers.size() < next + 2) throw FileError("the checkpoint has no orders of elimination");
    const auto count = static_cast<std::size_t>(numbers[next]);
    EliminationOrder order{{}, numbers[next + 1]};
    next += 2;
    if (numbers.size() - next < count) throw FileError("the checkpoint's orders of elimination are cut short");
    for (std::size_t k = 0; k < count; ++k) order.unknowns.push_back(static_cast<std::int64_t>(numbers[next + k]));
    next += count;
    solver->keep_order(std::move(order));
  }
}

std::vector<std::string> CoupledSystem::take_messages() { return std::exchange(messages_, {}); }

}  // namespace tether::coupled
