// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

TEST(BuildScene, GridAndGravity) {
  const Scene scene = build(square_region("gravc=-9.8"), {"in.xleft=-1.", "in.ytop=1.5"}).scene;
  EXPECT_EQ(scene.grid.nx, 5);
  EXPECT_EQ(scene.grid.ny, 5);
  EXPECT_EQ(scene.grid.x0, -1);
  EXPECT_EQ(scene.grid.y1, 1.5);
  EXPECT_EQ(scene.grid.dx, 0.5);
  EXPECT_EQ(scene.grid.dy, 0.375);
  EXPECT_EQ(scene.gravity, -9.8);
}

TEST(BuildScene, PhysicsByGroupsAndPath) {
  const auto physics = [](const std::string& groups, Path path) {
    Diagnostics diagnostics;
    const Deck deck = read_deck(on_unit_square("igen=1\n$\n" + groups), "a.in", {}, diagnostics);
    return build_scene(deck, std::nullopt, path, diagnostics).physics;
  };
  EXPECT_TRUE(std::holds_alternative<MaterialPoints>(physics("", Path::mpm)));
  EXPECT_TRUE(std::holds_alternative<Bars>(physics("", Path::fem)));
  EXPECT_TRUE(std::holds_alternative<ElasticBodies>(physics("$mesh element='q1' $\n", Path::fem)));
  EXPECT_TRUE(std::holds_alternative<RigidBody>(physics("$mesh element='q1' $\n$rigid $\n", Path::fem)));
  EXPECT_TRUE(std::holds_alternative<MeshFlow>(physics("$mesh element='q1' $\n$flow $\n", Path::fem)));
  EXPECT_TRUE(std::holds_alternative<BoxFlow>(physics("$mesh element='p1' $\n$coupled $\n", Path::coupled)));
  EXPECT_EQ(path_of(Bars{}), Path::fem);
  EXPECT_EQ(path_of(BoxFlow{}), Path::coupled);
}

TEST(BuildScene, WallsByTheDecksNumbers) {
  const Walls walls = build(square_region("wl=0,wr=1,wb=4,wt=5")).scene.walls;
  EXPECT_EQ(walls.left, Wall::fixed);
  EXPECT_EQ(walls.right, Wall::open);
  EXPECT_EQ(walls.bottom, Wall::symmetry);
  EXPECT_EQ(walls.top, Wall::axis);
  EXPECT_EQ(build(square_region()).scene.walls.left, Wall::free_slip);
}

TEST(BuildScene, StepIsTheSmallerOfTstepAndDtmax) {
  EXPECT_EQ(build(square_region()).scene.clock.tstep, 0.01);
  EXPECT_EQ(build(square_region("dtmax=.002")).scene.clock.tstep, 0.002);
  EXPECT_EQ(build(square_region("dtmax=.5")).scene.clock.tstep, 0.01);
  EXPECT_EQ(build(square_region()).scene.clock.tmax, 2);
}

TEST(BuildScene, FactorOfTheStepLimitAndOrderOfTheStressUpdate) {
  const Scene plain = build(square_region()).scene;
  EXPECT_EQ(plain.clock.cfl, 1);
  EXPECT_EQ(plain.method.order, StressOrder::musl);
  const Scene other = build(square_region(), {"mpm.cfl=0", "mpm.order='usf'"}).scene;
  EXPECT_EQ(other.clock.cfl, 0);
  EXPECT_EQ(other.method.order, StressOrder::usf);
  EXPECT_EQ(build(square_region(), {"mpm.order='usl'"}).scene.method.order, StressOrder::usl);
}

TEST(BuildScene, TitleAndUnits) {
  EXPECT_EQ(build("a title\nof two lines\n" + square_region("units='si'")).scene.title, "a title\nof two lines");
  EXPECT_EQ(build(square_region("units='si'")).scene.units, Units::si);
  EXPECT_EQ(build(square_region("units='cgs'")).scene.units, Units::cgs);
  EXPECT_EQ(build(square_region()).scene.units, Units::none);
}

TEST(BuildSceneErrors, EdgesThatAreNotInOrder) {
  EXPECT_EQ(build(square_region(), {"in.xright=0.", "in.ytop=-1."}).errors(),
            (Texts{"1:11: xright = 0 is not above xleft = 0", "2:9: ytop = -1 is not above ybot = 0"}));
}

TEST(BuildSceneErrors, NodesThatCoincideInFloatingPoint) {
  EXPECT_EQ(build(square_region(), {"in.xleft=1e16", "in.xright=1.0000000000000004e16"}).errors(),
            (Texts{"2:11: xright = 1e+16 is so close to xleft = 1e+16"}));
  EXPECT_EQ(build(square_region(), {"in.xright=1e-310"}).errors(),  // 1/dx is infinite
            (Texts{"1:11: xright = 1e-310 is so close to xleft = 0"}));
}

TEST(BuildScene, GeometryByCyl) {
  EXPECT_EQ(build(square_region()).scene.geometry, Geometry::plane);
  EXPECT_EQ(build(square_region("cyl=0.")).scene.geometry, Geometry::plane);
  EXPECT_EQ(build(square_region("cyl=1.")).scene.geometry, Geometry::axisymmetric);
}

TEST(BuildScene, WallsThatCanStandOnTheAxis) {
  for (const char* wall : {"4", "5", "6"})
    EXPECT_EQ(build(square_region(std::string("cyl=1.,wl=") + wall)).errors(), Texts{});
  EXPECT_EQ(build(square_region("cyl=1.,wl=0"), {"in.xleft=.25"}).errors(), Texts{});  // a hollow body
}

TEST(BuildSceneErrors, WallsThatCannotStandOnTheAxis) {
  for (const std::string wall : {"0", "1"}) {
    EXPECT_EQ(build(square_region("cyl=1.,wl=" + wall)).errors(),
              (Texts{"3:11: wl = " + wall + " stands on the axis"}));
    EXPECT_EQ(build(square_region("wl=" + wall)).errors(), Texts{});
  }
}

TEST(BuildSceneErrors, AGridBeyondTheAxis) {
  EXPECT_EQ(build(square_region("cyl=1."), {"in.xleft=-.5"}).errors(),
            (Texts{"1:10: xleft = -0.5 lies beyond the axis"}));
}

TEST(BuildSceneErrors, PlaneStressAboutAnAxis) {
  EXPECT_EQ(build(square_region("cyl=1.", "ipath(4,1)=2")).errors(),
            (Texts{"10:12: region 1: plane stress has no meaning about an axis, where the hoop carries too"}));
  EXPECT_EQ(build(square_region("cyl=1.", "ipath(4,1)=8")).errors(), Texts{});
  std::string file = string_deck("", "igen=0,cyl=1.");
  file.replace(file.find("3,3,3,8"), 7, "3,3,3,2");
  EXPECT_EQ(build(file).errors(),
            (Texts{"7:1: plane stress has no meaning about an axis, where the hoop carries too"}));
}

TEST(BuildScene, PressureAroundMembranes) {
  const std::string ambient = "$fluid pambient=7. $\n";
  const Built string = build(string_deck(ambient));
  EXPECT_EQ(string.scene.ambient, 7);
  EXPECT_TRUE(string.diagnostics.warnings().empty());
  const auto warnings = build(square_region() + ambient).diagnostics.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "pambient = 7 has no effect: there is no membrane");
  EXPECT_TRUE(build(square_region() + "$fluid pambient=0. $\n").diagnostics.warnings().empty());
}

TEST(BuildSceneErrors, AGridBeyondTheMemory) {
  const Texts errors = build(square_region(), {"in.nx=1000000", "in.ny=1000000"}).errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(errors[0].starts_with("1:7: 1000000 x 1000000 nodes and 0 points would need ")) << errors[0];
}

OutputIntervals outputs(const std::string& in) { return build(square_region(in)).scene.outputs; }

TEST(Outputs, HistoryTakesTheShortestOfItsIntervals) {
  EXPECT_EQ(outputs("iout(33)=1,tiout(33)=.3,iout(34)=1,tiout(34)=.2,iout(38)=1,tiout(38)=.5").history, .2);
  EXPECT_EQ(outputs("iout(33)=1,tiout(33)=.3").history, .3);
  EXPECT_EQ(outputs("iout(38)=1,tiout(38)=.5").history, .5);
  EXPECT_EQ(outputs("iout(33)=1,tiout(33)=.3,iout(34)=0,tiout(34)=.1").history, .3);  // 34 is off
}

TEST(Outputs, AHistoryThatIsOffHas200Records) {
  const OutputIntervals none = outputs("");
  EXPECT_EQ(none.history, 0.01);  // tmax = 2
  EXPECT_EQ(none.points, 0);
  EXPECT_EQ(none.grid, 0);
}

TEST(Outputs, PointFieldsAndGridFieldsByTheirSwitches) {
  for (const int k : {13, 32, 35, 36, 40}) {
    const std::string n = std::to_string(k);
    const OutputIntervals one = outputs("iout(" + n + ")=1,tiout(" + n + ")=.25");
    EXPECT_EQ(one.points, .25) << k;
    EXPECT_EQ(one.grid, 0) << k;
  }
  for (const int k : {30, 31, 37, 39}) {
    const std::string n = std::to_string(k);
    const OutputIntervals one = outputs("iout(" + n + ")=1,tiout(" + n + ")=.25");
    EXPECT_EQ(one.grid, .25) << k;
    EXPECT_EQ(one.points, 0) << k;
  }
  EXPECT_EQ(outputs("iout(13)=1,tiout(13)=.25,iout(36)=1,tiout(36)=.125").points, .125);
}

TEST(Outputs, AngleOfTwoTrackedPoints) {
  const std::string on = "igen=0,iout(38)=1,tiout(38)=.1";
  const std::string two = "$points tracked(1)=.true.,tracked(3)=.true. $\n", one = "$points tracked(1)=.true. $\n";
  EXPECT_TRUE(build(string_deck(two, on)).scene.outputs.tracked_angle);
  EXPECT_FALSE(build(string_deck(one, on)).scene.outputs.tracked_angle);
  EXPECT_FALSE(build(string_deck(two)).scene.outputs.tracked_angle);
}

TEST(Outputs, EverySwitchThatIsOnNeedsItsInterval) {
  EXPECT_EQ(build(square_region("iout(13)=1,iout(34)=1,iout(39)=1")).errors(),
            (Texts{"3:21: iout(34)=1 needs its interval tiout(34)", "3:10: iout(13)=1 needs its interval tiout(13)",
                   "3:32: iout(39)=1 needs its interval tiout(39)"}));
}

TEST(Clock, AStepAboveTheLargestIsTold) {
  const auto built = build(square_region("dtmax=.001"), {"in.tstep=.002"});
  EXPECT_EQ(built.scene.clock.tstep, .001);
  const auto warnings = built.diagnostics.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "tstep = 0.002 is above dtmax = 0.001: steps are no longer than dtmax");
  EXPECT_TRUE(build(square_region("dtmax=.002"), {"in.tstep=.001"}).diagnostics.warnings().empty());
}

TEST(Outputs, CheckpointsByTheirSwitch) {
  EXPECT_EQ(outputs("iout(41)=1,tiout(41)=.25").checkpoint, .25);
  EXPECT_EQ(outputs("iout(41)=0,tiout(41)=.25").checkpoint, 0);
}

TEST(Outputs, SwitchesThatWriteNothingAreTold) {
  const auto warnings = build(square_region("iout(41)=1,tiout(41)=1.,iout(12)=1,tiout(12)=1.")).diagnostics.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "iout(12)=1 writes nothing");
}

/// A string, let hang, as the solutions of chapter 5 need it.
Texts reference_errors(const std::string& solution, const std::string& points, const std::string& in) {
  return build(resting_string_deck(points + "$reference solution='" + solution + "' $\n", in)).errors();
}

TEST(Reference, IsNamedByTheDeck) {
  const std::string groups = "$points tracked(3)=.true. $\n$reference solution='pendulum' $\n";
  EXPECT_EQ(build(resting_string_deck(groups, "igen=0,gravc=-1.")).scene.reference, ReferenceKind::pendulum);
  EXPECT_EQ(build(square_region()).scene.reference, ReferenceKind::none);
}

TEST(Reference, OfAStringNeedsRestGravityAndItsLastPointTracked) {
  const std::string needs =
      "6:21: the solution 'spring' needs a string from a particle file that begins at rest, its last point tracked, "
      "and gravc < 0";
  const std::string last = "$points tracked(3)=.true. $\n";
  EXPECT_EQ(reference_errors("spring", last, "igen=0,gravc=-1."),
            Texts{"6:21: the solution 'spring' needs a string that hangs straight down from where it is held"});
  EXPECT_EQ(reference_errors("spring", last, "igen=0"), (Texts{needs}));
  EXPECT_EQ(reference_errors("spring", "$points $\n", "igen=0,gravc=-1."), (Texts{needs}));
  EXPECT_EQ(reference_errors("spring", "$points tracked(1)=.true. $\n", "igen=0,gravc=-1."), (Texts{needs}));
  const std::string moving = string_deck(last + "$reference solution='spring' $\n", "igen=0,gravc=-1.");
  EXPECT_EQ(build(moving).errors(), (Texts{needs}));
}

TEST(Reference, OfTheRiemannProblemNeedsTwoGases) {
  EXPECT_EQ(build(square_region() + "$reference solution='riemann' $\n").errors(),
            (Texts{"12:21: the solution 'riemann' needs two regions of gas, left and right, and nothing else"}));
}

TEST(Reference, OfThePistonNeedsItsFluid) {
  EXPECT_EQ(
      reference_errors("piston", "$points tracked(3)=.true. $\n", "igen=0"),
      (Texts{
          "6:21: the solution 'piston' needs a linear fluid, a spring from a particle file, its last point tracked"}));
}

}  // namespace
}  // namespace tether::test
