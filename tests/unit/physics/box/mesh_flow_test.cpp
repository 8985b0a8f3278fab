// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/mesh_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "algebra/eigen_sparse.hpp"
#include "physics/box/matrix.hpp"
#include "unit/physics/box/mesh_support.hpp"

// A fluid on triangles about bodies, in the unit square.

namespace tether::coupled {
namespace {

using std::numbers::pi;
using Values = std::vector<double>;

/// A disc with so many sides that has the area of one with this radius.
Mesh disc(const Vec<3>& middle, double radius, int sides) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  mesh.x = {middle[0], middle[1]};
  const double r = radius * std::sqrt(2 * pi / sides / std::sin(2 * pi / sides));
  for (int k = 0; k < sides; ++k) {
    const double angle = 0.1 + 2 * pi * k / sides;
    mesh.x.push_back(middle[0] + r * std::cos(angle)), mesh.x.push_back(middle[1] + r * std::sin(angle));
    mesh.nodes.insert(mesh.nodes.end(), {0, 1 + k, 1 + (k + 1) % sides});
    mesh.region.push_back(0);
  }
  return mesh;
}

/// What lies between two radii, with so many sides within.
Mesh shell(const Vec<3>& middle, double inner, double outer, int sides) {
  Mesh mesh;
  mesh.kind = ElementKind::tri3;
  const double r = inner * std::sqrt(2 * pi / sides / std::sin(2 * pi / sides));
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * pi * k / sides;
    for (const double radius : {r, outer})
      mesh.x.push_back(middle[0] + radius * std::cos(angle)), mesh.x.push_back(middle[1] + radius * std::sin(angle));
    const int a = 2 * k, b = 2 * ((k + 1) % sides);
    mesh.nodes.insert(mesh.nodes.end(), {a, a + 1, b + 1, a, b + 1, b});
    mesh.region.insert(mesh.region.end(), {0, 0});
  }
  return mesh;
}

using support::Flowing, support::box_of;

/// The fluid outside presses on what is beyond an open side: at rest a body has the weight of all the fluid in its
/// room.
TEST(MeshFlow, LiftsWhatIsBeyondAnOpenSide) {
  for (const Vec<3>& middle : {Vec<3>{0.5, 0.02, 0}, Vec<3>{0.97, 0.5, 0}, Vec<3>{0.5, 1.03, 0}}) {
    Coupled box = box_of(0.1);
    box.sides.fill(BoxSide::open), box.sides[side_left] = BoxSide::wall;
    const Mesh body = support::lattice(2, {2, 2, 1}, support::all, support::turned_block(middle, {0.3, 0.2, 0}, 0.4));
    Flowing at(box, body, {0, -10, 0});
    Values p;
    for (std::size_t k = 0; k < at.flow.rows().size(); ++k)
      p.push_back(box.density * 10 * (box.level - at.flow.place_of_pressure(k)[1]));
    Values force = at.flow.map().outside;
    add_transposed_product(at.flow.map().B, 1, p, force);
    double x = 0, y = 0;
    for (std::size_t k = 0; k < force.size(); k += 2) x += force[k], y += force[k + 1];
    EXPECT_NEAR(x, 0, 1e-10 * box.density);
    EXPECT_NEAR(y, box.density * 10 * 0.06, 1e-10 * box.density);
  }
}

TEST(MeshFlow, TrianglesFillWhatBodiesLeave) {
  for (const double angle : {0.0, 0.4, 1.1}) {
    const Mesh body = support::hollow_block(2, 2, {0.52, 0.47, 0}, 0.45, angle);
    const Flowing at(box_of(0.07), body);
    double volume = 0;
    for (const double of_cell : at.mesh().volume) {
      volume += of_cell;
      EXPECT_GT(of_cell, 0);
    }
    EXPECT_NEAR(volume, 1 - 0.45 * 0.45 * 8 / 9, 1e-12);
    EXPECT_EQ(at.flow.regions().count, 2);
    std::vector<int> seen(at.surface.side_count(), 0);
    for (std::size_t f = 0; f < at.mesh().faces(); ++f) {
      EXPECT_EQ(at.mesh().is_at_boundary(f), at.mesh().boundary[f].kind != BoundaryKind::none);
      if (at.mesh().boundary[f].kind == BoundaryKind::solid)
        ++seen[static_cast<std::size_t>(at.mesh().boundary[f].number)];
    }
    for (const int times : seen) EXPECT_GE(times, 1);
  }
}

/// At rest pressures balance gravity to the last digits, and hold a body by the weight of the fluid that it displaces.
TEST(MeshFlow, RestsAndFloats) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Values at = support::random_numbers(4, seed);
    const Mesh body =
        support::solid_block(2, 3, {0.5 + 0.2 * at[0], 0.5 + 0.2 * at[1], 0}, 0.2 + 0.05 * at[2], 2 * at[3]);
    const Vec<3> gravity{0.3, -0.8, 0};
    Flowing flowing(box_of(0.11), body, gravity);
    flowing.flow.add_forces({}, 1, flowing.state.v);
    const Values p = flowing.project();
    EXPECT_LT(flowing.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-11) << seed;
    const Values force = support::transposed_product(flowing.flow.map().B, p);
    const double volume = enclosed_volumes(flowing.surface, body.x)[0];
    for (std::size_t a = 0; a < 2; ++a) {
      double sum = 0;
      for (std::size_t k = a; k < force.size(); k += 2) sum += force[k];
      EXPECT_NEAR(sum, -volume * gravity[a], 1e-11) << seed;
    }
  }
}

TEST(MeshFlow, FindsAFlowThatGradientsCover) {
  const auto flow = [](const Vec<3>& x) {
    return Vec<3>{pi * std::pow(std::sin(pi * x[0]), 2) * std::sin(2 * pi * x[1]),
                  -pi * std::pow(std::sin(pi * x[1]), 2) * std::sin(2 * pi * x[0]), 0};
  };
  const auto gradient = [](const Vec<3>& x) {
    return Vec<3>{4 * std::cos(4 * x[0]) * std::cos(5 * x[1]), -5 * std::sin(4 * x[0]) * std::sin(5 * x[1]), 0};
  };
  std::vector<double> of_both, of_gradient;
  for (const double size : {1.0 / 16, 1.0 / 32, 1.0 / 64}) {
    Flowing both(box_of(size), {}), alone(box_of(size), {});
    both.set([&](const Vec<3>& x) {
      const Vec<3> v = flow(x), w = gradient(x);
      return Vec<3>{v[0] + w[0], v[1] + w[1], 0};
    });
    alone.set(gradient);
    both.project(), alone.project();
    double error = 0;  // as a field that is constant in each cell
    for (std::size_t cell = 0; cell < both.mesh().cells(); ++cell) {
      for (const int f : both.mesh().faces_of(cell)) {
        const Vec<3> v = flow(both.mesh().middle_of_face(static_cast<std::size_t>(f)));
        for (std::size_t a = 0; a < 2; ++a)
          error += both.mesh().volume[cell] / 3 * std::pow(both.state.v[a][cell] - v[a], 2);
      }
    }
    of_both.push_back(std::sqrt(error));
    of_gradient.push_back(alone.error([](const Vec<3>&) { return Vec<3>{}; }));
  }
  EXPECT_GT(std::log2(of_both[1] / of_both[2]), 0.95);
  EXPECT_GT(std::log2(of_gradient[1] / of_gradient[2]), 2.8);
}

/// The added mass of a disc in a shell, over the mass that it displaces, is (b^2 + a^2) / (b^2 - a^2).
TEST(MeshFlow, AddedMassOfADiscInAShell) {
  std::vector<double> error, slow;
  for (const int sides : {32, 64}) {
    const Mesh inner = disc({0.5, 0.5, 0}, 0.1, sides);
    const Mesh all = support::together(inner, shell({0.5, 0.5, 0}, 0.3, 0.4, 3 * sides));
    const Flowing flowing(box_of(2 * pi * 0.1 / sides), all);
    Values u(all.x.size(), 0.0);
    for (std::size_t k = 0; k < inner.x.size(); k += 2) u[k] = 1;
    const Values flux = support::product(flowing.flow.map().B, u), p = flowing.solved(flux);
    double twice = 0;
    for (std::size_t k = 0; k < p.size(); ++k) twice += p[k] * flux[k];
    const double mass = twice / (pi * 0.01);
    error.push_back(std::abs(mass - 1.25));
    slow.push_back(std::abs((2 + 1.25) / (2 + mass) - 1));  // what it accelerates at first, twice as heavy as the fluid
  }
  EXPECT_LT(slow[0], 0.007);
  EXPECT_LT(slow[1], 0.002);
  EXPECT_LT(error[0], 0.025);
  EXPECT_LT(error[1], 0.006);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.7);
}

/// A plate that comes down on the floor at a speed of 1 drives the fluid out of the film below it: its energy is
/// L^3 / (24 gap) where the film is thin, next to which that of the fluid elsewhere is none.
TEST(MeshFlow, AThinFilmIsSqueezedOut) {
  for (const double gap : {1e-3, 1e-4}) {
    constexpr double length = 0.4;
    const Mesh plate = support::lattice(2, {6, 1, 1}, support::all, [&](const Vec<3>& s) {
      return Vec<3>{0.3 + length * s[0], gap * length + 0.06 * s[1], 0};
    });
    const Flowing flowing(box_of(0.08 * length), plate);
    Values u(plate.x.size(), 0.0);
    for (std::size_t k = 1; k < u.size(); k += 2) u[k] = -1;
    const Values flux = support::product(flowing.flow.map().B, u), p = flowing.solved(flux);
    double energy = 0;
    for (std::size_t k = 0; k < p.size(); ++k) energy += 0.5 * p[k] * flux[k];
    EXPECT_NEAR(energy / (length * length / (24 * gap)), 1, 0.2) << gap;
  }
}

/// A sheet of a hundredth of the triangles' size lets nothing through: what flows on its two sides has nothing to do
/// with each other.
TEST(MeshFlow, ThinSheetsAreTight) {
  const Mesh sheet = support::lattice(2, {1, 24, 1}, support::all, [](const Vec<3>& s) {
    return Vec<3>{0.5 + 0.0006 * (s[0] - 0.5), s[1] < 0.5 ? 1e-12 : s[1] > 0.99 ? 1 - 1e-12 : s[1], 0};
  });
  Flowing flowing(box_of(0.06), sheet);
  flowing.set([](const Vec<3>&) { return Vec<3>{1, 0, 0}; });
  flowing.project();
  EXPECT_LT(flowing.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-10);
}

/// A side to nothing lets fluid out: no region is closed, and the pressure there is none.
TEST(MeshFlow, SidesToNothingAreOpen) {
  for (const BoxSide side : {BoxSide::open, BoxSide::empty}) {
    Coupled box = box_of(0.1);
    box.sides[side_top] = side, box.level = 0.8;
    Flowing at(box, support::solid_block(2, 2, {0.5, 0.5, 0}, 0.3, 0.2), {0, -2, 0});
    EXPECT_EQ(at.flow.regions().closed, std::vector<std::uint8_t>{0});
    at.flow.add_forces({}, 1, at.state.v);
    const Values p = at.project();
    EXPECT_LT(at.error([](const Vec<3>&) { return Vec<3>{}; }), 1e-11);
    const double level = side == BoxSide::open ? 0.8 : 1;
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p[k], 2 * (level - at.flow.place_of_pressure(k)[1]), 1e-11);
  }
}

/// Obstacles that touch a wall, overlap one another or reach out of the box, and a body that stands on one.
TEST(MeshFlow, WhatTouchesHasNoFluidInIt) {
  Coupled box = box_of(0.07);
  const auto obstacle = [](double x0, double x1, double y0, double y1) { return Box<3>{{x0, y0, 0}, {x1, y1, 1}}; };
  box.obstacles = {obstacle(0.1, 0.3, 0, 0.2), obstacle(0.2, 0.6, 0.1, 0.3), obstacle(0.25, 0.35, 0.05, 0.5),
                   obstacle(0.9, 1.2, 0.7, 0.8)};
  const double filled = 0.04 + (0.08 - 0.01) + (0.045 - (0.05 * 0.15 + 0.1 * 0.2 - 0.05 * 0.1)) + 0.01;
  const Mesh body = support::lattice(2, {2, 2, 1}, support::all, [](const Vec<3>& s) {
    return Vec<3>{0.4 + 0.15 * s[0], 0.3 + 0.2 * s[1], 0};
  });
  const Flowing at(box, body);
  double volume = 0;
  for (std::size_t cell = 0; cell < at.mesh().cells(); ++cell) {
    volume += at.mesh().volume[cell];
    const Vec<3> x = at.mesh().middle(cell);
    for (const Box<3>& of : box.obstacles)
      EXPECT_FALSE(x[0] > of.low[0] && x[0] < of.high[0] && x[1] > of.low[1] && x[1] < of.high[1]);
  }
  EXPECT_NEAR(volume, 1 - filled - 0.03, 3e-5);  // but for the film under the body
  EXPECT_EQ(at.flow.regions().count, 1);
}

/// Bodies that touch, lie on a wall or cross one another have a mesh about them, with a film where they only touch.
TEST(MeshFlow, BodiesThatTouchOrCrossHaveAMeshAboutThem) {
  int films = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Values at = support::random_numbers(6, seed);
    const double angle = seed % 4 == 0 ? 0 : 2 * at[3], width = 0.15 + 0.03 * at[2];
    const Vec<3> middle{0.5 + 0.15 * at[0], 0.5 + 0.15 * at[1], 0};
    const Mesh first = support::solid_block(2, 3, middle, width, angle);
    const double reach = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 1 + 0.02 * at[4] : 1 + at[4] * 1e-6;  // of touching
    const Vec<3> other{middle[0] + reach * width * std::cos(angle), middle[1] + reach * width * std::sin(angle), 0};
    const Mesh two = support::together(first, support::solid_block(2, seed % 2 == 0 ? 3 : 2, other, width, angle));
    const Flowing flowing(box_of(0.07), two, {0, -1, 0});
    double volume = 0;
    for (const double of_cell : flowing.mesh().volume) {
      EXPECT_GT(of_cell, 0) << seed;
      volume += of_cell;
    }
    EXPECT_NEAR(volume, 1 - 2 * width * width, 0.025 * width * width) << seed;
    for (std::size_t f = 0; f < flowing.mesh().faces(); ++f)
      EXPECT_EQ(flowing.mesh().is_at_boundary(f), flowing.mesh().boundary[f].kind != BoundaryKind::none);
    if (seed % 3 == 0) ++films;
  }
  EXPECT_GT(films, 60);
}

}  // namespace
}  // namespace tether::coupled
