// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/vec.hpp"
#include "physics/box/liquid/surface.hpp"

namespace tether::liquid {

/// A triangle in the plane, a tetrahedron in space, whose corners' distances from the surface are known.
struct Simplex {
  std::array<Vec<3>, 4> corner{};
  std::array<double, 4> distance{};
  double open = 0;  ///< part of it that no solid has, about
};

/// A piece of the surface: an edge in the plane, a triangle in space, the liquid to the left of an edge, and below a
/// triangle whose corners turn counter-clockwise as seen from above.
using Facet = std::array<Vec<3>, 3>;

/// What the surface makes of a simplex.
struct Cut {
  double volume = 0;  ///< of its part in the liquid
  std::array<Facet, 2> facet{};
  std::size_t facets = 0;
};
Cut cut_of(const Simplex& simplex, int dim);

/// Returns the facets of a surface but for those within solids.
std::vector<Facet> facets_of(const Surface& surface);

/// Area of a facet, per unit depth in the plane.
double area_of(const Facet& facet, int dim);

/// The points between which simplices lie: the middles of cells, and their feet on the box's sides, where the distance
/// is that of the last cell.
class SurfaceLattice {
 public:
  explicit SurfaceLattice(const Surface& surface) : surface_(surface), grid_(surface.room.grid) {
    for (std::size_t a = 0; a < 3; ++a) last_[a] = a < static_cast<std::size_t>(grid_.dim) ? grid_.n[a] : 0;
  }

  /// Calls whole(volume, open part) for the boxes of the lattice that are all in the liquid, and cut(simplex) for the
  /// simplices of those that the surface goes through.
  template <class Whole, class Cut>
  void each(const Whole& whole, const Cut& cut) const {
    std::array<int, 3> first{};
    for (first[2] = 0; first[2] <= last_[2]; ++first[2]) {
      for (first[1] = 0; first[1] <= last_[1]; ++first[1]) {
        for (first[0] = 0; first[0] <= last_[0]; ++first[0]) look_at(first, whole, cut);
      }
    }
  }

 private:
  std::size_t cell(const std::array<int, 3>& point) const {
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(grid_.dim); ++a)
      cell[a] = std::clamp(point[a] - 1, 0, grid_.n[a] - 1);
    return grid_.cell(cell);
  }
  double place(std::size_t a, int i) const {
    const int axis = static_cast<int>(a);
    return i == 0 ? grid_.low[a] : i == grid_.n[a] + 1 ? grid_.high(axis) : grid_.middle(axis, i - 1);
  }

  template <class Whole, class Cut>
  void look_at(const std::array<int, 3>& first, const Whole& whole, const Cut& cut) const {
    const auto dim = static_cast<std::size_t>(grid_.dim);
    const std::size_t corners = std::size_t{1} << dim;
    std::size_t wet = 0;
    double open = 0, volume = 1;
    for (std::size_t corner = 0; corner < corners; ++corner) {
      std::array<int, 3> point = first;
      for (std::size_t a = 0; a < dim; ++a) point[a] += static_cast<int>(corner >> a & 1);
      const std::size_t c = cell(point);
      wet += surface_.distance[c] < 0 ? 1U : 0U;
      open += surface_.open[c];
    }
    if (wet == 0) return;
    for (std::size_t a = 0; a < dim; ++a) volume *= place(a, first[a] + 1) - place(a, first[a]);
    if (wet == corners) return whole(volume, open / static_cast<double>(corners));
    part(first, cut);
  }

  template <class Cut>
  void part(const std::array<int, 3>& first, const Cut& cut) const {
    constexpr std::array<std::array<std::size_t, 3>, 6> orders{
        {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 0, 1}, {1, 2, 0}, {2, 1, 0}}};  // of axes, the first two of the plane
    const auto dim = static_cast<std::size_t>(grid_.dim);
    for (std::size_t o = 0; o < (dim == 2 ? 2 : 6); ++o) {
      Simplex simplex;
      std::array<int, 3> point = first;
      for (std::size_t k = 0; k <= dim; ++k) {
        if (k > 0) ++point[orders[o][k - 1]];
        for (std::size_t a = 0; a < dim; ++a) simplex.corner[k][a] = place(a, point[a]);
        simplex.distance[k] = surface_.distance[cell(point)];
        simplex.open += surface_.open[cell(point)] / static_cast<double>(dim + 1);
      }
      cut(simplex);
    }
  }

  const Surface& surface_;
  const StaggeredGrid& grid_;
  std::array<int, 3> last_{};
};

}  // namespace tether::liquid
