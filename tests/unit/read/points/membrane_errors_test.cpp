// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "unit/read/points/membranes_support.hpp"

namespace tether::test {
namespace {

TEST(MembraneErrors, EverythingThatIsMissingIsTold) {
  EXPECT_EQ(membranes("curve(1)='line',x(1,1)=0.,1.,y(1,1)=0.,0.").errors(),
            (Texts{"5:10: membrane 1: young(1) is not given", "5:10: membrane 1: density(1) is not given",
                   "5:10: membrane 1: thickness(1) is not given",
                   "5:10: membrane 1: neither count(1) nor spacing(1) is given"}));
}

TEST(MembraneErrors, CountAndSpacing) {
  EXPECT_EQ(one_line("count(1)=4,spacing(1)=.2").errors(),
            (Texts{"7:23: membrane 1: count(1) and spacing(1) are both given"}));
  EXPECT_EQ(one_line("spacing(1)=1.").errors(), (Texts{"7:12: membrane 1: too few points on a length of 0.8: 1"}));
  EXPECT_EQ(one_line("spacing(1)=8e-6").scene.points.size(), 100000u);
  EXPECT_EQ(one_line("spacing(1)=1e-6").errors(),
            (Texts{"7:12: membrane 1: 800000 points on a length of 0.8 are too many"}));
  const Texts huge = one_line("spacing(1)=1e-300").errors();
  ASSERT_EQ(huge.size(), 1u);
  EXPECT_TRUE(huge[0].starts_with("7:12: membrane 1: 5 x 5 nodes and 8e+299 points would need ")) << huge[0];
}

TEST(MembraneErrors, AClosedOneHasNoEndToPinAndThreePoints) {
  const std::string circle = std::string("curve(1)='arc',xc(1)=.5,yc(1)=.5,a(1)=.4\n") + membrane_properties;
  EXPECT_EQ(membranes(circle + "count(1)=9,pinned(1)='first'").errors(),
            (Texts{"7:22: membrane 1: it is closed and has no end to pin"}));
  EXPECT_EQ(membranes(circle + "count(1)=2").errors(),
            (Texts{"7:10: membrane 1: too few points on a length of 2.51327: 2"}));
}

Texts curve_errors(const std::string& curve) {
  return membranes(curve + "\n" + membrane_properties + "count(1)=5").errors();
}

TEST(MembraneErrors, ValuesThatAKindOfCurveNeeds) {
  EXPECT_EQ(curve_errors("curve(1)='line'"), (Texts{"5:10: curve 1: a line has 2 vertices, not 0"}));
  EXPECT_EQ(curve_errors("curve(1)='line',x(1,1)=0.,.5,1.,y(1,1)=0.,0.,0."),
            (Texts{"5:10: curve 1: a line has 2 vertices, not 3"}));
  EXPECT_EQ(curve_errors("curve(1)='spline',x(1,1)=0.,y(1,1)=0."),
            (Texts{"5:10: curve 1: a spline has at least 2 vertices, not 1"}));
  EXPECT_EQ(curve_errors("curve(1)='polyline',x(1,1)=0.,.5,1.,y(1,1)=0.,0."),
            (Texts{"5:34: curve 1: y(3,1) is not given"}));
  EXPECT_EQ(curve_errors("curve(1)='polyline',x(1,1)=0.,,1.,y(1,1)=0.,,0."),
            (Texts{"5:10: curve 1: x(2,1) is not given"}));
  EXPECT_EQ(curve_errors("curve(1)='arc'"), (Texts{"5:10: curve 1: a(1) is not given"}));
  EXPECT_EQ(curve_errors("curve(1)='ellipse'"),
            (Texts{"5:10: curve 1: a(1) is not given", "5:10: curve 1: b(1) is not given"}));
}

TEST(MembraneErrors, CurvesThatAreNone) {
  EXPECT_EQ(curve_errors("curve(1)='arc',a(1)=.1,from(1)=40.,to(1)=40."), (Texts{"5:10: curve 1: it has no length"}));
  EXPECT_EQ(curve_errors("curve(1)='arc',a(1)=.1,from(1)=-10."),
            (Texts{"5:10: curve 1: from -10 to 360 degrees it covers itself"}));
  EXPECT_EQ(curve_errors("curve(1)='polyline',x(1,1)=0.,.5,.5,y(1,1)=0.,.1,.1"),
            (Texts{"5:34: curve 1: vertices 2 and 3 are at one place"}));
  EXPECT_EQ(curve_errors("curve(1)='spline',x(1,1)=0.,.5,0.,y(1,1)=0.,.1,0."),
            (Texts{"5:10: curve 1: a closed spline needs 3 vertices and the first once more, not 2"}));
}

TEST(MembraneErrors, AGapBetweenJoinedCurvesIsToldWithBothEnds) {
  const std::string first = "curve(1)='line',x(1,1)=0.,.5,y(1,1)=.2,.2\n";
  const Built gap =
      membranes(first + "curve(2)='line',x(1,2)=.5,1.,y(1,2)=.3,.2\n" + membrane_properties + "count(1)=5");
  EXPECT_EQ(gap.errors(), (Texts{"6:10: curve 2 begins at (0.5, 0.3), 0.1 from (0.5, 0.2), where curve 1 ends"}));
  EXPECT_EQ(gap.diagnostics.errors()[0].hint, "curves of one membrane are joined in the order of their numbers");
  const Built turned =
      membranes(first + "curve(2)='line',x(1,2)=1.,.5,y(1,2)=.2,.2\n" + membrane_properties + "count(1)=5");
  ASSERT_EQ(turned.diagnostics.errors().size(), 1u);
  EXPECT_EQ(turned.diagnostics.errors()[0].hint, "its other end would meet: give it the other way round");
}

TEST(MembraneErrors, PointsOutsideTheGridStandAtTheirCurve) {
  const Built built = membranes(std::string("curve(1)='line',x(1,1)=0.,1.,y(1,1)=.5,.5\n") +
                                "curve(2)='line',x(1,2)=1.,1.5,y(1,2)=.5,.5\n" + membrane_properties + "count(1)=6");
  EXPECT_EQ(built.errors(), (Texts{"6:10: membrane 1: points outside the grid: 2 of 6, the first at (1.125, 0.5)"}));
}

TEST(MembraneErrors, APointOnTheAxis) {
  const std::string disc =
      std::string("curve(1)='line',x(1,1)=0.,.5,y(1,1)=.5,.5\n") + membrane_properties + "count(1)=5\n";
  EXPECT_EQ(membranes(disc, "cyl=1.,wl=5\n").errors(), Texts{});
  EXPECT_EQ(membranes(disc + "pinned(1)='first',strain='element'", "cyl=1.,wl=5\n").errors(),
            (Texts{"6:10: membrane 1: points on the axis: 1 of 5, the first at (0, 0.5)"}));
}

TEST(MembraneErrors, ValuesOfAMembraneWithoutCurvesOrOfACurveWithoutKind) {
  EXPECT_EQ(one_line("count(1)=4,thickness(2)=.1,density(2)=1.").errors(),
            (Texts{"7:25: thickness(2) is given, and no curve belongs to membrane 2"}));
  EXPECT_EQ(one_line("count(1)=4,wrinkle(3)=.false.").errors(),
            (Texts{"7:23: wrinkle(3) is given, and no curve belongs to membrane 3"}));
  EXPECT_EQ(one_line("count(1)=4,x(1,2)=.1,.2,y(1,2)=.1,.2,a(3)=1.").errors(),
            (Texts{"7:19: curve(2) is not given", "7:43: curve(3) is not given"}));
  EXPECT_EQ(build(square_region() + "$membrane law='plane-stress',wrinkle=.false. $\n").errors(), Texts{});
}

TEST(MembraneErrors, PoissonsRatioOfPlaneStress) {
  EXPECT_EQ(one_line("count(1)=4,law(1)='plane-stress',poisson(1)=-1.").errors(),
            (Texts{"7:45: membrane 1: Poisson's ratio -1 is out of range"}));
}

TEST(MembraneWarnings, ValuesWithoutEffect) {
  EXPECT_EQ(warnings(one_line("count(1)=4,poisson(1)=.3")),
            (Texts{"7:23: membrane 1: poisson(1) has no effect: law(1) is 'uniaxial'"}));
  EXPECT_EQ(warnings(one_line("count(1)=4,b(1)=.3,from(1)=10.")),
            (Texts{"7:17: curve 1: b(1) has no effect on a curve 'line'",
                   "7:28: curve 1: from(1) has no effect on a curve 'line'"}));
  const std::string arc =
      std::string("curve(1)='arc',xc(1)=.5,yc(1)=.5,a(1)=.4\n") + membrane_properties + "count(1)=5\n";
  EXPECT_EQ(warnings(membranes(arc + "b(1)=.2")), (Texts{"8:6: curve 1: b(1) has no effect on a curve 'arc'"}));
  EXPECT_EQ(warnings(membranes(arc + "y(2,1)=.2")), (Texts{"8:8: curve 1: y(2,1) has no effect on a curve 'arc'"}));
}

}  // namespace
}  // namespace tether::test
