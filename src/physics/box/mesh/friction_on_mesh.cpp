// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/friction_on_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/krylov.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {
FrictionOnMesh::FrictionOnMesh(const FlowMesh& mesh, FaceHolds holds, std::span<const std::size_t> open, double density,
                               double mu, NodeInertia nodes, double h)
    : mesh_(mesh),
      holds_(std::move(holds)),
      h_(h),
      nodes_(std::move(nodes)),
      masses_(masses_as_one(nodes_, mesh.dim)),
      strain_(mesh, h * mu, density, couples_at(mesh, open, holds_.held)),
      levels_(mesh, strain_, holds_, nodes_),
      x_(holds_.held.size() + nodes_.size(), 0.0) {}

/// Gives carried faces the velocities that nodes make.
void FrictionOnMesh::carry(std::span<double> x) const {
  const std::size_t dim = at(mesh_.dim);
  for (const FaceHolds::Carried& carried : holds_.carried) {
    for (std::size_t a = 0; a < dim; ++a) {
      double sum = 0;
      for (const auto& [of, share] : carried.nodes) sum += share * x[node(of * dim + a)];
      x[carried.face * dim + a] = sum;
    }
  }
}

/// What stands at carried faces goes to the nodes.
void FrictionOnMesh::pass_on(std::span<double> y) const {
  const std::size_t dim = at(mesh_.dim);
  for (const FaceHolds::Carried& carried : holds_.carried) {
    for (std::size_t a = 0; a < dim; ++a) {
      for (const auto& [of, share] : carried.nodes) y[node(of * dim + a)] += share * y[carried.face * dim + a];
      y[carried.face * dim + a] = 0;
    }
  }
}

/// The momentum by which cells of velocities v pull faces that stay at rest.
std::vector<double> FrictionOnMesh::pulls_of(const FaceValues& v) const {
  std::vector<double> pulls(x_.size(), 0.0);
  for (std::size_t cell = 0; cell < mesh_.cells(); ++cell) {
    Vec<3> momentum{};
    for (std::size_t a = 0; a < at(mesh_.dim); ++a) momentum[a] = strain_.pull(cell) * v[a][cell];
    strain_.give_faces(cell, momentum, pulls);
  }
  return pulls;
}

/// Momentum that cells, of velocities which pull so, and friction take of faces and nodes of velocities x.
std::vector<double> FrictionOnMesh::forces(Team& team, std::span<const double> pulls, std::span<const double> x) {
  std::vector<double> forces(x_.size(), 0.0);
  strain_.find_forces(team, x, forces);
  for (std::size_t k = 0; k < holds_.held.size(); ++k) forces[k] -= pulls[k];
  return forces;
}

/// (M + h K) e = what x leaves, e the change of free velocities.
int FrictionOnMesh::solve(Team& team, std::span<const double> pulls, std::span<const double> u, double tolerance) {
  const std::size_t count = x_.size();
  std::vector<double> right = forces(team, pulls, x_), e(count, 0.0), all(count, 0.0),
                      terms(pulls.begin(), pulls.end());
  pass_on(right), pass_on(terms);
  for (std::size_t k = 0; k < count; ++k) right[k] = levels_.is_free(k) ? -right[k] : 0;
  std::vector<double> lacking(nodes_.size()), impulse(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) lacking[k] = u[k] - x_[node(k)];
  nodes_.mass.multiply(lacking, impulse);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    if (levels_.is_free(node(k))) right[node(k)] += impulse[k], terms[node(k)] += masses_[k] * u[k];
  }
  const double residual = norm(team, right), enough = tolerance * std::max(norm(team, terms), residual);
  if (!(residual > enough)) return std::isfinite(residual) ? 0 : -1;
  const auto multiply = [&](std::span<const double> p, std::span<double> y) {
    std::copy(p.begin(), p.end(), all.begin());
    carry(all);
    strain_.find_forces(team, all, y.first(holds_.held.size()));
    nodes_.mass.multiply(p.subspan(holds_.held.size()), nodes_of(y));
    pass_on(y);
    for (std::size_t k = 0; k < count; ++k) y[k] = levels_.is_free(k) ? y[k] : 0;
  };
  const auto precondition = [&](std::span<const double> r, std::span<double> z) { levels_.precondition(r, z); };
  constexpr int most = 2000;
  const KrylovResult result = pcg(team, multiply, precondition, right, e, enough / residual, most);
  for (std::size_t k = 0; k < count; ++k) x_[k] += e[k];
  carry(x_);
  return result.converged ? result.iterations : -1;
}

/// Free velocities are those of the act before; in the first one those of the cells and nodes without their drive,
/// which friction leaves about as they are where that keeps them up.
void FrictionOnMesh::begin_with(const FaceValues& v, std::span<const double> u, std::span<const double> driven_to,
                                std::span<const double> given) {
  const std::size_t dim = at(mesh_.dim);
  for (std::size_t f = 0; f < mesh_.faces(); ++f) {
    const auto& cells = mesh_.cells_of_face[f];
    for (std::size_t a = 0; a < dim; ++a) {
      const double mean = cells[1] < 0 ? v[a][at(cells[0])] : 0.5 * (v[a][at(cells[0])] + v[a][at(cells[1])]);
      double& x = x_[f * dim + a];
      if (!levels_.is_free(f * dim + a)) x = given[f * dim + a];
      if (levels_.is_free(f * dim + a) && !begun_) x = mean;
    }
  }
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (!levels_.is_free(node(k))) x_[node(k)] = driven_to[k];
    if (levels_.is_free(node(k)) && !begun_) x_[node(k)] = u[k];
  }
  carry(x_);
  begun_ = true;
}

Rubbed FrictionOnMesh::act(Team& team, std::span<const double> u, std::span<const double> driven_nodes,
                           double tolerance, std::span<const double> given, const FaceValues& driven, FaceValues& v) {
  const std::size_t dim = at(mesh_.dim), cells = mesh_.cells();
  FaceValues driven_to = v;
  for (std::size_t a = 0; a < dim; ++a) {
    for (std::size_t cell = 0; cell < cells; ++cell) driven_to[a][cell] += h_ * driven[a][cell];
  }
  std::vector<double> nodes(u.begin(), u.end());
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] += h_ * driven_nodes[k];
  begin_with(v, u, nodes, given);
  const std::vector<double> pulls = pulls_of(driven_to);
  Rubbed result;
  result.iterations = solve(team, pulls, nodes, tolerance);
  if (result.iterations < 0) return result;
  std::vector<double> taken = forces(team, pulls, x_);
  result.heat = dot(team, x_, taken);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const Vec<3> of_faces = strain_.velocity(cell, x_);
    const double m = strain_.mass(cell), tie = strain_.tie(cell);
    for (std::size_t a = 0; a < dim; ++a) {
      const double before = driven_to[a][cell], after = (m * before + tie * of_faces[a]) / (m + tie);
      const double undriven = after - h_ * driven[a][cell];
      double& now = v[a][cell];
      result.heat += strain_.pull(cell) * (before - of_faces[a]) * after;
      result.taken += 0.5 * m * (now * now - undriven * undriven);
      now = undriven;
    }
  }
  pass_on(taken);
  for (std::size_t k = 0; k < u.size(); ++k) {
    result.impulse.push_back(-taken[node(k)]);
    result.nodes.push_back(x_[node(k)]);
  }
  return result;
}

}  // namespace tether::coupled
