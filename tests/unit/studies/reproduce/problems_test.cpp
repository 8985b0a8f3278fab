// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/problems.hpp"

#include <cmath>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "plan/load.hpp"
#include "studies/reproduce/runs.hpp"
#include "unit/studies/reproduce/support.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;

std::string refusal(const std::vector<std::string>& names) {
  try {
    problems_named(names, decks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Problems, HaveNamesOfTheirOwnAndWholeRows) {
  std::set<std::string> names;
  std::size_t quantities = 0;
  for (const Problem& problem : all_problems()) {
    EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
    EXPECT_FALSE(problem.place.empty() || problem.deck.empty() || problem.quantities.empty()) << problem.name;
    std::set<std::string> rows;
    for (const PublishedQuantity& quantity : problem.quantities) {
      EXPECT_TRUE(rows.insert(quantity.name).second) << problem.name << ": " << quantity.name;
      EXPECT_TRUE(quantity.reading) << problem.name << ": " << quantity.name;
      const std::string row = problem.name + ": " + quantity.name;
      EXPECT_TRUE(quantity.exact || (!quantity.thesis && !quantity.robust)) << row;
      EXPECT_TRUE(!quantity.published.empty() || quantity.upper_bound || quantity.by_published == Judged::none) << row;
      EXPECT_TRUE(quantity.theory || (!quantity.thesis_by_theory && !quantity.robust_by_theory)) << row;
      for (const Printed& printed : quantity.published) {
        EXPECT_FALSE(printed.place.empty()) << row;
        EXPECT_GT(printed.band, 0) << row;
      }
      ++quantities;
    }
  }
  RecordProperty("problems", static_cast<int>(names.size()));
  RecordProperty("quantities", static_cast<int>(quantities));
  EXPECT_GE(names.size(), 30u);
  EXPECT_GE(quantities, 120u);
}

/// What the thesis quotes of its theory, whatever any program makes of it.
TEST(Problems, TheoryIsThatOfTheThesis) {
  const auto expect = [](const char* problem, const char* quantity, double value, double part) {
    const auto theory = quantity_named(problem, quantity).theory;
    ASSERT_TRUE(theory) << problem << ": " << quantity;
    EXPECT_NEAR(theory->value, value, part * value) << problem << ": " << quantity;
  };
  expect("sod", "shock speed", 1.75, 0);
  expect("sod", "way of the shock", 0.25, 0);
  expect("spring-mass", "period", 0.01986, 1e-3);
  expect("spring-mass", "largest displacement", 0.005, 2e-3);
  expect("string-mass", "slack taken up", 0.01265, 1e-3);
  expect("string-mass", "tension until", 0.02413, 1e-3);
  expect("string-mass", "apex", 0.03678, 1e-3);
  expect("piston-m01", "period", 0.00709, 0);
  expect("piston-m1", "frequency [rad/s]", 281.2, 0);
}

/// What a deck of ours makes exact, by the decks of this project.
class Exact : public test::TemporaryFolder {
 protected:
  double exact(const std::string& problem, const std::string& quantity,
               const std::vector<std::string>& overrides = {}) {
    const Problem posed = problem_named(problem);
    DeckOptions options;
    options.overrides = overrides;
    write_file(folder / "deck.effective", load(posed.deck, options).effective);
    return quantity_named(problem, quantity).exact(RunFiles(folder));
  }
};

/// Ten per cent more of E or siep: the exact value is another, and no longer that of the thesis.
TEST_F(Exact, FollowsTheDeck) {
  EXPECT_NEAR(exact("sod-cell", "shock speed"), 1.7522, 1e-4);
  EXPECT_NEAR(exact("sod-cell", "shock speed", {"fluid.siep(1)=2.75", "fluid.siep(2)=2.2"}), 1.7522 * std::sqrt(1.1),
              1e-4);
  EXPECT_NEAR(exact("sod", "shock strength p2/p1"), 3.0313, 1e-4);
  EXPECT_NEAR(exact("piston-m1", "period"), 0.022347, 1e-6);
  EXPECT_NEAR(exact("piston-m1", "period", {"reg.matr(1,1)=1.738e6"}), 0.022347 / std::sqrt(1.1), 1e-5);
}

TEST_F(Exact, OfAStepLimitIsThatOfTheDecksCells) {
  EXPECT_NEAR(exact("stability-side", "longest stable step c dt/dx"), 1.0515, 1e-4);
  EXPECT_NEAR(exact("stability-centre", "longest stable step c dt/dx"), 2.1029, 1e-4);
}

TEST(Problems, WhatContradictsItselfStandsBesideEachOther) {
  const auto printed = [](const char* problem, const char* quantity, std::size_t k) {
    return quantity_named(problem, quantity).published.at(k).value;
  };
  EXPECT_EQ(printed("pendulum-40", "angle at the start [degrees]", 0), 19.8);
  EXPECT_EQ(printed("pendulum-40", "angle at the start [degrees]", 1), 18.44);
  EXPECT_NEAR(printed("cyl-500", "mass of the probe [kg]", 1), 5.655, 1e-3);
  EXPECT_NEAR(printed("cyl-200", "mass of the bag [g]", 1), 249.9, 0.05);
  EXPECT_NEAR(printed("cyl-200", "thickness of the bag [mm]", 1), 0.735, 1e-3);
  EXPECT_NEAR(printed("membrane-expansion-4", "total mass", 1), 0.5846, 1e-4);
  EXPECT_NEAR(printed("membrane-expansion-4", "total mass", 2), 0.5479, 1e-4);
  EXPECT_EQ(printed("membrane-expansion-4", "membrane points", 1), 600);
}

TEST(ProblemNames, SelectInTheOrderOfTheThesis) {
  const auto some = problems_named({"noise", "sod", "noise"}, decks);
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(some[0].name, "sod");
  EXPECT_EQ(some[1].name, "noise");
  EXPECT_EQ(problems_named({}, decks).size(), all_problems().size());
}

TEST(ProblemNames, AreToldWithTheNearestAndTheList) {
  const std::string text = refusal({"sod", "pendulm-20", "zzzzzzzz"});
  EXPECT_NE(text.find("'pendulm-20' (did you mean pendulum-20?), 'zzzzzzzz'"), std::string::npos) << text;
  EXPECT_NE(text.find("The problems are ball-net, ball-net-orig,"), std::string::npos) << text;
  EXPECT_EQ(text.find("'sod'"), std::string::npos) << text;
  EXPECT_EQ(refusal({"sod"}), "");
}

class Plans : public test::TemporaryFolder {
 protected:
  void SetUp() override { write_file(folder / "chaos.in", deck("tstep=1.0e-3")); }
  static std::string deck(const std::string& step) {
    return "$in nx=5, ny=5, xleft=0., xright=1., ybot=0., ytop=1., tmax=1.,\n" + step + "\n$\n";
  }
  Problem problem(bool varied, std::vector<std::string> overrides = {}) const {
    return {.name = "p",
            .place = "1",
            .deck = (folder / "chaos.in").string(),
            .thesis = {std::move(overrides), varied},
            .quantities = {{.name = "q"}}};
  }
};

/// The number behind "name=" of the overrides; not a number where there is none.
double override_of(const Study& study, const std::string& name) {
  for (const auto& text : study.sets) {
    if (text.starts_with(name + "=")) return parse_real(text.substr(name.size() + 1)).value();
  }
  return std::nan("");
}

TEST_F(Plans, OneRunByEitherMethod) {
  const auto runs = plan_runs({problem(false, {"in.tmax=2.0"})}, "out");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].study.sets, (std::vector<std::string>{"mpm.method='thesis'", "in.tmax=2.0"}));
  EXPECT_EQ(runs[1].study.sets, std::vector<std::string>{"mpm.method='robust'"});
  EXPECT_EQ(runs[0].out, fs::path("out/p/thesis"));
  EXPECT_EQ(runs[1].role, Role::robust);
}

TEST_F(Plans, AVariedStepDiffersInEveryPartOfIt) {
  const auto runs = plan_runs({problem(true)}, "out");
  ASSERT_EQ(runs.size(), 11u);
  std::set<double> steps;
  for (std::size_t k = 0; k < 10; ++k) {
    const double factor = override_of(runs[k].study, "in.tstep") / 1e-3;
    EXPECT_GT(factor, 0.995 - 1e-12);
    EXPECT_LT(factor, 1.005 + 1e-12);
    EXPECT_NEAR(override_of(runs[k].study, "mpm.cfl"), factor, 1e-12);  // the thesis' 1
    EXPECT_TRUE(std::isnan(override_of(runs[k].study, "in.dtmax")));    // not given: it follows tstep
    steps.insert(factor);
  }
  EXPECT_EQ(steps.size(), 10u);
  EXPECT_NEAR(*steps.begin(), 0.995, 1e-12);
  EXPECT_NEAR(*steps.rbegin(), 1.005, 1e-12);
}

TEST_F(Plans, AStepThatIsTakenAsItIsKeepsItsCfl) {
  write_file(folder / "chaos.in", deck("tstep=1.0e-3, dtmax=5.0e-4"));
  const auto runs = plan_runs({problem(true, {"mpm.cfl=0.0"})}, "out");
  EXPECT_EQ(override_of(runs[0].study, "mpm.cfl"), 0);
  EXPECT_NEAR(override_of(runs[0].study, "in.dtmax"), 0.995 * 5e-4, 1e-15);
}

TEST_F(Plans, TellOfAllDecksThatAreMissing) {
  Problem other = problem(true);
  other.deck = "none.in", other.compared_with = "neither.in";
  try {
    plan_runs({problem(false), other}, "out");
    FAIL();
  } catch (const FileError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("none.in"), std::string::npos) << text;
    EXPECT_NE(text.find("neither.in"), std::string::npos) << text;
    EXPECT_EQ(text.find("none.in", text.find("none.in") + 1), std::string::npos) << text;
  }
  EXPECT_THROW(problems_named({}, folder / "nowhere"), InputError);
}

TEST_F(Plans, TellOfADecksMistakesOnce) {
  write_file(folder / "chaos.in", deck("tstep=-1.0e-3"));
  for (const bool varied : {false, true}) {
    try {
      plan_runs({problem(varied)}, "out");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.diagnostics().size(), 1u) << error.what();
      EXPECT_EQ(error.diagnostics().front().place.line, 2);
    }
  }
}

TEST(Plan, OfTheDecksOfThisProjectNamesEveryProblem) {
  std::set<std::size_t> planned;
  const auto problems = all_problems();
  for (const auto& run : plan_runs(problems, "out")) planned.insert(run.problem);
  EXPECT_EQ(planned.size(), problems.size());
}

}  // namespace
}  // namespace tether::published
