// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/run_deck.hpp"

// What free bodies keep, by elements and rules.

namespace tether::cases {
namespace {

/// Largest change of a column after t = 5, where the loads are gone, over `size`.
double change_in_flight(const DeckRun& run, const std::string& column, double size) {
  const auto time = run.history.column("time"), values = run.history.column(column);
  const auto from = static_cast<std::size_t>(
      std::find_if(time.begin(), time.end(), [](double t) { return t > 5.0 + 1e-9; }) - time.begin());
  double largest = 0;
  for (std::size_t k = from; k < values.size(); ++k) largest = std::max(largest, std::abs(values[k] - values[from]));
  return largest / size;
}

double size_of(const DeckRun& run, const std::string& name) {
  double square = 0;
  for (const char* axis : {"x", "y", "z"}) square += std::pow(run.last(name + axis), 2);
  return std::sqrt(square);
}

void expect_kept(const DeckRun& run, double within) {
  EXPECT_LT(change_in_flight(run, "energy_total", run.last("energy_total")), within);
  EXPECT_LT(run.summary.at("energy_drift"), within);
  for (const char* axis : {"x", "y", "z"}) {
    const std::string name(axis);
    EXPECT_LT(change_in_flight(run, "momentum_" + name, size_of(run, "momentum_")), within);
    EXPECT_LT(change_in_flight(run, "angular_momentum_" + name, size_of(run, "angular_momentum_")), within);
  }
}

/// The block over so many free steps, with the dilatation of points, by which the mid-point rule bears least.
DeckRun fly(const char* law, const char* step, int steps, std::vector<std::string> overrides = {}) {
  overrides.push_back("fem.dilatation='point'");
  for (const char* region : {"1", "2", "3"}) overrides.push_back(std::string("fem.law(") + region + ")=" + law);
  // Such steps leave nothing of the shape: conservation alone is looked at.
  overrides.insert(overrides.end(),
                   {"limits.volume=0,0", "limits.quality=0,0", "limits.energy_step=0,0", "limits.energy_growth=0,0",
                    std::string("in.tstep=") + step, std::string("in.tiout(33)=") + step,
                    "in.tmax=" + std::to_string(5 + steps * std::stod(step))});
  return run_deck("l-block", overrides);
}

/// Energy and momenta over 1,000 free steps, or 100 of the longest, which is ten times what the mid-point rule bears.
void expect_kept_in_long_steps(const char* law, const char* ten_times) {
  const int steps = at_full_length() ? 1000 : 100;
  std::vector<const char*> lengths{ten_times};
  if (at_full_length()) lengths.insert(lengths.end(), {"0.1", "1.0"});
  for (const char* step : lengths) {
    SCOPED_TRACE(step);
    expect_kept(fly(law, step, steps), 1e-13 * steps);
  }
}

/// By the mid-point rule its energy grows to `growth` times what it was, or more.
void expect_lost_by_the_middle(const char* law, const char* step, int steps, double growth) {
  const DeckRun middle = fly(law, step, steps, {"fem.integrator='midpoint'"});
  EXPECT_GT(change_in_flight(middle, "energy_total", 2.5e5), growth);
}

TEST(FemSolids, TumblingBlockKeepsEnergyAndMomenta) {
  expect_kept_in_long_steps("'svk'", "2.0");
  expect_lost_by_the_middle("'svk'", "1.0", 30, 1e3);
  if (at_full_length()) expect_lost_by_the_middle("'svk'", "0.2", 1000, 1e3);
}

TEST(FemSolids, TumblingNeoHookeanBlockKeepsEnergyAndMomenta) {
  expect_kept_in_long_steps("'neo-hookean'", "3.0");
  if (at_full_length()) expect_lost_by_the_middle("'neo-hookean'", "0.3", 1000, 1);
}

/// Every element, by the mean dilatation where it has one, with a material that hardly changes its volume, over 1,000
/// free steps or 100. The block has as few elements as its shape allows: 1,000 steps of more take minutes.
TEST(FemSolids, TumblingBlocksOfAllElementsKeepEnergyAndMomenta) {
  for (const char* element : {"q1", "p1", "p2", "q2"}) {
    SCOPED_TRACE(element);
    std::vector<std::string> overrides{"mesh.element='" + std::string(element) + "'",
                                       at_full_length() ? "in.tmax=105." : "in.tmax=15.",
                                       "fem.dilatation='mean'",
                                       "mesh.cells(1:3,1)=1,1,1",
                                       "mesh.cells(1:3,2)=1,1,1",
                                       "mesh.cells(1:3,3)=1,1,1"};
    for (const char* region : {"1", "2", "3"}) {
      overrides.push_back("fem.law(" + std::string(region) + ")='neo-hookean'");
      overrides.push_back("reg.matr(2," + std::string(region) + ")=0.49");
    }
    expect_kept(run_deck("l-block", overrides), at_full_length() ? 1e-9 : 1e-11);
  }
}

/// The other two rules keep one or none of them: the mid-point rule the momenta, Newmark's neither.
TEST(FemSolids, OtherRulesLoseWhatTheDiscreteGradientKeeps) {
  const DeckRun middle = run_deck("l-block", {"in.tstep=0.25", "fem.integrator='midpoint'", "in.tmax=15.0"});
  EXPECT_GT(change_in_flight(middle, "energy_total", middle.last("energy_total")), 1e-3);
  EXPECT_LT(change_in_flight(middle, "angular_momentum_z", size_of(middle, "angular_momentum_")), 1e-10);
  const DeckRun newmark = run_deck("l-block", {"in.tstep=0.25", "fem.integrator='trapezoid'", "in.tmax=15.0"});
  EXPECT_GT(change_in_flight(newmark, "energy_total", newmark.last("energy_total")), 1e-3);
  EXPECT_GT(change_in_flight(newmark, "angular_momentum_z", size_of(newmark, "angular_momentum_")), 1e-3);
}

}  // namespace
}  // namespace tether::cases
