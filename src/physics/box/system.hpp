// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "base/process.hpp"
#include "model/coupled.hpp"
#include "physics/box/matrix.hpp"

namespace tether::coupled {

/// What the solutions have cost.
struct SystemCost {
  long long solves = 0, iterations = 0;
  long long lu_solves = 0;  ///< by factors where BiCGSTAB did not converge
  Seconds solve;
  double factor_nonzeros = 0;
};

/// Solves them, step after step: symbolic factors and orders of elimination are kept, and factors while matrices are.
class CoupledSystem {
 public:
  /// The team shares its loops; both must outlive it.
  CoupledSystem(const Coupled& scene, Team& team);
  ~CoupledSystem();

  /// Sets the velocities that are not held, and the pressures, zero in one cell of each loose region; p has the first
  /// guess of iterations. Throws RunError where there is no solution, with the time.
  void solve(const CoupledEquations& equations, double time, std::span<double> u, std::span<double> p);
  /// Throws RunError where more flows into a loose region than out of it, u being velocities that are held.
  static void check_balance(const CoupledEquations& equations, double time, std::span<const double> u);
  /// Finds the same for a correction of Newton's method, whose A need be neither symmetric nor definite, to
  /// `tolerance`. False where it is not found.
  bool correct(const CoupledEquations& equations, double tolerance, std::span<double> u, std::span<double> p);
  /// The solids alone, A u = b + B^T p with the pressures given.
  void solve_solids(const CoupledEquations& equations, double time, std::span<double> u, std::span<const double> p);
  /// The fluid alone, -L p = r + flux u with all velocities given.
  void solve_fluid(const CoupledEquations& equations, double time, std::span<const double> u, std::span<double> p);

  /// The pressures alone, L p = r, less the means of r in loose regions, to `tolerance` where it is by iterations.
  void solve_sources(const CoupledEquations& equations, double time, double tolerance, std::span<double> p);

  /// Lets go of what only solutions with the same matrices would need: no more of them follow.
  void let_go();
  /// "bicgstab", "direct" or "krylov".
  const char* solver_name() const;
  /// The orders of elimination that have been found, as numbers to be saved; with them another object's solutions are
  /// the same to the last bit. Throws FileError where they are not of this scene.
  std::vector<double> orders() const;
  void keep_orders(std::span<const double> orders);
  const SystemCost& cost() const { return cost_; }
  std::vector<std::string> take_messages();

 private:
  struct Parts;
  void solve_directly(const CoupledEquations& equations, double time, std::span<double> u, std::span<double> p);
  void solve_by_gradients(const CoupledEquations& equations, double time, std::span<double> u, std::span<double> p);
  void solve_as_the_paper(const CoupledEquations& equations, double time, std::span<double> u, std::span<double> p);
  void solve_by_lu(const SparseMatrix& K, std::span<const double> right, double time, int iterations,
                   std::span<double> x);
  bool correct_directly(const CoupledEquations& equations, const ReducedEquations& with, std::span<double> u,
                        std::span<double> p);
  void solve_pressures(const CoupledEquations& equations, double time, double tolerance,
                       std::span<const std::uint8_t> pinned, std::span<double> right, std::span<double> p);
  void check_pivots(std::int64_t expected, double time);

  const Coupled& scene_;
  bool direct_ = false;
  SystemCost cost_;
  std::vector<std::string> messages_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tether::coupled
