// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// Which element of a plane mesh of quadrilaterals (quad4 or quad9, straight or curved) a place is in, and where in the
/// reference element: a question of constant expected cost, for bins over the mesh list the few elements near by.
class PointFinder {
 public:
  /// Where a place is: its element, and its coordinates -1 .. 1 in the reference element.
  struct Found {
    int element = -1;
    Vec<2> s{};
  };

  /// The mesh must live as long, and keep its nodes.
  explicit PointFinder(const Mesh& mesh);

  /// Finds the element of the place x [length]; nothing where x is outside of the mesh, in a hole or not finite. On an
  /// edge or corner of several elements the one of lowest number is found. A place outside by no more than 1e-9 of the
  /// size of the nearest element, as places on walls are by rounding, is taken to that element's edge. `hint`, an
  /// element or any other number, only saves time where the place is in it: the answer does not depend on it. Safe to
  /// call by several threads; allocates nothing.
  std::optional<Found> find(Vec<2> x, int hint = -1) const;

 private:
  /// What is found without its nodes of an element: a box that it is in, a little enlarged, and the map from its
  /// reference element without the terms that bend or taper it, the other way round.
  struct Outline {
    Vec<2> low{}, high{}, centre{};
    std::array<double, 4> to_reference{};
    double within = 0;    ///< how far outside of it a place may be [length]
    double enough = 0;    ///< how near to a place a search for it has to come [length]
    double interior = 0;  ///< |s| below this is further from its edges than rounding
    bool affine = false;  ///< it is a parallelogram: no term bends or tapers it

    bool may_hold(const Vec<2>& x) const {
      return x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1];
    }
  };

  Outline outline_of(std::size_t e) const;
  void fill_bins();
  std::size_t bin(double x, std::size_t axis) const;
  template <class Shapes>
  std::optional<Found> find_of(const Vec<2>& x, int hint) const;
  template <class Shapes, class ReferencePlace>
  std::optional<Found> find_near(const Vec<2>& x, const ReferencePlace& place) const;
  template <class Shapes>
  std::optional<Vec<2>> reference_place(std::size_t e, const Vec<2>& x) const;
  template <class Shapes>
  std::optional<Vec<2>> reference_place_bent(std::size_t e, const Vec<2>& x) const;

  const Mesh* mesh_;
  double rounding_ = 0;  ///< of places [length]
  std::vector<Outline> outlines_;
  Vec<2> low_{}, per_width_{};  // of the bins
  std::array<std::size_t, 2> count_{1, 1};
  std::vector<int> start_, list_;  // the elements of each bin, ascending
};

}  // namespace tether
