// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "physics/box/flow.hpp"
#include "physics/box/solid_equations.hpp"
#include "physics/solids/step.hpp"

namespace tether::coupled {

/// Friction and pressures of a viscous fluid, found together: friction acts on velocities that are driven by the
/// pressures of the step's end, and these are found for what friction left. Passes over both go on until the velocities
/// that friction acted on are those of the end. One pass alone, with the pressures of the step before, has bodies in a
/// fluid of much viscosity swing to and fro.
class FrictionPasses {
 public:
  /// All must outlive it.
  FrictionPasses(const Coupled& scene, const Vec<3>& gravity, const SolidEquations& solids, const Flow& flow,
                 FlowFriction& friction)
      : scene_(scene), gravity_(gravity), solids_(solids), flow_(flow), friction_(friction) {}

  /// What a pass has after friction: forces, pressures and the motion of the solids, each time from the same start.
  struct Step {
    std::function<fem::NewtonReport(CoupledState&, double left)> find;  ///< may leave a part of what it begins with
    const FaceValues& change;            ///< that forces and pressures made of the velocities in it [velocity]
    const std::vector<double>& working;  ///< velocities of the nodes that the fluid sees in it [velocity]
    bool linear;                         ///< what it finds is linear in what friction leaves
    NodeInertia nodes;                   ///< of these velocities; none where the fluid slips along them
    std::span<double> drag;              ///< of the fluid's friction on the nodes, which it takes [force]
  };

  /// Finds a step of length h from a state, whose particles have no part in it. Where passes do not settle there is a
  /// warning once.
  fem::NewtonReport find(const Step& step, double h, CoupledState& state, std::vector<std::string>& messages) const;

 private:
  /// How well a pass finds its parts.
  struct Digits {
    double friction;  ///< of the momentum that it moves
    double left;      ///< of what the motion of the solids leaves over where it begins; 0: all its digits
  };
  /// What a pass found.
  struct Pass {
    fem::NewtonReport report;
    std::vector<double> rubbed;  ///< velocities of the nodes by friction and their drive [velocity]
  };
  Pass pass(const Step& step, double h, const Digits& digits, CoupledState& state) const;
  std::vector<double> weights(const CoupledState& state) const;
  std::vector<double> missed_drive(const Step& step, std::span<const double> drive, std::span<const double> rubbed,
                                   double h, CoupledState& state) const;
  void drive_by(std::span<const double> drive, CoupledState& state) const;
  double miss_of(std::span<const double> missed, std::span<const double> weights, double h,
                 const CoupledState& state) const;
  void add_viscous_pressure(double h, std::span<double> missed) const;
  void let_friction_be_first(const Step& step, double h, std::vector<double>& drive, const CoupledState& state) const;

  const Coupled& scene_;
  Vec<3> gravity_;  // [acceleration]
  const SolidEquations& solids_;
  const Flow& flow_;
  FlowFriction& friction_;
};

}  // namespace tether::coupled
