// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "base/vec.hpp"
#include "grid/contact/pair_distance.hpp"

namespace tether::coupled {

/// The distance of a place from a segment in the plane, or a triangle in space, with these corners, dim of them.
inline double facet_distance(int dim, const std::array<Vec<3>, 3>& corners, const Vec<3>& x) {
  const auto from_first = [&](const Vec<3>& to) { return SmallMatrix<3, 1>(minus(to, corners[0])); };
  if (dim == 2) {
    PairVectors<3, 2> r;
    r.col(0) = from_first(x), r.col(1) = from_first(corners[1]);
    return std::sqrt(squared_distance<3, 2>(r, nearest<PairKind::edge>(products_of<3, 2>(r))));
  }
  PairVectors<3, 3> r;
  r.col(0) = from_first(x), r.col(1) = from_first(corners[1]), r.col(2) = from_first(corners[2]);
  return std::sqrt(squared_distance<3, 3>(r, nearest<PairKind::triangle>(products_of<3, 3>(r))));
}

}  // namespace tether::coupled
