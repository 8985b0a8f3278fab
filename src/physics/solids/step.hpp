// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/process.hpp"
#include "physics/contact/body_contact.hpp"
#include "physics/solids/rigid_guess.hpp"
#include "physics/solids/surroundings.hpp"
#include "physics/solids/system.hpp"

namespace tether::fem {

/// How far Newton's method goes in a step.
struct NewtonRule {
  int most_iterations, most_shortenings;  ///< corrections, and halvings of one that leads away
};

/// Whole corrections find the way in stiff and slender bodies, through larger residuals; where they lead nowhere, as in
/// long steps of soft ones, a second attempt takes care.
inline constexpr std::array newton_rules{NewtonRule{12, 0}, NewtonRule{25, 6}};

/// Where bodies meet, surfaces stop corrections short, and stiffen from one to the next: more of them are needed.
inline constexpr NewtonRule meeting_rule{100, 8};
/// Backward Euler is for where these lead nowhere, and has a way down from anywhere.
inline constexpr NewtonRule euler_rule{300, 20};

/// How Newton's method went in a step.
struct NewtonReport {
  bool converged = false;
  std::vector<double> residuals;  ///< of each iteration, over the largest force
};

/// Which forces an implicit integrator balances in a step.
struct StepForces {
  StressAt at = StressAt::end;  ///< where between the step's ends the stress is taken
  bool dynamic = false;         ///< with inertia and damping, (17); else equilibrium at the step's end
  bool mean = false;            ///< inner and outer forces are the mean of both ends (trapezoidal rule)
  bool ends_as_mean = false;    ///< the velocity at the end is that over the step, of which it else is the mean
  bool euler = false;           ///< backward Euler: an energy is made least
  double loads_at = 1;          ///< part of the step after which the loads are taken, unless they are a mean
  Definite tangent = Definite::positive;
};

/// Those of an equilibrium, at the step's end.
inline constexpr StepForces equilibrium_forces{.at = StressAt::end};
inline constexpr StepForces euler_forces{.at = StressAt::end, .dynamic = true, .ends_as_mean = true, .euler = true};

/// Part of a step over which the velocities of supports are measured, to both sides of its end.
constexpr double slope_width = 1e-3;

/// What the steps have cost; the symbolic analysis is a part of the solution.
struct SolidCost {
  Seconds assembly, solve, analysis;
  double factor_nonzeros = 0;
};

/// One step of elastic bodies, from q0, v0 at t to q1, v1 at t + dt, by the solids' integrator.
class SolidStep {
 public:
  /// The system must outlive it, and surroundings, where something besides loads and contact acts.
  explicit SolidStep(const SolidSystem& system, Surroundings* surroundings = nullptr);

  /// Advances the state by dt, or leaves it as it was where Newton's method does not converge.
  NewtonReport advance(SolidState& state, double dt);
  /// Lets the next step begin its search where the last one ended: the same step again, in surroundings that have
  /// changed a little. Such a step may leave this part of what its beginning leaves over, and is no whole solution
  /// then.
  void start_where_it_ended(double left = 0) { again_ = true, ended_ = q1_, left_ = left; }
  /// Does the same by backward Euler, which takes energy: what is left for bodies that meet where steps that keep the
  /// energy are halved as often as they may be.
  NewtonReport advance_by_euler(SolidState& state, double dt);
  /// Does the same by a step that keeps the energy of shapes and contact, and takes of that of motion: the velocity at
  /// its end is that over the step.
  NewtonReport advance_calmly(SolidState& state, double dt);
  /// Finds how bodies touch where they are.
  void look_at_contact(SolidState& state);
  bool can_take_euler() const { return contact_ && rule_.dynamic; }
  /// Brings the state into equilibrium with the loads and supports of its time, at rest; by parts of them where all at
  /// once lead nowhere.
  NewtonReport settle(SolidState& state);
  /// Returns what central differences allow at these places [time].
  double longest_explicit_step(std::span<const double> q) const;

  const SolidCost& cost() const { return cost_; }
  /// Returns what the forces of the last step leave over: rounding, or what supports hold [force].
  std::span<const double> residual() const { return residual_; }
  /// Returns the forces of contact in the last step, which act against those from outside; zero without contact
  /// [force].
  std::span<const double> touching() const { return touching_; }
  /// Returns the size of the terms of the power of the last step's forces at velocities w [power].
  double terms_size(std::span<const double> w) const;

 private:
  NewtonReport settle_by(SolidState& state, double part);
  NewtonReport newton(const SolidState& state, double dt, const NewtonRule& rule);
  NewtonReport find_end(SolidState& state, double dt);
  NewtonReport meet(SolidState& state, double dt);
  bool goes_free(const SolidState& state);
  NewtonReport meet_by_easing(SolidState& state, double dt);
  void approach(const SolidState& state);
  void begin(const SolidState& state, double dt);
  void guess(const SolidState& state, double dt);
  void find_dead_forces(double time, double dt);
  void find_forces(const SolidState& state, double dt, bool again);
  void find_outer_forces(const SolidState& state, double dt);
  void add_pressures(const SolidState& state, double dt);
  double find_residual(const SolidState& state, double dt);
  double residual_after_correction(const SolidState& state, double dt, int shortenings, double before);
  double residual_downhill(const SolidState& state, double dt, int shortenings, double before);
  double left_over(double residual) const;
  double next_correction();
  static bool stagnates(const std::vector<double>& residuals);
  bool leads_nowhere() const;
  bool does_for_now() const;
  bool is_rounding() const;
  double known_places() const;
  bool nothing_acts() const;
  void note_stiffness(const SparseMatrix& K);
  bool correct(const SolidState& state, double dt);
  bool solve(SparseMatrix& K);
  void go_on();
  void shorten(double part);
  bool is_whole() const;
  bool supports_are_there() const;
  void lead_supports(const SparseMatrix& K);
  void stop_before_surfaces();
  void shorten_correction(double part);
  void accept(SolidState& state, double dt);
  void accept_contact(SolidState& state);
  void accept_motion(SolidState& state, double dt, double falling);
  void accept_equilibrium(SolidState& state);
  void note_hold(SolidState& state) const;
  /// The velocity at the end of a step of which the mean is w, from v0 at its start: w = (v0 + v1)/2 (17), or w = v1.
  double velocity_at_end(double w, double v0) const { return rule_.ends_as_mean ? w : 2 * w - v0; }
  /// Its derivative by w.
  double end_per_mean() const { return rule_.ends_as_mean ? 1 : 2; }
  double lost_by_ending_as_mean(const SolidState& state, double dt) const;
  double along_correction() const;
  void add_damping(double dt, std::span<const double> q0);
  void find_accelerations(std::span<const double> q, std::span<const double> v, double time, std::span<double> a);
  void explicit_step(SolidState& state, double dt);

  const SolidSystem& system_;
  Surroundings* surroundings_;
  StepForces rule_;
  RigidGuess rigid_guess_;
  SparseSolver solver_;
  std::optional<contact::BodyContact> contact_;
  bool meets_ = false;         // whether the forces of contact are asked
  bool again_ = false;         // whether the next step is to start where the last one ended
  std::vector<double> ended_;  // where that was, in such a step; else empty [length]
  double left_ = 0;            // part of what its beginning leaves over, that such a step may leave
  SparseMatrix K_, K0_;        // the tangent, and that of the reference shape, for damping
  // Places at the step's end; forces: inner ones at the start (trapezoidal rule), inner, outer, of these the ones that
  // the shape does not change, inertia, damping; their sum, the residual; the correction; and what is in between.
  std::vector<double> q1_, start_, inner_, outer_, dead_, inertia_, damping_, residual_, change_, scratch_;
  std::vector<double> touching_, led_;  // forces of contact, part of the inner ones; places where supports lead to
  double loaded_ = 1;                   // part of the loads that act while a body settles
  std::vector<double> moved_;           // velocities of supported nodes at the step's end
  std::vector<double> sizes_;           // of the residuals of corrections of bodies that meet [force]
  double part_ = 1;                     // of the last correction that was gone
  double scale_ = 0;                    // the largest force
  std::vector<double> stiffness_;       // of each unknown the largest number of its row of the tangent
  SolidCost cost_;
};

}  // namespace tether::fem
