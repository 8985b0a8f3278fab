// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "laws/tensors.hpp"
#include "loops/points.hpp"
#include "model/scene.hpp"
#include "physics/points/arrays.hpp"

namespace tether::mpm {

/// Unit tangent at a point of a string from its neighbours p - 1 and p + 1 along it, one-sided at its ends (7.1); a
/// closed one has none. A string's slots stay in the order of its file. Zero where the neighbours coincide.
Vec<2> tangent_at(const Points& points, Range string, std::size_t p, bool closed = false);

/// eps_1' += dt t . eps' . t with the rates of this step (5.2), (5.4); about an axis the hoop's, too.
void stretch_along_tangents(Points& points, Range string, double dt);

/// New tangents from the present places, and the total strain's component along them (5.3): with eps = eps_1' t (x) t
/// it is eps_1' (t . t_new)^2. That of a string that turns slowly keeps its strain, as it should, to second order of
/// the angle in a step; the jitter of a slack one is damped by it. Where neighbours coincide the tangent of before is
/// kept.
void turn_tangents(Points& points, Range string, bool closed = false);

/// A membrane as two-node elements between consecutive points, and mirrored half elements where it ends at a symmetry
/// wall. The energy of an element is V_0 W(eps_1', eps_2'), eps_1' = ln(l / L_0) and about an axis eps_2' = ln(r /
/// R_0); its forces are the derivative, so that points pull along the element and nothing turns them. The pressure
/// outside adds the energy p V of the volume that the membrane encloses: a closed one, or one whose ends both go on
/// behind walls that mirror, with these; between the left and the right wall what lies below it.
class Elements {
 public:
  /// Makes the elements of body b of the scene, in these slots; the points stand where they start, with their initial
  /// strains.
  Elements(const Scene& scene, std::size_t b, Range range, const Points& points, const Frame& frame);

  Range range() const { return range_; }
  /// Energy stored in the elements at the points' present places; that of the pressure outside, 0 at the start
  /// [energy].
  double strain_energy(const Points& points) const;
  bool encloses() const { return encloses_; }
  double ambient_energy(const Points& points) const {
    return ambient_ * (enclosed_volume(points) - enclosed_at_start_);
  }

  /// Strains, stresses and forces of the points' present places; the points get the means of their elements' strains
  /// and stresses, and the tangent. False where a strain is no number: `bad` is then the point.
  bool update(Points& points, std::size_t& bad);
  /// The forces of the pressure outside alone, for a membrane whose stress is its points'.
  void update_ambient(const Points& points);
  /// Force on point p [force].
  Pair force(std::size_t p) const { return force_[p - range_.begin]; }
  void set_force(std::size_t p, Pair force) { force_[p - range_.begin] = force; }

  // The ledger: what a step's forces gave at the nodes, against what the elements' energies lost.

  /// Says from where point p starts, how far it moves in the middle of the step, dt (v_old + v_new) / 2, and what its
  /// transfers lose.
  void book(std::size_t p, Pair place, Pair moved, double lost) {
    const std::size_t k = p - range_.begin;
    place_[k] = place, moved_[k] = moved, heat_[k] = lost;
  }
  /// Adds the elements' work defect, -dU - F . v_mid dt, to the points' heat, U with the energy of the pressure
  /// outside; the points stand at their new places.
  void settle(const Points& points);
  /// Energy that the step lost at point p [energy].
  double heat(std::size_t p) const { return heat_[p - range_.begin]; }

 private:
  struct Element {
    std::size_t a = 0, b = 0;       // slots; the same where the other end is the mirror image
    int mirror = -1;                // axis across which the image lies, or none
    double wall = 0;                // its place [length]
    double rest = 0, strain = 0;    // length and strain at the start
    double radius = 0, volume = 0;  // at the start; of a half element the volume of both halves
  };
  struct Shape {
    Pair along{};  // from a to b
    double length = 0, radius = 0;
  };

  struct Swept {  // what an element adds to the enclosed volume, and its slopes at the places of a and b
    double volume = 0;
    Pair by_a{}, by_b{};
  };

  void add(const Points& points, std::size_t a, std::size_t b, int mirror, double wall);
  bool ends_at_wall(const Points& points, const Scene& scene, std::size_t end, std::size_t inner);
  Shape shape(const Points& points, const Element& element) const;
  double share(const Element& element) const { return element.mirror < 0 ? 1 : 0.5; }
  double energy_of(const Element& element, const Shape& shape) const;
  void add_element(const Points& points, const Element& element, std::size_t e);
  void add_ambient(const Points& points);
  Swept swept(const Points& points, const Element& element) const;
  double enclosed_volume(const Points& points) const;
  void set_tangents(Points& points) const;
  void settle_ambient(const Points& points, const Element& element, const Swept& before);

  Range range_;
  Membrane law_;
  bool about_axis_ = false, closed_ = false, encloses_ = false;
  double ambient_ = 0;                        // pressure outside, signed by the sense of the points
  double reference_x_ = 0, reference_y_ = 0;  // where the enclosed volume counts from
  double enclosed_at_start_ = 0;
  std::vector<Element> elements_;
  std::vector<double> energy_;               // of each element
  std::vector<Pair> pull_;                   // of each element on its point b
  std::vector<double> turn_;                 // of each element in r on either point
  std::vector<Swept> swept_;                 // of each element, where there is pressure outside
  std::vector<Pair> force_, place_, moved_;  // of each point
  std::vector<double> heat_, strain_, hoop_, tension_, ring_, parts_;  // of each point
};

}  // namespace tether::mpm
