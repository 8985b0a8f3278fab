// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/strain_on_mesh.hpp"

#include <algorithm>
#include <utility>

#include "base/blocks.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double of_ties = 3;     // of the sum of squares of the slopes of a cell's functions; beta
constexpr double of_jumps = 0.5;  // gamma

}  // namespace

StrainOnMesh::StrainOnMesh(const FlowMesh& mesh, double mu, double density, std::vector<Couple> open)
    : mesh_(mesh),
      mu_(mu),
      density_(density),
      open_(std::move(open)),
      gradient_(mesh.cells() * at(mesh.dim * mesh.dim), 0.0),
      stress_(gradient_.size(), 0.0),
      place_(mesh.faces(), {-1, -1}),
      pulled_(mesh.cells()) {
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    double squares = 0;  // of the slopes of the faces' functions, times the cell's volume
    for (const int f : mesh.faces_of(cell)) {
      squares += dot(mesh.area[at(f)], mesh.area[at(f)]) / mesh.volume[cell];
      place_[at(f)][mesh.cell_of(at(f)) == cell ? 0 : 1] = static_cast<int>(out_.size());
      out_.push_back(mesh.out_of(cell, at(f)));
      way_.push_back(minus(mesh.middle_of_face(at(f)), mesh.middle(cell)));
    }
    tie_.push_back(of_ties * mu * squares);
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    double about = 0;  // the volume whose jumps a face has
    for (const int c : mesh.cells_of_face[f]) about += c < 0 ? 0 : mesh.volume[at(c)];
    jump_.push_back(mesh.is_at_boundary(f) ? 0 : of_jumps * mu * about / static_cast<double>(mesh.corners()));
    normal_.push_back(mesh.area[f]);
    for (double& along : normal_[f]) along /= mesh.size_of(f);
  }
}

template <int dim>
Vec<3> StrainOnMesh::velocity_in(std::size_t cell, std::span<const double> x) const {
  constexpr std::size_t corners = dim + 1;
  const int* faces = &mesh_.face[cell * corners];
  Vec<3> w{};
  for (std::size_t k = 0; k < corners; ++k) {
    const Vec<3>&out = out_[cell * corners + k], &way = way_[cell * corners + k];
    double flux = 0;
    for (std::size_t a = 0; a < dim; ++a) flux += x[at(faces[k]) * dim + a] * out[a];
    for (std::size_t a = 0; a < dim; ++a) w[a] += flux * way[a];
  }
  for (double& along : w) along /= mesh_.volume[cell];
  return w;
}

Vec<3> StrainOnMesh::velocity(std::size_t cell, std::span<const double> x) const {
  return mesh_.dim == 2 ? velocity_in<2>(cell, x) : velocity_in<3>(cell, x);
}

void StrainOnMesh::give_faces(std::size_t cell, const Vec<3>& momentum, std::span<double> y) const {
  const std::size_t dim = at(mesh_.dim);
  const auto faces = mesh_.faces_of(cell);
  for (std::size_t k = 0, place = cell * faces.size(); k < faces.size(); ++k, ++place) {
    const double along = dot(way_[place], momentum) / mesh_.volume[cell];
    for (std::size_t a = 0; a < dim; ++a) y[at(faces[k]) * dim + a] += along * out_[place][a];
  }
}

/// And how faces pull the cell where it is at rest.
template <int dim>
void StrainOnMesh::find_gradient(std::size_t cell, std::span<const double> x) {
  constexpr std::size_t count = dim * dim, corners = dim + 1;
  std::array<double, count> gradient{};
  const int* faces = &mesh_.face[cell * corners];
  for (std::size_t k = 0; k < corners; ++k) {
    const double* v = &x[at(faces[k]) * dim];
    const Vec<3>& out = out_[cell * corners + k];
    for (std::size_t a = 0; a < dim; ++a) {
      for (std::size_t b = 0; b < dim; ++b) gradient[a * dim + b] += v[a] * out[b];
    }
  }
  const double by_volume = 1 / mesh_.volume[cell];
  for (std::size_t k = 0; k < count; ++k) gradient_[cell * count + k] = by_volume * gradient[k];
  pulled_[cell] = velocity_in<dim>(cell, x);
  for (double& along : pulled_[cell]) along *= pull(cell) * by_volume;
}

/// 2 mu D, and the cell's part in the jumps at its faces.
template <int dim>
void StrainOnMesh::find_stress(std::size_t cell) {
  constexpr std::size_t count = dim * dim, corners = dim + 1;
  const double* own = &gradient_[cell * count];
  std::array<double, count> stress{};
  for (std::size_t a = 0; a < dim; ++a) {
    for (std::size_t b = 0; b < dim; ++b) stress[a * dim + b] = mu_ * (own[a * dim + b] + own[b * dim + a]);
  }
  const double by_volume = 1 / mesh_.volume[cell];
  for (std::size_t k = 0; k < corners; ++k) {
    const std::size_t f = at(mesh_.face[cell * corners + k]);
    const auto& cells = mesh_.cells_of_face[f];
    if (cells[1] < 0) continue;
    const double weight = jump_[f] * by_volume;
    const double* other = &gradient_[at(at(cells[0]) == cell ? cells[1] : cells[0]) * count];
    const Vec<3>& n = normal_[f];
    for (std::size_t a = 0; a < dim; ++a) {
      std::array<double, at(dim)> jump{};
      double across = 0;
      for (std::size_t b = 0; b < dim; ++b) {
        jump[b] = own[a * dim + b] - other[a * dim + b];
        across += jump[b] * n[b];
      }
      for (std::size_t b = 0; b < dim; ++b) stress[a * dim + b] += weight * (jump[b] - across * n[b]);
    }
  }
  std::copy(stress.begin(), stress.end(), &stress_[cell * count]);
}

template <int dim>
void StrainOnMesh::find_force(std::size_t face, std::span<double> y) const {
  std::array<double, at(dim)> force{};
  for (const int place : place_[face]) {
    if (place < 0) continue;
    const std::size_t cell = at(place) / (dim + 1);
    const Vec<3>& out = out_[at(place)];
    const double pulled = dot(way_[at(place)], pulled_[cell]);
    const double* stress = &stress_[cell * dim * dim];
    for (std::size_t a = 0; a < dim; ++a) {
      force[a] += pulled * out[a];
      for (std::size_t b = 0; b < dim; ++b) force[a] += stress[a * dim + b] * out[b];
    }
  }
  for (std::size_t a = 0; a < dim; ++a) y[face * dim + a] = force[a];
}

template <int dim>
void StrainOnMesh::find(Team& team, std::span<const double> x, std::span<double> y) {
  constexpr std::size_t cells_of_a_block = 512;
  const auto each = [&](std::size_t count, const auto& body) {
    each_block(
        team, count,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) body(k);
        },
        cells_of_a_block);
  };
  each(mesh_.cells(), [&](std::size_t cell) { find_gradient<dim>(cell, x); });
  each(mesh_.cells(), [&](std::size_t cell) { find_stress<dim>(cell); });
  each(mesh_.faces(), [&](std::size_t face) { find_force<dim>(face, y); });
  for (const Couple& couple : open_) {
    y[couple.i] += mu_ * couple.by * x[couple.j];
    y[couple.j] += mu_ * couple.by * x[couple.i];
  }
}

void StrainOnMesh::find_forces(Team& team, std::span<const double> x, std::span<double> y) {
  mesh_.dim == 2 ? find<2>(team, x, y) : find<3>(team, x, y);
}

}  // namespace tether::coupled
