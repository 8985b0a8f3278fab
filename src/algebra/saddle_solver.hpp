// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "algebra/sparse_solver.hpp"

namespace tether {

/// How a preconditioner solves for velocities: by LU factors; or by incomplete ones, ILU(0), which take no more room
/// than the matrix, are made in the time of some products with it, and suit matrices in which masses over the time step
/// and convection outweigh viscosity.
enum class VelocityMethod { complete, incomplete };

/// Approximate solution of A u = r for the velocities of nodes.
class VelocityBlock {
 public:
  /// Unknowns first[A] .. first[A + 1] - 1 are those of node A.
  VelocityBlock(VelocityMethod method, std::vector<int> first);
  VelocityBlock(const VelocityBlock&) = delete;
  VelocityBlock& operator=(const VelocityBlock&) = delete;

  /// False where A is singular, or for incomplete factors a pivot is zero.
  bool factorise(SparseMatrix A);
  /// u is linear in r, and apart from it.
  void solve(std::span<const double> r, std::span<double> u);
  double factor_nonzeros() const;

 private:
  bool factorise_in_place();
  void solve_in_place(std::span<const double> r, std::span<double> u) const;

  VelocityMethod method_;
  SparseMatrix A_;  // or its incomplete factors
  SparseSolver solver_;
  std::vector<std::size_t> diagonal_;  // where it stands in the incomplete factors
};

/// Rows and columns `kept` of A, ascending.
SparseMatrix principal_block(const SparseMatrix& A, std::span<const std::int64_t> kept);

/// What the unknowns of a flow are. Prescribed ones may be left out, or have rows and columns of the identity in K.
struct SaddleUnknowns {
  std::vector<std::uint8_t> is_pressure;  ///< of each unknown, 0 or 1
  std::vector<int> first;                 ///< unknowns first[A] .. first[A + 1] - 1 are those of node A, or none
  bool closed = false;                    ///< no side is open, and one pressure is prescribed
};

/// Solution of the large systems of incompressible flow,
///
///   K = [A G; D C],  unknowns: velocities and pressures of nodes in any order,
///
/// by GMRES with the preconditioner P = [A^ G; 0 S^] from the right. A^ is A or near it (see VelocityMethod), S^ stands
/// for the Schur complement S = C - D A^-1 G:
///
///   S^-1 = (Mp / viscous + C)^-1 + (Lp / inertial + C)^-1
///
/// Without C this is that of J. Cahouet, J.-P. Chabard, Int. J. Numer. Meth. Fluids 8 (1988) 869-895; with it each term
/// is still right where it is the larger one. Made for time steps in which a particle crosses few elements: convection
/// over many is not in S^, and the iterations then grow with the Reynolds number.
class SaddleSolver {
 public:
  /// Mp: the pressures' mass matrix <p q>. Lp: their Laplacian <grad p grad q>, on open sides with rows and columns of
  /// the identity. Both symmetric, of the pressures that are unknowns, in the order of K. Where the viscosity varies,
  /// as it does if a stiff body is part of the flow, Mp is to be <p q (viscous / that of the place)>.
  SaddleSolver(const SaddleUnknowns& unknowns, SparseMatrix Mp, SparseMatrix Lp,
               VelocityMethod method = VelocityMethod::incomplete);
  SaddleSolver(const SaddleSolver&) = delete;
  SaddleSolver& operator=(const SaddleSolver&) = delete;

  /// Sets the scales. With A = rho / dt M + theta mu <grad v grad w> + ... these are viscous = theta mu, or 2 theta mu
  /// where the stress is mu (grad v + grad v^T), and the weight of <div v div w> besides; inertial = rho / dt, 0 in
  /// steady flow. The signs are those of D = -G^T; both are negative where D = G^T.
  void scales(double viscous, double inertial);

  /// From the first guess x until |b - K x| <= tolerance |b|. The factors of an earlier K are used while they do in 30
  /// iterations, or half as many again as when they were new, or else made anew. False where 200 iterations do not do
  /// with new factors, or A is singular. The pattern of K may change from call to call, not its size. The same calls
  /// give the same bits.
  bool solve(const SparseMatrix& K, std::span<const double> b, std::span<double> x, double tolerance);

  /// The next solution makes new factors, as the first one does, and depends on nothing before it.
  void forget() { factorised_ = false; }

  int iterations() const { return iterations_; }  ///< of the last solution, all in all
  bool renewed() const { return renewed_; }       ///< whether it made factors for velocities
  double factor_nonzeros() const;                 ///< of all factors kept

 private:
  bool renew(const SparseMatrix& K);
  bool renew_pressure(const SparseMatrix& K);
  void find_constant(const SparseMatrix& K);
  bool iterate(const SparseMatrix& K, std::span<const double> b, std::span<double> x, double tolerance, int most);
  void precondition(const SparseMatrix& K, std::span<const double> r, std::span<double> z);
  void solve_pressure();

  bool closed_;
  std::vector<std::int64_t> velocities_, pressures_;  // the unknowns of K that they are
  SparseMatrix Mp_, Lp_, C_, viscous_part_, inertial_part_;
  double viscous_ = 0, inertial_ = 0;
  VelocityBlock velocity_;
  SparseSolver mass_, laplacian_;
  bool factorised_ = false, renewed_ = false, pressure_factorised_ = false;
  int iterations_ = 0, patience_ = 0;
  std::vector<double> ru_, u_, rp_, p_, q_;
  std::vector<double> free_;  // 0 for pressures that are held in K, 1 for others
  double constant_ = 0;       // p S p of p = free_ in a closed flow, or 0
};

}  // namespace tether
