// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "algebra/krylov.hpp"
#include "algebra/two_level.hpp"
#include "base/diagnostics.hpp"
#include "loops/thread_team.hpp"
#include "unit/full_length.hpp"
#include "unit/physics/box/mesh_support.hpp"

// A fluid on tetrahedra about bodies, in the unit cube.

namespace tether::coupled {
namespace {

using support::Flowing, support::box_of;
using Values = std::vector<double>;

/// Triangles of the unit sphere: those of an icosahedron, each edge in so many parts; about five times as many are on a
/// great circle.
struct Sphere {
  std::vector<Vec<3>> x;
  std::vector<std::array<int, 3>> triangles;

  explicit Sphere(int parts) {
    const double g = std::numbers::phi;
    std::vector<Vec<3>> corner;
    for (const auto& [a, b] : {std::pair{1.0, g}, {-1.0, g}, {1.0, -g}, {-1.0, -g}})
      corner.insert(corner.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    const auto near = [&](std::size_t a, std::size_t b) { return dot(corner[a], corner[b]) > 0; };
    for (std::size_t a = 0; a < 12; ++a) {
      for (std::size_t b = a + 1; b < 12; ++b) {
        for (std::size_t c = b + 1; c < 12; ++c) {
          if (near(a, b) && near(b, c) && near(c, a)) add({corner[a], corner[b], corner[c]}, parts);
        }
      }
    }
  }

 private:
  /// The node on the way to a place, which is new where none is there.
  int node(const Vec<3>& to) {
    const double size = std::sqrt(dot(to, to));
    const Vec<3> on{to[0] / size, to[1] / size, to[2] / size};
    const auto key = std::array{std::lround(1e6 * on[0]), std::lround(1e6 * on[1]), std::lround(1e6 * on[2])};
    const auto [known, is_new] = known_.try_emplace(key, static_cast<int>(x.size()));
    if (is_new) x.push_back(on);
    return known->second;
  }
  void add(const std::array<Vec<3>, 3>& of, int parts) {
    const auto place = [&](int i, int j) {
      Vec<3> to{};
      for (std::size_t a = 0; a < 3; ++a) to[a] = (parts - i - j) * of[0][a] + i * of[1][a] + j * of[2][a];
      return node(to);
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        turn({place(i, j), place(i + 1, j), place(i, j + 1)});
        if (i + j + 1 < parts) turn({place(i + 1, j + 1), place(i, j + 1), place(i + 1, j)});
      }
    }
  }
  void turn(std::array<int, 3> of) {
    const Vec<3>&a = x[at(of[0])], &b = x[at(of[1])], &c = x[at(of[2])];
    if (dot(cross(minus(b, a), minus(c, a)), a) < 0) std::swap(of[0], of[1]);
    triangles.push_back(of);
  }

  std::map<std::array<long, 3>, int> known_;
};

/// A sphere's volume over that of its triangles with nodes on it, cubic root.
double radius_factor(const Sphere& sphere) {
  double six = 0;
  for (const auto& [a, b, c] : sphere.triangles) six += dot(cross(sphere.x[at(a)], sphere.x[at(b)]), sphere.x[at(c)]);
  return std::cbrt(8 * std::numbers::pi / six);
}

void add_places(const Sphere& sphere, double radius, Mesh& mesh) {
  for (const Vec<3>& of : sphere.x) {
    for (const double along : of) mesh.x.push_back(0.5 + radius * along);
  }
}

/// What it encloses, of the same volume, in tetrahedra about its middle.
Mesh ball(const Sphere& sphere, double radius) {
  Mesh mesh;
  mesh.kind = ElementKind::tet4;
  mesh.x = {0.5, 0.5, 0.5};
  add_places(sphere, radius * radius_factor(sphere), mesh);
  for (const auto& [a, b, c] : sphere.triangles) mesh.nodes.insert(mesh.nodes.end(), {0, a + 1, b + 1, c + 1});
  mesh.region.assign(sphere.triangles.size(), 0);
  return mesh;
}

/// What lies between two spheres, three tetrahedra a triangle.
Mesh shell(const Sphere& sphere, double inner, double outer) {
  Mesh mesh;
  mesh.kind = ElementKind::tet4;
  add_places(sphere, inner * radius_factor(sphere), mesh), add_places(sphere, outer, mesh);
  const int up = static_cast<int>(sphere.x.size());
  for (std::array<int, 3> of : sphere.triangles) {
    while (of[0] > of[1] || of[0] > of[2]) of = {of[1], of[2], of[0]};  // diagonals by the nodes' order
    const auto [a, b, c] = of;
    if (b < c) {
      mesh.nodes.insert(mesh.nodes.end(), {a, b, c, c + up, a, b + up, b, c + up, a, b + up, c + up, a + up});
    } else {
      mesh.nodes.insert(mesh.nodes.end(), {a, b, c, b + up, a, c, c + up, b + up, a, b + up, c + up, a + up});
    }
  }
  mesh.region.assign(3 * sphere.triangles.size(), 0);
  for (std::size_t k = 0; k < mesh.nodes.size(); k += 4) {
    std::array<Vec<3>, 4> x{};
    for (std::size_t n = 0; n < 4; ++n) x[n] = place_of(mesh.x, mesh.nodes[k + n], 3);
    if (dot(cross(minus(x[1], x[0]), minus(x[2], x[0])), minus(x[3], x[0])) < 0)
      std::swap(mesh.nodes[k], mesh.nodes[k + 1]);
  }
  return mesh;
}

/// L^-1 r by conjugate gradients with two levels, the first pressure tied down where nothing is open.
Values solved(const Flowing& flowing, const Values& r, double tolerance = 1e-10, int* iterations = nullptr) {
  SymmetricRows rows = rows_of(flowing.flow.pressure_matrix(1));
  rows.diagonal[0] *= 2;
  ThreadTeam team(1);
  TwoLevelPreconditioner levels;
  EXPECT_TRUE(levels.set_up(rows, *flowing.flow.coarse_pressures()));
  Values x(r.size(), 0.0);
  const KrylovResult result = pcg(
      team, [&](std::span<const double> v, std::span<double> y) { rows.multiply(team, v, y); },
      [&](std::span<const double> v, std::span<double> z) { levels.precondition(v, z); }, r, x, tolerance, 300);
  EXPECT_TRUE(result.converged);
  if (iterations != nullptr) *iterations = result.iterations;
  return x;
}

/// At rest pressures balance gravity to the last digits, and hold a body by the weight of the fluid that it displaces.
TEST(SpaceMesh, RestsAndFloats) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Values at = support::random_numbers(4, seed);
    const Mesh body =
        support::solid_block(3, 2, {0.5 + 0.1 * at[0], 0.5 + 0.1 * at[1], 0.5 + 0.1 * at[2]}, 0.3, 2 * at[3]);
    const Vec<3> gravity{0.3, -0.8, 0};
    Flowing flowing(box_of(0.17, 3), body, gravity);
    flowing.flow.add_forces({}, 1, flowing.state.v);
    const Values p = flowing.project();
    EXPECT_LT(flowing.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-11) << seed;
    const Values force = support::transposed_product(flowing.flow.map().B, p);
    const double volume = enclosed_volumes(flowing.surface, body.x)[0];
    for (std::size_t a = 0; a < 3; ++a) {
      double sum = 0;
      for (std::size_t k = a; k < force.size(); k += 3) sum += force[k];
      EXPECT_NEAR(sum, -volume * gravity[a], 1e-11) << seed;
    }
  }
}

/// Conjugate gradients with two levels find pressures in so many iterations; in films, too.
TEST(SpaceMesh, TwoLevelsFindPressuresSoon) {
  for (const double low : {0.2, 1e-2, 1e-3, 1e-4}) {
    for (const double size : {0.11, 0.068}) {
      const Mesh plate = support::lattice(3, {6, 2, 6}, support::all, [&](const Vec<3>& s) {
        return Vec<3>{0.2 + 0.6 * s[0], low + 0.12 * s[1], 0.2 + 0.6 * s[2]};
      });
      const Flowing flowing(box_of(size, 3), plate);
      int iterations = 0;
      solved(flowing, support::random_numbers(flowing.flow.row_count(), 3), 1e-8, &iterations);
      EXPECT_LE(iterations, 45) << low;
    }
  }
}

/// The added mass of a sphere in a shell, over the mass that it displaces, is (b^3 + 2 a^3) / (b^3 - a^3) / 2.
TEST(SpaceMesh, AddedMassOfASphereInAShell) {
  std::vector<double> error, slow;
  const bool full = test::at_full_length();
  for (const int parts : full ? std::array{6, 12} : std::array{4, 8}) {  // five times as many sides around
    const Mesh inner = ball(Sphere(parts), 0.1);
    Coupled box = box_of(0.2 / parts, 3);
    box.cavities_only = true;
    const Flowing flowing(box, support::together(inner, shell(Sphere(2 * parts), 0.3, 0.4)));
    Values u(flowing.state.q.size(), 0.0);
    for (std::size_t k = 0; k < inner.x.size(); k += 3) u[k] = 1;
    const Values flux = support::product(flowing.flow.map().B, u), p = solved(flowing, flux);
    double twice = 0;
    for (std::size_t k = 0; k < p.size(); ++k) twice += p[k] * flux[k];
    const double exact = 0.5 * 0.029 / 0.026, mass = twice / (4.0 / 3 * std::numbers::pi * 0.001);
    error.push_back(mass / exact - 1);
    slow.push_back((2 + exact) / (2 + mass) - 1);  // what it accelerates at first, twice as heavy as the fluid
  }
  EXPECT_LT(std::abs(error[0]), full ? 0.04 : 0.09);
  EXPECT_LT(std::abs(error[1]), full ? 0.015 : 0.03);
  EXPECT_LT(std::abs(slow[0]), full ? 0.007 : 0.02);
  EXPECT_LT(std::abs(slow[1]), full ? 0.002 : 0.006);
}

/// A plate has nearly the same added mass along itself whatever elements it is made of: its sides have as short edges
/// as the mesh is to have at it.
TEST(SpaceMesh, CellsAtBodiesAreSmallWhateverTheirElementsAre) {
  std::vector<double> mass;
  for (const int n : {1, 4}) {
    const Mesh plate = support::lattice(3, {n, n, n}, support::all, [](const Vec<3>& s) {
      return Vec<3>{0.47 + 0.06 * s[0], 0.35 + 0.3 * s[1], 0.2 + 0.6 * s[2]};
    });
    Coupled box = box_of(0.2, 3);
    box.mesh->near = 0.06;
    const Flowing flowing(box, plate);
    Values u(flowing.state.q.size(), 0.0);
    for (std::size_t k = 1; k < u.size(); k += 3) u[k] = 1;
    const Values flux = support::product(flowing.flow.map().B, u), p = solved(flowing, flux);
    double twice = 0;
    for (std::size_t k = 0; k < p.size(); ++k) twice += p[k] * flux[k];
    mass.push_back(twice / (0.06 * 0.3 * 0.6));
  }
  EXPECT_NEAR(mass[0], mass[1], 0.1 * mass[1]);
  EXPECT_GT(mass[1], 0.1);
}

/// Bodies that are apart or touch have a mesh about them; of those that cross it is said where.
TEST(SpaceMesh, BodiesThatTouchHaveAMeshAboutThem) {
  const unsigned count = test::at_full_length() ? 200 : 60;
  unsigned made = 0;
  for (unsigned seed = 1; seed <= count; ++seed) {
    const Values at = support::random_numbers(6, seed);
    const double angle = seed % 4 == 0 ? 0 : 2 * at[3], width = 0.2 + 0.05 * at[2];
    const Vec<3> middle{0.5 + 0.15 * at[0], 0.5 + 0.15 * at[1], 0.5 + 0.1 * at[4]};
    const double reach = seed % 3 == 0 ? 1 : 1 + at[4] * (seed % 3 == 1 ? 1e-6 : 1e-4);  // of touching
    const Vec<3> other{middle[0] + reach * width * std::cos(angle),
                       middle[1] + reach * width * std::sin(angle) * std::cos(angle / 2),
                       middle[2] + reach * width * std::sin(angle) * std::sin(angle / 2)};
    const Mesh two = support::together(support::solid_block(3, 2, middle, width, angle),
                                       support::solid_block(3, seed % 2 == 0 ? 2 : 1, other, width, angle));
    try {
      const Flowing flowing(box_of(0.25, 3), two);
      double volume = 0;
      for (const double of_cell : flowing.mesh().volume) volume += of_cell;
      EXPECT_NEAR(volume, 1 - 2 * std::pow(width, 3), 0.08 * std::pow(width, 3)) << seed;
      ++made;
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("near ("), std::string::npos);
    }
  }
  EXPECT_GE(made, count - count / 40);
}

}  // namespace
}  // namespace tether::coupled
