// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/rigid.hpp"
#include "model/solids.hpp"
#include "results/saved_state.hpp"
#include "solvers/fem/rigid_step.hpp"

namespace tether::fem {

/// The mesh's bodies as one rigid body, and its loads: what no step changes.
class RigidSystem {
 public:
  /// `gravity` acts along y [length/time2]. Solids and rigid must outlive the system. Throws InputError where the mesh
  /// has no breadth to turn about.
  RigidSystem(const Solids& solids, const Rigid& rigid, double gravity);

  /// All loads of a time, without the weight.
  RigidForces loads(double time) const;
  RigidState start() const;

  const Solids& solids;
  const Rigid& rigid;
  Eigen::Vector3d gravity;
  RigidBody body;
  RigidForces weight;
  Eigen::Matrix<double, 4, Eigen::Dynamic> nodes;  ///< [1, theta] of each node: its place is q times that (18)

 private:
  struct Load {
    RigidForces forces;
    const Amplitude* amplitude;
  };
  std::vector<Load> loads_;
};

/// Of a rigid body and its run.
struct RigidRunState {
  RigidState body;
  double time = 0, time_lost = 0;  ///< time_lost: what compensated summation owes [time]
  double work = 0;                 ///< done by the loads so far, without the weight's [energy]
  double dt_last = 0, dt_min = 0;  ///< [time]
  long long steps = 0, newton_steps = 0, halvings = 0;
};

template <class Exchange>
void exchange(Exchange& with, const char* name, RigidColumns& columns) {
  std::vector<double> numbers(columns.data(), columns.data() + columns.size());
  with(name, numbers);
  std::copy(numbers.begin(), numbers.end(), columns.data());
}

/// Lists what a step depends on over saver and restorer alike.
template <class Exchange>
void exchange(Exchange& with, RigidRunState& state) {
  exchange(with, "q", state.body.q), exchange(with, "v", state.body.v);
  exchange(with, "lost_q", state.body.lost_q), exchange(with, "lost_v", state.body.lost_v);
  with("time", state.time), with("time_lost", state.time_lost), with("work", state.work);
  with("dt_last", state.dt_last), with("dt_min", state.dt_min);
  with("steps", state.steps), with("newton_steps", state.newton_steps), with("halvings", state.halvings);
}

}  // namespace tether::fem
