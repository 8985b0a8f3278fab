// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "algebra/sparse_solver.hpp"
#include "model/solids.hpp"
#include "physics/contact/contact_numbers.hpp"
#include "physics/solids/body_doubts.hpp"
#include "physics/solids/elements.hpp"
#include "physics/solids/side_pressure.hpp"
#include "physics/step_clock.hpp"
#include "results/results.hpp"

namespace tether::fem {

/// What contact did that is doubtful, so far.
struct ContactDoubts {
  double slid = 0;            ///< farthest way past each other of damped surfaces in a step, over the gap
  long long eased = 0;        ///< steps in which friction came up over a longer way than the deck's
  long long euler_steps = 0;  ///< steps by backward Euler because nothing else led on
};

/// How bodies touch: at the end of the last step, and what contact has taken so far.
struct ContactState {
  contact::ContactNumbers last;
  double rubbed = 0;  ///< by friction [energy]
  double damped = 0;  ///< where it is damped, and in steps of backward Euler [energy]
  ContactDoubts doubts;

  /// Takes note of a step's end, in which contact took `work` in all [energy]; `gap` is that of the contact.
  void note(contact::ContactNumbers now, double work, double gap) {
    doubts.slid = std::max(doubts.slid, now.slid / gap);
    rubbed += now.rubbed;
    damped += work - now.rubbed - (now.energy - last.energy);
    last = std::move(now);
  }
};

/// Of elastic bodies; dim numbers a node.
struct SolidState : StepClock {
  std::vector<double> q, v;  ///< places [length] and velocities of the nodes
  std::vector<double> a;     ///< accelerations, of central differences only [length/time2]
  double of_loads = 0;       ///< work that loads have done so far [energy]
  double of_supports = 0;    ///< work of supports and walls that lead nodes [energy]
  double damped = 0;         ///< taken by damping so far, and by steps of backward Euler [energy]
  std::vector<double> hold;  ///< what supports and walls did in the last step to unknowns that they hold [force]
  double residual = 0;       ///< that Newton's method ended the last step with, over the largest force
  long long newton_steps = 0, halvings = 0;
  ContactState contact;
  OverlapCount overlap;
  BodyDoubtNumbers doubts;
};

template <class Exchange>
void exchange(Exchange& with, ContactState& contact) {
  contact::ContactNumbers& last = contact.last;
  with("contact_energy", last.energy), with("rubbed", contact.rubbed), with("contact_damped", contact.damped);
  with("pressing", last.pressing), with("least_gap", last.least_gap), with("touching_sides", last.sides);
  with("contact_pressure", last.pressure), with("contact_friction", last.friction);
  with("contact_distance", last.distance);
  ContactDoubts& doubts = contact.doubts;
  with("slid", doubts.slid), with("eased", doubts.eased), with("euler_steps", doubts.euler_steps);
}

/// Lists what a step depends on over saver and restorer alike.
template <class Exchange>
void exchange(Exchange& with, SolidState& state) {
  exchange_clock(with, state);
  with("q", state.q), with("v", state.v), with("a", state.a);
  with("of_loads", state.of_loads), with("of_supports", state.of_supports), with("damped", state.damped);
  with("hold", state.hold), with("residual", state.residual);
  with("newton_steps", state.newton_steps), with("halvings", state.halvings);
  exchange(with, state.contact), exchange(with, state.overlap), exchange(with, state.doubts);
}

/// What the equations of elastic bodies are made of, that no step changes. Vectors have dim numbers a node.
class SolidSystem {
 public:
  /// `gravity` is an acceleration [length/time2]. The solids must outlive the system, and the team that shares its
  /// loops.
  SolidSystem(const Solids& solids, const Vec<3>& gravity, Team& team);
  /// One whose gravity acts along y.
  SolidSystem(const Solids& solids, double gravity, Team& team) : SolidSystem(solids, Vec<3>{0, gravity, 0}, team) {}

  int dim() const { return solids.mesh.dim(); }
  std::size_t unknowns() const { return solids.mesh.x.size(); }
  /// y = M v, the consistent mass matrix for each direction.
  void multiply_mass(std::span<const double> v, std::span<double> y) const;
  /// Adds `factor` times this matrix to one of the pattern.
  void add_mass(double factor, SparseMatrix& matrix) const;
  /// Forces that do not depend on the shape at a time: loads that keep their direction, and gravity [force].
  void external_forces(double time, std::span<double> f) const;
  /// Adds `factor` times those of pressures at a time between the shapes q0 and q1, where `at` says [force].
  void add_pressures(double time, StressAt at, std::span<const double> q0, std::span<const double> q1,
                     std::span<double> f, double factor = 1) const;
  /// Adds `factor` times the derivative of these forces by q1.
  void add_pressure_tangent(double time, StressAt at, std::span<const double> q0, std::span<const double> q1,
                            double factor, SparseMatrix& K) const;
  bool has_pressures() const { return !pressures_.empty(); }
  Team& team() const { return team_; }
  /// Size of gravity's acceleration [length/time2].
  double gravity() const;
  /// Potential energy of gravity, zero at the origin [energy].
  double gravity_energy(std::span<const double> q) const;
  /// Sets the places of supported nodes to where they are at a time.
  void place_supports(double time, std::span<double> q) const;
  /// Sets the velocities of supported nodes to how their places change about a time, from `h` before it, though not
  /// before t = 0, to `h` after it.
  void move_supports(double time, double h, std::span<double> v) const;

  const Solids& solids;
  std::unique_ptr<Elements> elements;
  NodalPattern pattern;
  SparseMatrix mass;                               ///< a number a pair of nodes
  std::vector<double> weights;                     ///< row sums of the consistent mass matrix, a number a node [mass]
  std::vector<std::vector<double>> region_lumped;  ///< each region's part of the lumped masses [mass]
  std::vector<double> lumped;                      ///< their sums, a number a node, all positive [mass]
  /// Of each region its part of the nodes' masses, of those that the integrator moves: where it is and how it moves is
  /// the mean by these [mass].
  std::vector<std::vector<double>> region_weights;
  std::vector<std::uint8_t> held;  ///< unknowns that supports prescribe
  std::vector<int> holder;         ///< of each unknown: the last support that prescribes it, from 0; -1 of free ones

 private:
  struct NodalLoad {
    std::vector<double> parts;  // a number a node: load_parts()
    const Load* load;
  };
  struct FollowingLoad {
    SidePressure of;
    const Load* load;
  };
  Team& team_;
  Vec<3> gravity_;
  std::vector<NodalLoad> loads_;
  std::vector<FollowingLoad> pressures_;
};

/// Velocities of the nodes at the start: each region moves and turns about its centre of mass; a node that regions
/// share has the mean of theirs by mass. Supported directions are at rest.
std::vector<double> first_velocities(const SolidSystem& system);

}  // namespace tether::fem
