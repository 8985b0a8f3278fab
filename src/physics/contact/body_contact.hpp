// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"
#include "grid/contact/pairs.hpp"
#include "grid/contact/surface.hpp"
#include "model/solids.hpp"
#include "physics/contact/contact_numbers.hpp"
#include "physics/contact/pair_force.hpp"

namespace tether::contact {

/// Contact of the bodies on a mesh with each other, with themselves, with planes and obstacles: forces of a step from
/// places q0 to q1, and how far nodes can go. Vectors have dim numbers a node.
class BodyContact {
 public:
  /// The solids, which have a contact, must outlive it, and the team that shares its loops. `gravity` is but a measure
  /// of what speed is slow [length/time2].
  BodyContact(const Solids& solids, double gravity, Team& team);

  /// Begins a step of length dt from q0, damped where the deck says so; with dt = 0 nothing rubs.
  void begin(std::span<const double> q0, double dt);
  /// Begins one whose forces are those of its end. With `convex` the derivatives of each side are made symmetric and
  /// positive semi-definite, so that corrections by them lead down.
  void begin_at_end(std::span<const double> q0, double dt, bool convex = false);
  /// Lets friction come up over so many times its way.
  void ease_friction(double times) { rule_.come_up = times * dt_ * stick_; }
  bool rubs() const { return rule_.friction > 0; }

  /// Returns the part of the way from the start q0 to a step's first guess before surfaces stop it: what is left of the
  /// distance of those nearer than the gap is 0.9 at least, since what a guess presses too much corrections take back
  /// by a fourth each.
  double part_of_guess(std::span<const double> q0, std::span<const double> change);
  /// Returns the part of a correction from q before they stop it, 0.4 of their distance left; it goes no farther along
  /// an axis than the guess did or a side is long: all that farther ways pass would have to be looked at.
  double part_of_correction(std::span<const double> q, std::span<const double> change);
  /// Returns whether anything presses at q1, or did at the start.
  bool presses(std::span<const double> q1);
  /// Adds what surfaces do against the forces from outside: the derivative of their energy, and friction.
  void add_forces(std::span<const double> q1, std::span<double> f);
  /// Returns K with `factor` times the derivative of these by q1. Its pattern grows from the step's beginning on by all
  /// that met.
  SparseMatrix with_slopes(const SparseMatrix& K, std::span<const double> q1, double factor);
  /// Returns how bodies touch at q1.
  ContactNumbers numbers(std::span<const double> q1);

 private:
  /// A pair that presses, or a point or guard near a plane.
  struct Active {
    std::size_t number = 0;  ///< of the pair, or of the point and then guards
    int plane = -1;
    double s0 = 0, s1 = 0;  ///< squared distances at both ends [length2]
    bool damps = false;     ///< whether it is the nearest thing to its point
  };
  /// Forces of one of them on its places, and their derivative.
  template <int dim>
  struct PlaceForces {
    std::array<int, 4> places{-1, -1, -1, -1};
    int count = 0;
    SmallMatrix<dim, 4> force;
    SmallMatrix<4 * dim, 4 * dim> slope;
    double energy = 0, pressing = 0, rubbing = 0, rubbed = 0, slid = 0;
  };

  double part_of_way(std::span<const double> q, std::span<const double> change, double left, double longest);
  double modulus(int side) const;
  PairScale scale_of(const ContactPair& pair) const;
  PairScale scale_of(const ContactPoint& point, bool guard) const;
  const ContactPoint& point_of(std::size_t number) const;
  bool is_guard(std::size_t number) const { return number >= surface_.points.size(); }
  void cover(std::span<const double> x1, std::span<const double> x2);
  void find_pairs(std::span<const double> x1, std::span<const double> x2);
  void measure_start();
  bool moved_little(std::span<const double> x) const;
  void find_near(std::span<const double> x1, std::span<const double> x2);
  void place(std::span<const double> q1);
  void find_active();
  void find_nearest();
  void find_active_at_planes();
  double part_before_planes(double part, double left) const;
  template <int dim>
  void find_forces(const PairRule& rule, const Active& active, PlaceForces<dim>& forces) const;
  int side_of(const Active& active) const;
  template <int dim, class Add>
  void each_force(bool with_slopes, const Add& add) const;
  template <int dim>
  void add_numbers(const Active& active, const PlaceForces<dim>& forces, ContactNumbers& numbers,
                   std::vector<std::array<double, 3>>& points) const;
  void spread(const std::vector<std::array<double, 3>>& points, ContactNumbers& numbers) const;

  const Solids& solids_;
  const Contact& contact_;
  Team& team_;
  ContactSurface surface_;
  ContactPairs pairs_;
  std::vector<double> modulus_;  // of each region's surface [stress]
  double gap_ = 0, guard_gap_ = 0, stick_ = 0, dt_ = 0;
  double guessed_far_ = 0;  // farthest that the step's first guess led a node along an axis [length]
  PairRule rule_;
  bool convex_ = false;                                // whether derivatives are made positive semi-definite
  std::vector<double> x0_, x1_, ways_, place_forces_;  // of the surface's places
  std::vector<double> s0_;                             // squared distances of the pairs at the start
  bool covered_ = false;                               // whether the pairs are all that can meet
  std::vector<std::size_t> near_;                      // pairs that can press about places near_to_, ascending
  std::vector<double> near_to_;                        // empty: near_ has all pairs
  std::vector<Active> active_;
  EigenSparse met_;  // zeros where anything met in this step
};

}  // namespace tether::contact
