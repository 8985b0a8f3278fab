// SPDX-License-Identifier: GPL-3.0-or-later
// What $flow says becomes the fluid of a scene: its mesh, beside that of bodies, its boundary, what is recorded of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "unit/read/flow/flow_support.hpp"

namespace tether::test {
namespace {

/// The element sides of all parts of the boundary by their nodes in ascending order, and how often each is there.
std::map<std::vector<int>, int> counted(const Flow& flow) {
  const auto n = static_cast<std::ptrdiff_t>(side_node_count_of(flow.mesh.kind));
  std::map<std::vector<int>, int> count;
  for (const FlowSide& side : flow.sides) {
    for (auto first = side.sides.begin(); first != side.sides.end(); first += n) {
      std::vector<int> nodes(first, first + n);
      std::sort(nodes.begin(), nodes.end());
      ++count[nodes];
    }
  }
  return count;
}

void expect_whole_boundary(const Flow& flow) {
  const Sides boundary = boundary_of(flow.mesh);
  const auto n = static_cast<std::ptrdiff_t>(side_node_count_of(flow.mesh.kind));
  const auto count = counted(flow);
  EXPECT_EQ(count.size() * static_cast<std::size_t>(n), boundary.size());
  for (auto first = boundary.begin(); first != boundary.end(); first += n) {
    std::vector<int> nodes(first, first + n);
    std::sort(nodes.begin(), nodes.end());
    ASSERT_TRUE(count.contains(nodes));
    EXPECT_EQ(count.at(nodes), 1);
  }
}

TEST(FlowScene, OfAnEmptyGroupIsAFluidWithinWallsAtRest) {
  const Built built = channel("");
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{});
  EXPECT_EQ(built.scene.path(), Path::fem);
  EXPECT_EQ(built.scene.points.size(), 0u);
  EXPECT_FALSE(built.scene.solids());
  ASSERT_TRUE(built.scene.flow());
  const Flow& flow = *built.scene.flow();
  EXPECT_EQ(flow.mesh.kind, ElementKind::quad9);
  EXPECT_EQ(flow.mesh.element_count(), 8u);
  EXPECT_EQ(flow.mesh.node_count(), 45u);
  EXPECT_EQ(flow.element, FlowElement::q2q1);
  EXPECT_EQ(flow.density, 3);
  EXPECT_EQ(flow.viscosity, .5);
  EXPECT_EQ(flow.integrator, FlowIntegrator::midpoint);
  EXPECT_EQ(flow.linearisation, Linearisation::newton);
  EXPECT_EQ(flow.tolerance, 1e-6);
  EXPECT_EQ(flow.speed, 0);
  EXPECT_TRUE(flow.start.absent() && flow.acceleration.absent());
  EXPECT_TRUE(flow.forces.empty() && flow.probes.empty() && flow.differences.empty() && flow.volume_penalty.empty());
  EXPECT_EQ(flow.tracers.count, (std::array{0, 0}));
  ASSERT_EQ(flow.sides.size(), 1u);
  EXPECT_EQ(flow.sides[0].name, "other walls");
  EXPECT_EQ(flow.sides[0].number, 0);
  EXPECT_EQ(flow.sides[0].boundary, Boundary::no_slip);
  expect_whole_boundary(flow);
  for (std::size_t n = 0; n < flow.twin.size(); ++n) EXPECT_EQ(flow.twin[n], static_cast<int>(n));
}

TEST(FlowScene, IsThereWithoutItsGroup) {
  const Built built = build_flow(
      "$reg nreg=1,nvi=4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,densir=3.,matr(1,1)=.5 $\n"
      "$mesh $\n$fem law='fluid' $\n");
  EXPECT_EQ(built.errors(), Texts{});
  ASSERT_TRUE(built.scene.flow());
  EXPECT_EQ(built.scene.flow()->mesh.element_count(), 1u);
}

TEST(FlowScene, HasWhatTheDeckSays) {
  const Built built = channel(
      "element='q1q1',integrator='euler',linearisation='picard',tolerance=1e-8,speed=2.,length=.5\n"
      "bx='x+10*y+100*t',by='-1',v0='y',probe(1,7)=1.,.5,1.5,.25,difference(1,3)=8,7,tracers=20,10,"
      "tracer_box=.5,1.5,.25,.75\nforce_on(2)='1.bottom',force_x(2)=1.,force_y(2)=-1.",
      "", {"reg.vrx=4.", "reg.vry=7."});
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{"vry(1) has no effect: v0 of $flow is there"});
  const Flow& flow = *built.scene.flow();
  EXPECT_EQ(flow.mesh.kind, ElementKind::quad4);
  EXPECT_EQ(flow.element, FlowElement::q1q1);
  EXPECT_EQ(flow.integrator, FlowIntegrator::euler);
  EXPECT_EQ(flow.linearisation, Linearisation::picard);
  EXPECT_EQ(flow.tolerance, 1e-8);
  EXPECT_EQ(flow.speed, 2);
  EXPECT_EQ(flow.length, .5);
  EXPECT_EQ(flow.acceleration.at(1, 2, 3), (std::array<double, 2>{321, -1}));
  EXPECT_EQ(flow.start.at(1, 2, 0), (std::array<double, 2>{4, 2}));
  EXPECT_EQ(flow.probes, (std::vector<std::array<double, 2>>{{1, .5}, {1.5, .25}}));
  EXPECT_EQ(flow.differences, (std::vector<std::array<int, 2>>{{1, 0}}));
  EXPECT_EQ(flow.tracers.count, (std::array{20, 10}));
  EXPECT_EQ(flow.tracers.box.low[0], .5);
  EXPECT_EQ(flow.tracers.box.high[0], 1.5);
  EXPECT_EQ(flow.tracers.box.low[1], .25);
  EXPECT_EQ(flow.tracers.box.high[1], .75);
  ASSERT_EQ(flow.forces.size(), 1u);
  EXPECT_EQ(flow.forces[0].name, "1.bottom");
  EXPECT_EQ(flow.forces[0].sides, flow.mesh.sides.at("1.bottom"));
  EXPECT_EQ(flow.forces[0].centre, (std::array<double, 2>{1, -1}));
}

TEST(FlowScene, SteadyIsAnIntegrator) {
  EXPECT_EQ(channel("steady=.true.").scene.flow()->integrator, FlowIntegrator::steady);
}

TEST(FlowScene, TracersWithoutABoxFillTheFluid) {
  const auto [count, box] = channel("tracers=3,2").scene.flow()->tracers;
  EXPECT_EQ(count, (std::array{3, 2}));
  EXPECT_EQ(box.low, (Vec<2>{0, 0}));
  EXPECT_EQ(box.high, (Vec<2>{2, 1}));
}

TEST(FlowScene, FluidOutsideHasNoPressureAtTheTop) {
  EXPECT_TRUE(channel("").scene.flow()->fluid_outside);
  EXPECT_EQ(channel("").scene.flow()->level, 1);
  const std::string open = "boundary_on(1)='1.right',boundary(1)='open',";
  EXPECT_EQ(channel(open + "level=-2.", "", {"in.gravc=-1."}).scene.flow()->level, -2);
  EXPECT_FALSE(channel(open + "outside='void'", "", {"in.gravc=-1."}).scene.flow()->fluid_outside);
}

TEST(FlowScene, SidesAreTheWholeBoundaryOnce) {
  for (const char* element : {"element='q1q1',", "element='q2q1',"}) {
    const Built built = channel(std::string(element) +
                                "boundary_on(3)='1.left',boundary(3)='inflow',boundary_u(3)='y*(1-y)*t',boundary_time("
                                "1,3)=0.,1.,boundary_factor(1,3)=0.,2.,boundary_on(5)='1.right',boundary(5)='open'");
    EXPECT_EQ(built.errors(), Texts{});
    const Flow& flow = *built.scene.flow();
    ASSERT_EQ(flow.sides.size(), 3u);
    expect_whole_boundary(flow);
    const FlowSide& inflow = side_of(flow, "1.left");
    EXPECT_EQ(inflow.boundary, Boundary::inflow);
    EXPECT_EQ(inflow.number, 3);
    EXPECT_EQ(inflow.velocity.at(0, .5, .5), (std::array<double, 2>{.125, 0}));
    EXPECT_EQ(inflow.velocity.factor.of, "boundary 3 (1.left)");
    EXPECT_EQ(side_of(flow, "1.right").boundary, Boundary::open);
    for (const int node : side_of(flow, "1.left").sides) EXPECT_EQ(flow.mesh.x[2 * static_cast<std::size_t>(node)], 0);
  }
}

/// Two blocks, the edge between which is no boundary.
TEST(FlowScene, SidesOfSeveralBlocksLeaveTheirJointOut) {
  const std::string reg =
      "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,xvi(1,2)=1.,2.,2.,1.,yvi(1,2)=0.,0.,1.,1.,\n"
      "densir=3.,3.,matr(1,1)=.5,matr(1,2)=.5 $\n"
      "$mesh cells(1,1)=2,2,cells(1,2)=2,2,side(1,1)='floor',side(1,2)='floor' $\n$fem law=2*'fluid' $\n";
  const Built built = build_flow(reg + "$flow boundary_on(1)='floor',boundary(1)='slip' $\n");
  EXPECT_EQ(built.errors(), Texts{});
  expect_whole_boundary(*built.scene.flow());
  EXPECT_EQ(side_of(*built.scene.flow(), "floor").sides.size(), 12u);
  const Built inner = build_flow(reg + "$flow boundary_on(1)='1.right',boundary(1)='slip'\nforce_on(1)='2.left' $\n");
  EXPECT_EQ(inner.errors(), (Texts{"8:22: '1.right' is no side of the fluid's boundary at (1, 0): elements join there",
                                   "9:13: '2.left' is no side of the fluid's boundary: elements join there"}));
}

TEST(FlowScene, PeriodicNodesShareTheLowest) {
  const std::string both =
      "boundary_on(1)='1.right',boundary(1)='periodic',boundary_with(1)='1.left',\n"
      "boundary_on(2)='1.bottom',boundary(2)='periodic',boundary_with(2)='1.top'";
  const Flow flow = *channel("element='q1q1'," + both).scene.flow();  // 5 x 3 nodes
  EXPECT_EQ(flow.twin, (std::vector<int>{0, 1, 2, 3, 0, 5, 6, 7, 8, 5, 0, 1, 2, 3, 0}));
  ASSERT_EQ(flow.sides.size(), 4u);
  expect_whole_boundary(flow);
  EXPECT_EQ(side_of(flow, "1.left").number, 1);
  EXPECT_EQ(side_of(flow, "1.left").boundary, Boundary::periodic);
}

/// An L of three squares whose opposite sides are one: all its corners are one place.
TEST(FlowScene, PeriodicNodesAreJoinedInChains) {
  const auto square = [](int r, double x, double y) {
    return fmt::format("xvi(1,{0})={1},{2},{2},{1},yvi(1,{0})={3},{3},{4},{4},matr(1,{0})=1.,\n", r, x, x + 1, y,
                       y + 1);
  };
  std::string flow;
  const std::pair<const char*, const char*> pairs[] = {
      {"2.top", "2.bottom"}, {"3.right", "3.left"}, {"3.top", "1.bottom"}, {"2.right", "1.left"}};
  for (int k = 1; const auto& [side, partner] : pairs)
    flow +=
        fmt::format("boundary_on({0})='{1}',boundary({0})='periodic',boundary_with({0})='{2}',\n", k++, side, partner);
  const Built built =
      build_flow("$reg nreg=3,nvi=3*4,densir=3*1.,\n" + square(1, 0, 0) + square(2, 1, 0) + square(3, 0, 1) +
                 "$\n$mesh $\n$fem law=3*'fluid' $\n$flow element='q1q1',\n" + flow + "$\n");
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.flow()->twin, std::vector<int>(8, 0));
}

TEST(FlowScene, PeriodicSidesHaveEquallyManyNodes) {
  const Built built = build_flow(
      "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,xvi(1,2)=3.,4.,4.,3.,yvi(1,2)=0.,0.,1.,1.,\n"
      "densir=3.,3.,matr(1,1)=.5,matr(1,2)=.5 $\n$mesh cells(1,1)=2,2,cells(1,2)=2,4 $\n$fem law=2*'fluid' $\n"
      "$flow boundary_on(1)='1.left',boundary(1)='periodic',\nboundary_with(1)='2.right' $\n");
  ASSERT_EQ(built.errors().size(), 1u);
  EXPECT_EQ(built.errors()[0].find("9:18: the nodes of '1.left' and '2.right' do not match: 5 and 9, "), 0u)
      << built.errors()[0];
}

TEST(FlowScene, KeepsTheDecksNumbersOfRegions) {
  const Built built = channel_with_body(
      "boundary_on(1)='2.left',boundary(1)='inflow',boundary_u(1)='y*(1-y)',boundary_on(2)='2.right',boundary(2)="
      "'open'\npenalty(1)=7.",
      ",load_on(1)='1.right',load(1,1)=1.,load_on(2)='region 1',load(1,2)=1.");
  EXPECT_EQ(built.errors(), Texts{});
  ASSERT_TRUE(built.scene.flow() && built.scene.solids());
  const Solids& solids = *built.scene.solids();
  EXPECT_EQ(solids.mesh.element_count(), 4u);
  EXPECT_EQ(solids.mesh.kind, ElementKind::quad9);
  EXPECT_EQ(solids.mesh.region, std::vector<int>(4, 0));
  ASSERT_EQ(solids.regions.size(), 1u);
  EXPECT_EQ(solids.regions[0].name, "region 1");
  EXPECT_EQ(solids.regions[0].density, 5);
  EXPECT_TRUE(solids.mesh.sides.contains("1.left"));
  EXPECT_FALSE(solids.mesh.sides.contains("2.left"));
  ASSERT_EQ(solids.loads.size(), 2u);
  EXPECT_EQ(solids.loads[1].region, 0);
  EXPECT_TRUE(solids.supports.empty());
  EXPECT_TRUE(built.scene.flow()->mesh.sides.contains("2.left"));
  EXPECT_FALSE(built.scene.flow()->mesh.sides.contains("1.left"));
  EXPECT_EQ(built.scene.flow()->density, 3);
  EXPECT_EQ(built.scene.flow()->volume_penalty, std::vector<double>{7});
}

/// The fluid as region 1, the bodies as 2 and 3: Mesh::region still counts the bodies from 0.
TEST(FlowScene, BodiesBehindAFluidAreCountedFromZero) {
  const Built built = build_flow(
      "$reg nreg=3,nvi=3*4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.\nxvi(1,2)=.5,.7,.7,.5,yvi(1,2)=.5,.5,.6,.6\n"
      "xvi(1,3)=1.,1.2,1.2,1.,yvi(1,3)=.5,.5,.6,.6,densir=3.,2.,1.,matr(1,1)=.5,matr(1,2)=10.,.3,matr(1,3)=20.,.3 $\n"
      "$mesh element='q1' $\n$fem law(1)='fluid',load_on(1)='region 3',load(1,1)=1.,\nload_on(2)='region "
      "1',load(1,2)=1. $\n"
      "$flow penalty(3)=9. $\n$points tracked_at(1,1)=1.2,.6 $\n");
  EXPECT_EQ(built.errors(), Texts{"9:12: there is no region 1"});
  const Solids& solids = *built.scene.solids();
  EXPECT_EQ(solids.mesh.region, (std::vector<int>{0, 1}));
  EXPECT_EQ(solids.regions.at(1).name, "region 3");
  EXPECT_EQ(solids.loads.at(0).region, 1);
  EXPECT_EQ(solids.tracked.at(0).place.nodes, std::vector<int>{7});
  EXPECT_EQ(built.scene.flow()->volume_penalty, (std::vector<double>{0, 9}));
}

TEST(FlowScene, FlawsOfBlocksNameTheDecksRegions) {
  const Built built = build_flow(
      "$reg "
      "nreg=3,nvi=3*4,densir=3*1.,matr(1,1)=10.,.3,matr(1,2)=1.,matr(1,3)=1.\nxvi(1,1)=.2,.3,.3,.2,yvi(1,1)=.2,.2,.3,.3"
      "\nxvi(1,2)=0.,1.,1.,0.,yvi(1,2)=0.,0.,1.,1.\nxvi(1,3)=1.,2.,2.,1.,yvi(1,3)=0.,0.,1.,1. $\n"
      "$mesh cells(1,2)=2,2,cells(1,3)=2,3 $\n$fem law(2)=2*'fluid' $\n");
  ASSERT_EQ(built.errors().size(), 1u);
  EXPECT_EQ(
      built.errors()[0].find("7:10: region 3: the node at (1, 0.166667) hangs: it lies within a side of region 2"), 0u)
      << built.errors()[0];
}

}  // namespace
}  // namespace tether::test
