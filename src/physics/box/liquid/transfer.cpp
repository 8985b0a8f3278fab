// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/transfer.hpp"

#include <cmath>

#include "base/blocks.hpp"

namespace tether::liquid {
namespace {

constexpr double no_volume = 1e-12;  // of a cell

/// Adds a particle's volume and momentum to the faces across one axis about it.
template <std::size_t dim>
void add_to_faces(const StaggeredGrid& grid, const Lattice<dim>& faces, const Particles& particles, std::size_t axis,
                  std::size_t k, std::vector<double>& volume, std::vector<double>& momentum) {
  constexpr std::size_t corners = Lattice<dim>::corners;
  const LatticePlace<dim> at = faces.locate(place_of<dim>(particles, k));
  std::array<double, corners> weight, v;
  weight[0] = particles.volume[k], v[0] = particles.v[axis][k];
  for (std::size_t b = 0, count = 1; b < dim; ++b, count *= 2) {
    const double rise = particles.slope[axis][b][k] * grid.d[b];
    for (std::size_t corner = 0; corner < count; ++corner) {
      weight[corner + count] = at.part[b] * weight[corner], weight[corner] *= 1 - at.part[b];
      v[corner + count] = v[corner] + (1 - at.part[b]) * rise, v[corner] -= at.part[b] * rise;
    }
  }
  const std::ptrdiff_t first = faces.number(at.low);
  const bool inside = faces.has_all_about(at);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    if (!inside && !faces.has(at, corner)) continue;
    const auto f = static_cast<std::size_t>(first + faces.step(corner));
    volume[f] += weight[corner], momentum[f] += weight[corner] * v[corner];
  }
}

template <std::size_t dim>
coupled::FaceValues to_faces_in(Team& team, const StaggeredGrid& grid, const Particles& particles,
                                const CellParticles& cells, coupled::FaceValues& v) {
  coupled::FaceValues volume = coupled::face_values(grid);
  v = coupled::face_values(grid);
  for (std::size_t axis = 0; axis < dim; ++axis) {
    const Lattice<dim> faces(grid, static_cast<int>(axis));
    each_slab(team, grid, cells, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        add_to_faces<dim>(grid, faces, particles, axis, k, volume[axis], v[axis]);
    });
    for (std::size_t f = 0; f < v[axis].size(); ++f) {
      if (volume[axis][f] <= no_volume * grid.volume()) volume[axis][f] = 0;
      v[axis][f] = volume[axis][f] > 0 ? v[axis][f] / volume[axis][f] : 0;
    }
  }
  return volume;
}

/// The velocity that the faces across an axis have at a place, and its slopes: axis by axis, lines between two values
/// halve their number.
template <std::size_t dim>
double take(const StaggeredGrid& grid, const Lattice<dim>& faces, const std::vector<double>& v,
            const std::array<double, dim>& x, const HeldSides& held, std::array<double, dim>& slope) {
  constexpr std::size_t corners = Lattice<dim>::corners;
  const LatticePlace<dim> at = faces.locate_within(x);
  const double* first = v.data() + faces.number(at.low);
  std::array<double, corners> value;
  std::array<std::array<double, corners / 2>, dim> slopes;
  for (std::size_t corner = 0; corner < corners; ++corner) value[corner] = first[faces.step(corner)];
  std::size_t left = corners / 2;
  for (std::size_t b = 0; b < dim; ++b, left /= 2) {
    for (std::size_t k = 0; k < left; ++k) {
      const double change = value[2 * k + 1] - value[2 * k];
      slopes[b][k] = change;
      value[k] = value[2 * k] + at.part[b] * change;
      for (std::size_t a = 0; a < b; ++a)
        slopes[a][k] = slopes[a][2 * k] + at.part[b] * (slopes[a][2 * k + 1] - slopes[a][2 * k]);
    }
  }
  for (std::size_t b = 0; b < dim; ++b) {
    const double beyond = faces.beyond(x, b);
    slope[b] = slopes[b][0] / grid.d[b];
    if (beyond != 0)
      slope[b] = held[2 * b + (beyond > 0 ? 1 : 0)] ? std::copysign(2 / grid.d[b], -beyond) * value[0] : 0;
  }
  return value[0] * faces.left_by_walls(x, held);
}

template <std::size_t dim>
void from_faces_in(Team& team, const StaggeredGrid& grid, const coupled::FaceValues& v, const HeldSides& held,
                   Particles& particles) {
  for (std::size_t axis = 0; axis < dim; ++axis) {
    const Lattice<dim> faces(grid, static_cast<int>(axis));
    each_block(team, particles.size(), [&](std::size_t begin, std::size_t end) {
      std::array<double, dim> slope;
      for (std::size_t k = begin; k < end; ++k) {
        particles.v[axis][k] = take<dim>(grid, faces, v[axis], place_of<dim>(particles, k), held, slope);
        for (std::size_t b = 0; b < dim; ++b) particles.slope[axis][b][k] = slope[b];
      }
    });
  }
}

template <std::size_t dim>
std::vector<double> filling_in(Team& team, const StaggeredGrid& grid, const Particles& particles,
                               const CellParticles& cells) {
  std::vector<double> filled(grid.cell_count(), 0.0);
  const Lattice<dim> middles(grid, -1);
  const double per_volume = 1 / grid.volume();
  each_slab(team, grid, cells, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const LatticePlace<dim> at = middles.locate(place_of<dim>(particles, k));
      for (std::size_t corner = 0; corner < Lattice<dim>::corners; ++corner) {
        std::array<int, dim> point = at.low;
        for (std::size_t b = 0; b < dim; ++b)
          point[b] = std::clamp(point[b] + static_cast<int>(corner >> b & 1), 0, middles.size[b] - 1);
        filled[static_cast<std::size_t>(middles.number(point))] +=
            particles.volume[k] * per_volume * Lattice<dim>::weight(at, corner);
      }
    }
  });
  return filled;
}

}  // namespace

coupled::FaceValues to_faces(Team& team, const StaggeredGrid& grid, const Particles& particles,
                             const CellParticles& cells, coupled::FaceValues& v) {
  return grid.dim == 2 ? to_faces_in<2>(team, grid, particles, cells, v)
                       : to_faces_in<3>(team, grid, particles, cells, v);
}

void from_faces(Team& team, const StaggeredGrid& grid, const coupled::FaceValues& v, const HeldSides& held,
                Particles& particles) {
  grid.dim == 2 ? from_faces_in<2>(team, grid, v, held, particles) : from_faces_in<3>(team, grid, v, held, particles);
}

std::vector<double> filling(Team& team, const StaggeredGrid& grid, const Particles& particles,
                            const CellParticles& cells) {
  return grid.dim == 2 ? filling_in<2>(team, grid, particles, cells) : filling_in<3>(team, grid, particles, cells);
}

}  // namespace tether::liquid
