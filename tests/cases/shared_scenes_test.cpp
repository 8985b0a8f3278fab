// SPDX-License-Identifier: GPL-3.0-or-later
// One scene, one deck, several paths: the ring, the piston, the pendulum, the flap, and what meets, of decks/paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"
#include "results/signal.hpp"

namespace tether::cases {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

/// How far a column is from where it was, at each record.
Numbers way_of(const DeckRun& run, const std::string& column) {
  Numbers way = run.history.column(column);
  const double start = way.front();
  for (double& each : way) each -= start;
  return way;
}

/// When a way is back at 0 for the second time, by a line through the records on both sides [time].
double second_return(const DeckRun& run, const std::string& column) {
  const Numbers time = run.history.column("time"), way = way_of(run, column);
  int returns = 0;
  for (std::size_t k = 2; k < way.size(); ++k) {
    if ((way[k - 1] < 0) == (way[k] < 0) || ++returns < 2) continue;
    return time[k - 1] - way[k - 1] / (way[k] - way[k - 1]) * (time[k] - time[k - 1]);
  }
  return 0;
}

/// Twice the mean time between a column's passages through a level [time].
double swing_period(const DeckRun& run, const std::string& column, double level) {
  return period_about(run.history.column("time"), run.history.column(column), level);
}

/// The farthest way, by a parabola through the record there and those three before and after it.
double farthest(Numbers way) {
  for (double& each : way) each = std::abs(each);
  const auto found = std::max_element(way.begin() + 3, way.end() - 3) - way.begin();
  const auto k = static_cast<std::size_t>(found);
  const double slope = way[k + 3] - way[k - 3], bend = way[k - 3] - 2 * way[k] + way[k + 3];
  return way[k] - slope * slope / (8 * bend);
}

/// The ring in steps twice as long, until it has come back for the second time.
const Texts longer_ring_steps{"in.tstep=.008", "in.tiout(33)=.008", "in.tmax=.376"};

/// The same on half as many lines, in a fluid of 16 x 16 elements.
Texts coarser_ring() {
  Texts cells = with(longer_ring_steps, {"mesh.cells(1:2,11)=16,16"});
  for (int part = 1; part <= 10; ++part) cells.push_back("mesh.cells(1:2," + std::to_string(part) + ")=10,8");
  return cells;
}

/// Coupled runs without viscosity, 20, 30 and 40 elements across, lead to a period of .3583.
TEST(SharedScene, IsARingThatSwingsInFluidByThreePaths) {
  constexpr double period = 0.3583;
  const Texts on_fewer_cells = with(longer_ring_steps, {"in.nx=41", "in.ny=41"});
  const auto period_by = [](const char* path, const Texts& less) {
    return second_return(run_by(path, "ring", at_full_length() ? Texts{} : less), "point_x_1");
  };
  EXPECT_NEAR(period_by("mpm", {"in.tmax=.368"}), period, 0.01 * period);
  EXPECT_NEAR(period_by("fem", coarser_ring()), period, 0.01 * period);
  EXPECT_NEAR(period_by("coupled", on_fewer_cells), period, 0.01 * period);
}

/// Exact: the sum over the modes of a bar with a bar upon it, at the middle of the upper one.
TEST(SharedScene, IsAPistonOnItsFluidByThreePaths) {
  constexpr double drop = 3.02636e-5;
  EXPECT_NEAR(farthest(way_of(run_by("mpm", "piston"), "point_y_1")), drop, 0.01 * drop);
  EXPECT_NEAR(farthest(way_of(run_by("fem", "piston"), "point_y_1")), drop, 0.0005 * drop);
  EXPECT_NEAR(farthest(way_of(run_by("coupled", "piston"), "point_y_1")), drop, 0.0005 * drop);
}

TEST(SharedScene, IsNearerToThePistonByFinerPoints) {
  constexpr double drop = 3.02636e-5;
  const auto error = [](const std::vector<std::string>& grid) {
    return std::abs(farthest(way_of(run_by("mpm", "piston", grid), "point_y_1")) - drop);
  };
  const double order = std::log2(error({"in.ny=31", "in.nx=2"}) / error({"in.ny=61", "in.nx=3"}));
  EXPECT_NEAR(order, 1, 0.2);
}

TEST(SharedScene, IsAPendulumByPointsBarsAndElements) {
  const double points = run_by("mpm", "pendulum").summary.at("error_period");
  const DeckRun bars = run_by("bars", "pendulum"), elements = run_by("fem", "pendulum");
  EXPECT_LT(std::abs(points), 0.001);
  EXPECT_LT(std::abs(bars.summary.at("error_period")), 0.001);
  const double exact = bars.summary.at("exact_period");
  EXPECT_NEAR(swing_period(elements, "point_x_1", 0.33333), exact, 0.0003 * exact);
}

/// Coupled runs without viscosity lead to .95e-3; elements' fluid sticks to the flap, which makes its way longer. The
/// way is farthest at t = .28, and as far in steps of .02 as in those of the deck.
TEST(SharedScene, IsAFlapInAStreamByTwoPaths) {
  constexpr double way = 0.95e-3;
  const Texts shorter{"in.tstep=.02", "in.tiout(33)=.02", "in.tmax=.36"};
  for (const auto& [path, within] : {std::pair("fem", 0.04), std::pair("coupled", 0.02)}) {
    const DeckRun run = run_by(path, "flap", at_full_length() ? Texts{} : shorter);
    EXPECT_NEAR(farthest(way_of(run, "point_x_1")), way, within * way) << path;
  }
}

/// Mean of a column from a time on.
double mean_from(const DeckRun& run, const std::string& column, double time) {
  const Numbers times = run.history.column("time"), values = run.history.column(column);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] >= time - 1e-9) sum += values[k], ++count;
  }
  return sum / count;
}

/// Finer and finer elements, at half the step, lead to a speed of .0357, and steps of .02 and of .05, too.
TEST(SharedScene, IsABlockThatSinksByThreePaths) {
  constexpr double speed = 0.0357;
  const Texts longer{"in.tstep=.05", "in.tiout(33)=.05"};
  const Texts coarser = with(longer, {"in.nx=49", "in.ny=97"});
  for (const auto& [path, less] : {std::pair("mpm", longer), std::pair("fem", longer), std::pair("coupled", coarser)}) {
    const DeckRun run = run_by(path, "block", at_full_length() ? Texts{} : less);
    EXPECT_NEAR(-mean_from(run, "body_vy_1", 1), speed, 0.03 * speed) << path;
  }
}

/// The drag of a step is that of the speed that the body keeps: longer and shorter steps lead to the same.
TEST(SharedScene, IsABlockThatSinksAsFastByOtherSteps) {
  constexpr double speed = 0.0357;
  for (const char* step : {"in.tstep=.05", "in.tstep=.005"}) {
    const DeckRun run = run_by("coupled", "block", {step, "in.nx=33", "in.ny=65"});
    EXPECT_NEAR(-mean_from(run, "body_vy_1", 1), speed, 0.07 * speed) << step;
    EXPECT_LE(run.summary.at("energy_drift"), 1e-10) << step;
  }
}

/// A column of viscous linear fluid that slides down between two walls: g L^2 / (8 nu) in its middle.
TEST(ViscousLinearFluid, SlidesBetweenWallsAsAParabola) {
  const auto error = [](int cells) {
    const std::string text =
        "$in path='mpm',nx=" + std::to_string(cells + 1) + ",ny=" + std::to_string(6 * cells + 1) +
        ",xleft=0.,xright=.5,ybot=-.5,ytop=2.5,wl=0,wr=0,wb=1,wt=1,gravc=-.1,tmax=2.,tstep=.02,iout(33)=1,"
        "tiout(33)=.1 $\n"
        "$reg nreg=1,nvi=4,densir=1.,xvi(1,1)=0,.5,.5,0.,yvi(1,1)=0.,0.,2.,2.,matr(1,1)=20.,.05,ipath(4,1)=8 $\n"
        "$mpm method='robust' $\n$points tracked_at(1,1)=.25,1. $\n";
    const DeckRun run = run_text("column", text);
    EXPECT_LE(run.summary.at("energy_drift"), 1e-10);
    return std::abs(-run.last("point_vy_1") / 0.0625 - 1);
  };
  const double coarse = error(8), fine = error(16);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

/// How fast two bodies part, over how fast they met.
double restitution(const DeckRun& run) {
  return (run.last("body_vx_2") - run.last("body_vx_1")) / run.first("body_vx_1");
}

/// Exact: two equal bars swap their velocities. Points lose some to their transfer.
TEST(SharedScene, IsTwoBarsThatMeetByTwoPaths) {
  EXPECT_NEAR(restitution(run_by("mpm", "two-bar")), 0.837, 0.01);
  EXPECT_NEAR(restitution(run_by("fem", "two-bar")), 1, 0.015);
}

/// The mean of the parts that the ring is made of, all alike.
double ring_speed(const DeckRun& run, int parts) {
  double sum = 0;
  for (int part = 1; part <= parts; ++part) sum += run.last("body_vx_" + std::to_string(part)) / parts;
  return sum;
}

/// Elements lead to a speed back of .817; points come nearer to it on finer cells.
TEST(SharedScene, IsARingThatFliesAgainstAWallByTwoPaths) {
  EXPECT_NEAR(ring_speed(run_by("fem", "ring-wall", {"in.tstep=.002", "in.tmax=.6"}), 4), 0.817, 0.03);
  const double coarse = ring_speed(run_by("mpm", "ring-wall", {"in.tmax=.6"}), 1);
  const double fine =
      ring_speed(run_by("mpm", "ring-wall", {"in.tmax=.6", "in.nx=121", "in.ny=121", "in.tstep=1.5e-4"}), 1);
  EXPECT_NEAR(coarse, 0.817, 0.06);
  EXPECT_LT(coarse, fine);
  EXPECT_LT(fine, 0.817);
}

}  // namespace
}  // namespace tether::cases
