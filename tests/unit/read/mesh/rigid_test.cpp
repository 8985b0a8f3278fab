// SPDX-License-Identifier: GPL-3.0-or-later
// What $rigid says becomes a rigid body of the scene; what a deck says beside it and that has no meaning is told.
#include "model/solids.hpp"

#include <gtest/gtest.h>

#include "read/path.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

/// Two boxes, of which the second is on lines 8 to 10; `groups` begin on line 12.
Built build_rigid(const std::string& groups, const std::vector<std::string>& overrides = {}) {
  Built built;
  const std::string text =
      "$in\nnx=2,ny=2,xleft=-5.,xright=5.,ybot=-5.,ytop=5.,tmax=2.,tstep=.01\nwl=1,wr=1,wb=1,wt=1\n$\n"
      "$reg\nnreg=2,nvi=4,4\nxvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.\nxvi(1,2)=1.,2.,2.,1.\nyvi(1,2)=0.,0.,1.,1.\n"
      "densir=1.,3. $\n$mesh z(1,1)=0.,1.,0.,1. $\n" +
      groups;
  const Deck deck = read_deck(text, "a.in", overrides, built.diagnostics);
  built.scene = build_scene(deck, std::nullopt, path_of(deck, built.diagnostics), built.diagnostics);
  return built;
}

TEST(RigidScene, OfAnEmptyGroupIsAFreeBodyAtRestAboutItsCentre) {
  const Built built = build_rigid("$rigid $\n");
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{});
  EXPECT_EQ(built.scene.path(), Path::fem);
  ASSERT_TRUE(built.scene.rigid() && built.scene.solids());
  const Rigid& rigid = *built.scene.rigid();
  EXPECT_EQ(rigid.form, RigidForm::reduced);
  EXPECT_FALSE(rigid.point || rigid.pin);
  EXPECT_EQ(rigid.directors, Eigen::Matrix3d::Identity());
  EXPECT_EQ(rigid.velocity, Eigen::Vector3d::Zero());
  EXPECT_EQ(rigid.unknowns(), 6);
  EXPECT_TRUE(rigid.forces.empty() && rigid.torques.empty());
}

TEST(RigidScene, HasWhatTheDeckSays) {
  const Built built = build_rigid(
      "$fem vrz=2*3. $\n$rigid form='constrained',point=1.,2.,3.,directors(1,2)=.5,2.,.25,omega=4.,5.,6.\n"
      "torque(1,3)=1.,2.,3.,torque_time(1,3)=0.,1.,torque_factor(1,3)=.5,.25\n"
      "force(1,1)=7.,8.,9.,force_at(1,1)=.1,.2,.3,turning(1)=.true. $\n",
      {"reg.vrx=2*1.", "reg.vry=2*2."});
  EXPECT_EQ(built.errors(), Texts{});
  const Rigid& rigid = *built.scene.rigid();
  EXPECT_EQ(rigid.unknowns(), 18);
  EXPECT_EQ(*rigid.point, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(rigid.directors.col(0), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(rigid.directors.col(1), Eigen::Vector3d(.5, 2, .25));
  EXPECT_EQ(rigid.velocity, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(rigid.omega, Eigen::Vector3d(4, 5, 6));
  ASSERT_EQ(rigid.torques.size(), 1u);
  EXPECT_EQ(rigid.torques[0].torque, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(rigid.torques[0].amplitude.at(.5), .375);
  ASSERT_EQ(rigid.forces.size(), 1u);
  EXPECT_EQ(rigid.forces[0].force, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(rigid.forces[0].at, Eigen::Vector3d(.1, .2, .3));
  EXPECT_TRUE(rigid.forces[0].turning);
  EXPECT_EQ(rigid.forces[0].amplitude.at(7), 1);
}

TEST(RigidScene, APinTakesUnknowns) {
  EXPECT_EQ(build_rigid("$rigid pin=0.,0.,0. $\n").scene.rigid()->unknowns(), 3);
  EXPECT_EQ(build_rigid("$rigid pin=0.,0.,0.,form='constrained' $\n").scene.rigid()->unknowns(), 21);
}

TEST(RigidScene, AllMistakesAreToldAtOnce) {
  const Built built = build_rigid(
      "$fem static=.true.,alpha=1.,integrator='trapezoid',fix_on(1)='1.left',\nspin(1,2)=1. $\n"
      "$rigid point=1.,pin=1.,2.,directors(1,1)=0.,0.,0.,force(1,2)=1.,0.,0.,turning(3)=.true. $\n",
      {"reg.vrx=1.,2."});
  const Texts expected{"12:13: a rigid body has no equilibrium to look for: loads move it",
                       "12:26: a rigid body has no damping",
                       "12:40: a rigid body has no steps by 'trapezoid'",
                       "12:62: a rigid body has no supports at its nodes",
                       "13:11: region 2 does not turn alone: it is part of a rigid body",
                       "14:14: point has 1 of its three components",
                       "14:24: pin has 2 of its three components",
                       "14:42: director 1 has length 0",
                       "1:12: region 2 moves with vrx = 2, region 1 with 1: they are one rigid body",
                       "14:62: force 2 has no place",
                       "14:82: turning(3) belongs to no force"};
  auto told = built.errors(), wanted = expected;
  std::sort(told.begin(), told.end()), std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(told, wanted);
}

TEST(RigidScene, WhatHasNoEffectIsAWarning) {
  EXPECT_EQ(warnings_of(build_rigid("$fem tolerance=1e-11,cfl=.9,integrator='midpoint' $\n$rigid $\n")), Texts{});
  EXPECT_EQ(warnings_of(build_rigid("$fem tolerance=1e-9,cfl=.5 $\n$rigid $\n")),
            (Texts{"tolerance of $fem has no effect on a rigid body", "cfl of $fem has no effect on a rigid body"}));
}

}  // namespace
}  // namespace tether::test
