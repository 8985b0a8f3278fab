// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/plane_quantities.hpp"

namespace tether {

const std::vector<Quantity>& body_quantities() {
  static const std::vector<Quantity> rows{
      {"body_x", Dimension::length, "centre of mass, x", Per::body},
      {"body_y", Dimension::length, "centre of mass, y", Per::body},
      {"body_vx", Dimension::velocity, "velocity of the centre of mass, x", Per::body},
      {"body_vy", Dimension::velocity, "velocity of the centre of mass, y", Per::body},
      {"body_mass", Dimension::mass, "mass", Per::body},
  };
  return rows;
}

const std::vector<Quantity>& tracked_quantities() {
  static const std::vector<Quantity> rows{
      {"point_x", Dimension::length, "place, x", Per::point},
      {"point_y", Dimension::length, "place, y", Per::point},
      {"point_vx", Dimension::velocity, "velocity, x", Per::point},
      {"point_vy", Dimension::velocity, "velocity, y", Per::point},
  };
  return rows;
}

}  // namespace tether
