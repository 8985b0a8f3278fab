// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/common_columns.hpp"

#include <cmath>
#include <numbers>

namespace tether {
namespace {

using Row = Column<ColumnSetting, CommonSums>;
using D = Dimension;

}  // namespace

const When<ColumnSetting>& in_space() {
  static const When<ColumnSetting> when("in space", [](const ColumnSetting& s) { return s.dim == 3; });
  return when;
}

double tracked_angle(const CommonSums& sums) {
  const auto &first = sums.tracked.front().place, &last = sums.tracked.back().place;
  return std::atan2(last[0] - first[0], first[1] - last[1]) * 180 / std::numbers::pi;
}

const When<ColumnSetting>& in_plane() {
  static const When<ColumnSetting> when("in the plane", [](const ColumnSetting& s) { return s.dim == 2; });
  return when;
}

CommonGroup energy_columns() {
  return {
      {{"time", D::time, "time", &CommonSums::time},
       {"dt", D::time, "length of the last step", &CommonSums::dt},
       {"energy_kinetic", D::energy, "kinetic energy", &CommonSums::kinetic},
       {"energy_strain", D::energy, "energy stored in solids, strings and linear fluids", &CommonSums::strain},
       {"energy_internal", D::energy, "internal energy of gas", &CommonSums::internal},
       {"energy_potential", D::energy, "potential energy in gravity, zero at y = 0", &CommonSums::potential},
       {"energy_total", D::energy,
        "sum of these, with energy_ambient, energy_step and energy_contact where there are such", &CommonSums::total}}};
}

CommonGroup momentum_columns() {
  const auto momentum = [](const CommonSums& s, std::size_t axis, std::size_t) { return s.momentum[axis]; };
  return {{{"mass", D::mass, "mass", &CommonSums::mass}, Row("momentum_", D::momentum, "momentum", momentum).vector()}};
}

CommonGroup plane_spin_column() {
  return {{{"angular_momentum_z", D::angular_momentum, "angular momentum about the origin",
            [](const CommonSums& s) { return s.angular[2]; }}}};
}

CommonGroup spin_columns() {
  const auto angular = [](const CommonSums& s, std::size_t axis, std::size_t) { return s.angular[axis]; };
  return {{Row("angular_momentum_", D::angular_momentum, "angular momentum about the origin", angular).vector()}};
}

CommonGroup body_columns() {
  const auto place = [](const CommonSums& s, std::size_t axis, std::size_t b) { return s.bodies.at(b).place[axis]; };
  const auto velocity = [](const CommonSums& s, std::size_t axis, std::size_t b) {
    return s.bodies.at(b).velocity[axis];
  };
  const auto mass = [](const CommonSums& s, std::size_t b) { return s.bodies.at(b).mass; };
  return {{Row("body_", D::length, "centre of mass", place).vector().each(Per::body),
           Row("body_v", D::velocity, "velocity of the centre of mass", velocity).vector().each(Per::body),
           Row("body_mass", D::mass, "mass of the body", mass).each(Per::body)}};
}

CommonGroup tracked_columns() {
  const auto place = [](const CommonSums& s, std::size_t axis, std::size_t k) { return s.tracked.at(k).place[axis]; };
  const auto velocity = [](const CommonSums& s, std::size_t axis, std::size_t k) {
    return s.tracked.at(k).velocity[axis];
  };
  return {{"of tracked points", [](const ColumnSetting& s) { return !s.point_names.empty(); }},
          {Row("point_", D::length, "place", place).vector().each(Per::point),
           Row("point_v", D::velocity, "velocity", velocity).vector().each(Per::point)}};
}

}  // namespace tether
