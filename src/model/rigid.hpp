// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "base/words.hpp"
#include "model/solids.hpp"

namespace tether {

/// How a step of a rigid body is solved: in the null space of its constraints, or with a multiplier for each of them.
enum class RigidForm { reduced, constrained };
template <>
inline constexpr std::array<Word<RigidForm>, 2> words<RigidForm>{
    {{RigidForm::reduced, "reduced"}, {RigidForm::constrained, "constrained"}}};

/// A torque that keeps its direction in space [force length].
struct RigidTorque {
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  Amplitude amplitude;
};

/// A force at a place of the body, by the shape at the start; it keeps its direction, or turns with the body.
struct RigidForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), at = Eigen::Vector3d::Zero();  // [force], [length]
  bool turning = false;
  Amplitude amplitude;
};

/// That all bodies on the mesh together are one rigid body, as the deck's group $rigid says. Its mesh, densities, loads
/// and tracked places are those of the scene's solids.
struct Rigid {
  RigidForm form = RigidForm::reduced;
  std::optional<Eigen::Vector3d> point;                     ///< reference point; none: the centre of mass
  Eigen::Matrix3d directors = Eigen::Matrix3d::Identity();  ///< d_i in column i
  std::optional<Eigen::Vector3d> pin;                       ///< a place of the body that is held
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();       ///< of the centre of mass at the start; 0 with a pin
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();          ///< angular velocity at the start [1/time]
  std::vector<RigidTorque> torques;
  std::vector<RigidForce> forces;

  int unknowns() const { return form == RigidForm::reduced ? (pin ? 3 : 6) : (pin ? 21 : 18); }
};

/// Below this volume of their unit vectors directors count as dependent: 8 of 16 digits of every convective coordinate
/// would be lost.
constexpr double least_spanned_volume = 1e-8;

/// The volume that the directions of three directors span, of any hand; their lengths are finite and not 0.
inline double spanned_volume(const Eigen::Matrix3d& directors) {
  return std::abs((directors * directors.colwise().norm().cwiseInverse().asDiagonal()).determinant());
}

}  // namespace tether
