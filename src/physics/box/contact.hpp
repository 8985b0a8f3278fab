// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"

namespace tether::coupled {

/// What a node does at a wall: it is away from it; its velocity across the wall is held at zero and it slides; all of
/// its velocity is held; it ends on the wall by the velocity across that (5) takes it there with; or it is held across
/// and its velocity along the wall is turned round, so that by (5) it does not move there.
enum class Touch : std::uint8_t { away, slides, sticks, rebounds, grips };

/// Contact of the surface's nodes with walls of the box and obstacles, with Coulomb's friction: which nodes touch, and
/// whether they slide, is found together with the velocities, step by step. A node's impact is inelastic; but (5)
/// leaves stiff motions velocities that change their sign every step, and one that a wall would have to pull to a halt,
/// and that would go through it if let go, rebounds. Walls only press, on nodes that come, and rub against the way that
/// (5) takes, so that contact gives the solids no energy. Which of the nodes that are not halted rebound is a linear
/// complementarity problem with a symmetric positive definite matrix: it has one solution, which block pivoting finds.
class Contact {
 public:
  /// Both must outlive it.
  Contact(const Coupled& scene, const SolidSurface& surface);

  /// Finds the walls that nodes at q with velocities u may reach in a step of length h. `touches`, a number a velocity
  /// (that across the wall), says what they did before and will say what they do; those of nodes that are not at a wall
  /// are cleared.
  void begin(std::span<const double> q, std::span<const double> u, double h, std::vector<Touch>& touches);
  /// Marks the velocities that touching nodes do not choose, and sets those of `u1`.
  void hold(std::span<const Touch> touches, std::span<std::uint8_t> held, std::span<double> u1) const;
  /// How much farther than by (5) the step takes nodes that are halted, to end on the wall: zero of all others
  /// [length].
  std::vector<double> lifts(std::span<const Touch> touches, std::size_t unknowns) const;
  /// Adds the friction of sliding nodes to forces.
  void add_friction(std::span<double> forces) const;
  /// Takes note of a solution: velocities u1 after the step, the forces on held velocities, and the inertia
  /// M (u1 - u0). Returns whether nodes touch or slide that did not, or the other way, or are rubbed by another
  /// force: the solution is to be found again then.
  bool changed(std::span<const double> u1, std::span<const double> reactions, std::span<const double> inertia,
               std::vector<Touch>& touches);
  /// Puts nodes that touch a wall, or went through it or into an obstacle, onto it.
  void place(std::span<double> q) const;

 private:
  struct Meeting {
    std::size_t node = 0, axis = 0;
    double side = 1;              // +1: the node stays above the place
    double place = 0;             // of the wall [length]
    double gap = 0;               // at the step's start [length]
    Vec<3> from{};                // where the node is then [length]
    const Box<3>* box = nullptr;  // the obstacle; null: a side of the box
    bool touching = false;        // the node's velocity across is held because of this one
    Vec<3> before{};              // the node's velocity then
    bool released = false;        // in this step, after which it can but rebound
    bool turned = false;          // in this step, by friction: more of it than mu allows may hold it
    bool driven = false;          // in this step, along its way by what halted it: it is not halted again
    Vec<3> along{};               // unit vector of the friction on a node that slides; zero: not known yet
    double friction = 0;          // on it [force]
  };
  double lift(const Meeting& meeting) const;
  /// Returns the velocity with which (5) ends on the wall.
  double rebound(const Meeting& meeting) const {
    return -meeting.before[meeting.axis] - 2 * meeting.side * meeting.gap / h_;
  }
  std::size_t unknown(const Meeting& meeting) const { return meeting.node * dim_ + meeting.axis; }
  void meet_walls(std::size_t node, const Vec<3>& x, double reach);
  void meet_obstacle(const Box<3>& box, std::size_t node, const Vec<3>& x, double reach);
  bool is_covered(const Box<3>& box, std::size_t axis, double up, const Vec<3>& x) const;
  bool is_behind(const Meeting& meeting, const Vec<3>& x) const;
  Touch next(Meeting& meeting, Touch now, std::span<const double> u1, std::span<const double> reactions,
             std::span<const double> inertia) const;
  bool all_at_once(std::size_t wrong);
  Touch rubbed(Meeting& meeting, Touch now, double pressed, std::span<const double> u1,
               std::span<const double> reactions) const;
  Vec<3> along_wall(const Meeting& meeting, std::span<const double> values) const;

  const Coupled& scene_;
  std::size_t dim_;
  double h_ = 0;
  std::vector<int> nodes_;
  std::vector<Meeting> meetings_;
  std::size_t fewest_ = 0;  // released nodes that were wrong in a solution of this step
  int chances_ = 0;         // solutions that may have no fewer before one node changes at a time
};

}  // namespace tether::coupled
