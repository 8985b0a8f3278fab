// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/expression.hpp"
#include "base/vec.hpp"
#include "base/words.hpp"
#include "grid/mesh.hpp"
#include "grid/mesh_place.hpp"
#include "laws/hyperelastic.hpp"
#include "model/contact.hpp"
#include "model/dilatation.hpp"

namespace tether {

/// A factor over time: an expression in t, or a table, linear between its times, constant before the first and after
/// the last; 1 without either. Copies share the expression, so that one thread at a time may ask all of them.
struct Amplitude {
  std::vector<double> time, factor;
  std::shared_ptr<const Expression> expression = {};
  std::string of = {};  ///< what it belongs to, for messages: "load 2"
  /// Throws RunError where the expression has no finite value.
  double at(double t) const;
};

/// How a step of the finite element path goes: the discrete gradient that keeps the energy, the mid-point rule, the
/// trapezoidal rule (Newmark's with beta = 1/4, gamma = 1/2), central differences with lumped masses; or no dynamics.
enum class Integrator { energy, midpoint, trapezoid, central, equilibrium };
template <>
inline constexpr std::array<Word<Integrator>, 4> words<Integrator>{{{Integrator::energy, "energy"},
                                                                    {Integrator::midpoint, "midpoint"},
                                                                    {Integrator::trapezoid, "trapezoid"},
                                                                    {Integrator::central, "central"}}};

/// One material of a mesh.
struct SolidRegion {
  std::string name;
  ElasticLaw law;
  double density = 0;  // of the reference shape [mass/volume]
  Vec<3> velocity{};   // at the start
  Vec<3> spin{};       // angular velocity about the region's centre of mass at the start [1/time]
};

/// A load on sides [force/area], at each of some nodes [force] or, without any of these, in the volume of a region
/// [force/volume]. Its force keeps its direction; its pressure pushes against the sides as they lie at the time.
struct Load {
  Sides sides;
  std::vector<int> nodes;
  int region = -1;  // from 0
  Vec<3> force{};
  double pressure = 0;
  Amplitude amplitude;

  bool is_dead() const { return force != Vec<3>{}; }
};

/// Nodes that follow a prescribed displacement in some directions [length].
struct Support {
  std::vector<int> nodes;
  std::array<bool, 3> fixed{};
  Vec<3> displacement{};
  Amplitude amplitude;
  int number = 0;  ///< of the deck's support, from 1; 0 of a wall
};

/// A place of a body whose path is recorded, and what the history calls it.
struct TrackedPlace {
  MeshPlace place;
  std::string name;
};

/// Elastic bodies on a mesh, as the deck's groups $mesh and $fem describe them.
struct Solids {
  Mesh mesh;
  std::vector<SolidRegion> regions;
  std::vector<Load> loads;
  std::vector<Support> supports;
  std::vector<TrackedPlace> tracked;
  Integrator integrator = Integrator::energy;
  Dilatation dilatation = Dilatation::automatic;
  double alpha = 0, beta = 0;     ///< Rayleigh damping alpha M + beta K [1/time], [time]
  double tolerance = 1e-11;       ///< of Newton's method: residual over the largest force
  bool from_equilibrium = false;  ///< starts in equilibrium with the loads of t = 0
  std::optional<Contact> contact = {};
};

/// The energy that bodies store where rounding moves their nodes by a 1e-13 of the bodies' extent, from a neighbour to
/// the next: what is less is no motion [energy, in the plane per unit depth].
double rounding_energy(const Solids& solids);

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
