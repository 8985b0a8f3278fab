// SPDX-License-Identifier: GPL-3.0-or-later
// Which probes and bodies are within a fluid, and where probes beside it go.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "grid/point_finder.hpp"
#include "read/flow/checks.hpp"
#include "unit/read/flow/flow_support.hpp"

namespace tether::test {
namespace {

TEST(FlowPlaces, TheEdgesOfAFluidAreInIt) {
  const auto errors = [](const std::string& at) { return ring("q2q1", 4, "probe(1,1)=" + at).errors(); };
  EXPECT_EQ(errors("2.,0."), Texts{});
  EXPECT_EQ(errors("0.,1."), Texts{});
  EXPECT_EQ(errors("1.4142135623730951,1.4142135623730951"), Texts{});
  EXPECT_EQ(errors("1.2,-.7"), Texts{});
  EXPECT_EQ(errors("0.,0.").size(), 1u);
  EXPECT_EQ(errors("0.,5.").size(), 1u);
  EXPECT_EQ(warnings_of(ring("q2q1", 4, "probe(1,1)=0.,2.,1.2,-.7")), Texts{});
}

/// A ring of radius 1 to 2 and elements of the size .76: half of that is the most that a probe is moved.
TEST(FlowPlaces, AProbeBesideAnEdgeIsMovedToIt) {
  const Built near = ring("q2q1", 4, "probe(1,3)=2.001,0.,1.5,0.,\nprobe(1,5)=0.,.999,difference(1,1)=5,3");
  EXPECT_EQ(near.errors(), Texts{});
  ASSERT_EQ(warnings_of(near).size(), 2u);
  const std::string told = "probe 3 at (2.001, 0) lies outside the fluid's mesh by 0.001 and is moved to (2, ";
  EXPECT_EQ(warnings_of(near)[0].substr(0, told.size()), told);
  const Flow& flow = *near.scene.flow();
  ASSERT_EQ(flow.probes.size(), 3u);
  EXPECT_NEAR(flow.probes[0][0], 2, 1e-8);
  EXPECT_EQ(flow.probes[1], (std::array<double, 2>{1.5, 0}));
  EXPECT_NEAR(flow.probes[2][1], 1, 1e-8);
  EXPECT_EQ(flow.differences, (std::vector<std::array<int, 2>>{{2, 0}}));
  EXPECT_EQ(ring("q2q1", 4, "probe(1,1)=0.,2.37").errors(), Texts{});
  EXPECT_EQ(ring("q2q1", 4, "probe(1,1)=0.,2.42").errors(),
            Texts{"24:33: probe 1 at (0, 2.42) lies outside the fluid"});
}

/// All around, on the walls themselves: a chord of an edge of 90/n degrees is off its arc by 1 - cos(45/n) at most.
TEST(FlowPlaces, PlacesOnCurvedWallsAreMovedToPlacesThatAreFound) {
  for (const auto& [element, cells, most] :
       {std::tuple{"q1q1", 3, 2 * (1 - std::cos(std::numbers::pi / 12))}, {"q2q1", 2, 2e-3}}) {
    std::string probes;
    for (int k = 1; k <= 90; ++k) {
      const double angle = 0.0701 * k, r = k % 2 ? 2 : 1;
      probes += fmt::format("probe(1,{})={:.6f},{:.6f},\n", k, r * std::cos(angle), r * std::sin(angle));
    }
    const Built built = ring(element, cells, probes);
    ASSERT_EQ(built.errors(), Texts{});
    EXPECT_GT(warnings_of(built).size(), 40u);
    const PointFinder finder(built.scene.flow()->mesh);
    for (std::size_t k = 0; k < 90; ++k) {
      const auto& at = built.scene.flow()->probes[k];
      EXPECT_TRUE(finder.find(at)) << element << k;
      EXPECT_NEAR(std::hypot(at[0], at[1]), k % 2 ? 1 : 2, most * 1.001) << element << k;
    }
  }
}

/// A curved edge may bulge out of the box of its nodes: here from -15 degrees over 15 to 45.
TEST(FlowPlaces, TheBulgeOfAnEdgeIsInTheFluid) {
  const std::vector<std::string> graded{"mesh.grading(2,1)=2."};
  EXPECT_EQ(ring("q2q1", 2, "probe(1,1)=1.99,0.", "", graded).errors(), Texts{});
  EXPECT_EQ(warnings_of(ring("q2q1", 2, "probe(1,1)=1.99,0.", "", graded)), Texts{});
  EXPECT_EQ(warnings_of(ring("q2q1", 2, "probe(1,1)=2.01,0.", "", graded)).size(), 1u);
}

/// A body from radius 1.5 to the rim, whose nodes lie on a circle and the fluid's sides within it.
Built body_at_the_rim(const char* element, int cells) {
  std::string x = "xvi(1,5)=", y = ",\nyvi(1,5)=";
  for (const auto& [r, angle] : {std::pair{1.5, .1}, {2., .1}, {2., .6}, {1.5, .6}})
    x += fmt::format("{:.17g},", r * std::cos(angle)), y += fmt::format("{:.17g},", r * std::sin(angle));
  return ring(element, cells, "", x + y.substr(1) + "matr(1,5)=10.,.3 ",
              {"mesh.edge(2,5)='arc'", "mesh.edge(4,5)='arc'", "mesh.cells(1:2,5)=4,8"});
}

TEST(FlowPlaces, NodesOfBodiesOnRoundWallsAreMovedToThem) {
  for (const auto& [element, cells] : {std::pair{"q1q1", 4}, {"q1q1", 9}, {"q2q1", 2}}) {
    const Built built = body_at_the_rim(element, cells);
    ASSERT_EQ(built.errors(), Texts{}) << element << cells;
    EXPECT_EQ(warnings_of(built)[0].substr(0, 10), "region 5: ") << warnings_of(built)[0];
    const PointFinder finder(built.scene.flow()->mesh);
    const Mesh& mesh = built.scene.solids()->mesh;
    double farthest = 0;
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      EXPECT_TRUE(finder.find({mesh.x[2 * n], mesh.x[2 * n + 1]}));
      farthest = std::max(farthest, std::hypot(mesh.x[2 * n], mesh.x[2 * n + 1]));
    }
    EXPECT_GT(farthest, 1.95);
  }
  const Texts errors = body_at_the_rim("q1q1", 1).errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("lies outside the fluid"), std::string::npos) << errors[0];
}

TEST(FlowPlaces, BodiesLieWithinTheFluid) {
  const auto errors = [](const std::string& x, const std::string& y) {
    return ring("q2q1", 4, "", "xvi(1,5)=" + x + ",\nyvi(1,5)=" + y + ",matr(1,5)=10.,.3 ").errors();
  };
  EXPECT_EQ(errors("1.2,1.4,1.4,1.2", "-.1,-.1,.1,.1"), Texts{});
  EXPECT_EQ(errors(".8,1.4,1.4,.8", "-.1,-.1,.1,.1"),
            Texts{"17:10: region 5: its node at (0.8, -0.1) lies outside the fluid"});
}

TEST(FlowPlaces, BodiesStayOffInflowsAndMayTouchWalls) {
  const auto errors = [](const std::string& kind) {
    Built built = build_flow(
        "$reg nreg=2,nvi=4,4\nxvi(1,1)=.5,1.,1.,.5\nyvi(1,1)=0.,0.,.5,.5\nxvi(1,2)=0.,2.,2.,0.,"
        "yvi(1,2)=0.,0.,1.,1.\ndensir=5.,3.,matr(1,1)=100.,.3,matr(1,2)=.5 $\n$mesh cells(1,2)=4,2 $\n"
        "$fem law(2)='fluid' $\n$flow boundary_on(1)='2.bottom',boundary_u(1)='0',boundary(1)='" +
        kind + "' $\n");
    return built.errors();
  };
  EXPECT_EQ(errors("moving"), Texts{});
  EXPECT_EQ(errors("inflow"), Texts{"5:10: region 1: its node at (0.5, 0) lies on the inflow '2.bottom'"});
}

}  // namespace
}  // namespace tether::test
