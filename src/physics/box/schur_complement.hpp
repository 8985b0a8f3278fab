// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "algebra/krylov.hpp"
#include "algebra/quasidefinite_solver.hpp"
#include "algebra/sparse_solver.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/pressure_preconditioner.hpp"

namespace tether::coupled {

/// The constant pressures c that equations of pressures alone do not feel and free velocities do: one of each closed
/// region that is not loose. W has a column for each, 1 in its region.
class ConstantPressures {
 public:
  ConstantPressures() = default;
  explicit ConstantPressures(const CoupledEquations& equations);

  std::size_t count() const { return cells_.size(); }
  /// The c of a pressure, or -1.
  int of(std::size_t pressure) const { return of_[pressure]; }
  /// sums += W^T x.
  void add_sums(std::span<const double> x, std::span<double> sums) const;
  /// p += W c.
  void add(std::span<const double> c, std::span<double> p) const;
  /// Takes the means over the regions off, and returns them.
  std::vector<double> take_means(std::span<double> p) const;

 private:
  std::vector<int> of_;
  std::vector<double> cells_;  // of each c how many pressures
};

/// They as a border of the other equations.
class RegionConstants {
 public:
  RegionConstants(const CoupledEquations& equations, const ReducedEquations& with);

  /// c. `x` has the solution of the other equations by `factors`, velocities first, and is corrected.
  std::vector<double> found(QuasidefiniteSolver& factors, std::span<double> x) const;
  const ConstantPressures& constants() const { return constants_; }

 private:
  ConstantPressures constants_;
  std::vector<std::vector<double>> border_;  // of each constant its column S
  std::vector<double> right_;                // of each the sum of r
};

/// The pressures by conjugate gradients, or by GMRES where A is not symmetric, with the solids taken out by factors of
/// A: (L + C A^-1 B^T) p = -r - C A^-1 b, C the map of flux. The preconditioner takes L with the solids as if their
/// nodes moved each on its own. The constant pressures c of closed regions that solids feel are further unknowns, p = x
/// + W c with W the regions' cells: L does not feel them, and of those that stiff solids need, rounding of L p would
/// leave nothing else. The equations of c are sums of those of x; x without means in these regions is the solution that
/// is found. They are preconditioned by W^T C A^-1 B^T W.
class SchurComplement {
 public:
  /// The team shares its loops, and must outlive it.
  SchurComplement(int dim, Team& team) : team_(team), solids_(dim), preconditioner_(team) {}

  /// p has the first guess; u is what the pressures make of it.
  KrylovResult solve(const CoupledEquations& equations, const ReducedEquations& with, double tolerance,
                     std::span<double> u, std::span<double> p);
  /// L p = right, L with rows of pinned pressures.
  KrylovResult solve_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned,
                               std::span<const double> right, double tolerance, std::span<double> p);

  /// Lets go of what only solutions with the same matrices would need.
  void let_go() { preconditioner_.clear(), B_ = {}, flux_ = {}, held_L_ = {}; }

 private:
  bool set_up(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);
  bool set_up_pressures(const CoupledEquations& equations);
  bool make_levels(const CoupledEquations& equations, std::span<const double> inverse);
  void take_pressures(const CoupledEquations& equations, std::span<const std::uint8_t> pinned);
  void set_up_constants();
  const CouplingMatrix& flux() const { return flux_.rows() > 0 ? flux_ : B_; }
  void move_solids(std::span<const double> forces);
  KrylovResult iterate(bool symmetric, std::span<const double> right, double tolerance, std::span<double> x);
  void multiply(std::span<const double> x, std::span<double> y);
  void precondition(std::span<const double> r, std::span<double> z);

  Team& team_;
  SparseSolver solids_;
  std::int64_t ordered_ = 0;         // unknowns of the solids that their order is for
  CouplingMatrix B_, flux_;          // less what is held or pinned, as L_; flux_ is empty where it is B
  SparseMatrix held_L_;              // of pinned pressures
  const SparseMatrix* L_ = nullptr;  // it, or that of the equations where none is pinned
  PressurePreconditioner preconditioner_;
  ConstantPressures constants_;
  Eigen::MatrixXd stiffness_;  // of the solids against c, (W^T C A^-1 B^T W)^-1
  std::vector<double> whole_, forces_, moved_;
};

}  // namespace tether::coupled
