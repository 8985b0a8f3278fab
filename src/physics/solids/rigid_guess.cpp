// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/rigid_guess.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

namespace tether::fem {

using Eigen::Matrix3d, Eigen::Vector3d;

RigidGuess::RigidGuess(const Mesh& mesh, std::span<const double> weights, const std::vector<std::uint8_t>& held)
    : dim_(static_cast<std::size_t>(mesh.dim())), weights_(weights), part_(parts_of(mesh)) {
  parts_.resize(static_cast<std::size_t>(count_parts(mesh)));
  inertia_.resize(parts_.size()), momentum_.resize(parts_.size());
  for (std::size_t n = 0; n < part_.size(); ++n) {
    if (part_[n] < 0) continue;
    Part& part = parts_[static_cast<std::size_t>(part_[n])];
    part.mass += weights_[n];
    for (std::size_t i = 0; i < dim_; ++i) part.held |= held[n * dim_ + i] != 0;
  }
}

Vector3d RigidGuess::at(std::span<const double> q, std::size_t node) const {
  return {q[node * dim_], q[node * dim_ + 1], dim_ == 3 ? q[node * dim_ + 2] : 0};
}

/// The rigid motion that has each part's momentum and angular momentum, with the masses as points.
void RigidGuess::find_motions(std::span<const double> q, std::span<const double> v, double dt) {
  for (Part& part : parts_) part.centre = part.velocity = Vector3d::Zero();
  for (std::size_t n = 0; n < part_.size(); ++n) {
    if (part_[n] < 0) continue;
    Part& part = parts_[static_cast<std::size_t>(part_[n])];
    const double share = weights_[n] / part.mass;
    part.centre += share * at(q, n), part.velocity += share * at(v, n);
  }
  std::fill(inertia_.begin(), inertia_.end(), Matrix3d::Zero());
  std::fill(momentum_.begin(), momentum_.end(), Vector3d::Zero());
  for (std::size_t n = 0; n < part_.size(); ++n) {
    if (part_[n] < 0) continue;
    const auto p = static_cast<std::size_t>(part_[n]);
    const Vector3d x = at(q, n) - parts_[p].centre;
    inertia_[p] += weights_[n] * (x.squaredNorm() * Matrix3d::Identity() - x * x.transpose());
    momentum_[p] += weights_[n] * x.cross(at(v, n));
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    inertia_[p] += 1e-12 * inertia_[p].trace() * Matrix3d::Identity();  // a part may lie on a line
    const Vector3d turn = dt * inertia_[p].ldlt().solve(momentum_[p]);
    parts_[p].turn = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
}

void RigidGuess::find(std::span<const double> q, std::span<const double> v, double dt, std::span<double> q1) {
  find_motions(q, v, dt);
  std::copy(q.begin(), q.end(), q1.begin());
  for (std::size_t n = 0; n < part_.size(); ++n) {
    if (part_[n] < 0) continue;
    const Part& part = parts_[static_cast<std::size_t>(part_[n])];
    if (part.held) continue;
    const Vector3d x = part.centre + dt * part.velocity + part.turn * (at(q, n) - part.centre);
    for (std::size_t i = 0; i < dim_; ++i) q1[n * dim_ + i] = x[static_cast<Eigen::Index>(i)];
  }
}

}  // namespace tether::fem
