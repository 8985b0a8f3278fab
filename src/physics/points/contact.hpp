// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "loops/points.hpp"
#include "model/scene.hpp"
#include "physics/points/arrays.hpp"
#include "physics/points/balance.hpp"
#include "physics/points/normals.hpp"

namespace tether::mpm {

/// Nodes that more than one body touches, with mass, momentum, force and velocities of every body there (9.4)-(9.6).
/// What shares a field everywhere counts as one: each solid is one, and all fluids and membranes together are one, for
/// the gas must not leave its membrane; without a fluid each membrane is one.
///
/// `release` decides by a criterion of A.1.3, for every pair of bodies at a node, on the velocities mapped before the
/// force update and once for the step. Bodies that a chain of contacts joins move in their common centre-of-mass field,
/// the others each in its own: for two bodies the thesis' rule, and for three a membrane can be pinched between two.
/// `gap` keeps every body in its own field and, after the solve, takes away the approach of two whose points touch: an
/// impulse along the normal, without friction.
class Contact {
 public:
  Contact(const Scene& scene, const Points& points, const Frame& frame);

  bool on() const { return groups_ > 1; }
  int group_of(std::size_t body) const { return group_of_[body]; }
  std::size_t shared_nodes() const { return nodes_.size(); }

  // Which nodes are shared, and what the points of each body give there. Templates of contact_map.hpp fill these.

  /// Forgets the nodes of the step before.
  void begin();
  /// Returns whether points of the group in this cell have touched their nodes already; from now on they have.
  bool stamp(std::size_t cell, int group) {
    const std::uint64_t mark = stamp_ * 64 + static_cast<std::uint64_t>(group);
    if (cell_stamp_[cell] == mark) return true;
    cell_stamp_[cell] = mark;
    return false;
  }
  /// A body of the group gives to this node.
  void touch(int group, std::size_t node);
  /// Number of a shared node, -1 of any other.
  int slot(std::size_t node) const { return slot_[node]; }
  NodeSums& sums(int slot, int group) { return sums_[index(slot, group)]; }
  /// Point p, or where it gives to a ghost its image, stands at `place`.
  void add_point(int slot, int group, std::size_t p, Pair place, double N) {
    near_[index(slot, group)].push_back({p, place, N});
  }
  /// All bodies have touched their nodes.
  void open(const Frame& frame);
  /// Returns whether a cell's points give to a shared node, or may lend it their colour.
  bool near_shared(std::size_t cell) const { return near_stamp_[cell] == stamp_; }
  /// Slots of the body's points in such cells, in ascending order, from open() to the end of the step.
  std::vector<std::size_t>& near_points(std::size_t body) { return near_points_[body]; }
  void clear_forces();

  // The step.

  /// Which bodies share a field; their velocities before the solve.
  void decide(const Points& points, const Frame& frame);
  /// (9.4), (9.5) of each body, and what contact makes of it.
  void solve(const Points& points, const Frame& frame, double gravity, double dt);
  /// Adds each body's sums at the shared nodes.
  void total(NodeTotals& totals, const Frame& frame, double dt) const;
  /// Velocities from momenta that the points gave back (3.24), each field's own.
  void clear_convected();
  void divide_convected(const Frame& frame);

  /// Puts the fields of a group, before and after the solve, in the place of the common ones, or takes them out again.
  void exchange(Grid& grid, int group);

  /// Energy that the impulses of `gap` took from the bodies since the start [energy].
  double lost() const { return lost_; }
  void set_lost(double lost) { lost_ = lost; }

  /// Pairs of bodies that criterion 3 holds apart, by node and pair: what a restart needs.
  std::vector<int> memory() const;
  void remember(const std::vector<int>& memory);

 private:
  struct Near {
    std::size_t p;
    Pair place;
    double N;
  };
  std::size_t index(int slot, int group) const {
    return static_cast<std::size_t>(slot) * static_cast<std::size_t>(groups_) + static_cast<std::size_t>(group);
  }
  void mark_near(int node, const Frame& frame);
  bool in_contact(int node, int slot, int a, int b);
  void join_fields(int slot);
  void fields_of(int slot, const Frame& frame);
  void impulses(const Points& points, const Frame& frame, int slot, double dt);
  Pair centroid(int slot, int group) const;
  bool edge(const Points& points, int slot, int group, Pair from, Pair normal, double sense, double& edge) const;
  void push_apart(const Points& points, const Frame& frame, int slot, int a, int b, double dt);

  ContactRule rule_;
  int criterion_, groups_ = 0;
  double half_cell_ = 0;        // reach of the gap's points sideways [length]
  std::vector<int> group_of_;   // of each body
  std::vector<double> radius_;  // of each point: half its spacing, half a membrane's thickness [length]
  std::uint64_t stamp_ = 0;     // of the step
  std::vector<std::uint64_t> cell_stamp_, owner_stamp_, near_stamp_;
  std::vector<int> owner_;      // of each node: the first group that touched it
  std::vector<int> slot_;       // of each node: its number, -1 of one that is not shared
  std::vector<int> nodes_;      // the shared ones
  std::vector<Ghost> ghosts_;   // theirs
  std::vector<NodeSums> sums_;  // of each shared node and group, as all below
  std::vector<NodeMotion> motion_;
  std::vector<Pair> convected_;
  std::vector<Vec<2>> normal_;
  std::vector<int> field_;  // the lowest group that shares its field
  std::vector<std::vector<Near>> near_;
  std::vector<Pair> pushed_;                           // of each group at one node: its impulses [momentum]
  std::vector<std::vector<std::size_t>> near_points_;  // of each body
  std::vector<BodyNormals> normals_;
  double lost_ = 0;
  std::set<std::pair<int, int>> apart_;  // criterion 3: node and pair that were let go
};

}  // namespace tether::mpm
