// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "model/coupled.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"
#include "physics/box/coupling_map.hpp"
#include "physics/box/flow_box.hpp"
#include "physics/box/placer.hpp"
#include "unit/alone.hpp"

// Solids in a box of fluid for the tests of the coupled path, and what the path makes of where they are.

namespace tether::coupled::support {

using Cell = std::array<int, 3>;
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// n[0] x n[1] (x n[2]) squares (cubes) of the unit square (cube), those that keep(square) takes, each of two triangles
/// (six tetrahedra); nodes are where map(place) puts them.
template <class Keep, class Map>
Mesh lattice(int dim, Cell n, const Keep& keep, const Map& map) {
  Mesh mesh;
  mesh.kind = dim == 2 ? ElementKind::tri3 : ElementKind::tet4;
  if (dim == 2) n[2] = 1;
  std::vector<int> number(at((n[0] + 1) * (n[1] + 1) * (n[2] + 1)), -1);
  const auto node = [&](const Cell& c) {
    int& known = number[at(c[0] + (n[0] + 1) * (c[1] + (n[1] + 1) * c[2]))];
    if (known >= 0) return known;
    known = static_cast<int>(mesh.x.size()) / dim;
    const Vec<3> x = map(Vec<3>{double(c[0]) / n[0], double(c[1]) / n[1], dim == 3 ? double(c[2]) / n[2] : 0});
    mesh.x.insert(mesh.x.end(), x.begin(), x.begin() + dim);
    return known;
  };
  Cell c{};
  for (c[2] = 0; c[2] < n[2]; ++c[2]) {
    for (c[1] = 0; c[1] < n[1]; ++c[1]) {
      for (c[0] = 0; c[0] < n[0]; ++c[0]) {
        if (!keep(c)) continue;
        std::array<int, 3> order{0, 1, 2};  // of the axes, on the way from one corner to the opposite one
        do {
          int turns = 0;
          for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = a + 1; b < 3; ++b) turns += order[a] > order[b] ? 1 : 0;
          }
          std::vector<int> element{node(c)};
          Cell corner = c;
          for (int a = 0; a < dim; ++a) ++corner[at(order[at(a)])], element.push_back(node(corner));
          if (turns % 2 == 1) std::swap(element[1], element[2]);
          mesh.nodes.insert(mesh.nodes.end(), element.begin(), element.end());
          mesh.region.push_back(0);
        } while (std::next_permutation(order.begin(), order.begin() + dim));
      }
    }
  }
  return mesh;
}

inline bool all(const Cell&) { return true; }

/// A block with these sides and middle, turned by an angle about z and, in space, half of it about x.
inline auto turned_block(const Vec<3>& middle, const Vec<3>& sides, double angle) {
  return [=](const Vec<3>& s) {
    Vec<3> x{(s[0] - 0.5) * sides[0], (s[1] - 0.5) * sides[1], (s[2] - 0.5) * sides[2]};
    x = {std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1], x[2]};
    if (sides[2] > 0) {
      const double a = 0.5 * angle;
      x = {x[0], std::cos(a) * x[1] - std::sin(a) * x[2], std::sin(a) * x[1] + std::cos(a) * x[2]};
    }
    return Vec<3>{middle[0] + x[0], middle[1] + x[1], middle[2] + x[2]};
  };
}

/// A square (cube) of three squares (cubes) along each axis whose middle one is left out, cut finer by `by`.
inline Mesh hollow_block(int dim, int by, const Vec<3>& middle, double side, double angle) {
  const auto keep = [=](const Cell& c) {
    bool inner = true;
    for (int a = 0; a < dim; ++a) inner = inner && c[at(a)] / by == 1;
    return !inner;
  };
  return lattice(dim, {3 * by, 3 * by, 3 * by}, keep, turned_block(middle, {side, side, dim == 3 ? side : 0}, angle));
}

inline Mesh solid_block(int dim, int n, const Vec<3>& middle, double side, double angle) {
  return lattice(dim, {n, n, n}, all, turned_block(middle, {side, side, dim == 3 ? side : 0}, angle));
}

/// Two meshes as one, of two bodies.
inline Mesh together(Mesh a, const Mesh& b) {
  const int first = static_cast<int>(a.node_count());
  a.x.insert(a.x.end(), b.x.begin(), b.x.end());
  for (const int node : b.nodes) a.nodes.push_back(node + first);
  a.region.insert(a.region.end(), b.region.begin(), b.region.end());
  return a;
}

inline std::vector<double> random_numbers(std::size_t count, unsigned seed, double size = 1) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> numbers(count);
  for (double& x : numbers) x = number(engine);
  return numbers;
}

/// A box of n cells a side, the unit square or cube, with walls, and fluid of density 1.
/// By cells that are wholly fluid or solid, unless a test says otherwise.
inline Coupled fluid_in_box(int dim, int n) {
  Coupled coupled;
  coupled.coupling = coupling_of(CouplingMode::symmetric);
  coupled.grid.dim = dim;
  for (std::size_t a = 0; a < at(dim); ++a) coupled.grid.n[a] = n, coupled.grid.d[a] = 1.0 / n;
  return coupled;
}

inline Solids elastic(Mesh mesh, double E = 1000, double nu = 0.3, double density = 1) {
  Solids solids;
  solids.mesh = std::move(mesh);
  const Lame law = lame(E, nu);
  solids.regions.push_back({"body", StVenantKirchhoff{law.lambda, law.mu}, density});
  return solids;
}

/// What CoupledStep finds of solids at q, less what it does about pockets.
struct Surroundings {
  SolidSurface surface;
  SurfacePieces pieces;
  Crossings crossings;
  CutCells cut;
  FlowDomain domain;
  PressureNumbers numbers;
  CouplingMap map;

  Surroundings(const Coupled& coupled, const Mesh& mesh, std::span<const double> q)
      : surface(surface_of(mesh)),
        pieces(cut_surface(surface, q, coupled.grid, coupled.coupling.cuts_faces ? 2 : 1)),
        crossings(find_crossings(surface, q, coupled.grid)) {
    const FlowBox box(coupled);
    const bool cuts = coupled.coupling.cuts_faces;
    domain = box.around(crossings);
    if (cuts) cut = cut_cells(pieces, crossings, domain), domain = box.around(crossings, cut);
    numbers = number_pressures(domain);
    const PressureSampler sampler(surface, q, pieces, domain);
    map = map_by_pressures(alone(), {surface, pieces, domain, numbers}, sampler, cuts ? &cut : nullptr);
  }
  Surroundings(const Coupled& coupled, const Mesh& mesh) : Surroundings(coupled, mesh, mesh.x) {}

  int region_at(const Vec<3>& x) const {
    Cell c{};
    for (std::size_t a = 0; a < at(domain.grid.dim); ++a)
      c[a] = static_cast<int>(std::floor((x[a] - domain.grid.low[a]) / domain.grid.d[a]));
    return domain.region[domain.grid.cell(c)];
  }
};

inline std::vector<double> product(const CouplingMatrix& B, const std::vector<double>& u) {
  const Eigen::VectorXd y = B * Eigen::Map<const Eigen::VectorXd>(u.data(), std::ssize(u));
  return {y.begin(), y.end()};
}
inline std::vector<double> transposed_product(const CouplingMatrix& B, const std::vector<double>& p) {
  const Eigen::VectorXd y = B.transpose() * Eigen::Map<const Eigen::VectorXd>(p.data(), std::ssize(p));
  return {y.begin(), y.end()};
}

/// A dimension and how the coupling counts cells, for tests of both.
struct CouplingKind {
  int dim;
  CouplingMode mode;
};
inline void PrintTo(const CouplingKind& kind, std::ostream* out) { *out << kind.dim << " " << word_of(kind.mode); }

}  // namespace tether::coupled::support
