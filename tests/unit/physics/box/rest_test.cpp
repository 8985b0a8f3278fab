// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid at rest under gravity stays at rest, whatever sides are open, with layers of smoke, too.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/box/grid_flow.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/solver.hpp"
#include "unit/alone.hpp"
#include "unit/physics/box/plan_support.hpp"

namespace tether::coupled {
namespace {

using Overrides = std::vector<std::string>;

Overrides with(Overrides all, const Overrides& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Air in a box whose cells are no squares.
const std::string plane =
    "$in nx=14,ny=11,xleft=0.,xright=2.,ybot=-.4,ytop=1.1,tmax=.5,tstep=.02,gravc=-9.81 $\n"
    "$coupled density=1.2 $\n";
const std::string space =
    "$in nx=8,ny=7,xleft=0.,xright=2.,ybot=-.4,ytop=1.1,tmax=.2,tstep=.02,gravc=-9.81 $\n"
    "$coupled density=1.2,nz=6,zback=0.,zfront=1. $\n";

double speed_after(const std::string& deck, const Overrides& overrides, double time = 0.2) {
  const Plan plan = plan_of(deck, overrides);
  CoupledSolver solver(plan);
  solver.advance(time);
  double fastest = 0;
  for (const Field& field : solver.grid().fields) {
    if (field.quantity.dimension != Dimension::velocity) continue;
    for (const double v : field.values) fastest = std::max(fastest, std::abs(v));
  }
  return fastest;
}

/// Every way to open at least one of the first so many sides.
std::vector<Overrides> openings(int sides) {
  std::vector<Overrides> all;
  for (int which = 1; which < 1 << sides; ++which) {
    all.emplace_back();
    for (int side = 0; side < sides; ++side) {
      if ((which >> side & 1) != 0) all.back().push_back("coupled.side(" + std::to_string(side + 1) + ")='open'");
    }
  }
  return all;
}

class Rest : public testing::TestWithParam<const char*> {
 protected:
  Overrides mode{std::string("coupled.mode='") + GetParam() + "'"};
};
INSTANTIATE_TEST_SUITE_P(Coupled, Rest, testing::Values("symmetric", "cut-cell", "splitting", "paper"),
                         [](const auto& info) {
                           std::string name = info.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST_P(Rest, BesideOpenSides) {
  for (const Overrides& open : openings(4)) EXPECT_LE(speed_after(plane, with(mode, open)), 1e-10) << open.size();
  for (const Overrides& open : openings(6)) {
    if (open.size() % 2 == 0) continue;
    EXPECT_LE(speed_after(space, with(mode, open), 0.06), 1e-10) << open.size();
  }
}

/// Walls rub the fluid where it is viscous; the level is where the deck wants it.
TEST_P(Rest, OfAViscousFluidAtAnyLevel) {
  const Overrides sides{"coupled.side(2)='open'", "coupled.side(4)='open'", "coupled.viscosity=.05"};
  for (const char* level : {"coupled.level=7.", "coupled.level=.3", "coupled.level=-3."})
    EXPECT_LE(speed_after(plane, with(mode, with(sides, {level}))), 1e-10) << level;
}

/// Heavy smoke below warm smoke, which end within cells; next to a wall, and where the layers reach open sides.
const Overrides layers{
    "coupled.smoke_box(1:4,1)=0.,2.,-.4,.03", "coupled.box_smoke(1)=1.5", "coupled.smoke_box(1:4,2)=0.,2.,.62,1.1",
    "coupled.box_temperature(2)=30.",         "coupled.smoke_weight=.7",  "coupled.smoke_lift=.03"};

TEST_P(Rest, OfLayersOfSmoke) {
  for (const Overrides& open : openings(4))
    EXPECT_LE(speed_after(plane, with(mode, with(layers, open))), 1e-10) << open.size();
  EXPECT_LE(speed_after(plane, with(mode, layers)), 1e-10);
  const Overrides deep{"coupled.smoke_box(5:6,1)=0.,1.", "coupled.smoke_box(5:6,2)=0.,1."};
  EXPECT_LE(
      speed_after(space, with(mode, with(layers, with(deep, {"coupled.side(1)='open'", "coupled.side(6)='open'"}))),
                  0.06),
      1e-10);
}

/// Obstacles leave the layers what they are.
TEST_P(Rest, BesideObstacles) {
  const Overrides more{"coupled.side(1)='open'", "coupled.side(3)='open'", "coupled.obstacle(1:4,1)=.5,1.2,-.4,.5",
                       "coupled.obstacle(1:4,2)=1.8,2.,.4,1.1"};
  EXPECT_LE(speed_after(plane, with(mode, with(layers, more))), 1e-10);
}

/// A block of .4 x .2, half of it beyond an open side: fluid lifts all of it, and pushes it nowhere. Far within it is
/// lifted as much, and beyond nothing it is lifted by half.
TEST(CoupledRest, LiftsWhatIsBeyondASideToo) {
  const std::string deck =
      "$in nx=11,ny=11,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.1,tstep=.05,gravc=-9.81 $\n"
      "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e9,.3,xvi(1,1)=.3,.7,.7,.3,yvi(1,1)=.37,.37,.57,.57 $\n"
      "$mesh element='p1',cells(1,1)=4,2 $\n$coupled density=1000.,mode='cut-cell' $\n";
  const auto force = [&](double way, const char* level, const char* side) {
    const Plan plan = plan_of(deck, {level, side});
    CoupledStep step(plan.scene, *plan.scene.solids(), alone());
    CoupledState state = step.start();
    for (std::size_t n = 0; n < state.q.size(); n += 2) state.q[n] += way;
    const Placement at = dynamic_cast<const GridFlow&>(step.flow()).placed(state.q);
    std::vector<double> nodes = at.map.outside, p;
    for (const std::size_t cell : at.numbers.cell)
      p.push_back(1000 * -9.81 *
                  (at.domain.grid.middle(1, at.domain.grid.place_of_cell(cell)[1]) - plan.scene.coupled()->level));
    add_transposed_product(at.map.B, 1, p, nodes);
    std::array<double, 2> sum{};
    for (std::size_t k = 0; k < nodes.size(); ++k) sum[k % 2] += nodes[k];
    return sum;
  };
  for (const char* level : {"coupled.level=1.", "coupled.level=5.", "coupled.level=-2."}) {
    for (const double way : {0.0, 0.5, 0.53}) {
      const auto [x, y] = force(way, level, "coupled.side(2)='open'");
      EXPECT_NEAR(y, 1000 * 9.81 * 0.08, 1e-8) << level << way;
      EXPECT_NEAR(x, 0, 1e-8) << level << way;
    }
  }
  EXPECT_NEAR(force(0.5, "coupled.level=1.", "coupled.side(2)='void'")[1], 1000 * 9.81 * 0.04, 1e-8);
}

/// Water at rest gets under a block in a corner of the box and between it and the wall: the film's pressure there grows
/// with the depth, though its rims are at two heights.
TEST(CoupledRest, LiftsABlockInACorner) {
  for (const std::string mode : {"cut-cell", "symmetric"}) {
    for (const char* places :
         {"xvi(1,1)=0.,.4,.4,0.,yvi(1,1)=0.,0.,.3,.3", "xvi(1,1)=.02,.43,.43,.02,yvi(1,1)=.03,.03,.31,.31"}) {
      const Plan plan = plan_of(
          "$in nx=11,ny=11,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.1,tstep=.05,gravc=-9.81 $\n"
          "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e9,.3," +
              std::string(places) +
              " $\n$mesh element='p1',cells(1,1)=4,3 $\n$coupled density=1000.,side(4)='open',mode='" + mode + "' $\n",
          {});
      CoupledStep step(plan.scene, *plan.scene.solids(), alone());
      const CoupledState state = step.start();
      const Placement at = dynamic_cast<const GridFlow&>(step.flow()).placed(state.q);
      std::vector<double> nodes = at.map.film_weight, p;
      for (const std::size_t cell : at.numbers.cell)
        p.push_back(1000 * -9.81 * (at.domain.grid.middle(1, at.domain.grid.place_of_cell(cell)[1]) - 1));
      add_transposed_product(at.map.B, 1, p, nodes);
      std::array<double, 2> sum{};
      for (std::size_t k = 0; k < nodes.size(); ++k) sum[k % 2] += nodes[k];
      const double weight = 1000 * 9.81 * enclosed_volumes(step.surface(), state.q)[0];
      // Of whole cells half a cell's pressure; a gap leaves pieces at its rims whose cell begins next to them.
      const double error = mode == "symmetric" ? 0.2 : (places[9] == '0' ? 1e-9 : 0.01);
      EXPECT_NEAR(sum[1] / weight, 1, error) << mode << places;
      EXPECT_NEAR(sum[0] / weight, 0, error) << mode << places;
    }
  }
}

/// As ever where the deck wants it: a pressure of zero all down a side lets the fluid fall out of it.
TEST(CoupledRest, IsLostBesideNothing) {
  EXPECT_GT(speed_after(plane, {"coupled.side(2)='void'"}), 1);
  EXPECT_LE(speed_after(plane, {"coupled.side(4)='void'"}), 1e-10);
}

}  // namespace
}  // namespace tether::coupled
