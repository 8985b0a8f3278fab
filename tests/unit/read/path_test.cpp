// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/path.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "deck/reader.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

using Texts = std::vector<std::string>;

struct Seen {
  Path path;
  Deck deck;
  Texts remarks, warnings, errors;
};

/// What the path sees of a deck.
Seen seen(const std::string& groups, const std::string& in = "") {
  Diagnostics of_reader, diagnostics;
  const Deck deck =
      read_deck("$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=1.,tstep=1." + in + " $\n" + groups, "a.in", {},
                of_reader);
  EXPECT_FALSE(of_reader.has_errors());
  const Path path = path_of(deck, diagnostics);
  Seen all{path, deck_of_path(deck, path, diagnostics), {}, {}, {}};
  for (const auto& remark : diagnostics.remarks()) all.remarks.push_back(remark.message);
  for (const auto& error : diagnostics.errors()) all.errors.push_back(error.message);
  for (const auto& warning : diagnostics.warnings()) all.warnings.push_back(warning.message);
  return all;
}

TEST(PathOfADeck, IsWhatItsGroupsAskFor) {
  EXPECT_EQ(seen("").path, Path::mpm);
  for (const char* group : {"mesh", "fem", "rigid", "flow"})
    EXPECT_EQ(seen(std::string("$") + group + " $\n").path, Path::fem);
  EXPECT_EQ(seen("$reg nreg=1 $\n$fem law(1)='fluid' $\n").path, Path::fem);
  const Seen coupled = seen("$coupled $\n$mesh $\n$mpm method='robust' $\n");
  EXPECT_EQ(coupled.path, Path::coupled);
  EXPECT_EQ(coupled.remarks, Texts{});
  EXPECT_TRUE(coupled.deck.has_group("mpm"));  // of which the path itself warns
}

TEST(PathOfADeck, IsWhatTheDeckNames) {
  const std::string all = "$mpm method='robust' $\n$mesh element='q2' $\n$fem cfl=.5 $\n$coupled density=2. $\n";
  const Seen mpm = seen(all, ",path='mpm'");
  EXPECT_EQ(mpm.path, Path::mpm);
  EXPECT_EQ(mpm.remarks, (Texts{"the mpm path has no use for $mesh", "the mpm path has no use for $fem",
                                "the mpm path has no use for $coupled"}));
  EXPECT_FALSE(mpm.deck.has_group("mesh") || mpm.deck.has_group("fem") || mpm.deck.has_group("coupled"));
  EXPECT_EQ(mpm.deck.text("mpm.method"), "robust");
  const Seen fem = seen(all, ",path='fem'");
  EXPECT_EQ(fem.path, Path::fem);
  EXPECT_EQ(fem.remarks, (Texts{"the fem path has no use for $mpm", "the fem path has no use for $coupled"}));
  EXPECT_EQ(fem.deck.text("mesh.element"), "q2");
  const Seen coupled = seen(all, ",path='coupled'");
  EXPECT_EQ(coupled.path, Path::coupled);
  EXPECT_EQ(coupled.remarks,
            (Texts{"the coupled path has no use for $mpm", "the coupled path has no use for cfl of $fem"}));
  EXPECT_FALSE(coupled.deck.given("fem.cfl"));
  EXPECT_EQ(coupled.deck.real("coupled.density"), 2);
}

TEST(PathOfADeck, LeavesExactSolutionsToPointsAndBars) {
  const std::string text = "$membrane $\n$mesh $\n$reference solution='pendulum' $\n";
  EXPECT_EQ(seen(text, ",path='mpm'").deck.text("reference.solution"), "pendulum");
  EXPECT_EQ(seen(text, ",path='bars'").deck.text("reference.solution"), "pendulum");
  const Seen fem = seen(text, ",path='fem'");
  EXPECT_EQ(fem.remarks, (Texts{"the fem path has no use for $membrane", "the fem path has no use for $reference"}));
  EXPECT_EQ(fem.deck.text("reference.solution"), "");
}

TEST(PathOfADeck, LeavesOutOfAGroupWhatIsOfPoints) {
  const Seen fem = seen("$reg nreg=1,nprg=9,densir(1)=2. $\n$points heavy(2)=1.,tracked_at(1,1)=0.,1. $\n$mesh $\n",
                        ",path='fem',wl=0");
  EXPECT_EQ(fem.remarks,
            (Texts{"the fem path has no use for nprg of $reg", "the fem path has no use for heavy of $points"}));
  EXPECT_EQ(fem.deck.integer("in.wl"), 0);
  EXPECT_EQ(fem.deck.real("reg.densir", 1), 2);
  EXPECT_TRUE(fem.deck.given("points.tracked_at", 2, 1));
  EXPECT_FALSE(fem.deck.given("points.heavy", 2));
  const Seen coupled = seen("$mesh $\n$coupled $\n", ",path='coupled',wl=0");
  EXPECT_EQ(coupled.remarks, Texts{"the coupled path has no use for wl of $in"});
}

TEST(PathOfADeck, OfStringsWithoutAMeshIsThatOfPoints) {
  const Seen bars = seen("$points heavy(2)=1. $\n$membrane wrinkle=.true. $\n", ",path='fem'");
  EXPECT_EQ(bars.path, Path::fem);
  EXPECT_EQ(bars.remarks, Texts{});
  EXPECT_EQ(bars.deck.real("points.heavy", 2), 1);
}

TEST(PathOfADeck, WarnsOfWhatActsOnTheSceneAndIsLeftOut) {
  const std::string all =
      "$mesh $\n$fem settle=.true.,static=.false.,load_on(1)='1.right',fix_on(1)='1.left' $\n"
      "$coupled jet_on(1)='left',spring_on(1)='region 1' $\n";
  EXPECT_EQ(seen(all, ",path='mpm'").warnings,
            (Texts{"the mpm path leaves settle of $fem out, which acts on the scene",
                   "the mpm path leaves load_on of $fem out, which acts on the scene",
                   "the mpm path leaves jet_on of $coupled out, which acts on the scene",
                   "the mpm path leaves spring_on of $coupled out, which acts on the scene"}));
  EXPECT_EQ(seen(all, ",path='fem'").warnings,
            (Texts{"the fem path leaves jet_on of $coupled out, which acts on the scene",
                   "the fem path leaves spring_on of $coupled out, which acts on the scene"}));
  EXPECT_EQ(seen(all, ",path='coupled'").warnings,
            Texts{"the coupled path leaves settle of $fem out, which acts on the scene"});
}

TEST(PathOfADeck, NeedsAFluidToBeCoupled) {
  EXPECT_EQ(seen("$mesh $\n", ",path='coupled'").errors, Texts{"the coupled path needs $coupled"});
}

TEST(PathOfADeck, IsNamedByTheCommandLine) {
  Diagnostics diagnostics;
  const Deck deck = read_deck("$in nx=2, path='fem' $\n$mesh $\n", "a.in", {}, diagnostics).with_path("mpm");
  EXPECT_EQ(path_of(deck, diagnostics), Path::mpm);
  EXPECT_EQ(deck.place("in.path").line, 1);
}

TEST(RegionsOfAPath, AreThoseThatTheDeckGivesIt) {
  const std::string regions = "$reg nreg=3,paths(2)='mpm fem',paths(3)='coupled' $\n$coupled $\n";
  const Seen mpm = seen(regions, ",path='mpm'");
  EXPECT_EQ(regions_of(mpm.deck), (std::vector<int>{1, 2}));
  EXPECT_EQ(mpm.remarks.front(), "the mpm path leaves regions of others out: 3");
  EXPECT_EQ(regions_of(seen(regions, ",path='coupled'").deck), (std::vector<int>{1, 3}));
  EXPECT_EQ(regions_of(seen(regions, ",path='bars'").deck), (std::vector<int>{1}));
  const Seen unnamed = seen(regions);
  EXPECT_EQ(regions_of(unnamed.deck), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(unnamed.warnings, Texts{"paths has no effect: the deck names no path"});
  EXPECT_EQ(seen("$reg nreg=1,paths(1)='mpm fme' $\n", ",path='mpm'").errors, Texts{"'fme' is no path"});
}

TEST(PathOfADeck, MakesBarsOfTheStringsOfADeckWithAMesh) {
  const Seen bars = seen("$mesh element='q2' $\n$fem cfl=.5 $\n$membrane wrinkle=.true. $\n", ",path='bars'");
  EXPECT_EQ(bars.path, Path::fem);
  EXPECT_FALSE(bars.deck.has_group("mesh"));
  EXPECT_TRUE(bars.deck.has_group("membrane"));
  EXPECT_EQ(bars.deck.real("fem.cfl"), 0.5);
}

}  // namespace
}  // namespace tether
