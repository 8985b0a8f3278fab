// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algebra/eigen_sparse.hpp"
#include "base/numbers.hpp"
#include "physics/box/mesh/mesh_flow.hpp"

namespace tether::coupled {

// Pressures on a mesh, and what they do.

std::vector<std::uint8_t> MeshFlow::regions_of_jets(const FaceValues& v) const {
  std::vector<std::uint8_t> by_jets(at(at_.regions.count), 0);
  each_prescribed(v, [&](std::size_t face, double) { by_jets[at(at_.mesh->region[at_.mesh->cell_of(face)])] = 1; });
  return by_jets;
}

std::vector<double> MeshFlow::guess_of(const CoupledState& state) const {
  std::vector<double> p;
  for (const std::size_t f : at_.pressures.face_of) p.push_back(state.p[f]);
  return p;
}

void MeshFlow::keep_pressures(std::span<const double> p, CoupledState& state) const {
  for (std::size_t f = 0; f < state.p.size(); ++f)
    state.p[f] = at_.pressures.of[f] < 0 ? pressure_outside(f) : p[at(at_.pressures.of[f])];
}

SparseMatrix MeshFlow::pressure_matrix(const Placed& at_q, double by) const {
  const FlowMesh& mesh = *at_q.mesh;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const int f : mesh.faces_of(cell)) {
      for (const int g : mesh.faces_of(cell)) {
        if (at_q.pressures.of[at(f)] < 0 || at_q.pressures.of[at(g)] < 0) continue;
        entries.emplace_back(at_q.pressures.of[at(f)], at_q.pressures.of[at(g)],
                             by * dot(mesh.out_of(cell, at(f)), mesh.out_of(cell, at(g))) / mesh.volume[cell]);
      }
    }
  }
  EigenSparse L(static_cast<Eigen::Index>(at_q.pressures.face_of.size()),
                static_cast<Eigen::Index>(at_q.pressures.face_of.size()));
  L.setFromTriplets(entries.begin(), entries.end());
  return sparse_of(L);
}

/// Pressures that are linear in each cell, and those of the faces of flat cells, as in films.
CoarseUnknowns MeshFlow::coarse_of(const Placed& at_q) {
  const FlowMesh& mesh = *at_q.mesh;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  const std::size_t count = at_q.pressures.face_of.size();
  for (std::size_t k = 0; k < count; ++k) {
    for (const int n : mesh.face_nodes(at_q.pressures.face_of[k])) entries.emplace_back(k, n, 1.0 / mesh.dim);
  }
  CoarseUnknowns coarse;
  coarse.interpolation.resize(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(mesh.x.size()));
  coarse.interpolation.setFromTriplets(entries.begin(), entries.end());
  const std::vector<std::uint8_t> is_flat = mesh.faces_of_flat_cells();
  for (std::size_t k = 0; k < count; ++k) {
    if (is_flat[at_q.pressures.face_of[k]] != 0) coarse.stiff.push_back(k);
  }
  return coarse;
}

/// Through each face what comes out of the cells on both sides is to be nothing.
std::vector<double> MeshFlow::net_flux(const FaceValues& v) const {
  const FlowMesh& mesh = *at_.mesh;
  std::vector<double> r(at_.pressures.face_of.size(), 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const int f : mesh.faces_of(cell)) {
      if (at_.pressures.of[at(f)] < 0) continue;
      const Vec<3> out = mesh.out_of(cell, at(f));
      for (std::size_t a = 0; a < at(mesh.dim); ++a) r[at(at_.pressures.of[at(f)])] -= out[a] * v[a][cell];
    }
  }
  each_prescribed(v, [&](std::size_t face, double out) { r[at(at_.pressures.of[face])] += out; });
  return r;
}

void MeshFlow::add_pressure(std::span<const double> p, double by, FaceValues& v) const {
  const FlowMesh& mesh = *at_.mesh;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const int f : mesh.faces_of(cell)) {
      if (at_.pressures.of[at(f)] < 0) continue;
      const Vec<3> out = mesh.out_of(cell, at(f));
      for (std::size_t a = 0; a < at(mesh.dim); ++a)
        v[a][cell] -= by * out[a] * p[at(at_.pressures.of[at(f)])] / mesh.volume[cell];
    }
  }
}

double MeshFlow::kinetic_energy_on(const FlowMesh& mesh, const FaceValues& v, const FaceValues& w) const {
  double sum = 0;
  for (std::size_t a = 0; a < at(mesh.dim); ++a) {
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) sum += mesh.volume[cell] * v[a][cell] * w[a][cell];
  }
  return 0.5 * scene_.density * sum;
}

double MeshFlow::prescribed_power(std::span<const double> p, const FaceValues& v) const {
  double power = 0;
  each_prescribed(v, [&](std::size_t face, double out) { power += p[at(at_.pressures.of[face])] * out; });
  return power;
}

std::vector<double> MeshFlow::masses() const {
  const FlowMesh& mesh = *at_.mesh;
  std::vector<double> masses;
  for (std::size_t a = 0; a < at(mesh.dim); ++a) {
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) masses.push_back(scene_.density * mesh.volume[cell]);
    if (a == 0) masses.resize(mesh.cells() + mesh.faces(), 0.0);
  }
  return masses;
}

/// By the largest face of each: that a cell is thin, as in a film, loses nothing of what is carried along.
double MeshFlow::cells_crossed(const FaceValues& v, double h) const {
  const FlowMesh& mesh = *at_.mesh;
  double most = 0;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const double largest = mesh.largest_face(cell);
    double square = 0;
    for (std::size_t a = 0; a < at(mesh.dim); ++a) square += v[a][cell] * v[a][cell];
    most = std::max(most, h * std::sqrt(square) / (mesh.dim == 2 ? largest : std::sqrt(2 * largest)));
  }
  return most;
}

}  // namespace tether::coupled
