// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/move.hpp"

#include <algorithm>
#include <cmath>

#include "base/blocks.hpp"
#include "base/numbers.hpp"
#include "physics/box/flow_paths.hpp"
#include "physics/box/liquid/hats.hpp"

namespace tether::liquid {
namespace {

constexpr double from_walls = 1e-3;  // cells that particles stay away from what they cannot pass

using coupled::FlowDomain;
using coupled::FlowPlace;

template <std::size_t dim>
class Mover {
 public:
  Mover(const FlowDomain& room, const coupled::FaceValues& v, const HeldSides& held)
      : grid_(room.grid),
        v_(v),
        held_(held),
        any_held_(held != HeldSides{}),
        paths_(room),
        faces_(faces_of(grid_, std::make_index_sequence<dim>())) {}

  /// Returns whether it left the box.
  bool carry(Particles& particles, std::size_t k, double h, const Exits& exits) const {
    std::array<double, dim> u;
    for (std::size_t b = 0; b < dim; ++b) u[b] = particles.v[b][k];
    const int parts = std::max(1, static_cast<int>(std::ceil(cells(u, h))));
    FlowPlace at = flow_place(place_of<dim>(particles, k));
    for (int part = 0; part < parts; ++part) {
      const double time = h / parts;
      FlowPlace half = at;
      if (part > 0) u = velocity(place(at));
      paths_.follow(half, way(u, 0.5 * time));
      paths_.follow(at, way(velocity(place(half)), time));
      if (leaves(at, exits)) return true;
    }
    put(at, particles, k);
    return false;
  }

  void shift(Particles& particles, std::size_t k, double most) const {
    const std::array<double, dim> x = place_of<dim>(particles, k), ways = velocity(x);
    FlowPlace at = flow_place(x);
    Vec<dim> cells;
    for (std::size_t b = 0; b < dim; ++b) cells[b] = std::clamp(ways[b] / grid_.d[b], -most, most);
    paths_.follow(at, cells);
    put(at, particles, k);
  }

 private:
  template <std::size_t... axis>
  static std::array<Lattice<dim>, dim> faces_of(const StaggeredGrid& grid, std::index_sequence<axis...>) {
    return {Lattice<dim>(grid, static_cast<int>(axis))...};
  }
  std::array<double, dim> place(const FlowPlace& at) const {
    std::array<double, dim> x;
    for (std::size_t b = 0; b < dim; ++b) x[b] = grid_.low[b] + (at.cell[b] + at.at[b]) * grid_.d[b];
    return x;
  }
  FlowPlace flow_place(const std::array<double, dim>& x) const {
    FlowPlace at;
    for (std::size_t b = 0; b < dim; ++b) {
      const double cells = (x[b] - grid_.low[b]) / grid_.d[b];
      at.cell[b] = std::clamp(static_cast<int>(cells), 0, grid_.n[b] - 1);
      at.at[b] = std::clamp(cells - at.cell[b], 0.0, 1.0);
    }
    return at;
  }
  std::array<double, dim> velocity(const std::array<double, dim>& x) const {
    std::array<double, dim> u;
    for (std::size_t a = 0; a < dim; ++a) {
      u[a] = faces_[a].between(v_[a].data(), x);
      if (any_held_) u[a] *= faces_[a].left_by_walls(x, held_);
    }
    return u;
  }
  Vec<dim> way(const std::array<double, dim>& u, double time) const {
    Vec<dim> cells;
    for (std::size_t b = 0; b < dim; ++b) cells[b] = u[b] * time / grid_.d[b];
    return cells;
  }
  double cells(const std::array<double, dim>& u, double time) const {
    double most = 0;
    for (std::size_t b = 0; b < dim; ++b) most = std::max(most, std::abs(u[b]) * time / grid_.d[b]);
    return most;
  }
  /// Returns whether a place at a side of the box is in an exit.
  bool leaves(const FlowPlace& at, const Exits& exits) const {
    for (std::size_t b = 0; b < dim; ++b) {
      const int side = static_cast<int>(2 * b);
      if (at.cell[b] == 0 && at.at[b] <= 0 && exits.lead_out(at.cell, side)) return true;
      if (at.cell[b] == grid_.n[b] - 1 && at.at[b] >= 1 && exits.lead_out(at.cell, side + 1)) return true;
    }
    return false;
  }
  /// Puts a particle there, a little away from faces that let nothing through.
  void put(FlowPlace at, Particles& particles, std::size_t k) const {
    const std::size_t cell = grid_.cell(at.cell);
    for (std::size_t b = 0; b < dim; ++b) {
      if (!paths_.joins().joined(cell, static_cast<int>(2 * b))) at.at[b] = std::max(at.at[b], from_walls);
      if (!paths_.joins().joined(cell, static_cast<int>(2 * b + 1))) at.at[b] = std::min(at.at[b], 1 - from_walls);
    }
    const std::array<double, dim> x = place(at);
    for (std::size_t b = 0; b < dim; ++b) particles.x[b][k] = x[b];
  }

  const StaggeredGrid& grid_;
  const coupled::FaceValues& v_;
  HeldSides held_;
  bool any_held_;
  coupled::FlowPaths<dim> paths_;
  std::array<Lattice<dim>, dim> faces_;
};

/// Calls f(mover, particle) for all particles.
template <class Function>
void each(Team& team, const FlowDomain& room, const coupled::FaceValues& v, const HeldSides& held, std::size_t count,
          const Function& f) {
  const auto loop = [&](const auto& mover) {
    each_block(team, count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) f(mover, k);
    });
  };
  room.grid.dim == 2 ? loop(Mover<2>(room, v, held)) : loop(Mover<3>(room, v, held));
}

}  // namespace

std::vector<std::uint8_t> carry_particles(Team& team, const FlowDomain& room, const coupled::FaceValues& v,
                                          const HeldSides& held, const Exits& exits, double h, Particles& particles) {
  std::vector<std::uint8_t> left(particles.size(), 0);
  each(team, room, v, held, particles.size(),
       [&](const auto& mover, std::size_t k) { left[k] = mover.carry(particles, k, h, exits) ? 1 : 0; });
  return left;
}

void shift_particles(Team& team, const FlowDomain& room, const coupled::FaceValues& ways, double most,
                     Particles& particles) {
  each(team, room, ways, {}, particles.size(),
       [&](const auto& mover, std::size_t k) { mover.shift(particles, k, most); });
}

namespace {

/// Puts a particle that is in a solid before the place of the surface that is nearest to it.
void put_before(const NearestSurface& near, const Vec<3>& velocity, const StaggeredGrid& grid, double away,
                Particles& particles, std::size_t k) {
  const Vec<3> x = place_of(particles, grid.dim, k), way = minus(near.place, x);
  double inwards = 0;
  for (std::size_t a = 0; a < at(grid.dim); ++a) {
    const double to = x[a] + (1 + away / near.distance) * way[a], edge = from_walls * grid.d[a];
    particles.x[a][k] = std::clamp(to, grid.low[a] + edge, grid.high(static_cast<int>(a)) - edge);
    inwards -= (particles.v[a][k] - velocity[a]) * way[a] / near.distance;
  }
  for (std::size_t a = 0; a < at(grid.dim) && inwards > 0; ++a) particles.v[a][k] += inwards * way[a] / near.distance;
}

}  // namespace

void put_out_of_solids(Team& team, const StaggeredGrid& grid, const NearSolids& solids, std::span<const double> u,
                       Particles& particles) {
  if (solids.none()) return;
  const double size = *std::min_element(grid.d.begin(), grid.d.begin() + grid.dim);
  each_block(team, particles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vec<3> x = place_of(particles, grid.dim, k);
      if (!solids.hold(x)) continue;
      const auto near = solids.nearest(x);
      if (!near || near->distance == 0) continue;
      put_before(*near, solids.velocity(*near, u), grid, from_walls * size, particles, k);
    }
  });
}

}  // namespace tether::liquid
