// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

#include "algebra/eigen_sparse.hpp"
#include "physics/box/mesh/mesh_flow.hpp"
#include "unit/alone.hpp"
#include "unit/physics/box/bodies_support.hpp"

// A fluid on triangles or tetrahedra about bodies, in the unit square or cube.

namespace tether::coupled::support {

inline Coupled box_of(double size, int dim = 2) {
  Coupled box = fluid_in_box(dim, 16);
  box.coupling = coupling_of(CouplingMode::cut_cell);
  box.mesh = {.size = size, .near = size};
  return box;
}

using Values = std::vector<double>;

/// A flow about bodies at its start.
struct Flowing {
  Coupled scene;
  SolidSurface surface;
  MeshFlow flow;
  CoupledState state;

  Flowing(const Coupled& box, const Mesh& mesh, const Vec<3>& gravity = {})
      : scene(box), surface(surface_of(mesh)), flow(scene, gravity, surface, mesh.x.size(), alone()) {
    state.q = mesh.x;
    flow.start(state);
  }

  /// L^-1 r, 0 in the first pressure of each closed region.
  Values solved(const Values& r) const {
    const SparseMatrix L = flow.pressure_matrix(1);
    EigenSparse A = eigen_of(L);
    std::vector<std::uint8_t> met(static_cast<std::size_t>(flow.regions().count), 0);
    for (std::size_t k = 0; k < r.size(); ++k) {
      const auto region = static_cast<std::size_t>(flow.regions().of[k]);
      if (met[region] == 0 && flow.regions().closed[region] != 0)
        A.coeffRef(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) *= 2;
      met[region] = 1;
    }
    const Eigen::SimplicialLDLT<EigenSparse> factors(A);
    const Eigen::VectorXd p = factors.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), std::ssize(r)));
    return {p.begin(), p.end()};
  }
  /// Makes the velocity free of divergence about bodies at rest; returns the pressures.
  Values project() {
    Values r = flow.net_flux(state.v);
    for (double& value : r) value = -value;
    const Values p = solved(r);
    flow.add_pressure(p, 1, state.v);
    return p;
  }
  const FlowMesh& mesh() const { return flow.mesh(); }
  double energy() const { return flow.kinetic_energy(state.v, state.v); }
  double error(const auto& exact) const {
    double sum = 0;
    for (std::size_t cell = 0; cell < mesh().cells(); ++cell) {
      const auto v = exact(mesh().middle(cell));
      for (std::size_t a = 0; a < at(mesh().dim); ++a)
        sum += mesh().volume[cell] * std::pow(state.v[a][cell] - v[a], 2);
    }
    return std::sqrt(sum);
  }
  /// Gives each cell the mean over the middles of its faces.
  void set(const auto& velocity) {
    for (std::size_t cell = 0; cell < mesh().cells(); ++cell) {
      for (std::size_t a = 0; a < at(mesh().dim); ++a) state.v[a][cell] = 0;
      for (const int f : mesh().faces_of(cell)) {
        const auto v = velocity(mesh().middle_of_face(static_cast<std::size_t>(f)));
        for (std::size_t a = 0; a < at(mesh().dim); ++a)
          state.v[a][cell] += v[a] / static_cast<double>(mesh().corners());
      }
    }
  }
};

}  // namespace tether::coupled::support
