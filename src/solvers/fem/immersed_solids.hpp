// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/flow.hpp"
#include "solvers/fem/body_rates.hpp"
#include "solvers/fem/flow_state.hpp"
#include "solvers/fem/flow_unknowns.hpp"
#include "solvers/fem/immersed_inertia.hpp"
#include "solvers/fem/immersed_map.hpp"
#include "solvers/fem/solid_system.hpp"

namespace tether::fem {

/// Elastic bodies immersed in a flow (3): what a step asks of them. Their nodes go with the fluid's interpolated
/// velocity (51), and their stress, their excess inertia and weight act on the fluid through the transpose of the same
/// map, taken once a step at the predicted middle (49), (55). The fluid's pressure and viscosity stay in their place:
/// with the pressure subtracted, too, as (55) prints, it would have no equation inside of them.
class ImmersedSolids {
 public:
  /// Flow, unknowns and solids must outlive it.
  ImmersedSolids(const Solids& solids, const FlowUnknowns& unknowns, double gravity);

  /// Places and velocities of the nodes at the start; those of supported ones over a part of a step of dt.
  void start(FlowState& state, double dt);
  /// A step of dt from the state, whose stress and velocity are taken at theta of it; in a sudden one
  /// supports keep their velocity. Throws RunError where a node is outside of the fluid.
  void begin(const FlowState& state, double dt, double theta, bool sudden);
  /// Moves the nodes by fluid velocities v0, v1 at its ends.
  void move(std::span<const double> v0, std::span<const double> v1);
  /// Ends a correction of v1 that move() has followed.
  void end_correction();
  /// Takes the last one back, after v1 and move().
  void take_back_correction() { stresses_.swap(stresses_before_), corrected_ = q1_; }
  /// The least det F at the step's end, and at the middle where the stress is taken there.
  double least_change_of_volume() const;
  /// Adds the forces on the fluid's momentum equations to f; their size before they balance each other [force].
  double add_forces(std::span<double> f);
  /// The clusters of fluid nodes that the solids couple, pairs of cells.
  Lists clusters() const;
  /// Adds their derivative by v1; `first` is the number of the first of the clusters in the pattern.
  void add_tangent(std::size_t first, const ClusterPattern& pattern, SparseMatrix& K);
  /// Takes the step over into the state, whose v is that of the end; its work from outside is added there.
  void accept(FlowState& state);

  /// Energies of the state: kinetic, of the excess mass; strain; potential, of the excess weight [energy].
  double kinetic_energy(const FlowState& state) const;
  double strain_energy(const FlowState& state) const { return strain_energy(state.q); }
  double potential_energy(const FlowState& state) const { return system_.gravity_energy(state.q); }
  /// Of the last step, before accept(): the forces that the nodes' equations leave, of stress, excess inertia, excess
  /// weight and loads, which the fluid takes of free ones and supports of held ones; and where the nodes are, how they
  /// move and are accelerated.
  struct LastStep {
    std::span<const double> forces;
    BodyMotion motion;
  };
  LastStep last_step() const { return {F_, {middle_, V_, rate_}}; }
  /// Adds what the fluid's nodes get of forces at free solid nodes to f.
  void spread(std::span<const double> forces, std::span<double> f) const { map_.add_forces(forces, f); }
  const ImmersedMap& map() const { return map_; }

  /// The element that is nearest to being turned inside out, for messages.
  std::string worst_element() const;

  const Solids& solids() const { return solids_; }
  const SolidSystem& system() const { return system_; }

 private:
  double strain_energy(std::span<const double> q) const;
  void place(std::span<const double> x, double time);
  void find_tangent();
  std::vector<std::pair<std::size_t, std::size_t>> cell_pairs() const;
  static void spread(const double (&s)[2][2], std::span<const double> of_c, std::span<const double> of_d, double* block,
                     std::size_t size);
  std::vector<std::vector<double>> blocks_of(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const;

  const Solids& solids_;
  const FlowUnknowns& unknowns_;
  Solids excess_;  // with densities less the fluid's
  SolidSystem system_;
  std::unique_ptr<ExcessInertia> inertia_;  // null where there is none
  Solids penalised_;                        // with laws that cost volume alone
  std::unique_ptr<Elements> penalty_;       // null where nothing is penalised
  StressAt rule_ = StressAt::gradient;
  ImmersedMap map_;
  SparseMatrix S_;
  // The step: solid nodes' places at its start, middle and end, and there behind the last correction; the stress that
  // the tangent takes; what supports prescribe, their places and velocities at its end and accelerations; velocity,
  // acceleration and forces.
  double time_ = 0, dt_ = 0, theta_ = 0.5;
  std::vector<double> q0_, middle_, q1_, corrected_, stresses_, stresses_before_, supported_, led_, led_rate_, V_,
      rate_, F_, free_, outer_, change_, difference_;
};

}  // namespace tether::fem
