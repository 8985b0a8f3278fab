// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/flow_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/load.hpp"

namespace tether {
namespace {

Plan plan_of(const std::string& deck, const std::vector<std::string>& overrides) {
  return load(std::string(TETHER_SOURCE_DIR) + "/decks/" + deck + ".in", {overrides, "", ""}).plan;
}

std::string systems(const std::string& deck, const std::vector<std::string>& overrides) {
  const Plan plan = plan_of(deck, overrides);
  const auto found = std::find_if(plan.terms.begin(), plan.terms.end(),
                                  [](const Term& term) { return term.name == "linear systems"; });
  return found == plan.terms.end() ? "none" : found->reason;
}

const std::vector<std::string> large{"flow.steady=.false.", "in.tstep=.002", "mesh.cells(1,1)=258",
                                     "mesh.cells(2,1)=258"};

TEST(FlowPlan, TellsBySolverAndWhy) {
  const std::string factors = "LU factors, kept while they lead on", gmres = "GMRES with incomplete factors";
  EXPECT_EQ(systems("cavity", {}), factors + ": GMRES takes many iterations for steady flows");
  EXPECT_EQ(systems("two-flaps", {}), factors + ": GMRES takes many iterations for stiff bodies");
  EXPECT_EQ(systems("cavity", {"flow.steady=.false."}), factors + ": 12675 unknowns are no more than 200000");
  EXPECT_EQ(systems("cavity", large), gmres + ": 201243 unknowns are more than 200000");
  EXPECT_EQ(systems("cavity", {"flow.solver='krylov'"}), gmres + ", as the deck says");
  EXPECT_EQ(systems("cavity", {"flow.solver='direct'"}), factors + ", as the deck says");
}

/// Measured: 610 MB and 0.75 s a step.
TEST(FlowPlan, CostsOfGmresGrowWithTheUnknowns) {
  const Cost cost = plan_of("cavity", large).cost;
  EXPECT_NEAR(cost.seconds / cost.steps, 0.8, 0.1);
  EXPECT_NEAR(cost.megabytes, 600, 50);
}

}  // namespace
}  // namespace tether
