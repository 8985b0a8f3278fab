// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "physics/box/liquid/exits.hpp"
#include "physics/box/liquid/move.hpp"
#include "physics/box/liquid/near_solids.hpp"
#include "physics/box/liquid/seed.hpp"
#include "physics/box/liquid/sums.hpp"
#include "physics/box/liquid/surface.hpp"
#include "physics/box/liquid/transfer.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::liquid {
namespace {

using coupled::FaceValues;
using coupled::FlowBox;
using coupled::Placer;
using coupled::Room;
using coupled::support::fluid_in_box;
using tether::at;

Coupled scene_of(int dim, int cells) {
  Coupled scene = fluid_in_box(dim, cells);
  scene.liquid.emplace();
  scene.liquid->per_axis = dim == 2 ? 3 : 2;
  return scene;
}

/// So many particles anywhere in the box, of volumes that differ.
Particles anywhere(const StaggeredGrid& grid, std::size_t count, double margin) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  Particles particles;
  for (std::size_t k = 0; k < count; ++k) {
    Vec<3> x{}, v{};
    for (std::size_t a = 0; a < at(grid.dim); ++a) {
      const double low = grid.low[a] + margin, high = grid.high(static_cast<int>(a)) - margin;
      x[a] = low + part(random) * (high - low), v[a] = part(random) - 0.5;
    }
    particles.add(grid.dim, x, v, 0.5 + part(random));
    for (std::size_t a = 0; a < at(grid.dim); ++a) {
      for (std::size_t b = 0; b < at(grid.dim); ++b) particles.slope[a][b].back() = part(random) - 0.5;
    }
  }
  return particles;
}

class Liquids : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(InPlaneAndSpace, Liquids, testing::Values(2, 3));

/// A field that is linear in place goes from particles to faces and back as it is.
TEST_P(Liquids, LinearVelocitiesStay) {
  const int dim = GetParam();
  const StaggeredGrid grid = scene_of(dim, 6).grid;
  Particles particles = anywhere(grid, 3000, 0);
  const auto field = [&](std::size_t a, const Vec<3>& x) {
    return 0.3 + double(a) + 2 * x[0] - (1 + double(a)) * x[1] + 0.5 * x[2];
  };
  for (std::size_t k = 0; k < particles.size(); ++k) {
    for (std::size_t a = 0; a < at(dim); ++a) {
      particles.v[a][k] = field(a, place_of(particles, dim, k));
      for (std::size_t b = 0; b < at(dim); ++b) particles.slope[a][b][k] = b == 0 ? 2 : b == 1 ? -(1 + double(a)) : 0.5;
    }
  }
  const CellParticles cells = sort_by_cells(alone(), grid, particles);
  FaceValues v;
  to_faces(alone(), grid, particles, cells, v);
  Particles back = particles;
  from_faces(alone(), grid, v, {}, back);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const auto cell = cell_of(grid, place_of(particles, dim, k));
    for (std::size_t a = 0; a < at(dim); ++a) {
      bool inner = true;  // faces half a cell beyond the box are not there
      for (std::size_t b = 0; b < at(dim); ++b) inner = inner && cell[b] > 0 && cell[b] < grid.n[b] - 1;
      if (!inner) continue;
      EXPECT_NEAR(back.v[a][k], particles.v[a][k], 1e-12);
      for (std::size_t b = 0; b < at(dim); ++b) EXPECT_NEAR(back.slope[a][b][k], particles.slope[a][b][k], 1e-11);
    }
  }
}

/// Faces get the particles' momentum, and particles that move with their faces keep it.
TEST_P(Liquids, MomentumIsKept) {
  const int dim = GetParam();
  const StaggeredGrid grid = scene_of(dim, 8).grid;
  Particles particles = anywhere(grid, 500, 1.5 * grid.d[0]);
  const CellParticles cells = sort_by_cells(alone(), grid, particles);
  FaceValues v;
  const FaceValues volume = to_faces(alone(), grid, particles, cells, v);
  Particles back = particles;
  from_faces(alone(), grid, v, {}, back);
  for (std::size_t a = 0; a < at(dim); ++a) {
    double before = 0, on_faces = 0, after = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      before += particles.volume[k] * particles.v[a][k], after += back.volume[k] * back.v[a][k];
    }
    for (std::size_t f = 0; f < v[a].size(); ++f) on_faces += volume[a][f] * v[a][f];
    EXPECT_NEAR(on_faces, before, 1e-11);
    EXPECT_NEAR(after, before, 1e-11);
  }
}

/// Sorted particles are the same ones, each in its cell, whatever the number of threads.
TEST_P(Liquids, SortingKeepsAll) {
  const int dim = GetParam();
  const StaggeredGrid grid = scene_of(dim, 5).grid;
  Particles particles = anywhere(grid, 700, 0), sorted = particles;
  const CellParticles cells = sort_by_cells(alone(), grid, sorted);
  double sum = 0;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    for (std::size_t k = cells.first[c]; k < cells.first[c + 1]; ++k) {
      EXPECT_EQ(grid.cell(cell_of(grid, place_of(sorted, dim, k))), c);
      sum += sorted.volume[k] * sorted.x[0][k] * sorted.v[1][k];
    }
  }
  double before = 0;
  for (std::size_t k = 0; k < particles.size(); ++k)
    before += particles.volume[k] * particles.x[0][k] * particles.v[1][k];
  EXPECT_NEAR(sum, before, 1e-10);
  EXPECT_EQ(cells.first.back(), particles.size());
}

/// The scene's room with figures as obstacles, and where these are.
struct WithObstacles {
  explicit WithObstacles(const Coupled& of)
      : scene(of),
        none{.dim = of.grid.dim, .sides = {}, .sheet = {}, .cavity = {}, .part = {}, .whole_sides = {}, .parting = {}},
        whole(of, none, 0) {
    const FlowBox box(of);
    const coupled::Outside outside(of, {});
    room = Placer(of, none, 0, box, outside, alone()).room_at({});
  }
  NearSolids solids() const { return {whole.surface(), room.places, scene.grid, room.crossings}; }

  const Coupled& scene;
  SolidSurface none;  // of bodies
  coupled::WholeSurface whole;
  Room room;
};

/// What a wall leaves of a hat, against sums over many places.
TEST_P(Liquids, OpenPartsOfHats) {
  const int dim = GetParam();
  Coupled scene = scene_of(dim, 4);
  const double n = std::sqrt(dim == 2 ? 0.8 : 1.0);
  const HalfSpace wall{{0.4, 0.3, 0.5}, {-0.4 / n, 0.8 / n, dim == 2 ? 0 : 0.4472135954999579 / n}};
  scene.shaped.push_back({wall, 1});
  const WithObstacles with(scene);
  const Room& room = with.room;
  const std::vector<double> open = open_parts(room.domain, room.all_pieces());
  const StaggeredGrid& grid = scene.grid;
  constexpr int samples = 40;
  for (std::size_t c = 0; c < open.size(); ++c) {
    const Vec<3> middle = grid.middle(grid.place_of_cell(c));
    double sum = 0, weights = 0;
    std::array<int, 3> i{};
    for (i[2] = 0; i[2] < (dim == 3 ? samples : 1); ++i[2]) {
      for (i[1] = 0; i[1] < samples; ++i[1]) {
        for (i[0] = 0; i[0] < samples; ++i[0]) {
          Vec<3> x = middle;
          double weight = 1;
          for (std::size_t a = 0; a < at(dim); ++a) {
            const double s = 2 * (i[a] + 0.5) / samples - 1;
            weight *= 1 - std::abs(s), x[a] += s * grid.d[a];
            if (x[a] < grid.low[a]) x[a] = 2 * grid.low[a] - x[a];  // the walls of the box mirror
            const double high = grid.high(static_cast<int>(a));
            if (x[a] > high) x[a] = 2 * high - x[a];
          }
          weights += weight, sum += contains(wall, x) ? 0 : weight;
        }
      }
    }
    EXPECT_NEAR(open[c], sum / weights, 3e-3) << c;
  }
}

/// A level surface is found where it is, at any height, and moves the liquid up to it.
TEST_P(Liquids, LevelSurfaces) {
  const int dim = GetParam();
  for (const double height : {0.31, 0.5, 0.583, 0.7499}) {
    Coupled scene = scene_of(dim, 12);
    scene.liquid->regions.push_back({Figure(Box<3>{{0, 0, 0}, {1, height, 1}}), {}, 1});
    const WithObstacles with(scene);
    const Room& room = with.room;
    Particles particles = seed(scene, room.domain, with.solids());
    const CellParticles cells = sort_by_cells(alone(), scene.grid, particles);
    const Surface surface{room.domain, room.open,
                          surface_distances(scene.grid, filling(alone(), scene.grid, particles, cells), room.open)};
    LiquidSums sums = sums_of(particles, dim, 1, {});
    add_surface(surface, sums);
    EXPECT_NEAR(sums.volume, height, 3e-3 / 12);
    EXPECT_NEAR(sums.enclosed, height, 0.03 / 12) << height;
    EXPECT_NEAR(sums.area, 1, 1e-6);
    const coupled::FlowDomain liquid = liquid_in(room.domain, surface.distance, Air::empty);
    double moved = 0;  // by the faces across y
    for (std::size_t f = 0; f < liquid.face[1].size(); ++f)
      moved += liquid.face[1][f] == coupled::FaceKind::open ? liquid.volume[1][f] : 0;
    EXPECT_NEAR(moved, height - 0.5 / 12, 0.03 / 12) << height;  // those in the bottom's wall move none
  }
}

/// Regions have their true volumes, whatever cuts them.
TEST_P(Liquids, SeedsHaveTheTrueVolume) {
  const int dim = GetParam();
  Coupled scene = scene_of(dim, 16);
  const Ellipsoid ball{{0.5, 0.5, dim == 3 ? 0.5 : 0}, {0.3, 0.3, dim == 3 ? 0.3 : 0}};
  scene.liquid->regions.push_back({Figure(ball), {1, 2, 3}, 1});
  scene.shaped.push_back({HalfSpace{{0.5, 0.5, 0.5}, {0.6, 0.8, 0}}, 1});
  const WithObstacles with(scene);
  const Room& room = with.room;
  const NearSolids solids = with.solids();
  const Particles particles = seed(scene, room.domain, solids);
  const LiquidSums sums = sums_of(particles, dim, 1, {});
  const double half = dim == 2 ? std::numbers::pi * 0.09 / 2 : 2 * std::numbers::pi * 0.027 / 3;
  EXPECT_NEAR(sums.volume / half, 1, 1e-3);
  EXPECT_EQ(sums.velocity[1], 2);
  const double off = dim == 2 ? 4 * 0.3 / (3 * std::numbers::pi) : 3 * 0.3 / 8;
  EXPECT_NEAR(sums.middle[0], 0.5 + 0.6 * off, 1e-3);
  EXPECT_NEAR(sums.middle[1], 0.5 + 0.8 * off, 1e-3);
}

/// What is in a solid comes out by the nearest way, without the speed that took it there.
TEST_P(Liquids, NothingStaysInSolids) {
  const int dim = GetParam();
  Coupled scene = scene_of(dim, 8);
  const Ellipsoid ball{{0.5, 0.5, dim == 3 ? 0.5 : 0}, {0.31, 0.31, dim == 3 ? 0.31 : 0}};
  scene.shaped.push_back({ball, 1});
  const WithObstacles with(scene);
  const NearSolids solids = with.solids();
  Particles particles = anywhere(scene.grid, 2000, 0);
  std::size_t inside = 0;
  const auto radius = [&](std::size_t k) {
    const Vec<3> to = minus(place_of(particles, dim, k), ball.middle);
    return std::sqrt(dot(to, to));
  };
  Particles before = particles;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const double r = radius(k);
    if (std::abs(r - 0.31) > 1e-3) {
      EXPECT_EQ(solids.hold(place_of(particles, dim, k)), r < 0.31) << r;
    }
    inside += r < 0.309 && r > 0.2 ? 1 : 0;
  }
  EXPECT_GT(inside, 100);
  put_out_of_solids(alone(), scene.grid, solids, {}, particles);
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Vec<3> to = minus(place_of(before, dim, k), ball.middle);
    const double r = std::sqrt(dot(to, to));
    if (r < 0.2) continue;  // no side is near
    EXPECT_GT(radius(k), 0.3095);
    double outwards = 0;
    for (std::size_t a = 0; a < at(dim); ++a) outwards += particles.v[a][k] * to[a] / r;
    if (r < 0.309) {
      EXPECT_GT(outwards, -0.05) << r;
    }
  }
}

}  // namespace
}  // namespace tether::liquid
