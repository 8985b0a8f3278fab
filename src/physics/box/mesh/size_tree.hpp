// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/vec.hpp"

namespace tether::coupled {

/// Segments in the plane or triangles in space with a size each, halved again and again along the longest side of their
/// extent, so that few of them need to be looked at for the least size about a place, which grows with the distance.
class SizeTree {
 public:
  struct Facet {
    std::array<Vec<3>, 3> corners;  ///< dim of them
    double size;
  };
  SizeTree(int dim, std::vector<Facet> facets);
  /// The least size of all; very large where there is none.
  double least() const { return parts_.empty() ? std::numeric_limits<double>::max() : parts_.front().least; }

  struct Nearby {
    double size;     ///< least of sizes with growth times their distance
    double nearest;  ///< distance of a facet, where one is nearer than was asked
  };
  /// Looks for sizes below `size`, and for facets nearer than `apart` times the least size.
  Nearby about(const Vec<3>& x, double growth, double size, double apart) const;
  /// Returns a size below which there is none in a box about x, which is twice as wide as `half`.
  double least_in(const Vec<3>& x, const Vec<3>& half, double growth, double size) const;

 private:
  struct Part {
    Vec<3> low, high;  // the extent of its facets
    double least;      // of their sizes
    std::size_t first, last;
    int below = -1;  // the first of its two halves
  };
  struct Search;
  void halve(std::size_t part);
  void look(std::size_t part, Search& search) const;

  int dim_;
  std::vector<Facet> facets_;
  std::vector<Part> parts_;
};

}  // namespace tether::coupled
