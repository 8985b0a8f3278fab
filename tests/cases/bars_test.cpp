// SPDX-License-Identifier: GPL-3.0-or-later
// The string decks of thesis chapter 5 unchanged by bars, the code of Figs. 36 and 37, against exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/diagnostics.hpp"
#include "plan/load.hpp"
#include "results/checkpoint.hpp"
#include "run/run.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::cases {
namespace {

class BarDecks : public test::TemporaryFolder {
 protected:
  Loaded loaded(const std::string& deck, const std::vector<std::string>& overrides = {}) const {
    return load(std::string(TETHER_SOURCE_DIR) + "/decks/" + deck + ".in", {overrides, "", "fem"});
  }
  /// summary.txt of a run by bars.
  std::map<std::string, double> run_deck(const std::string& deck, const std::vector<std::string>& overrides = {}) {
    const Loaded by_bars = loaded(deck, overrides);
    outcome_ = run(by_bars.plan, request_of(by_bars, folder / deck, ""));
    std::map<std::string, double> summary;
    for (const auto& [key, value] : outcome_.summary) {
      if (key == "path") {
        EXPECT_EQ(value, "fem");
      } else {
        summary[key] = std::stod(value);
      }
    }
    EXPECT_EQ(summary.at("mass_drift"), 0);
    return summary;
  }
  RunOutcome outcome_;
};

/// The exact spring has 9e-4 of the mass spread along it, a third of which swings with it. Here eight points between
/// wall and mass have 1e-4 of it each and move with i/9 of its speed: half of sum (i/9)^2 1e-4 - 3e-4 = -2.4e-5 of the
/// period is missing.
TEST_F(BarDecks, SpringMass) {
  const auto summary = run_deck("spring-mass");
  EXPECT_NEAR(summary.at("error_period"), -2.41e-5, 1e-6);
  EXPECT_LT(std::abs(summary.at("error_largest_drop")), 1e-3);
  EXPECT_LT(summary.at("energy_drift"), 1e-10);
}

TEST_F(BarDecks, StringMass) {
  const auto summary = run_deck("string-mass");
  EXPECT_LT(std::abs(summary.at("error_taut_time")), 1e-3);
  EXPECT_LT(std::abs(summary.at("error_largest_drop")), 5e-3);
  EXPECT_LT(std::abs(summary.at("error_slack_again_time")), 2e-3);
  EXPECT_LT(std::abs(summary.at("error_apex_time")), 2e-3);
  EXPECT_LT(summary.at("energy_drift"), 1e-3);
}

/// The exact string has its mass spread along it and is as long as the mass at rest stretches it; without either it is
/// -1.3e-4 off.
TEST_F(BarDecks, Pendulums) {
  for (const char* deck : {"pendulum-20", "pendulum-40", "pendulum-80", "pendulum-40-two-way"}) {
    const auto summary = run_deck(deck);
    EXPECT_NEAR(summary.at("period"), 1.2120, 0.002 * 1.2120) << deck;
    EXPECT_LT(std::abs(summary.at("error_period")), 4e-5) << deck;
    EXPECT_LT(summary.at("energy_drift"), 1e-6) << deck;
  }
}

// Fig. 37: by bars the angle comes back to where it began.
TEST_F(BarDecks, APendulumKeepsItsAmplitude) {
  run_deck("pendulum-40");
  const auto angle = outcome_.history.column("tracked_angle"), time = outcome_.history.column("time");
  double left = 0, right = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    right = std::max(right, angle[k]);
    if (time[k] > 0.9) left = std::min(left, angle[k]);
  }
  EXPECT_NEAR(right, 18.437, 0.01);
  EXPECT_NEAR(left, -18.437, 0.01);
}

TEST_F(BarDecks, APinInPlaceOfTheWallChangesNothing) {
  const double held = run_deck("pendulum-20").at("period");
  EXPECT_NEAR(run_deck("pendulum-20", {"points.pinned(1)=.true.", "in.wt=1"}).at("period"), held, 1e-6);
}

TEST_F(BarDecks, ARestartGoesOnToTheLastBit) {
  const std::vector<std::string> outputs{"in.tmax=0.031", "in.iout(41)=1", "in.tiout(41)=0.01"};
  run_deck("string-mass", outputs);
  const auto whole = outcome_.history.records;
  const Loaded deck = loaded("string-mass", outputs);
  RunRequest parts = request_of(deck, folder / "parts", "");
  double reached = 0;
  parts.progress = [&reached](const Progress& progress) { reached = progress.time; };
  parts.interrupted = [&reached] { return reached > 0.0137 ? 15 : 0; };
  EXPECT_THROW(run(deck.plan, parts), Interrupted);
  parts.progress = nullptr, parts.interrupted = nullptr;
  parts.restart = checkpoints_in(folder / "parts").at(0);
  EXPECT_EQ(run(deck.plan, parts).history.records, whole);
  EXPECT_EQ(read_checkpoint(checkpoints_in(folder / "parts").at(0)).state,
            read_checkpoint(checkpoints_in(folder / "string-mass").at(0)).state);
}

TEST_F(BarDecks, WhatTheyCannotRepresentIsRefused) {
  for (const char* deck : {"sod", "ball-net", "cyl-200", "piston-m1", "two-bar", "stability-side"}) {
    EXPECT_THROW(loaded(deck), InputError) << deck;
  }
}

}  // namespace
}  // namespace tether::cases
