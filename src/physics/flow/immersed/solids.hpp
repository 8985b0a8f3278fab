// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "grid/carried_nodes.hpp"
#include "model/flow.hpp"
#include "physics/contact/body_contact.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/immersed/blocks.hpp"
#include "physics/flow/immersed/map.hpp"
#include "physics/flow/immersed/pressure.hpp"
#include "physics/flow/immersed/rates.hpp"
#include "physics/flow/state.hpp"
#include "physics/flow/unknowns.hpp"
#include "physics/solids/system.hpp"

namespace tether::fem {

/// Of a steady solution: when the loads are those that it takes [time], and the part of them that acts.
struct LoadsAtRest {
  double time = 0, part = 1;
};

/// What a step of a flow hands to its bodies: its length [time], where in it stress and velocity are taken (theta),
/// 1/dt or 0 for a steady flow [1/time], the fluid's viscosity [stress time]; in a sudden one supports keep their
/// velocity. In search of a steady solution bodies have no inertia and the map is taken at the start.
struct ImmersedMoment {
  double dt = 0, theta = 0.5, rate = 0, viscosity = 0;
  bool sudden = false;
  std::optional<LoadsAtRest> rest{};
};

/// Elastic bodies immersed in a flow (3): what a step asks of them. Nodes that the fluid carries go with its
/// interpolated velocity (51), the others follow these; the bodies' stress, excess inertia and weight act on the fluid
/// through the transpose of the same map, taken once a step at the predicted middle (49), (55). The fluid's viscosity
/// stays in its place; its pressure is taken out of bodies that have a law for their volume, where (55) has it taken
/// out of all, and goes on smoothly in them, for else it would have no equation there.
class ImmersedSolids {
 public:
  /// Flow, unknowns and solids must outlive it.
  ImmersedSolids(const Solids& solids, const FlowUnknowns& unknowns, double gravity, Team& team);

  /// Places and velocities of the nodes at the start; those of supported ones over a part of a step of dt.
  void start(FlowState& state, double dt);
  /// A step from the state. Throws RunError where a node is outside of the fluid.
  void begin(const FlowState& state, const ImmersedMoment& moment);
  /// Moves the nodes by fluid velocities v0, v1 at its ends.
  void move(std::span<const double> v0, std::span<const double> v1);
  /// Lets the nodes of bodies that meet stay before the surface that is in the way of the first guess, as open_gap()
  /// does at the step's start. After move().
  void stop_guess();
  /// Returns the part of the present correction, which move() has followed, before surfaces stop it.
  double part_before_surfaces();
  bool meets() const { return contact_.has_value(); }
  /// Returns whether surfaces press each other, so that the tangent changes much from one correction to the next.
  bool press() const;
  /// Lets the nodes stay where the step has begun, with a gap to where v1 takes them, which the corrections close: of
  /// a steady flow, whose velocity was zero at the places of before, not at these. After move().
  void open_gap();
  /// A part of the present correction closes as much of the gap; before move().
  void close_gap(double part) { open_ = open_before_ * (1 - part); }
  bool gap_is_open() const { return open_ > 0; }
  /// How long bodies have to go with the fluid until they are at rest in it to 1e-4 and better [time].
  double settling_time(double viscosity);
  /// The largest velocity at the fluid's nodes about the bodies, of which theirs is a mean, in the step.
  double speed_beside() const;
  /// Ends a correction of v1 that move() has followed.
  void end_correction();
  /// Takes the last one back, after v1 and move().
  void take_back_correction() { stresses_.swap(stresses_before_), corrected_ = q1_; }
  /// The least det F at the step's end, and at the middle where the stress is taken there.
  double least_change_of_volume() const;
  /// Adds the forces on the fluid's momentum equations to f, and to g what they change in those of continuity, with the
  /// pressures p; the sizes of both before they balance each other.
  FlowScale add_forces(std::span<const double> p, std::span<double> f, std::span<double> g);
  /// Finds their derivatives by v1 and p.
  void linearise();
  /// The clusters of fluid nodes that the solids couple, pairs of cells; since linearise().
  Lists clusters() const { return blocks_->clusters(); }
  /// Adds the derivatives; `first` is the number of the first of the clusters in the pattern.
  void add_tangent(std::size_t first, const ClusterPattern& pattern, SparseMatrix& K) const {
    blocks_->add_to(first, pattern, K);
  }
  /// Takes the step over into the state, whose v is that of the end; its work from outside is added there.
  void accept(FlowState& state);

  /// Energies of the state: kinetic, of the excess mass; strain; potential, of the excess weight [energy].
  double kinetic_energy(const FlowState& state) const;
  double strain_energy(const FlowState& state) const { return strain_energy(state.q); }
  double potential_energy(const FlowState& state) const { return system_.gravity_energy(state.q); }
  /// Of the last step, before accept(): the forces that the nodes' equations leave, of stress, excess inertia, excess
  /// weight, loads and the pressure that is not inside, which the fluid takes of free ones and supports of held ones;
  /// and where the nodes are, how they move and are accelerated.
  struct LastStep {
    std::span<const double> forces;
    BodyMotion motion;
    double loaded;  ///< part of the loads and of gravity that acted, below 1 on the way to a steady solution
  };
  LastStep last_step() const { return {F_, {middle_, V_, rate_}, moment_.rest ? moment_.rest->part : 1}; }
  /// Moves forces at nodes that follow to those that are carried, of free and of held nodes; what comes to held ones
  /// of the free ones their supports take.
  void lead_to_carried(std::span<double> free, std::span<double> held) const;
  /// Adds what the fluid's nodes get of forces at solid nodes to f.
  void spread(std::span<const double> forces, std::span<double> f) const;
  /// Returns the map of the carried nodes, in their order.
  const ImmersedMap& map() const { return map_; }

  const Solids& solids() const { return solids_; }
  const SolidSystem& system() const { return system_; }
  const CarriedNodes& carried() const { return carried_; }

 private:
  double strain_energy(std::span<const double> q) const;
  void place(std::span<const double> x, double time);
  void velocities(std::span<const double> v, std::span<const double> given, std::span<double> V);
  EigenSparse find_tangent();
  void find_stiffness();
  SparseMatrix& with_contact(double factor);
  void note_contact(FlowState& state);
  void add_forces_of_gap();
  void find_rounding();
  void release_carried(EigenSparse& A, bool rows) const;

  const Solids& solids_;
  const FlowUnknowns& unknowns_;
  Solids excess_;  // with densities less the fluid's
  SolidSystem system_;
  std::unique_ptr<ExcessInertia> inertia_;  // null where there is none
  Solids penalised_;                        // with laws that cost volume alone
  std::unique_ptr<Elements> penalty_;       // null where nothing is penalised
  StressAt rule_ = StressAt::gradient;
  CarriedNodes carried_;
  ImmersedMap map_;                           // of the carried nodes
  std::optional<ImmersedPressure> pressure_;  // of bodies with a law for their volume
  std::optional<contact::BodyContact> contact_;
  SparseMatrix S_, met_;  // met_: with contact
  std::optional<ImmersedBlocks> blocks_;
  // The step: solid nodes' places at its start, middle and end, and there after the last correction; the stress that
  // the tangent takes; what supports prescribe, their places and velocities at its end and accelerations; velocity,
  // that at its end, acceleration and forces; numbers of carried nodes.
  double time_ = 0, rounding_ = 0;
  ImmersedMoment moment_;
  std::vector<double> q0_, middle_, q1_, corrected_, stresses_, stresses_before_, supported_, led_, led_rate_, V_, V1_,
      rate_, F_, free_, outer_, change_, difference_, at_carried_, touching_;
  // The gap at the step's start [length], the part of it that is open, and that before the present correction.
  std::vector<double> gap_;
  double open_ = 0, open_before_ = 0;
};

}  // namespace tether::fem
