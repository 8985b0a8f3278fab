// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/exits.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/flow_box.hpp"

namespace tether::liquid {

Exits::Exits(const coupled::FlowDomain& room, const coupled::FaceValues& v) : grid_(room.grid) {
  for (int side = 0; side < 2 * grid_.dim; ++side) {
    const int axis = axis_of_side(side);
    coupled::each_face_of_side(grid_, side, [&](std::size_t f) {
      const coupled::FaceKind kind = room.face[at(axis)][f];
      const bool out =
          kind == coupled::FaceKind::prescribed && (is_low_side(side) ? v[at(axis)][f] < 0 : v[at(axis)][f] > 0);
      if (kind != coupled::FaceKind::open && !out) return;
      exit_[at(axis)].resize(grid_.face_count(axis), 0);
      exit_[at(axis)][f] = 1;
    });
  }
}

double remove_marked(std::span<const std::uint8_t> marked, Particles& particles) {
  double volume = 0;
  for (std::size_t k = 0; k < marked.size(); ++k) volume += marked[k] != 0 ? particles.volume[k] : 0;
  if (volume == 0) return 0;
  each_list(particles, [&](const std::string&, std::vector<double>& list) {
    if (list.empty()) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < marked.size(); ++k) {
      if (marked[k] == 0) list[kept++] = list[k];
    }
    list.resize(kept);
  });
  return volume;
}

double Inflow::blow_in(std::span<const double> speeds, double h, std::span<double> owed, Particles& particles) const {
  double volume = 0;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    if (speeds[k] <= 0) continue;
    const std::size_t axis = at(axis_of_side(scene_.jets[k].side));
    const double apart = scene_.grid.d[axis] / scene_.liquid->per_axis;
    owed[k] += speeds[k] * h;
    for (; owed[k] >= apart; owed[k] -= apart)
      volume += add_layer(k, owed[k] - 0.5 * apart, apart, speeds[k], particles);
  }
  return volume;
}

Particles Inflow::not_yet_in(std::span<const double> owed) const {
  Particles particles;
  for (std::size_t k = 0; k < owed.size(); ++k) {
    if (owed[k] > 0) add_layer(k, 0.5 * owed[k], owed[k], 0, particles);
  }
  return particles;
}

double Inflow::add_layer(std::size_t jet, double depth, double thickness, double speed, Particles& particles) const {
  const StaggeredGrid& grid = scene_.grid;
  const Jet& of = scene_.jets[jet];
  const std::size_t across = at(axis_of_side(of.side));
  std::array<int, 3> count{1, 1, 1}, i{};
  Vec<3> apart{1, 1, 1};
  for (std::size_t a = 0; a < at(grid.dim); ++a) {
    if (a == across) continue;
    const double size = of.patch.high[a] - of.patch.low[a];
    count[a] = std::max(1, static_cast<int>(std::lround(size / grid.d[a] * scene_.liquid->per_axis)));
    apart[a] = size / count[a];
  }
  apart[across] = thickness;
  const double inwards = is_low_side(of.side) ? 1 : -1, side = of.patch.low[across];
  double volume = 0;
  for (i[2] = 0; i[2] < count[2]; ++i[2]) {
    for (i[1] = 0; i[1] < count[1]; ++i[1]) {
      for (i[0] = 0; i[0] < count[0]; ++i[0]) {
        Vec<3> x{}, velocity{};
        for (std::size_t a = 0; a < at(grid.dim); ++a) x[a] = of.patch.low[a] + (i[a] + 0.5) * apart[a];
        x[across] = std::clamp(side + inwards * depth, grid.low[across], grid.high(static_cast<int>(across)));
        velocity[across] = inwards * speed;
        if (coupled::jet_at(scene_, of.side, x) != static_cast<int>(jet)) continue;
        particles.add(grid.dim, x, velocity, apart[0] * apart[1] * apart[2]);
        volume += apart[0] * apart[1] * apart[2];
      }
    }
  }
  return volume;
}

}  // namespace tether::liquid
