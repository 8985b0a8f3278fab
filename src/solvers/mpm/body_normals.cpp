// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/mpm/body_normals.hpp"

#include <algorithm>
#include <cmath>

namespace tether::mpm {

BodyNormals::BodyNormals(const BackgroundGrid& shape, const Walls& walls)
    : nx_(shape.nx), least_(least_color_slope / std::max(shape.dx, shape.dy)), color_(shape, walls) {}

void BodyNormals::take(const PlaceArrays& places, Range body) {
  color_.clear();
  color_.add(places, body);
}

Vec2 BodyNormals::outward(int node) const {
  const int i = node % nx_, j = node / nx_;
  const Pair inward = color_.gradient(i, j);  // the colour grows into the body
  const double length = std::sqrt(inward[0] * inward[0] + inward[1] * inward[1]);
  if (!(length > least_ * color_.around(i, j))) return {};
  return {-inward[0] / length, -inward[1] / length};
}

}  // namespace tether::mpm
