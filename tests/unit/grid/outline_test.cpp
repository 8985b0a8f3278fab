// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tether {
namespace {

/// The same without rows: every piece is asked.
bool is_inside(const std::vector<Vec<2>>& outline, const Vec<2>& at) {
  bool inside = false;
  for (std::size_t k = 0, before = outline.size() - 1; k < outline.size(); before = k++) {
    const Vec<2>&a = outline[before], &b = outline[k];
    if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside;
}

TEST(Outline, HoldsWhatIsInsideASquare) {
  const Outline square({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  EXPECT_TRUE(square.holds({1, 0.5}));
  for (const Vec<2>& at : {Vec<2>{3, 0.5}, {-1, 0.5}, {1, 1.5}, {1, -0.5}}) EXPECT_FALSE(square.holds(at));
  EXPECT_FALSE(square.holds({1, std::numeric_limits<double>::quiet_NaN()}));
}

// Of outlines that cross themselves, too, at places that are as high as corners, and where one corner is far away.
TEST(Outline, DecidesAsIfEveryPieceWereAsked) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const std::size_t corners : {2U, 3U, 7U, 40U, 500U}) {
    std::vector<Vec<2>> outline;
    for (std::size_t k = 0; k < corners; ++k) {
      const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(corners);
      outline.push_back({std::cos(angle) + 0.2 * any(random), std::sin(angle) + 0.2 * any(random)});
    }
    outline.back()[1] = -50;
    const Outline rows(outline);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
      Vec<2> at{1.3 * any(random), 1.3 * any(random)};
      if (k % 3 == 0) at[1] = outline[static_cast<std::size_t>(k) % corners][1];
      EXPECT_EQ(rows.holds(at), is_inside(outline, at));
      inside += rows.holds(at);
    }
    EXPECT_TRUE(corners < 3 || inside > 0);
  }
}

TEST(Outline, MayBeFlat) {
  const Outline flat({{0, 1}, {1, 1}, {2, 1}});
  EXPECT_FALSE(flat.holds({1, 1}));
}

}  // namespace
}  // namespace tether
