// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene has of a deck with $coupled.
#include "model/coupled.hpp"

#include <gtest/gtest.h>

#include "deck/document.hpp"
#include "model/solids.hpp"
#include "unit/read/box/coupled_support.hpp"

namespace tether::test {
namespace {

using Triple = std::array<double, 3>;

TEST(CoupledScene, CellsLieBetweenTheNodes) {
  const Built plane = box("");
  ASSERT_EQ(plane.errors(), Texts{});
  EXPECT_EQ(plane.scene.path(), Path::coupled);
  EXPECT_EQ(plane.scene.solids(), nullptr);
  EXPECT_EQ(plane.scene.clock.cfl, 0);
  EXPECT_EQ(plane.scene.coupled()->grid, (StaggeredGrid{2, {8, 4, 1}, {0, 0, 0}, {.25, .25, 1}}));
  const Built space = box("nz=6,zback=-1.,zfront=1.5");
  ASSERT_EQ(space.errors(), Texts{});
  EXPECT_EQ(space.scene.coupled()->grid, (StaggeredGrid{3, {8, 4, 5}, {0, 0, -1}, {.25, .25, .5}}));
}

TEST(CoupledScene, HasTheDefaultsOfTheTable) {
  const Built built = box("");
  const Coupled& c = *built.scene.coupled();
  EXPECT_EQ(c.coupling.mode, CouplingMode::cut_cell);
  EXPECT_EQ(c.integrator, CoupledIntegrator::paper);
  EXPECT_EQ(c.advection, Advection::maccormack);
  EXPECT_EQ(c.systems, Systems::automatic);
  EXPECT_EQ(c.tolerance, 1e-12);
  EXPECT_EQ(c.density, 2);
  EXPECT_EQ(c.viscosity, 0);
  EXPECT_EQ(c.sides, (std::array<BoxSide, 6>{}));
  EXPECT_TRUE(c.jets.empty() && c.obstacles.empty() && c.voids.empty() && c.springs.empty());
  EXPECT_FALSE(c.cavities_only || c.smoke);
  EXPECT_TRUE(c.contact && c.volume_term && c.area_repair && c.convex);
}

TEST(CoupledScene, ReadsTheMethod) {
  const Built built =
      box("mode='splitting',integrator='trapezoid',advection='semi-lagrangian',solver='krylov',\n"
          "tolerance=1e-6,viscosity=.5,friction=.3,volume_term=.false.,area_repair=.false.,\n"
          "convex=.false.,u0=1.,v0=2.,side(2)='open',side(4)='open'",
          square_body());
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built),
            Texts{"a viscous fluid slips along bodies: it rubs at walls and obstacles alone, bodies "
                  "feel its pressure and no drag of friction"});
  const Coupled& c = *built.scene.coupled();
  EXPECT_EQ(c.coupling.mode, CouplingMode::splitting);
  EXPECT_EQ(c.integrator, CoupledIntegrator::trapezoid);
  EXPECT_EQ(c.advection, Advection::semi_lagrangian);
  EXPECT_EQ(c.systems, Systems::krylov);
  EXPECT_EQ(c.tolerance, 1e-6);
  EXPECT_EQ(c.viscosity, .5);
  EXPECT_EQ(c.friction, .3);
  EXPECT_FALSE(c.volume_term || c.area_repair || c.convex);
  EXPECT_EQ(c.start, (Triple{1, 2, 0}));
  using enum BoxSide;
  EXPECT_EQ(c.sides, (std::array{wall, open, wall, open, wall, wall}));
  EXPECT_EQ(box("mode='cut-cell'").scene.coupled()->coupling.mode, CouplingMode::cut_cell);
  EXPECT_EQ(box("mode='paper'").scene.coupled()->coupling.mode, CouplingMode::paper);
}

TEST(CoupledScene, JetsAreTheWholeSideOrAPart) {
  const Built built =
      box("side(4)='open',jet_on='left','bottom','right',jet(1,2)=.5,1.,jet_speed=1.,-2.,3.,"
          "jet_time(1,3)=0.,1.,jet_factor(1,3)=0.,4.,jet_expression(2)='2*t'");
  ASSERT_EQ(built.errors(), Texts{});
  const auto& jets = built.scene.coupled()->jets;
  ASSERT_EQ(jets.size(), 3u);
  EXPECT_EQ(jets[0].patch.low, (Triple{0, 0, 0}));
  EXPECT_EQ(jets[0].patch.high, (Triple{0, 1, 1}));
  EXPECT_EQ(jets[1].patch.low, (Triple{.5, 0, 0}));
  EXPECT_EQ(jets[1].patch.high, (Triple{1, 0, 1}));
  EXPECT_EQ(jets[2].patch.low, (Triple{2, 0, 0}));
  EXPECT_EQ(jets[1].number, 2);
  EXPECT_EQ(jets[1].speed * jets[1].amplitude.at(.5), -2);
  EXPECT_EQ(jets[2].speed * jets[2].amplitude.at(.5), 6);
  EXPECT_FALSE(built.scene.coupled()->smoke);
}

TEST(CoupledScene, InSpaceAJetHasTwoExtents) {
  const Built built = box(depth +
                          "side(1)='open',jet_on='top','front',jet(1,1)=.5,1.,.25,.75,jet(1,2)=1.,2.,0.,.5,"
                          "jet_speed=1.,1.,jet_temperature(2)=3.");
  ASSERT_EQ(built.errors(), Texts{});
  const auto& jets = built.scene.coupled()->jets;
  ASSERT_EQ(jets.size(), 2u);
  EXPECT_EQ(jets[0].patch.low, (Triple{.5, 1, .25}));
  EXPECT_EQ(jets[0].patch.high, (Triple{1, 1, .75}));
  EXPECT_EQ(jets[1].patch.low, (Triple{1, 0, 1}));
  EXPECT_EQ(jets[1].patch.high, (Triple{2, .5, 1}));
  EXPECT_TRUE(built.scene.coupled()->smoke);
  const StaggeredGrid& grid = built.scene.coupled()->grid;
  const auto top = faces_of(jets[0].side, jets[0].patch, grid), front = faces_of(jets[1].side, jets[1].patch, grid);
  std::vector<std::size_t> faces;
  for (const FacePart& of_jet : top) {
    faces.push_back(of_jet.face);
    EXPECT_EQ(of_jet.part, 1);
  }
  EXPECT_EQ(faces,
            (std::vector{grid.face(1, 2, 4, 1), grid.face(1, 3, 4, 1), grid.face(1, 2, 4, 2), grid.face(1, 3, 4, 2)}));
  EXPECT_EQ(front.size(), 8u);
  EXPECT_EQ(cell_at(jets[0].side, grid, top[0].face), grid.cell(2, 3, 1));
  EXPECT_EQ(cell_at(jets[1].side, grid, front[0].face), grid.cell(4, 0, 3));
}

/// Its area is that of the deck, by parts of faces, whatever the grid; also where it is narrower than a face.
TEST(CoupledScene, AJetHasItsArea) {
  for (const auto& [extent, low, high] : {std::tuple("0.,1.", 0., 1.), std::tuple(".25,.5", .25, .5),
                                          std::tuple(".2,.6", .2, .6), std::tuple(".3,.31", .3, .31)}) {
    const Built built = box(std::string("side(2)='open',jet_on='left',jet_speed=1.,jet(1,1)=") + extent);
    ASSERT_EQ(built.errors(), Texts{});
    const Coupled& c = *built.scene.coupled();
    double area = 0;
    for (const FacePart& of_jet : faces_of(c.jets[0].side, c.jets[0].patch, c.grid)) {
      area += of_jet.part * c.grid.area(0);
      EXPECT_EQ(SideFaces(c).jets(0, of_jet.face).size(), 1u);
      EXPECT_EQ(SideFaces(c).open(0, of_jet.face), 0);
    }
    EXPECT_NEAR(area, high - low, 1e-15) << extent;
  }
}

/// In space, too, where a later jet takes its part of an earlier one, and an opening has what no jet has. A face of a
/// jet is open nowhere.
TEST(CoupledScene, SidesAreShared) {
  const Built built = box(depth +
                          "jet_on='top','top',jet(1,1)=.1,1.,.1,.9,jet(1,2)=.55,1.3,.3,.65,jet_speed=1.,1.,"
                          "open_on(1)='top',open(1,1)=1.4,1.9,.2,.8");
  ASSERT_EQ(built.errors(), Texts{});
  const Coupled& c = *built.scene.coupled();
  const SideFaces sides(c);
  std::array<double, 2> of_jet{};
  double open = 0;
  for (std::size_t f = 0; f < c.grid.face_count(1); ++f) {
    for (const JetShare& share : sides.jets(1, f))
      of_jet[static_cast<std::size_t>(share.jet)] += share.part * c.grid.area(1);
    open += sides.open(1, f) * c.grid.area(1);
  }
  EXPECT_NEAR(of_jet[0], .9 * .8 - .45 * .35, 1e-14);
  EXPECT_NEAR(of_jet[1], .75 * .35, 1e-14);
  EXPECT_NEAR(open, .5 * .6 - .1 * .5, 1e-14);  // faces from 1.25 to 1.5 have parts of jet 2
}

TEST(CoupledScene, BoxesAreCutAtTheGrid) {
  const Built built = box("obstacle(1,1)=-1.,.5,.25,9.,void(1,2)=1.5,2.,0.,1.");
  ASSERT_EQ(built.errors(), Texts{});
  const Coupled& c = *built.scene.coupled();
  ASSERT_EQ(c.obstacles.size(), 1u);
  EXPECT_EQ(c.obstacles[0].low, (Triple{-1, .25, 0}));
  EXPECT_EQ(c.obstacles[0].high, (Triple{.5, 9, 1}));
  ASSERT_EQ(c.voids.size(), 1u);
  EXPECT_TRUE(c.voids[0].contains({1.75, .5, .5}));
  EXPECT_FALSE(c.voids[0].contains({1.25, .5, .5}));
}

TEST(CoupledScene, SidesLieAtFluidOrNothing) {
  using enum BoxSide;
  const Built built = box("side='open','wall','void'");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.coupled()->sides, (std::array{open, wall, empty, wall, wall, wall}));
  EXPECT_EQ(built.scene.coupled()->level, 1);  // the top
  EXPECT_EQ(box("side(1)='open',level=-3.").scene.coupled()->level, -3);
}

TEST(CoupledScene, BoxesHoldSmokeAtTheStart) {
  const Built built =
      box("smoke_box(1,1)=-1.,.5,.25,9.,smoke_box(1,3)=.3,.31,0.,1.,box_smoke(1)=2.,box_temperature(1)=-5.,box_smoke(3)"
          "=.5");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{});
  const Coupled& c = *built.scene.coupled();
  EXPECT_TRUE(c.smoke);
  ASSERT_EQ(c.smoke_boxes.size(), 2u);
  EXPECT_EQ(c.smoke_boxes[0].box.low, (Triple{-1, .25, 0}));
  EXPECT_EQ(c.smoke_boxes[0].box.high, (Triple{.5, 9, 1}));
  EXPECT_EQ(c.smoke_boxes[0].density, 2);
  EXPECT_EQ(c.smoke_boxes[0].temperature, -5);
  EXPECT_EQ(c.smoke_boxes[1].density, .5);  // thinner than a cell
  EXPECT_EQ(warnings_of(box("smoke_box(1,1)=0.,.5,0.,.5")), Texts{"smoke_box 1 holds neither smoke nor warmth"});
  EXPECT_TRUE(box("smoke_box(1,1)=0.,.5,0.,.5,box_temperature(1)=5.").scene.coupled()->smoke);  // warmth alone
}

TEST(CoupledScene, WallsOfTheBoxHoldNoBody) {
  const Built built = box("",
                          "$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,.5,.5,densir=5.,"
                          "matr(1,1)=100.,.3,vrx=2. $\n$mesh element='p1' $\n$fem alpha=.1,beta=.2 $\n");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{});
  ASSERT_NE(built.scene.solids(), nullptr);
  EXPECT_TRUE(built.scene.solids()->supports.empty());
  EXPECT_EQ(built.scene.solids()->alpha, .1);
  EXPECT_EQ(built.scene.solids()->beta, .2);
  EXPECT_EQ(built.scene.solids()->regions[0].velocity, (Triple{2, 0, 0}));
}

TEST(CoupledScene, AHingeHoldsTheNearestNode) {
  const Built built = box("hinge(1,1)=.55,.3", square_body());
  ASSERT_EQ(built.errors(), Texts{});
  const Solids& solids = *built.scene.solids();
  ASSERT_EQ(solids.supports.size(), 1u);
  ASSERT_EQ(solids.supports[0].nodes.size(), 1u);
  const auto node = static_cast<std::size_t>(solids.supports[0].nodes[0]);
  EXPECT_EQ(solids.mesh.x[2 * node], .5);
  EXPECT_EQ(solids.mesh.x[2 * node + 1], .25);
  EXPECT_EQ(solids.supports[0].fixed, (std::array{true, true, false}));
}

TEST(CoupledScene, InSpaceAHingeIsALine) {
  const Built built = box(depth + "hinge(1,1)=.8,.7", cube_body());
  ASSERT_EQ(built.errors(), Texts{});
  const Solids& solids = *built.scene.solids();
  ASSERT_EQ(solids.supports.size(), 1u);
  EXPECT_EQ(solids.supports[0].nodes.size(), 3u);
  EXPECT_EQ(solids.supports[0].fixed, (std::array{true, true, true}));
  for (const int node : solids.supports[0].nodes) {
    EXPECT_EQ(solids.mesh.x[3 * static_cast<std::size_t>(node)], .75);
    EXPECT_EQ(solids.mesh.x[3 * static_cast<std::size_t>(node) + 1], .75);
  }
}

TEST(CoupledScene, SpringsActOnSidesAndRegions) {
  const Built built = box("spring_on='region 1','1.left',spring(1,1)=1.,2.,spring(2,2)=3.", square_body());
  ASSERT_EQ(built.errors(), Texts{});
  const auto& springs = built.scene.coupled()->springs;
  ASSERT_EQ(springs.size(), 2u);
  EXPECT_EQ(springs[0].nodes.size(), 9u);
  EXPECT_EQ(springs[1].nodes.size(), 3u);
  EXPECT_EQ(springs[0].stiffness, (Triple{1, 2, 0}));
  EXPECT_EQ(springs[1].stiffness, (Triple{0, 3, 0}));
}

TEST(CoupledScene, LargeOnesInSpaceGoByConjugateGradients) {
  Coupled c;
  c.grid.n = {1000, 1000, 1};
  EXPECT_EQ(systems_of(c), Systems::direct);
  c.grid.dim = 3, c.grid.n = {10, 20, 10};
  EXPECT_EQ(systems_of(c), Systems::direct);
  c.grid.n = {10, 20, 11};
  EXPECT_EQ(systems_of(c), Systems::krylov);
  c.systems = Systems::direct;
  EXPECT_EQ(systems_of(c), Systems::direct);
}

}  // namespace
}  // namespace tether::test
