// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

// Runs that go wrong: told once, and ended beyond reason.

namespace tether::cases {
namespace {

using Overrides = std::vector<std::string>;

std::size_t messages_of_limit(const DeckRun& run, const std::string& name) {
  return static_cast<std::size_t>(std::count_if(run.messages.begin(), run.messages.end(), [&](const auto& text) {
    return text.find("(" + name + " of $limits)") != std::string::npos;
  }));
}

std::string error_of(const std::string& name, const std::string& deck, const Overrides& overrides) {
  try {
    run_text(name, deck, overrides);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

/// A soft block that a load presses to a fraction of its volume.
const char* const pressed =
    "$in nx=3,ny=3,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=1.,tstep=.02,iout(33)=1,tiout(33)=.5,wl=1,wr=1,wb=1,wt=1 "
    "$\n"
    "$reg nreg=1,nvi=4,densir(1)=1.,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,matr(1,1)=100.,.0 $\n"
    "$mesh element='q1',cells(1,1)=3,3 $\n"
    "$fem law(1)='neo-hookean',fix_on(1)='1.bottom',fix(1:2,1)=0.,0.,load_on(1)='1.top',load(1:2,1)=0.,-150.,"
    "load_expression(1)='min(t*2,1)',alpha=20. $\n";

TEST(Limits, OfElementsAndBodies) {
  const DeckRun quiet = run_text("quiet", pressed);
  const double quality = quiet.summary.at("quality_least"), volume = quiet.summary.at("volume_worst");
  ASSERT_LT(volume, 0.5);
  ASSERT_GT(quality, 0.1);
  ASSERT_LE(quality, volume);
  EXPECT_EQ(messages_of_limit(quiet, "quality"), 0u);
  EXPECT_EQ(messages_of_limit(quiet, "volume"), 1u);
  const DeckRun strict = run_text("strict", pressed, {"limits.quality(1)=.99", "limits.volume(1)=0."});
  EXPECT_EQ(messages_of_limit(strict, "quality"), 1u);
  EXPECT_EQ(messages_of_limit(strict, "volume"), 0u);
  EXPECT_EQ(strict.summary.at("quality_least"), quality);
  const std::string text = error_of("stopped", pressed, {"limits.quality=.99,.9"});
  EXPECT_NE(text.find("below the limit of 0.9 (quality of $limits)"), std::string::npos) << text;
  EXPECT_NE(text.find("element "), std::string::npos) << text;
  EXPECT_NE(error_of("small", pressed, {"limits.volume=.99,.9"}).find("body 1"), std::string::npos);
}

/// Elements of order 2 fold where those of order 1 are too stiff to: the first that is turned inside out ends the run,
/// and of a law that bears any volume the first that has next to none.
TEST(Limits, OfElementsThatAreTurnedInsideOut) {
  for (const char* dilatation : {"point", "mean"}) {
    const Overrides folded{"mesh.element='q2'", std::string("fem.dilatation='") + dilatation + "'"};
    const std::string text = error_of("folded", pressed, folded);
    EXPECT_NE(text.find("the least volume of an element over that at the start is -"), std::string::npos) << text;
    EXPECT_NE(text.find("below the limit of 1e-09 (quality of $limits)"), std::string::npos) << text;
    Overrides other = folded;
    other.push_back("fem.law(1)='svk'");
    const std::string soft = error_of("soft", pressed, other);
    EXPECT_NE(soft.find("below the limit of 0.001 (quality of $limits)"), std::string::npos) << soft;
  }
}

/// A block of two cells that flies to and fro between walls.
const char* const thrown =
    "$in nx=11,ny=11,igen=1,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=4.,tstep=2.d-3,wl=6,wr=6,wb=6,wt=6 $\n"
    "$reg nreg=1,nvi=4,xvi(1,1)=.3,.5,.5,.3,yvi(1,1)=.3,.3,.5,.5,rex=1.,rey=1.,nprg=4,densir=1.,\n"
    "ipath(1,1)=3,3,3,0,matr(1,1)=100.,.3,vrx=1.,vry=.5 $\n";

TEST(Losses, OfAMethodThatDampsMostOfTheMotionAreToldOnce) {
  const auto told_losses = [](const DeckRun& run) {
    return std::count_if(run.messages.begin(), run.messages.end(),
                         [](const auto& text) { return text.find("the method itself lost") != std::string::npos; });
  };
  const DeckRun damped = run_text("damped", thrown, {"mpm.method='robust'"});
  ASSERT_GT(damped.summary.at("energy_lost"), 0.9);
  EXPECT_EQ(told_losses(damped), 1);
  EXPECT_EQ(told_losses(run_text("kept", thrown)), 0);  // the thesis' method gains
  // A block that all but rests at a wall loses next to nothing, though that is most of its motion.
  const DeckRun still =
      run_text("still", thrown, {"mpm.method='robust'", "reg.vrx=1e-9", "reg.vry=0.", "reg.xvi(1:4,1)=.8,1.,1.,.8"});
  ASSERT_GT(still.summary.at("energy_lost"), 0.5);
  EXPECT_EQ(told_losses(still), 0);
}

/// A bar by steps a fifth above their limit, whose energy grows by up to 19 times between records.
TEST(Limits, OfTheEnergy) {
  const Overrides wild{"mpm.cfl=1.2",        "in.tstep=1.",        "in.dtmax=1.",
                       "in.tiout(33)=1.d-4", "in.tiout(34)=1.d-4", "limits.energy_growth(2)=0."};
  const DeckRun run = run_deck("stability-side", wild);
  EXPECT_GT(run.summary.at("energy_growth"), 1e20);
  EXPECT_GT(run.summary.at("energy_step_largest"), 15);
  EXPECT_EQ(messages_of_limit(run, "energy_growth"), 1u);
  EXPECT_EQ(messages_of_limit(run, "energy_step"), 1u);
  Overrides off = wild;
  off.push_back("limits.energy_step(1)=0.");
  off.push_back("limits.energy_growth(1)=0.");
  EXPECT_TRUE(run_deck("stability-side", off).messages.empty());
  for (const char* stop :
       {"limits.energy_step=.5,10.", "limits.energy_growth=.05,1.", "limits.energy_growth=.05,100."}) {
    Overrides strict = wild;
    strict.emplace_back(stop);
    try {
      run_deck("stability-side", strict);
      ADD_FAILURE() << "it ran to its end with " << stop;
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("of $limits): likely cause"), std::string::npos) << error.what();
    }
  }
}

/// A stiff block that turns as it lands: a step of .02 stretches it by the square of the angle that it turns by.
TEST(Limits, OfABlockThatTurnsTooFar) {
  const char* const turning =
      "$in nx=17,ny=17,xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=1.,tstep=.02,gravc=-9.81,iout(33)=1,tiout(33)=.02 $\n"
      "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e8,.3,vrx(1)=1.,xvi(1,1)=.89,1.18,1.11,.82,"
      "yvi(1,1)=.45,.56,.75,.64 $\n$mesh element='p1',cells(1,1)=4,4 $\n"
      "$coupled density=1e-3,side(1)='open','open','wall','open',friction=.8,integrator='trapezoid' $\n";
  const DeckRun run = run_text("turning", turning, {"limits.energy_growth(2)=0."});
  EXPECT_GT(run.summary.at("energy_growth"), 100);
  EXPECT_EQ(messages_of_limit(run, "energy_step"), 1u);
  const std::string text = error_of("turning", turning, {});
  EXPECT_NE(text.find("above the limit of 100 (energy_growth of $limits)"), std::string::npos) << text;
}

/// By the paper's two maps the fluid does not give what the solids take, and the trapezoidal rule damps nothing: a
/// light block on a spring gains .29 of what is exchanged, a soft one in wide cells runs away.
TEST(Limits, OfThePapersMapsByTheTrapezoidalRule) {
  const char* const swimming =
      "$in nx=10,ny=10,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=6.,tstep=.01,iout(33)=1,tiout(33)=.01 $\n"
      "$reg nreg=1,nvi=4,densir(1)=5.,xvi(1,1)=.4,.6,.6,.4,yvi(1,1)=.4,.4,.6,.6,matr(1,1)=1e8,.3,vrx(1)=.002 $\n"
      "$mesh element='p1',cells(1,1)=4,4 $\n$coupled density=1000.,side(1)='open','wall',spring_on(1)='region 1',\n"
      "spring(1:2,1)=3000.,3000.,integrator='trapezoid',mode='paper' $\n";
  const DeckRun run = run_text("swimming", swimming);
  EXPECT_GT(run.summary.at("energy_rise"), 0.2);
  EXPECT_EQ(messages_of_limit(run, "energy_growth"), 1u);
  EXPECT_EQ(messages_of_limit(run, "splitting"), 1u);
  EXPECT_EQ(messages_of_limit(run_text("swimming", swimming, {"coupled.mode='cut-cell'"}), "energy_growth"), 0u);
  const Overrides soft{"in.nx=12",          "in.ny=12",       "reg.densir(1)=500.",
                       "reg.matr(1,1)=2e4", "reg.vrx(1)=.05", "coupled.side(2)='open'"};
  EXPECT_NE(error_of("swimming", swimming, soft), "");
}

// Steps above their limit between two records far apart: the run ends by what its energy shows, before points leave.
TEST(Limits, AreLookedAtBetweenRecords) {
  const Overrides wild{"mpm.cfl=1.06", "in.tstep=1.",      "in.dtmax=1.",
                       "in.tmax=10.",  "in.tiout(33)=10.", "in.tiout(34)=10."};
  std::string text = "it ran to its end";
  try {
    run_deck("stability-side", wild);
  } catch (const RunError& error) {
    text = error.what();
  }
  EXPECT_NE(text.find("above the limit of 100 (energy_step of $limits)"), std::string::npos) << text;
}

/// A soft block of points between slip walls that its weight presses together.
TEST(Limits, OfTheVolumesOfPoints) {
  const char* const block =
      "$in nx=6,ny=13,xleft=0.,xright=.5,ybot=0.,ytop=1.2,tmax=.3,tstep=.001,gravc=-150.,wl=6,wr=6,wb=6,wt=1,\n"
      "iout(33)=1,tiout(33)=.01 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,.5,.5,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=1.,nprg=4,\n"
      "ipath(1,1)=3,3,3,0,matr(1,1)=100.,0. $\n$mpm method='robust' $\n";
  const DeckRun run = run_text("block", block);
  EXPECT_EQ(messages_of_limit(run, "volume"), 1u);
  const auto volume = run.history.column("body_volume_1");
  EXPECT_NEAR(volume.front(), 0.5, 1e-12);
  EXPECT_NEAR(*std::min_element(volume.begin(), volume.end()) / 0.5, run.summary.at("volume_worst"), 1e-3);
  EXPECT_NE(error_of("stopped", block, {"limits.volume=.9,.7"}).find("of body 1, below the limit of 0.7"),
            std::string::npos);
}

/// What is right is not told of.
TEST(Limits, AreNotReachedByWhatIsRight) {
  for (const char* deck : {"pendulum-20", "spring-mass", "l-block", "coupled-piston"}) {
    const DeckRun run = run_deck(deck, {"in.tmax=" + std::string(deck[0] == 's' ? "2.d-2" : ".3")});
    for (const char* name : {"quality", "volume", "energy_step", "energy_growth", "splitting", "cfl"})
      EXPECT_EQ(messages_of_limit(run, name), 0u) << deck << " " << name;
    EXPECT_LT(run.summary.at("energy_step_largest"), 0.1) << deck;
  }
}

}  // namespace
}  // namespace tether::cases
