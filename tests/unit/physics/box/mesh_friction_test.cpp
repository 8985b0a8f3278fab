// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "unit/physics/box/mesh_support.hpp"

// Friction of a fluid on triangles and tetrahedra.

namespace tether::coupled {
namespace {

using std::numbers::pi;
using support::Flowing, support::box_of;

/// How far the rate at which a vortex between sides that slip decays is from 4 pi^2 nu, of it.
double error_of_decay(int dim, double size, int steps) {
  Coupled box = box_of(size, dim);
  box.viscosity = 0.02;
  box.sides.fill(BoxSide::slip);
  Flowing at(box, {});
  at.set([](const Vec<3>& x) {
    return Vec<3>{std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1]), 0};
  });
  at.project();
  const double before = at.energy(), time = 0.5, h = time / steps;
  at.flow.begin_friction(at.state, {}, h);
  for (int k = 0; k < steps; ++k) {
    at.flow.add_friction(at.state, h, 1e-10, {});
    at.project();
  }
  return std::log(before / at.energy()) / time / (4 * pi * pi * box.viscosity) - 1;
}

TEST(MeshFriction, AVortexDecaysToSecondOrder) {
  const double coarse = std::abs(error_of_decay(2, 0.1, 25)), fine = std::abs(error_of_decay(2, 0.05, 100));
  EXPECT_LT(fine, 0.002);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

TEST(MeshFriction, AVortexDecaysInSpace) { EXPECT_LT(std::abs(error_of_decay(3, 0.2, 10)), 0.05); }

/// A fluid about a body that is free, in a box whose sides do not hold it.
struct Held {
  Coupled scene;
  Mesh body;
  Flowing at;
  FaceHolds holds;

  explicit Held(int dim)
      : scene(box_of(dim == 2 ? 0.1 : 0.25, dim)),
        body(support::hollow_block(dim, 2, {0.52, 0.47, dim == 3 ? 0.5 : 0.0}, 0.4, 0.3)),
        at(scene, body) {
    for (std::size_t f = 0; f < at.mesh().faces(); ++f) {
      const bool carried = at.mesh().boundary[f].kind == BoundaryKind::solid;
      holds.held.insert(holds.held.end(), static_cast<std::size_t>(dim), carried ? 1 : 0);
      if (!carried) continue;
      const auto side = static_cast<std::size_t>(at.mesh().boundary[f].number);
      holds.carried.push_back({f, node_shares(at.surface, side, body.x, at.mesh().middle_of_face(f))});
    }
  }
};

/// Nodes of a mass that nothing holds.
NodeInertia alike(std::size_t numbers, double mass) {
  return loose_nodes(std::vector<double>(numbers, mass), std::vector<std::uint8_t>(numbers, 0));
}

/// Fluid and nodes keep their momentum, and lose as much energy as becomes heat, and more in a step.
TEST(MeshFriction, KeepsMomentum) {
  for (const int dim : {2, 3}) {
    Held of(dim);
    const FlowMesh& mesh = of.at.mesh();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<double> u(of.body.x.size());
    for (double& velocity : u) velocity = any(random);
    FaceValues v, none;
    for (std::size_t a = 0; a < at(dim); ++a) {
      for (std::size_t cell = 0; cell < mesh.cells(); ++cell) v[a].push_back(any(random)), none[a].push_back(0);
    }
    const double rho = of.scene.density;
    FrictionOnMesh friction(mesh, of.holds, {}, rho, 0.3, alike(u.size(), 1.0 / 40), 0.1);
    const FaceValues v0 = v;
    const std::vector<double> given(mesh.faces() * at(dim), 0.0), undriven(u.size(), 0.0);
    const Rubbed rubbed = friction.act(alone(), u, undriven, 1e-13, given, none, v);
    ASSERT_GT(rubbed.iterations, 0);
    double lost = 0;
    for (std::size_t a = 0; a < at(dim); ++a) {
      double sum = 0, size = 0;
      for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
        sum += rho * mesh.volume[cell] * (v[a][cell] - v0[a][cell]);
        size += rho * mesh.volume[cell];
        lost += 0.5 * rho * mesh.volume[cell] * (v0[a][cell] * v0[a][cell] - v[a][cell] * v[a][cell]);
      }
      for (std::size_t k = a; k < u.size(); k += at(dim)) sum += rubbed.impulse[k];
      EXPECT_NEAR(sum, 0, 1e-11 * size);
    }
    EXPECT_NEAR(lost, rubbed.taken, 1e-12 * lost);
    for (std::size_t k = 0; k < u.size(); ++k)
      lost += (u[k] * u[k] - std::pow(u[k] + 40 * rubbed.impulse[k], 2)) / (2 * 40.0);
    EXPECT_GT(rubbed.heat, 0.01 * lost);
    EXPECT_LT(rubbed.heat, lost);
  }
}

/// Nodes of a body that is all but rigid go along as one: K ties each of them to all others along its axis.
TEST(MeshFriction, MovesAStiffBodyAsAWhole) {
  for (const int dim : {2, 3}) {
    Held of(dim);
    const FlowMesh& mesh = of.at.mesh();
    const std::size_t n = of.body.x.size();
    constexpr double mass = 0.02, stiff = 1e4;
    NodeInertia nodes{.mass = {}, .held = std::vector<std::uint8_t>(n, 0)};
    nodes.mass.n = static_cast<std::int64_t>(n);
    nodes.mass.start.push_back(0);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = k % at(dim); l < n; l += at(dim)) {
        nodes.mass.row.push_back(static_cast<std::int64_t>(l));
        nodes.mass.value.push_back(l == k ? mass + stiff * static_cast<double>(n / at(dim) - 1) : -stiff);
      }
      nodes.mass.start.push_back(static_cast<std::int64_t>(nodes.mass.row.size()));
    }
    for (const double of_one : masses_as_one(nodes, dim)) EXPECT_NEAR(of_one, mass, 1e-12 * stiff);
    FaceValues v, none;
    for (std::size_t a = 0; a < at(dim); ++a) {
      for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
        v[a].push_back(mesh.middle(cell)[1] + (a == 1 ? 0.3 : 0)), none[a].push_back(0);
      }
    }
    const std::vector<double> still(n, 0.0), given(mesh.faces() * at(dim), 0.0);
    FrictionOnMesh friction(mesh, of.holds, {}, of.scene.density, 0.3, nodes, 0.1);
    const Rubbed rubbed = friction.act(alone(), still, still, 1e-13, given, none, v);
    ASSERT_GT(rubbed.iterations, 0);
    for (std::size_t a = 0; a < at(dim); ++a) {
      double impulse = 0;
      for (std::size_t k = a; k < n; k += at(dim)) impulse += rubbed.impulse[k];
      const double velocity = impulse / (mass * static_cast<double>(n / at(dim)));
      EXPECT_GT(std::abs(velocity), 0.01);
      for (std::size_t k = a; k < n; k += at(dim)) EXPECT_NEAR(rubbed.nodes[k], velocity, 1e-5);
    }
  }
}

/// A fluid that turns with a body as a whole has no friction.
TEST(MeshFriction, TurningAsAWholeCostsNothing) {
  for (const int dim : {2, 3}) {
    Held of(dim);
    const FlowMesh& mesh = of.at.mesh();
    const auto turning = [](const Vec<3>& x) { return Vec<3>{0.3 - 2 * x[1], 2 * x[0], 0.1}; };
    std::vector<double> u, x;
    for (std::size_t n = 0; n < of.body.x.size(); n += at(dim)) {
      const Vec<3> w = turning({of.body.x[n], of.body.x[n + 1], 0});
      u.insert(u.end(), w.begin(), w.begin() + dim);
    }
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
      const Vec<3> w = turning(mesh.middle_of_face(f));
      x.insert(x.end(), w.begin(), w.begin() + dim);
    }
    const StrainOnMesh strain(mesh, 1, 1, {});
    FaceValues v, none;
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
      const Vec<3> w = strain.velocity(cell, x);
      for (std::size_t a = 0; a < at(dim); ++a) v[a].push_back(w[a]), none[a].push_back(0);
    }
    const FaceValues v0 = v;
    FrictionOnMesh friction(mesh, of.holds, {}, 1, 50, alike(u.size(), 0.1), 0.1);
    const Rubbed rubbed =
        friction.act(alone(), u, std::vector<double>(u.size(), 0), 1e-13, std::vector<double>(x.size(), 0.0), none, v);
    EXPECT_LT(std::abs(rubbed.heat), 1e-9);
    for (std::size_t a = 0; a < at(dim); ++a) {
      for (std::size_t cell = 0; cell < mesh.cells(); ++cell) EXPECT_NEAR(v[a][cell], v0[a][cell], 1e-9);
    }
  }
}

}  // namespace
}  // namespace tether::coupled
