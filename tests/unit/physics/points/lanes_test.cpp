// SPDX-License-Identifier: GPL-3.0-or-later
// Points by lanes: the same bits by every instruction set, and what the passes one by one find.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "physics/points/derived.hpp"
#include "physics/points/fields.hpp"
#include "physics/points/layout.hpp"
#include "physics/points/movers.hpp"
#include "physics/points/nodes.hpp"
#include "physics/points/steps.hpp"
#include "unit/physics/points/lane_scenes.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

/// A run of some steps with the walls given, with records at some of them alone.
class LaneRun {
 public:
  LaneRun(const LaneScene& of, Wall wall, const LaneChoice& lanes)
      : scene_(scene_on(BackgroundGrid(23, 26, -2, 2, -2, 2), all_walls(wall), 0.004, robust_set())),
        state_(start(made(of), lanes)),
        set_(step_set(scene_)) {}
  void steps(int n) {
    for (int k = 0; k < n; ++k) {
      StepWork work{.state = state_, .scene = scene_, .found = {}, .records = k + 1 == n};
      set_.step(work, 0.004);
      ASSERT_EQ(work.found.trouble.kind, TroubleKind::none) << k;
      state_.balance.add(work.nodes, work.found.squares, work.found.lifted, scene_.method.transfer == Transfer::apic, 0,
                         0.004);
      state_.c_max = std::sqrt(work.found.c_squared_max);
      ++state_.steps, moved_ += work.found.crossings;
      if (std::any_of(state_.blocks.begin(), state_.blocks.end(),
                      [](const auto& blocks) { return blocks && blocks->scattered(); }))
        lay_out(state_, scene_), state_.list_fluids(scene_), ++layouts_;
      set_.list_active(state_);
    }
  }
  /// A field of the points by their numbers.
  std::vector<double> field(LineArray<double> Points::*array) const {
    std::vector<double> values(state_.point_count());
    const Points& P = state_.points;
    for_points(P, Slots{0, P.size()},
               [&](std::size_t p) { values[static_cast<std::size_t>(P.id[p])] = P.at(array, p); });
    return values;
  }
  const State& state() const { return state_; }
  State& state() { return state_; }
  /// What the history says of it [energy].
  double transfer() const {
    return state_.balance.transfer + (state_.carried_at_start - sums_of(state_, scene_).carried);
  }
  const Scene& scene() const { return scene_; }
  long long moved() const { return moved_; }
  int layouts() const { return layouts_; }

 private:
  const Scene& made(const LaneScene& of) {
    of.add(scene_);
    set_velocities(scene_, [](double x, double y) {
      return Vec<2>{0.4 + 0.3 * std::sin(3 * x) - 0.5 * y, 0.2 + 0.6 * x * std::cos(2 * y)};
    });
    return scene_;
  }
  Scene scene_;
  State state_;
  StepSet set_;
  long long moved_ = 0;
  int layouts_ = 0;
};

constexpr LineArray<double> Points::*compared[] = {
    &Points::x,      &Points::y,   &Points::vx,  &Points::vy,  &Points::vxx, &Points::vyx,
    &Points::vxy,    &Points::vyy, &Points::sxx, &Points::syy, &Points::sxy, &Points::szz,
    &Points::energy, &Points::fxx, &Points::fxy, &Points::fyx, &Points::fyy, &Points::fzz};

class Lanes : public testing::TestWithParam<std::tuple<LaneScene, Wall>> {
 protected:
  int steps() const { return std::get<0>(GetParam()).steps; }  // before the scene's forces run wild
  LaneRun run(const LaneChoice& lanes) const { return {std::get<0>(GetParam()), std::get<1>(GetParam()), lanes}; }
};
INSTANTIATE_TEST_SUITE_P(Scenes, Lanes,
                         testing::Combine(testing::ValuesIn(lane_scenes),
                                          testing::Values(Wall::open, Wall::free_slip, Wall::fixed)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param).name) + "Wall" +
                                  std::to_string(static_cast<int>(std::get<1>(info.param)));
                         });

TEST_P(Lanes, HaveTheSameBitsByEveryInstructionSet) {
  LaneRun one = run({InstructionSet::one, true});
  one.steps(steps());
  EXPECT_GT(one.moved(), 0);
  for (const InstructionSet set : instruction_sets) {
    if (!has(set)) continue;
    LaneRun other = run({set, true});
    other.steps(steps());
    for (const auto array : compared) EXPECT_EQ(other.field(array), one.field(array));
    EXPECT_EQ(other.transfer(), one.transfer());
    EXPECT_EQ(other.state().heat_given, one.state().heat_given);
  }
}

TEST_P(Lanes, HaveTheSameBitsOnAnyNumberOfThreads) {
  LaneRun one = run({});
  one.steps(steps());
  for (const int threads : {2, 3, 8}) {
    LaneRun other = run({.threads = threads});
    other.steps(steps());
    for (const auto array : compared) EXPECT_EQ(other.field(array), one.field(array)) << threads << " threads";
    EXPECT_EQ(other.transfer(), one.transfer());
    EXPECT_EQ(other.state().heat_given, one.state().heat_given);
  }
}

// Velocities are written only where somebody reads them, which must be no matter of results.
TEST_P(Lanes, DoNotDependOnWhenTheyAreRead) {
  LaneRun seldom = run({}), often = run({});
  seldom.steps(steps());
  for (const int n : {1, 7, 12, 1, 1, steps() - 22}) often.steps(n);
  for (const auto array : compared) EXPECT_EQ(often.field(array), seldom.field(array));
  EXPECT_EQ(often.transfer(), seldom.transfer());
}

// Sums in another order: rounding is all that may differ, of each field's largest value.
TEST_P(Lanes, FindWhatPointsFindOneByOne) {
  LaneRun lanes = run({}), alone = run({InstructionSet::one, false});
  ASSERT_TRUE(lanes.state().lane_passes && !alone.state().lane_passes);
  lanes.steps(steps()), alone.steps(steps());
  EXPECT_EQ(lanes.moved(), alone.moved());
  for (const auto array : compared) {
    const auto a = lanes.field(array), b = alone.field(array);
    double worst = 0, most = 1e-300;
    for (std::size_t k = 0; k < b.size(); ++k)
      worst = std::max(worst, std::abs(a[k] - b[k])), most = std::max(most, std::abs(b[k]));
    EXPECT_LT(worst, 2e-12 * most);
  }
  const double energy = stored_energy(alone.scene(), alone.state(), order_of_all(alone.state())).sum();
  EXPECT_NEAR(lanes.transfer(), alone.transfer(), 1e-12 * energy);
  EXPECT_NEAR(lanes.state().balance.work, alone.state().balance.work, 1e-12 * energy);
  EXPECT_NEAR(lanes.state().heat_given, alone.state().heat_given, 1e-12 * energy);
}

// A point that comes into cells where no block is, when all slots are taken by blocks: its body gets more slots, those
// of the other bodies move on, and nobody notices.
TEST(LaneLayout, GivesABodyMoreSlots) {
  const LaneScene two{"TwoBodies", [](Scene& s) {
                        add_body(s, robust_gas(), lattice(0.1, -1, 1, -1, 0), 1.3, 4.0);
                        add_body(s, plane_stress(3, 0.2), lattice(0.1, -1, 1, 0.2, 1), 1.3);
                      }};
  LaneRun run(two, Wall::free_slip, {});
  run.steps(3);
  const auto before = run.field(&Points::x);
  State& state = run.state();
  Blocks& blocks = *state.blocks[0];
  const std::size_t slots = state.ranges[0].size(), other = state.ranges[1].size();
  while (blocks.blocks() * Blocks::lanes < slots) blocks.enter({0, 0});
  const std::size_t slot = blocks.groups()[0].first * Blocks::lanes + 7;
  ASSERT_TRUE(state.points.holds(state.ranges[0].begin + slot));
  std::vector<double> numbers;
  for (const double* array : arrays_of(state.points)) numbers.push_back(array[state.ranges[0].begin + slot]);
  const Blocks::Cell cell{blocks.groups()[0].row, blocks.groups()[0].cell + 7};
  Movers(state, run.scene(), 0).move(std::array{Moved{slot, cell, 0}}, std::array{Blocks::Cell{1, 1}}, numbers);
  EXPECT_GT(state.ranges[0].size(), slots);
  EXPECT_EQ(state.ranges[1].begin, state.ranges[0].end);
  EXPECT_EQ(state.ranges[1].size(), other);
  EXPECT_EQ(state.points.size(), state.ranges[1].end);
  EXPECT_EQ(run.field(&Points::x), before);
  EXPECT_TRUE(blocks.scattered());
  lay_out(state, run.scene()), state.list_fluids(run.scene());
  EXPECT_FALSE(state.blocks[0]->scattered());
  EXPECT_EQ(run.field(&Points::x), before);
}

// More of them than there are notes of.
TEST(LaneLayout, MovesABodyThatChangesItsCellsAsAWhole) {
  const LaneScene edge{"AtTheEdgesOfCells", [](Scene& s) {
                         std::vector<PointAt> points;
                         for (int k = 0; k < 12000; ++k) {
                           const double x = s.grid.x0 + (6.5 + k % 12) * s.grid.dx - 2e-4;  // half way between nodes
                           points.push_back({x, -1.2 + 1.4 * (k + 0.5) / 12000, 3e-4});
                         }
                         add_body(s, plane_strain(3, 0.3), points, 1.3);
                       }};
  LaneRun run(edge, Wall::free_slip, {}), alone(edge, Wall::free_slip, {InstructionSet::one, false});
  run.steps(1), alone.steps(1);
  EXPECT_GT(run.moved(), 4 * LaneFindings::most_noted);
  run.steps(4), alone.steps(4);
  EXPECT_EQ(run.moved(), alone.moved());
  for (const auto array : {&Points::x, &Points::y, &Points::vx, &Points::sxx}) {
    const auto a = run.field(array), b = alone.field(array);
    for (std::size_t k = 0; k < b.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-11) << k;
  }
}

// Where the stress waits for the points' new places, a crowd needs more blocks in the midst of a step.
TEST(LaneLayout, GrowsWithinAStep) {
  const LaneScene crowd{"Crowd", [](Scene& s) {
                          s.method = {.gas_energy = GasEnergy::rate};
                          IdealGas gas = robust_gas(0.02);
                          gas.rule = DensityRule::quadratic;
                          add_body(s, gas, lattice(0.03, -1, 1, -1, 1), 1.3, 8.0);
                        }};
  LaneRun run(crowd, Wall::free_slip, {}), alone(crowd, Wall::free_slip, {InstructionSet::one, false});
  const std::size_t slots = run.state().ranges[0].size();
  run.steps(100), alone.steps(100);
  EXPECT_NE(run.state().ranges[0].size(), slots);
  const auto a = run.field(&Points::x), b = alone.field(&Points::x);
  for (std::size_t k = 0; k < b.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-11);
}

/// Every point stands in a lane of its cell, and every slot without one is empty.
TEST(LaneLayout, PutsPointsIntoTheirCells) {
  const LaneScene solid{"Solid", [](Scene& s) {
                          add_body(s, plane_stress(3, 0.2), scattered(lattice(0.08, -1.2, 1.4, -1, 1.2), 0.08), 1.3);
                        }};
  LaneRun run(solid, Wall::open, {});
  run.steps(40);
  const State& state = run.state();
  const Blocks& blocks = *state.blocks[0];
  const Locator locator(state.grid.frame.shape);
  std::size_t found = 0;
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::uint32_t block = group.first; block != Blocks::none; block = blocks.next(block)) {
      for (std::size_t l = 0; l < Blocks::lanes; ++l) {
        const std::size_t p = state.ranges[0].begin + block * Blocks::lanes + l;
        const auto at = SplineKernel::locate(locator, state.points.x[p], state.points.y[p]);
        EXPECT_EQ(at.j, group.row);
        EXPECT_EQ(at.i, group.cell + static_cast<int>(l));
        if (state.points.holds(p)) {
          ++found;
        } else {
          EXPECT_EQ(state.points.mass[p], 0);
          EXPECT_EQ(state.points.sxx[p], 0);
        }
      }
    }
  }
  EXPECT_EQ(found, state.point_count());
}

}  // namespace
}  // namespace tether::mpm
