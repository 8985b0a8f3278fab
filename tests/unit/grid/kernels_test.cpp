// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

// Both kernels on cells of .5 by .25, at random places and at those where a kernel changes its nodes.

namespace tether {
namespace {

const BackgroundGrid kernel_grid(9, 11, -1, 3, 2, 4.5);

struct Spot {
  double x, y;
};

/// Inside by a cell at least, where every kernel finds its nodes.
std::vector<Spot> spots_inside() {
  std::vector<Spot> spots{{0.25, 3}, {0.5, 3}, {0.5, 3.125}, {0, 2.5}, {0.75, 3.375}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-0.49, 2.49), y(2.26, 4.24);
  for (int k = 0; k < 50; ++k) spots.push_back({x(random), y(random)});
  return spots;
}

Pair place_of(std::size_t n) {
  const auto nx = static_cast<std::size_t>(kernel_grid.nx);
  return pair(kernel_grid.x0 + static_cast<double>(n % nx) * kernel_grid.dx,
              kernel_grid.y0 + static_cast<double>(n / nx) * kernel_grid.dy);
}

constexpr double v0[2] = {0.3, -0.7}, by_x[2] = {1.1, -2}, by_y[2] = {0.4, 0.9};

/// A velocity that is linear in space.
Pair linear_velocity(Pair at) {
  return pair(v0[0] + by_x[0] * at[0] + by_y[0] * at[1], v0[1] + by_x[1] * at[0] + by_y[1] * at[1]);
}

/// One that no kernel reproduces.
Pair rough_velocity(std::size_t n) {
  return pair(std::sin(3.0 * static_cast<double>(n)), std::cos(5.0 * static_cast<double>(n)));
}

void expect_pair(Pair found, Pair expected, double tolerance) {
  EXPECT_NEAR(found[0], expected[0], tolerance);
  EXPECT_NEAR(found[1], expected[1], tolerance);
}

template <class Kernel>
class EveryKernel : public testing::Test {
 protected:
  /// Calls visit(spot, place, nodes).
  template <class Visit>
  void each(const Visit& visit) {
    for (const Spot& spot : spots_inside()) {
      const auto at = Kernel::locate(locator_, spot.x, spot.y);
      visit(spot, at, Kernel::nodes(locator_, at));
    }
  }
  std::map<std::size_t, double> values_by_node(double x, double y) {
    const auto at = Kernel::locate(locator_, x, y);
    const auto nodes = Kernel::nodes(locator_, at);
    const auto N = Kernel::values(at);
    std::map<std::size_t, double> of;
    for (std::size_t k = 0; k < Kernel::size; ++k) of[nodes[k]] += N[k];
    return of;
  }
  Locator locator_{kernel_grid};
};

using Kernels = testing::Types<LinearKernel, SplineKernel>;
TYPED_TEST_SUITE(EveryKernel, Kernels);

TYPED_TEST(EveryKernel, ValuesSumToOneAndGradientsToZero) {
  this->each([&](const Spot&, const auto& at, const auto& nodes) {
    double sum = 0;
    for (const double N : TypeParam::values(at)) {
      EXPECT_GE(N, 0);
      sum += N;
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    Pair of_ones{};
    TypeParam::minus_divergence(this->locator_, at, nodes, pair(1, 2), pair(3, 4),
                                [&](std::size_t, Pair f) { of_ones += f; });
    expect_pair(of_ones, pair(0, 0), 1e-14);
    const auto constant = [](std::size_t) { return pair(2, -5); };
    const LinearField grad = TypeParam::gradient(this->locator_, at, nodes, constant);
    expect_pair(grad.by_x, pair(0, 0), 1e-13);
    expect_pair(grad.by_y, pair(0, 0), 1e-13);
  });
}

TYPED_TEST(EveryKernel, NodesAreTheNearestOnesAndAveragedLieAtThePlace) {
  this->each([&](const Spot& spot, const auto& at, const auto& nodes) {
    const auto N = TypeParam::values(at);
    Pair mean{};
    for (std::size_t k = 0; k < TypeParam::size; ++k) {
      ASSERT_LT(nodes[k], kernel_grid.nodes());
      const Pair d = place_of(nodes[k]) - pair(spot.x, spot.y);
      EXPECT_LE(std::abs(d[0]), 1.5 * kernel_grid.dx);
      EXPECT_LE(std::abs(d[1]), 1.5 * kernel_grid.dy);
      mean += N[k] * d;
    }
    expect_pair(mean, pair(0, 0), 1e-12);  // Locator::edge moves a place on a cell's edge by 1e-12 of the cell
  });
}

TYPED_TEST(EveryKernel, LinearFieldsAreReproduced) {
  const auto velocity = [](std::size_t n) { return linear_velocity(place_of(n)); };
  this->each([&](const Spot& spot, const auto& at, const auto& nodes) {
    const Pair there = linear_velocity(pair(spot.x, spot.y));
    expect_pair(TypeParam::value(at, nodes, velocity), there, 1e-11);
    const LinearField grad = TypeParam::gradient(this->locator_, at, nodes, velocity);
    const LinearField affine = TypeParam::affine(this->locator_, at, nodes, velocity);
    expect_pair(affine.v, there, 1e-11);
    for (const LinearField& field : {grad, affine}) {
      expect_pair(field.by_x, pair(by_x[0], by_x[1]), 1e-11);
      expect_pair(field.by_y, pair(by_y[0], by_y[1]), 1e-11);
    }
  });
}

TYPED_TEST(EveryKernel, SpreadGivesNodesTheFieldsValues) {
  const LinearField given{pair(0.2, 0.1), pair(1, -3), pair(-2, 0.5)};
  this->each([&](const Spot& spot, const auto& at, const auto& nodes) {
    const auto N = TypeParam::values(at);
    std::size_t k = 0;
    TypeParam::spread(this->locator_, at, nodes, given, [&](std::size_t n, double weight, Pair v) {
      const Pair d = place_of(n) - pair(spot.x, spot.y);
      EXPECT_EQ(n, nodes[k]);
      EXPECT_EQ(weight, N[k++]);
      expect_pair(v, given.v + d[0] * given.by_x + d[1] * given.by_y, 1e-11);
    });
    EXPECT_EQ(k, TypeParam::size);
  });
}

// -(a G_ix + b G_iy), and sum_i v_i (x) G_ip, with gradients by central differences of the values.
TYPED_TEST(EveryKernel, GradientsAreTheSlopesOfTheValues) {
  const Pair a = pair(0.7, -0.4), b = pair(1.3, 2.1);
  const double e = 1e-6;
  for (const Spot spot : {Spot{0.11, 3.07}, Spot{1.37, 2.71}, Spot{2.18, 3.93}}) {
    const auto at = TypeParam::locate(this->locator_, spot.x, spot.y);
    const auto nodes = TypeParam::nodes(this->locator_, at);
    auto right = this->values_by_node(spot.x + e, spot.y), left = this->values_by_node(spot.x - e, spot.y);
    auto above = this->values_by_node(spot.x, spot.y + e), below = this->values_by_node(spot.x, spot.y - e);
    LinearField expected;
    std::map<std::size_t, Pair> forces;
    for (const std::size_t n : nodes) {
      const double gx = (right[n] - left[n]) / (2 * e), gy = (above[n] - below[n]) / (2 * e);
      forces[n] = -(gx * a + gy * b);
      expected.by_x += gx * rough_velocity(n), expected.by_y += gy * rough_velocity(n);
    }
    TypeParam::minus_divergence(this->locator_, at, nodes, a, b,
                                [&](std::size_t n, Pair f) { expect_pair(f, forces[n], 1e-8); });
    const LinearField grad = TypeParam::gradient(this->locator_, at, nodes, rough_velocity);
    expect_pair(grad.by_x, expected.by_x, 1e-8);
    expect_pair(grad.by_y, expected.by_y, 1e-8);
  }
}

// What the ledger and the angular momentum of APIC build on: sum_i N_i (x_i - x_p)(x_i - x_p) = h^2/4 an axis,
// wherever the point is.
TEST(SplineKernelTest, SecondMomentIsAQuarterOfACellSquared) {
  const Locator locator(kernel_grid);
  for (const Spot& spot : spots_inside()) {
    const auto at = SplineKernel::locate(locator, spot.x, spot.y);
    const auto nodes = SplineKernel::nodes(locator, at);
    const auto N = SplineKernel::values(at);
    Pair squares{};
    double mixed = 0;
    for (std::size_t k = 0; k < SplineKernel::size; ++k) {
      const Pair d = place_of(nodes[k]) - pair(spot.x, spot.y);
      squares += N[k] * d * d;
      mixed += N[k] * d[0] * d[1];
    }
    expect_pair(squares, pair(kernel_grid.dx * kernel_grid.dx / 4, kernel_grid.dy * kernel_grid.dy / 4), 1e-15);
    EXPECT_NEAR(mixed, 0, 1e-15);
  }
}

// Of a field that is not linear APIC keeps C = 4/h^2 sum N v (x_i - x_p), which is no gradient.
TEST(SplineKernelTest, AffineFieldIsTheFirstMomentOverTheSecond) {
  const Locator locator(kernel_grid);
  for (const Spot& spot : spots_inside()) {
    const auto at = SplineKernel::locate(locator, spot.x, spot.y);
    const auto nodes = SplineKernel::nodes(locator, at);
    const auto N = SplineKernel::values(at);
    LinearField expected;
    for (std::size_t k = 0; k < SplineKernel::size; ++k) {
      const Pair d = place_of(nodes[k]) - pair(spot.x, spot.y), v = N[k] * rough_velocity(nodes[k]);
      expected.v += v;
      expected.by_x += 4 / (kernel_grid.dx * kernel_grid.dx) * d[0] * v,
          expected.by_y += 4 / (kernel_grid.dy * kernel_grid.dy) * d[1] * v;
    }
    const LinearField affine = SplineKernel::affine(locator, at, nodes, rough_velocity);
    expect_pair(affine.v, expected.v, 1e-14);
    expect_pair(affine.by_x, expected.by_x, 1e-13);
    expect_pair(affine.by_y, expected.by_y, 1e-13);
  }
}

}  // namespace
}  // namespace tether
