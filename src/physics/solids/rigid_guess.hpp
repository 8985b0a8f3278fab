// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/mesh.hpp"

namespace tether::fem {

/// Where bodies would be at a step's end if each connected part of a mesh moved on as if it were rigid. Newton's method
/// starts better there than from q + dt v where a step is long beside the body's vibrations: their velocities, carried
/// on, would strain it by far more than they ever do.
class RigidGuess {
 public:
  /// `weights`: mass of each node; `held`: of each unknown, whether a support holds it. A part that is held anywhere
  /// stays where it is. The mesh must outlive it.
  RigidGuess(const Mesh& mesh, std::span<const double> weights, const std::vector<std::uint8_t>& held);

  /// Places q1 of a step dt from places q and velocities v, dim numbers a node.
  void find(std::span<const double> q, std::span<const double> v, double dt, std::span<double> q1);

 private:
  struct Part {
    bool held = false;
    double mass = 0;
    Eigen::Vector3d centre, velocity;
    Eigen::Matrix3d turn;
  };
  void find_motions(std::span<const double> q, std::span<const double> v, double dt);
  Eigen::Vector3d at(std::span<const double> q, std::size_t node) const;

  std::size_t dim_;
  std::span<const double> weights_;
  std::vector<int> part_;
  std::vector<Part> parts_;
  std::vector<Eigen::Matrix3d> inertia_;
  std::vector<Eigen::Vector3d> momentum_;
};

}  // namespace tether::fem
