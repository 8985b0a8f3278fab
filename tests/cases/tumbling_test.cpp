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

/// Energy and momenta over 1,000 free steps, with the longest ten times what the mid-point rule bears, whose energy has
/// grown by then to `growth` times what it was; with the dilatation of points, by which that rule bears least.
void expect_kept_where_the_middle_is_not(const char* law, const char* bearable, const char* ten_times, double growth) {
  const auto fly = [&](const char* step, std::vector<std::string> overrides) {
    overrides.push_back("fem.dilatation='point'");
    for (const char* region : {"1", "2", "3"}) overrides.push_back(std::string("fem.law(") + region + ")=" + law);
    // Such steps leave nothing of the shape: conservation alone is looked at.
    overrides.insert(overrides.end(),
                     {"limits.volume=0,0", "limits.quality=0,0", "limits.energy_step=0,0", "limits.energy_growth=0,0",
                      std::string("in.tstep=") + step, std::string("in.tiout(33)=") + step,
                      "in.tmax=" + std::to_string(5 + 1000 * std::stod(step))});
    return run_deck("l-block", overrides);
  };
  const DeckRun middle = fly(bearable, {"fem.integrator='midpoint'"});
  EXPECT_GT(change_in_flight(middle, "energy_total", 2.5e5), growth);
  for (const char* step : {"0.1", "1.0", ten_times}) {
    SCOPED_TRACE(step);
    expect_kept(fly(step, {}), 1e-10);
  }
}

TEST(FemSolids, TumblingBlockKeepsEnergyAndMomenta) { expect_kept_where_the_middle_is_not("'svk'", "0.2", "2.0", 1e3); }

TEST(FemSolids, TumblingNeoHookeanBlockKeepsEnergyAndMomenta) {
  expect_kept_where_the_middle_is_not("'neo-hookean'", "0.3", "3.0", 1);
}

/// Every element, by the mean dilatation where it has one, with a material that hardly changes its volume. The block
/// has as few elements as its shape allows: 1,000 steps of more take minutes.
TEST(FemSolids, TumblingBlocksOfAllElementsKeepEnergyAndMomenta) {
  for (const char* element : {"q1", "p1", "p2", "q2"}) {
    SCOPED_TRACE(element);
    std::vector<std::string> overrides{"mesh.element='" + std::string(element) + "'",
                                       "in.tmax=105.",
                                       "fem.dilatation='mean'",
                                       "mesh.cells(1:3,1)=1,1,1",
                                       "mesh.cells(1:3,2)=1,1,1",
                                       "mesh.cells(1:3,3)=1,1,1"};
    for (const char* region : {"1", "2", "3"}) {
      overrides.push_back("fem.law(" + std::string(region) + ")='neo-hookean'");
      overrides.push_back("reg.matr(2," + std::string(region) + ")=0.49");
    }
    expect_kept(run_deck("l-block", overrides), 1e-9);
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
