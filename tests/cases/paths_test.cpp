// SPDX-License-Identifier: GPL-3.0-or-later
// One scene, one deck, several paths: decks/paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

namespace tether::cases {
namespace {

using Texts = std::vector<std::string>;

/// How far the body's centre of mass is below where it was, at each record.
std::vector<double> sag_of(const DeckRun& run) {
  std::vector<double> sag = run.history.column("body_y_1");
  const double start = sag.front();
  for (double& y : sag) y = start - y;
  return sag;
}

// The bar of decks/paths/bar.in.
constexpr double bar_g = 1e-3, L = 1, c2 = 1000;

/// What the bar's end at the clamp gives pulls its centre of mass up: g t^2/2 - g c t^3/(6 L) until t = 2 L/c, and back
/// in the same way.
double exact_sag(double t) {
  const double c = std::sqrt(c2), period = 4 * L / c;
  double phase = std::fmod(t, period);
  phase = std::min(phase, period - phase);
  return 0.5 * bar_g * phase * phase - bar_g * c * phase * phase * phase / (6 * L);
}

/// Root of the mean square, over the largest.
double error_of_bar(const DeckRun& run) {
  const std::vector<double> time = run.history.column("time"), sag = sag_of(run);
  double squares = 0;
  for (std::size_t k = 0; k < sag.size(); ++k) squares += std::pow(sag[k] - exact_sag(time[k]), 2);
  return std::sqrt(squares / static_cast<double>(sag.size())) / exact_sag(2 * L / std::sqrt(c2));
}

TEST(OneScene, IsABarLetGoByThreePaths) {
  EXPECT_LT(error_of_bar(run_by("mpm", "bar")), 0.005);
  EXPECT_LT(error_of_bar(run_by("fem", "bar")), 0.005);
  EXPECT_LT(error_of_bar(run_by("coupled", "bar")), 0.005);
}

TEST(OneScene, IsNearerToABarByShorterStepsAndFinerMeshes) {
  const Texts coarse{"mesh.cells(2,1)=10", "in.tstep=2.e-3"}, fine{"mesh.cells(2,1)=20", "in.tstep=1.e-3"};
  const double before = error_of_bar(run_by("fem", "bar", coarse)), after = error_of_bar(run_by("fem", "bar", fine));
  EXPECT_GT(std::log2(before / after), 1.5) << before << ' ' << after;
  const double points = error_of_bar(run_by("mpm", "bar", {"in.ny=97", "in.nx=9"}));
  EXPECT_GT(std::log2(error_of_bar(run_by("mpm", "bar")) / points), 0.85) << points;
}

/// The largest sag of the first swing, by a parabola through records, and the period, by records between which the sag
/// rises through half of it.
struct SagSwing {
  double largest = 0, period = 0;
};

SagSwing sag_swing_of(const DeckRun& run) {
  const std::vector<double> time = run.history.column("time"), sag = sag_of(run);
  const auto k = static_cast<std::size_t>(
      std::max_element(sag.begin(), sag.begin() + static_cast<std::ptrdiff_t>(sag.size() / 2)) - sag.begin());
  const double before = sag[k - 3], at = sag[k], after = sag[k + 3];
  const double slope = after - before, bend = before - 2 * at + after;
  const double half = 0.5 * (at - slope * slope / (8 * bend));
  std::vector<double> rises;
  for (std::size_t i = 1; i < sag.size(); ++i) {
    if (sag[i - 1] < half && sag[i] >= half)
      rises.push_back(time[i - 1] + (half - sag[i - 1]) / (sag[i] - sag[i - 1]) * (time[i] - time[i - 1]));
  }
  return {2 * half, rises.size() < 2 ? 0 : rises[1] - rises[0]};
}

/// Converged: biquadratic elements, 20 x 4 to 80 x 16, in steps of .005 give 3.14382e-3 to 3.14412e-3 and 1.00628 to
/// 1.00630. The box has the deck's 160 x 32 linear triangles, or quadratic elements as the bodies in air.
TEST(OneScene, IsACantileverLetGoByThreePaths) {
  constexpr double largest = 3.1441e-3, period = 1.0063;
  const Texts quadratic{"mesh.element='q2'", "mesh.cells(1:2,1)=20,4"};
  for (const SagSwing& swing :
       {sag_swing_of(run_by("mpm", "cantilever")), sag_swing_of(run_by("fem", "cantilever", quadratic)),
        sag_swing_of(run_by("coupled", "cantilever", at_full_length() ? Texts{} : quadratic))}) {
    EXPECT_NEAR(swing.largest, largest, 0.005 * largest);
    EXPECT_NEAR(swing.period, period, 0.005 * period);
  }
}

/// What a run leaves as its deck is the same run again, by the path that was asked for.
TEST(OneScene, GoesAgainByThePathItWasRunBy) {
  for (const std::string path : {"mpm", "fem", "coupled"}) {
    const DeckRun run = run_by(path, "bar", {"in.tmax=.01"});
    const DeckRun again = run_file(run.folder + "/deck.effective");
    EXPECT_EQ(again.history.column("body_y_1"), run.history.column("body_y_1")) << path;
  }
}

}  // namespace
}  // namespace tether::cases
