// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "base/vec.hpp"
#include "grid/contact/pair_distance.hpp"

namespace tether::coupled {

/// The distance of a place from a segment in the plane, or a triangle in space, with these corners, dim of them.
inline double facet_distance(int dim, const std::array<Vec<3>, 3>& corners, const Vec<3>& x) {
  const auto from_first = [&](const Vec<3>& to) {
    const Vec<3> way = minus(to, corners[0]);
    return Eigen::Vector3d(way[0], way[1], way[2]);
  };
  if (dim == 2) {
    PairVectors<3, 2> r;
    r << from_first(x), from_first(corners[1]);
    return std::sqrt(squared_distance<3, 2>(r, nearest<PairKind::edge>(products_of<3, 2>(r))));
  }
  PairVectors<3, 3> r;
  r << from_first(x), from_first(corners[1]), from_first(corners[2]);
  return std::sqrt(squared_distance<3, 3>(r, nearest<PairKind::triangle>(products_of<3, 3>(r))));
}

}  // namespace tether::coupled
