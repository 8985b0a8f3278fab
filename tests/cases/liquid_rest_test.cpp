// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/liquid_support.hpp"
#include "cases/run_deck.hpp"

// Liquids with a surface that are at rest. Density and gravity are 1.

namespace tether::cases {
namespace {

/// Water in a box of which a wall at 30 degrees cuts off a corner.
DeckRun still(int cells, const std::string& more) {
  return run_text("still", box(cells, cells, 1.0 / cells, 0.5 / cells, 5) +
                               liquid("liquid_below(1)='.613', obstacle_plane(1,1)=.6,.1,-.5,.866025403784," + more));
}

double fastest(const DeckRun& run, std::size_t from = 0) {
  const auto cfl = run.history.column("cfl");  // half a cell is gone at a speed of 1
  return 2 * *std::max_element(cfl.begin() + static_cast<std::ptrdiff_t>(from), cfl.end());
}

TEST(LiquidAtRest, StaysAtRest) {
  for (const char* mode : {"mode='cut-cell'", "mode='symmetric'"}) {
    const DeckRun run = still(32, mode);
    EXPECT_LT(fastest(run), 1e-3 * std::sqrt(0.613)) << mode;
    EXPECT_NEAR(run.first("liquid_volume"), 0.51815, 1e-4);
    EXPECT_EQ(run.first("liquid_particles"), run.last("liquid_particles"));
    EXPECT_NEAR(run.last("fluid_volume") / run.first("fluid_volume"), 1, 2e-3) << mode;
  }
  const DeckRun jittered = still(32, "liquid_jitter=1., liquid_particles=4");
  EXPECT_LT(fastest(jittered), 0.05);
  EXPECT_LT(fastest(jittered, jittered.history.column("cfl").size() - 10), 0.005);
}

/// Beaches that the surface meets, an ellipse awash and a block that is held half under water: all at rest, and the
/// block is lifted by what it displaces.
TEST(LiquidAtRest, StaysAtRestWhereTheSurfaceMeetsSolids) {
  const auto of = [](const std::string& more, const std::string& bodies = "") {
    return run_text("shore", box(32, 32, 1.0 / 32, 0.03, 6) + bodies + liquid("liquid_below(1)='.613'," + more));
  };
  for (const char* beach : {"-.258819045,.965925826", "-.5,.866025404", "-.965925826,.258819045"}) {
    const DeckRun run = of(std::string("obstacle_plane(1,1)=.437,.55,") + beach);
    const auto kinetic = run.history.column("energy_kinetic");
    EXPECT_LT(*std::max_element(kinetic.begin(), kinetic.end()), 1e-5) << beach;
  }
  const DeckRun awash = of("obstacle_ellipse(1,1)=.3,.7,.35,.65");
  const auto kinetic = awash.history.column("energy_kinetic");
  EXPECT_LT(*std::max_element(kinetic.begin(), kinetic.end()), 1e-5);
  const DeckRun block =
      of("",
         "$reg nreg=1, nvi=4, densir(1)=2., xvi(1,1)=.397,.609,.543,.331, yvi(1,1)=.467,.556,.713,.624, "
         "matr(1,1)=1e5,.3 $\n$mesh cells(1,1)=4,4, side(1,1)='s','s','s','s' $\n"
         "$fem fix_on(1)='s', fix(1:2,1)=0.,0. $\n");
  const auto lift = block.history.column("body_force_y_1");
  // What is below .613 of the quadrilateral.
  const auto shoelace = [](const std::vector<std::pair<double, double>>& x) {
    double twice = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto& [a, b] = x[k];
      const auto& [c, d] = x[(k + 1) % x.size()];
      twice += a * d - b * c;
    }
    return 0.5 * twice;
  };
  const double right = 0.609 - (0.613 - 0.556) / (0.713 - 0.556) * (0.609 - 0.543),
               left = 0.331 + (0.624 - 0.613) / (0.624 - 0.467) * (0.397 - 0.331);
  const double under = shoelace({{0.397, 0.467}, {0.609, 0.556}, {right, 0.613}, {left, 0.613}});
  double mean = 0, squares = 0;
  const double count = static_cast<double>(lift.size() - 2);
  for (std::size_t n = 2; n < lift.size(); ++n)
    mean += lift[n] / under / count, squares += std::pow(lift[n] / under - 1, 2) / count;
  EXPECT_NEAR(mean, 1, 0.03);
  EXPECT_LT(std::sqrt(squares), 0.06);
}

/// Obstacles that overlap are one: no liquid is where they do, and its volume is true.
TEST(LiquidAtRest, ObstaclesThatOverlap) {
  const DeckRun run = run_text(
      "valley", box(40, 40, 1.0 / 40, 0.02, 0.4) + liquid("liquid_below(1)='.4', obstacle_plane(1,1)=.5,.1,.3,1., "
                                                          "obstacle_plane(1,2)=.5,.1,-.3,1."));
  const double half = std::min(0.5, 0.3 / 0.3);  // of the width at the surface
  EXPECT_NEAR(run.first("liquid_volume"), 2 * (0.3 * half - 0.3 * half * half / 2), 1e-4);
  EXPECT_NEAR(run.last("fluid_volume"), run.first("liquid_volume"), 2e-3);
  const auto kinetic = run.history.column("energy_kinetic");
  EXPECT_LT(*std::max_element(kinetic.begin(), kinetic.end()), 1e-4 * 0.1);
}

/// Without a wall that cuts cells it is at rest to the last digits.
TEST(LiquidAtRest, StaysAtRestInAPlainBox) {
  const DeckRun run = run_text("plain", box(32, 32, 1.0 / 32, 0.5 / 32, 2) + liquid("liquid_below(1)='.625'"));
  EXPECT_LT(fastest(run), 1e-12);
}

}  // namespace
}  // namespace tether::cases
