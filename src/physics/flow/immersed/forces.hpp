// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/point_finder.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/immersed/rates.hpp"
#include "physics/flow/immersed/solids.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// A force in the plane and its torque about a place.
struct PlaneForce {
  double x = 0, y = 0, torque = 0;
  void add(double fx, double fy, double arm_x, double arm_y) { x += fx, y += fy, torque += arm_x * fy - arm_y * fx; }
  void add(const PlaneForce& other, double times = 1) {
    x += times * other.x, y += times * other.y, torque += times * other.torque;
  }
};

/// What a body has got in the last step: body_forces of FlowState has 9 numbers a body, in this order.
struct BodyForce {
  PlaneForce fluid;  ///< of the fluid, about the body's centre
  Vec<2> hold{};     ///< of supports and walls [force]
  Vec<2> change{};   ///< of the body's momentum by time [force]
  Vec<2> centre{};   ///< of the body [length]
  static constexpr std::size_t size = 9;
};
BodyForce body_force(std::span<const double> body_forces, std::size_t body);

/// What a body's clamps give to what a force is recorded of: clamps of FlowState has 6 numbers a force and body, those
/// of bodies within those of forces.
struct Clamp {
  PlaneForce held;   ///< what supports take of held nodes that lie on walls there
  PlaneForce given;  ///< what else the body gives to the fluid's nodes there, a part of these nodes' forces
  static constexpr std::size_t size = 6;
};
Clamp clamp(std::span<const double> clamps, std::size_t bodies, std::size_t force, std::size_t body);

/// The forces of immersed bodies. A body's equations leave forces at its nodes: those of held ones are what supports
/// give them. Those of the others the fluid's functions carry to the fluid's nodes, to which those of the fluid that is
/// taken to fill the body's place are added: its inertia less its weight, and its stress. What of both stands at nodes
/// that walls prescribe, these give to the body: with that of supports it is the body's hold. The rest is what the
/// fluid around the body gives it, for there all forces are in balance. So the fluid's force, hold, weight and loads
/// are the change of momentum by the body's full density, on any mesh: the stress in the body's place adds up to
/// nothing.
class ImmersedForces {
 public:
  /// All must outlive it.
  ImmersedForces(const ImmersedSolids& immersed, const FlowUnknowns& unknowns, const FlowElements& elements,
                 double gravity);

  /// No forces.
  void start(FlowState& state) const;
  /// Those of the step that ends, which `m` is about, before its places are left.
  void record(const FlowMoment& m, FlowState& state);

 private:
  void find_stress(const FlowMoment& m);
  void split_forces(std::size_t body);
  void record_body(std::size_t body, const BodyRates& rates, std::span<double> to) const;
  void record_clamp(std::size_t force, std::span<double> to) const;
  double part_on_walls(std::size_t carried) const;

  const ImmersedSolids& immersed_;
  const FlowUnknowns& unknowns_;
  const FlowElements& elements_;
  double gravity_;
  PointFinder finder_;
  std::vector<double> on_wall_;                // 1 of the fluid's nodes on walls, else 0
  std::vector<std::vector<double>> shares_;    // of each region, its part of each solid node
  std::vector<std::vector<NodeShare>> nodes_;  // of each recorded force
  std::vector<std::array<double, 3>> stress_;  // of the fluid in the bodies' places: xx, yy, xy
  // Of one body: what supports take; the forces at its nodes that go to the fluid's, and what walls have of these.
  std::vector<double> held_, free_, given_;
};

}  // namespace tether::fem
