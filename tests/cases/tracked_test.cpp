// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Places that are tracked lie within elements, on all paths with a mesh.

namespace tether::cases {
namespace {

/// A bar of 1 pulled by E/100 along itself: what stands at x goes to 1.01 x, wherever nodes are.
TEST(Tracked, APlaceWithinAnElementMovesAsTheElementDoes) {
  for (const char* element : {"'q1'", "'q2'", "'p1'"}) {
    const DeckRun run =
        run_text("pulled", std::string("a bar\n$in nx=2,ny=2,xleft=-1.,xright=9.,ybot=-9.,ytop=9.,tmax=1.,tstep=1.,"
                                       "iout(33)=1,tiout(33)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,"
                                       "yvi(1,1)=-.1,-.1,.1,.1,densir(1)=1.,matr(1,1)=1.,0. $\n"
                                       "$mesh cells(1,1)=4,1,element=") +
                               element +
                               " $\n$fem static=.true.,law(1)='linear',fix_on(1)='1.left',fix(1:2,1)=0.,0.,"
                               "load_on(1)='1.right',load(1,1)=.01 $\n$points tracked_at(1,1)=.6,.03 $\n");
    EXPECT_NEAR(run.first("point_x_1"), 0.6, 1e-15);
    EXPECT_NEAR(run.last("point_x_1"), 0.6 * 1.01, 1e-12) << element;
    EXPECT_NEAR(run.last("point_y_1"), 0.03, 1e-12) << element;
    EXPECT_EQ(run.history.layout.point_names, std::vector<std::string>{"place (0.6, 0.03)"});
  }
}

struct Tracking {
  const char* deck;
  std::vector<std::string> overrides;
  std::vector<double> place;
};

TEST(Tracked, PlacesAreThoseAskedForOnEveryPath) {
  const std::vector<Tracking> all{
      {"l-block", {"points.tracked_at(1,1)=4.1", "points.tracked_at(2,1)=.7", "mesh.tracked_z(1)=1.3"}, {4.1, .7, 1.3}},
      {"rigid-body",
       {"points.tracked_at(1,1)=1.3", "points.tracked_at(2,1)=.7", "mesh.tracked_z(1)=.3"},
       {1.3, .7, .3}},
      {"disk", {"points.tracked_at(1,1)=.62", "points.tracked_at(2,1)=.41", "in.tmax=.02"}, {.62, .41}},
      {"coupled-bar", {"points.tracked_at(1,1)=.71", "points.tracked_at(2,1)=.33", "in.tmax=.04"}, {.71, .33}},
      {"coupled-bar-3d",
       {"points.tracked_at(1,1)=.71", "points.tracked_at(2,1)=.33", "mesh.tracked_z(1)=.37", "in.tmax=.04"},
       {.71, .33, .37}}};
  for (const Tracking& tracking : all) {
    auto overrides = tracking.overrides;
    if (tracking.deck[0] != 'd' && tracking.deck[0] != 'c') overrides.emplace_back("in.tmax=.2");
    const DeckRun run = run_deck(tracking.deck, overrides);
    for (std::size_t i = 0; i < tracking.place.size(); ++i)
      EXPECT_NEAR(run.first(std::string("point_") + "xyz"[i] + "_1"), tracking.place[i], 1e-14) << tracking.deck;
  }
}

/// A rigid body keeps the distances between places within elements.
TEST(Tracked, PlacesOfARigidBodyKeepTheirDistance) {
  const DeckRun run = run_deck("rigid-free", {"points.tracked_at(1,1)=.1", "points.tracked_at(2,1)=-.9",
                                              "points.tracked_at(1,2)=1.2", "points.tracked_at(2,2)=.3", "in.tmax=5."});
  const auto distance = [&](bool last) {
    double square = 0;
    for (const char axis : {'x', 'y', 'z'}) {
      const auto column = [&](const char* k) {
        const std::string name = std::string("point_") + axis + k;
        return last ? run.last(name) : run.first(name);
      };
      square += std::pow(column("_1") - column("_2"), 2);
    }
    return std::sqrt(square);
  };
  EXPECT_NEAR(distance(false), std::hypot(1.1, 1.2), 1e-14);
  EXPECT_NEAR(distance(true), distance(false), 1e-12);
}

}  // namespace
}  // namespace tether::cases
