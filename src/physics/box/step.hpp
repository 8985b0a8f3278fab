// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "physics/box/contact.hpp"
#include "physics/box/flow.hpp"
#include "physics/box/fluid_around.hpp"
#include "physics/box/friction_passes.hpp"
#include "physics/box/solid_equations.hpp"
#include "physics/box/state.hpp"
#include "physics/box/swings.hpp"
#include "physics/box/system.hpp"
#include "physics/solids/step.hpp"
#include "plan/plan.hpp"

namespace tether::coupled {

/// After these solutions of a step what touches stays as it is.
constexpr int most_contact_solutions = 60;

/// A step of fluid and solids together. The scene must outlive it, and the team that shares its loops.
class CoupledStep {
 public:
  CoupledStep(const Scene& scene, const Solids& solids, Team& team);

  /// At rest or moving as the scene says, the fluid's velocity made divergence-free beside the solids'.
  CoupledState start();
  /// `by_euler`: the solids as fem::SolidStep::advance_by_euler() has them.
  /// Where it has not converged, the state is neither that before nor that after.
  fem::NewtonReport advance(CoupledState& state, double h, bool by_euler = false);
  /// Returns whether steps keep the energy of the solids: they may need halves then, or backward Euler.
  bool keeps_energy() const { return solid_step_.has_value(); }
  bool can_take_euler() const { return solid_step_ && solid_step_->can_take_euler(); }

  const SolidEquations& solids() const { return solids_; }
  const SolidSurface& surface() const { return surface_; }
  const CoupledSystem& system() const { return system_; }
  /// The fluid about the solids as the last step left them.
  const Flow& flow() const { return *flow_; }
  /// Returns what later steps depend on beside the state: the orders of elimination that have been found.
  std::vector<double> orders() const { return system_.orders(); }
  /// Goes on from a state that was saved with its orders.
  void resume(CoupledState& state);
  std::vector<std::string> take_messages();

 private:
  /// What is found together: pressures, which velocities contact holds, and what holds them.
  struct Solution {
    std::vector<std::uint8_t> held;  ///< by supports and contact
    bool same_matrices = false;      ///< nothing else is held than in the solution before
    double left = 0;                 ///< part of what it begins with that a solution found again may leave
    Regions regions;
    SparseMatrix L;
    std::vector<double> p;        ///< of each pressure [stress]
    std::vector<double> b;        ///< of the solids, with friction and lifts [force]
    std::vector<double> working;  ///< velocities of the solids that the pressures work at: u1, or the step's mean
    std::vector<double> taken;    ///< force of the fluid by the solids' equations, of held ones by the fluid's [force]
    double terms = 0;             ///< size of the terms of these equations' power [power]
    std::vector<double> fluid_force, wall_force, friction;  ///< on the nodes; walls without friction [force]
    std::vector<double> lifts;                              ///< of the nodes that contact halts [length]
  };

  void project_start(CoupledState& state);
  fem::NewtonReport find_calm(CoupledState& state, double h, SolidRule rule, Solution& solution);
  fem::NewtonReport find_step(CoupledState& state, double h, SolidRule rule, Solution& solution);
  fem::NewtonReport find_with_friction(CoupledState& state, double h, SolidRule rule, Solution& solution);
  void solve(CoupledState& state, double h, bool again, Solution& solution);
  Solution begin_solution(const CoupledState& state, double h) const;
  FluidOfStep fluid_of(const CoupledState& state, double h, const Solution& solution) const;
  fem::NewtonReport solve_by_energy(CoupledState& state, double h, SolidRule rule, bool again, Solution& solution);
  void take_moved(const fem::SolidState& moved, CoupledState& state, double h, Solution& solution);
  void book_moved(const fem::SolidState& moved, const Solution& solution, CoupledState& state);
  void look_at_contact(CoupledState& state);
  void finish(CoupledState& state, double h, Solution& solution);
  void note_powers(const CoupledState& state, Solution& solution) const;
  void find_regions_of(const CoupledState& state, double h, Solution& solution) const;
  void solve_once(const FluidOfStep& fluid, CoupledState& state, Solution& solution);
  void account(const FaceValues& free, const Solution& solution, CoupledState& state, double h);
  void book_fluid(const Solution& solution, double moving, double let_in, double sources, CoupledState& state,
                  double h);
  void book_solids(std::span<const double> q0, std::span<const double> u0, const Solution& solution,
                   CoupledState& state, double h);
  double energy_of(const FaceValues& v) const { return flow_->kinetic_energy(v, v); }
  double stored(std::span<const double> q) const;
  void move_solids(CoupledState& state, std::span<const double> u0, double h);
  void check(const CoupledState& state) const;
  void tell_of_unsettled_contact(CoupledState& state);
  void tell_of_unmeasured_volume(const Regions& regions, CoupledState& state);
  void note_bodies_that_left(double time, CoupledState& state);
  void note_turning(CoupledState& state, double h);
  void note_unswept(const std::vector<double>& q0, const Solution& solution, CoupledState& state);

  const Scene& scene_;
  const Coupled& coupled_;
  SolidSurface surface_;
  SolidEquations solids_;
  Contact contact_;
  CoupledSystem system_;
  std::unique_ptr<Flow> flow_;
  FluidAround around_;
  std::optional<FrictionPasses> passes_;      // of a viscous fluid
  std::optional<fem::SolidStep> solid_step_;  // of steps that keep the energy
  std::optional<Swings> swings_;              // of such in a viscous fluid
  std::vector<std::string> messages_;
  FaceValues change_;                  // velocities before forces and pressures act; then what these change
  std::vector<double> drag_;           // of the fluid's friction on the nodes in this step [force]
  std::vector<double> first_volumes_;  // that the surface's sheets enclose at the start
};

}  // namespace tether::coupled
