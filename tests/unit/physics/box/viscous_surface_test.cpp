// SPDX-License-Identifier: GPL-3.0-or-later
// Friction in a liquid with a surface, which is free of stress there.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/box/friction/viscosity.hpp"
#include "physics/box/liquid/parts.hpp"
#include "physics/box/solver.hpp"
#include "unit/alone.hpp"
#include "unit/full_length.hpp"
#include "unit/physics/box/plan_support.hpp"
#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using Place = std::array<double, 3>;

/// Liquid of density 1 where a distance is below 0, in a box of side 1.
class Liquid {
 public:
  template <class Distance>
  Liquid(int dim, int n, const Distance& distance) : domain_(box(unit_box(dim, n))) {
    std::vector<double> cells;
    for (std::size_t c = 0; c < domain_.grid.cell_count(); ++c)
      cells.push_back(n * distance(domain_.grid.middle(domain_.grid.place_of_cell(c))));
    parts = liquid::liquid_parts(domain_.grid, cells);
    v = face_values(domain_.grid);
  }

  Rubbed rub(double nu, double h, const FaceValues& driven = {}) {
    const RubbingFluid fluid{domain_, 1, nu, parts, Beyond::nothing, nullptr};
    return Friction(fluid, {}, h).act(alone(), {}, {}, 1e-13, driven, v);
  }
  /// Of the halves of the cells about it, as friction counts it.
  double mass(int axis, std::size_t f) const {
    return part_of_face(parts, domain_.grid, axis, domain_.grid.place_of_face(axis, f)) * domain_.volume[at(axis)][f];
  }
  template <class Function>
  double sum(const Function& f) const {
    double all = 0;
    for (int axis = 0; axis < domain_.grid.dim; ++axis) {
      for (std::size_t face = 0; face < v[at(axis)].size(); ++face)
        all += mass(axis, face) * f(axis, middle_of_face(domain_.grid, axis, face), v[at(axis)][face]);
    }
    return all;
  }
  const FlowDomain& domain() const { return domain_; }

  CellParts parts;
  FaceValues v;

 private:
  FlowDomain domain_;
};

double ball(const Vec<3>& x) { return std::hypot(x[0] - 0.52, x[1] - 0.47, x[2] == 0 ? 0 : x[2] - 0.5) - 0.31; }

TEST(ViscousDrop, TurnsAndFliesAsItDid) {
  for (const int dim : {2, 3}) {
    Liquid drop(dim, 16, ball);
    const FaceValues start = faces_of(drop.domain().grid, [](const Place& x) {
      return Place{2 - 3 * x[1], 1 + 3 * x[0] - 0.7 * x[2], 0.7 * x[1]};
    });
    drop.v = start;
    drop.rub(1, 1);
    for (int axis = 0; axis < dim; ++axis) {
      for (std::size_t f = 0; f < start[at(axis)].size(); ++f) {
        if (drop.mass(axis, f) > 0) {
          EXPECT_NEAR(drop.v[at(axis)][f], start[at(axis)][f], 1e-11);
        }
      }
    }
  }
}

TEST(ViscousDrop, KeepsMomentumAndBecomesRigidHoweverLongTheStep) {
  Liquid drop(2, 16, ball);
  const FaceValues start = faces_of(drop.domain().grid, [](const Place& x) {
    return Place{std::sin(9 * x[0] + 5 * x[1]), std::cos(7 * x[0] * x[1]) + x[0], 0};
  });
  const auto along_x = [](int axis, const Place&, double v) { return axis == 0 ? v : 0; };
  const auto turning = [](int axis, const Place& x, double v) { return axis == 0 ? -x[1] * v : x[0] * v; };
  const auto energy = [](int, const Place&, double v) { return 0.5 * v * v; };
  for (const double nu : {1e-2, 1.0, 1e3}) {
    drop.v = start;
    const double momentum = drop.sum(along_x), turn = drop.sum(turning), before = drop.sum(energy);
    const Rubbed rubbed = drop.rub(nu, 0.1);
    EXPECT_NEAR(drop.sum(along_x), momentum, 1e-7);
    EXPECT_NEAR(drop.sum(turning), turn, 1e-7);
    EXPECT_NEAR(before - drop.sum(energy), rubbed.taken, 1e-7);
    EXPECT_GT(rubbed.taken, 0);
    if (nu < 1e3) continue;
    const FaceValues rigid = drop.v;
    drop.rub(nu, 0.1);
    EXPECT_NEAR(drop.sum([&](int, const Place&, double v) { return v * v; }), 2 * (before - rubbed.taken), 1e-6);
  }
}

/// The exact speed at a height in a layer of this depth that has flowed for some time, from rest, under a pull along
/// it.
double speed_of_layer(double y, double depth, double nu, double pull, double time) {
  using std::numbers::pi;
  double speed = pull / nu * (depth * y - 0.5 * y * y);
  for (int k = 1; k < 40; k += 2) {
    const double wave = k * pi / (2 * depth);
    speed -= 2 * pull / (nu * depth * std::pow(wave, 3)) * std::exp(-nu * wave * wave * time) * std::sin(wave * y);
  }
  return speed;
}

const std::vector<double>& values_of(const Snapshot& grid, const char* name) {
  return std::find_if(grid.fields.begin(), grid.fields.end(),
                      [&](const Field& field) { return field.quantity.name == name; })
      ->values;
}

/// The largest error of the speed in the middle of a layer that begins to flow under gravity along it, over that which
/// its surface comes to: u = pull / nu (H y - y^2/2) less what decays, at the time H^2 / (2 nu). The layer is so long
/// that its ends have no part in it by then.
double error_of_layer(int cells, double depth, int steps) {
  const double nu = 0.5, pull = 0.2, time = depth * depth / (2 * nu);
  const std::string deck = fmt::format(
      "$in nx={}, ny={}, xleft=0., xright=6., ybot=0., ytop=.5, tstep={:.17g}, tmax={:.17g}, gravc=-1. $\n"
      "$coupled density=1., liquid=.true., liquid_below(1)='{:.17g}', viscosity={}, gravity_x={} $\n",
      6 * cells + 1, cells / 2 + 1, time / steps, time, depth, nu, pull);
  const Plan plan = plan_of(deck);
  CoupledSolver solver(plan);
  solver.advance(time);
  const Snapshot grid = solver.grid();
  const std::vector<double>& v = values_of(grid, "vx");
  double error = 0;
  for (int j = 0; (j + 0.5) / cells < depth; ++j) {
    const double y = (j + 0.5) / cells;
    const double exact = speed_of_layer(y, depth, nu, pull, time);
    error = std::max(error, std::abs(v[at(j * 6 * cells + 3 * cells)] - exact));
  }
  return error / (pull / nu * depth * depth / 2);
}

/// Depths that end at a face, in a lower and in an upper half of a cell.
TEST(ViscousLayer, BeginsToFlowToSecondOrderInTheCells) {
  for (const double depth : {0.25, 0.25 + 0.3 / 16, 0.25 + 0.8 / 16}) {
    const double coarse = error_of_layer(16, depth, 32), finest = error_of_layer(32, depth, 128);
    EXPECT_LT(coarse, 0.03) << depth;
    EXPECT_GT(std::log2(coarse / finest), 1.7) << depth;
  }
}

/// A film on a plane at 30 degrees that cuts the cells, when it has all but come to Nusselt's profile: the mean speed
/// of its cells in the middle over the exact one.
double speed_of_film(int cells_deep, double nu) {
  const double cell = 1. / 128, depth = cells_deep * cell, time = 4 * depth * depth / nu;
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  const auto place = [&](double a, double b) { return fmt::format("{}, {}", a * c - b * s, 0.1 + a * s + b * c); };
  const std::string deck = fmt::format(
      "$in nx=161, ny=116, xleft=0., xright=1.25, ybot=0., ytop={}, tstep={}, tmax={}, gravc=-1. $\n"
      "$coupled density=1., liquid=.true., viscosity={}, obstacle_plane(1,1)=0., .1, {}, {}, liquid_polygon(1,1)={}, "
      "{}, "
      "{}, {} $\n",
      115 * cell, time / 32, time, nu, -s, c, place(0.05, -0.02), place(1.3, -0.02), place(1.3, depth),
      place(0.05, depth));
  const Plan plan = plan_of(deck);
  CoupledSolver solver(plan);
  solver.advance(time);
  const Snapshot grid = solver.grid();
  const std::vector<double>&vx = values_of(grid, "vx"), &vy = values_of(grid, "vy"), &kind = values_of(grid, "kind");
  double found = 0, exact = 0;
  for (std::size_t k = 0; k < vx.size(); ++k) {
    const double x = (static_cast<double>(k % 160) + 0.5) * cell, y = (static_cast<double>(k / 160) + 0.5) * cell - 0.1;
    const double a = x * c + y * s, b = y * c - x * s;
    if (kind[k] != 0 || a < 0.4 || a > 0.8 || b < 0) continue;
    found -= vx[k] * c + vy[k] * s;
    exact += speed_of_layer(b, depth, nu, s, time);
  }
  return found / exact;
}

TEST(ViscousFilm, ComesToNusseltsProfileOnASlope) {
  EXPECT_NEAR(speed_of_film(4, 0.05), 1, 0.05);
  std::vector<double> viscosities{1e3};
  if (test::at_full_length()) viscosities.push_back(0.05);
  for (const double nu : viscosities) EXPECT_NEAR(speed_of_film(8, nu), 1, 0.03);
}

}  // namespace
}  // namespace tether::coupled
