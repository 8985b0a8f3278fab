// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Steps of a box that keep the energy of its solids: what stiff bodies gain by turning, bodies that meet in a fluid,
// and the same motion as on the path of finite elements where the fluid weighs nothing.

namespace tether::cases {
namespace {

/// The most that the total energy grows from one row to the next, less what came in and what the fluid's cells made of
/// it between steps, over its first value.
double growth(const DeckRun& run) {
  std::vector<double> net = run.history.column("energy_total");
  const auto add = [&](const char* book, double sign) {
    const auto amounts = run.history.column(book);
    for (std::size_t k = 0; k < net.size(); ++k) net[k] += sign * amounts[k];
  };
  for (const char* book : {"energy_gravity", "energy_open", "energy_outside", "energy_jets"}) add(book, -1);
  for (const char* book : {"energy_advected", "energy_remeshed"}) add(book, 1);
  double most = -INFINITY;
  for (std::size_t k = 1; k < net.size(); ++k) most = std::max(most, net[k] - net[k - 1]);
  return most / run.first("energy_total");
}

double largest(const DeckRun& run, const char* column) {
  double most = 0;
  for (const double value : run.history.column(column)) most = std::max(most, std::abs(value));
  return most;
}

std::string spinning(double modulus, double rate) {
  return fmt::format(
      "a block that turns\n$in nx=21,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.3,tstep=.01,iout(33)=1,"
      "tiout(33)=.01 $\n$reg nreg=1,nvi=4,xvi(1,1)=.3,.7,.7,.3,yvi(1,1)=.4,.4,.6,.6,densir(1)=1000.,"
      "matr(1,1)={:.3g},.3 $\n$mesh cells(1,1)=4,2 $\n$fem spin(3,1)={:.3g} $\n"
      "$coupled density=1000.,side(4)='open' $\n",
      modulus, rate);
}

/// A step that stretches what turns gives a stiff body many times its energy; one that keeps it does not, whatever the
/// stiffness.
TEST(CoupledEnergy, StiffBodiesThatTurnGainNothing) {
  for (const double modulus : {1e6, 1e8, 1e10}) {
    const DeckRun run = run_text("spin", spinning(modulus, 5), {"coupled.step='energy'"});
    EXPECT_LE(growth(run), 0) << modulus;
    EXPECT_LE(run.summary.at("energy_drift"), 1e-11) << modulus;
    EXPECT_LE(run.summary.at("interface_mismatch"), 1e-9) << modulus;
    EXPECT_EQ(run.summary.at("halvings"), 0) << modulus;
  }
  EXPECT_GT(growth(run_text("spin", spinning(1e9, 2), {"coupled.step='linear'"})), 1);
}

/// A closed box keeps the volume of its fluid, and stiff bodies keep theirs: they turn as in an open one, and Newton's
/// method finds each step quickly.
TEST(CoupledEnergy, StiffBodiesTurnInClosedBoxes) {
  for (const char* flow : {"grid", "mesh"}) {
    const std::string of = fmt::format("coupled.flow='{}'", flow);
    const DeckRun open = run_text("spin", spinning(1e10, 5), {"coupled.step='energy'", of});
    const DeckRun closed = run_text("spin", spinning(1e10, 5), {"coupled.step='energy'", of, "coupled.side(4)='wall'"});
    EXPECT_NEAR(closed.last("energy_kinetic"), open.last("energy_kinetic"), 0.05 * open.last("energy_kinetic")) << flow;
    EXPECT_LE(growth(closed), 0) << flow;
    EXPECT_LE(closed.summary.at("interface_mismatch"), 1e-9) << flow;
    EXPECT_LE(closed.summary.at("newton_iterations"), 5 * closed.summary.at("steps")) << flow;
  }
}

/// The scene asks for it by itself, where it matters; else a linear step reports what it gave.
TEST(CoupledEnergy, IsTakenWhereItIsNeeded) {
  EXPECT_EQ(run_text("spin", spinning(1e9, 2)).summary.count("newton_iterations"), 1U);
  const DeckRun soft = run_text("spin", spinning(1e6, 2));
  EXPECT_EQ(soft.summary.count("newton_iterations"), 0U);
  EXPECT_LT(soft.summary.at("linear_gain"), 0.01);
  const DeckRun linear = run_text("spin", spinning(1e9, 2), {"coupled.step='linear'"});
  EXPECT_GT(linear.summary.at("linear_gain"), 1);
  const auto says = [](const std::string& text) { return text.find("step='energy'") != std::string::npos; };
  EXPECT_TRUE(std::any_of(linear.messages.begin(), linear.messages.end(), says));
}

/// A soft block as heavy as the water, in a tank that is open above: what its surface sweeps is its volume to the
/// second order, so that gravity does on the water what Archimedes says, and nothing feeds ripples.
TEST(CoupledEnergy, SoftBodiesUnderAnOpenTopGetNoEnergyOfGravity) {
  constexpr double gravity = 9.4, density = 1000;
  const DeckRun run = run_text(
      "soft-block",
      "a soft block\n$in nx=24,ny=18,xleft=0.,xright=1.51,ybot=0.,ytop=1.13,tmax=3.,tstep=.02,gravc=-9.4,iout(33)=1,"
      "tiout(33)=.02 $\n$reg nreg=1,nvi=4,xvi(1,1)=.5607,1.1133,1.0393,.4867,yvi(1,1)=.2907,.5243,.6993,.4657,"
      "densir(1)=1000.,matr(1,1)=4.e5,.35 $\n$mesh element='q2',cells(1,1)=6,3 $\n$fem law='neo-hookean' $\n"
      "$coupled density=1000.,side(4)='void',step='energy' $\n");
  const double risen =
      run.last("body_volume_1") * run.last("body_y_1") - run.first("body_volume_1") * run.first("body_y_1");
  const double work = run.last("energy_gravity");
  EXPECT_LT(risen, -1e-4);
  EXPECT_NEAR(work / (density * gravity * risen), 1, 0.15);
  EXPECT_LT(run.last("energy_kinetic"), 2);
  EXPECT_LT(run.last("energy_strain"), 7);
  EXPECT_LT(std::abs(run.summary.at("volume_unswept")), 1e-3);
}

/// In space, by factors and by GMRES.
TEST(CoupledEnergy, InSpace) {
  const std::vector<std::string> space{
      "coupled.nz=9", "coupled.zback=0.", "coupled.zfront=.8", "mesh.z(1,1)=.31,.52",  "mesh.cells(3,1)=1",
      "in.nx=11",     "in.ny=11",         "in.tmax=.05",       "coupled.step='energy'"};
  std::vector<double> ends;
  for (const char* solver : {"direct", "krylov"}) {
    std::vector<std::string> of = space;
    of.push_back(fmt::format("coupled.solver='{}'", solver));
    const DeckRun run = run_text("spin", spinning(1e8, 5), of);
    of.push_back("coupled.side(4)='wall'");
    const DeckRun closed = run_text("spin", spinning(1e8, 5), of);
    EXPECT_LE(growth(run), 0) << solver;
    EXPECT_LE(run.summary.at("interface_mismatch"), 1e-9) << solver;
    EXPECT_NEAR(closed.last("energy_kinetic"), run.last("energy_kinetic"), 0.02 * run.last("energy_kinetic")) << solver;
    ends.push_back(run.last("energy_kinetic"));
  }
  EXPECT_NEAR(ends[0], ends[1], 1e-9 * ends[0]);
}

/// Two blocks that fall onto each other and a floor, in a box with walls.
std::string falling(const char* more) {
  return fmt::format(
      "two blocks\n$in nx=17,ny=17,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.5,tstep=.01,gravc=-10.,iout(33)=1,"
      "tiout(33)=.01{}",
      more);
}
constexpr const char* blocks =
    "$reg nreg=2,nvi=4,4,xvi(1,1)=.3,.7,.7,.3,yvi(1,1)=.1,.1,.3,.3,xvi(1,2)=.5,.8,.8,.5,yvi(1,2)=.4,.4,.6,.6,"
    "densir(1)=2000.,3000.,matr(1,1)=1e6,.3,matr(1,2)=1e7,.3 $\n$mesh cells(1,1)=4,2,cells(1,2)=3,2 $\n"
    "$fem law='neo-hookean','neo-hookean',spin(3,2)=2. $\n";

TEST(CoupledEnergy, BodiesMeetInAFluid) {
  for (const char* step : {"in.tstep=.01", "in.tstep=.033333333333333333"}) {
    const DeckRun run =
        run_text("meet", falling(" $\n") + blocks + "$contact $\n$coupled density=1000.,side(4)='open' $\n", {step});
    EXPECT_LE(growth(run), 0) << step;
    EXPECT_LE(run.summary.at("energy_drift"), 1e-10) << step;
    EXPECT_LE(run.summary.at("interface_mismatch"), 1e-9) << step;
    EXPECT_EQ(run.summary.at("nodes_inside"), 0) << step;
    EXPECT_GT(largest(run, "contact_sides"), 1) << step;
  }
}

/// Friction, of the box or of $contact, takes the same; what it takes is booked.
TEST(CoupledEnergy, FrictionIsBooked) {
  std::vector<double> taken;
  for (const char* contact :
       {"$contact friction=.4 $\n$coupled density=1000.,", "$coupled density=1000.,friction=.4,"}) {
    const DeckRun run =
        run_text("rub", falling(" $\n") + blocks + contact + "side(4)='open',step='energy' $\n", {"reg.vrx(1)=1.,-1."});
    EXPECT_LE(run.summary.at("energy_drift"), 1e-10);
    taken.push_back(run.last("energy_friction"));
  }
  EXPECT_GT(taken[0], 0);
  EXPECT_EQ(taken[0], taken[1]);
}

/// With next to no fluid, bodies move as they do without: the two paths share the step and the contact.
TEST(CoupledEnergy, WithoutAFluidIsThePathOfElements) {
  const DeckRun box = run_text(
      "thin", falling(" $\n") + blocks + "$contact $\n$coupled density=1e-7,side(4)='open' $\n", {"in.tmax=.3"});
  const DeckRun alone =
      run_text("alone", falling(",wl=1,wr=1,wb=1,wt=1 $\n") + blocks + "$contact wall='left','right','bottom' $\n",
               {"in.tmax=.3"});
  for (const char* column : {"body_x_1", "body_y_1", "body_x_2", "body_y_2", "body_vx_2", "body_vy_2"})
    EXPECT_NEAR(box.last(column), alone.last(column), 1e-6) << column;
}

/// A bag of fluid on a floor holds its volume, and its pressure the weight.
TEST(CoupledEnergy, AClosedRegionIsHeld) {
  std::vector<std::string> of{"in.tmax=.6", "coupled.step='energy'"};
  for (const char* axis : {"x", "y"}) of.push_back(fmt::format("in.n{}={}", axis, at_full_length() ? 33 : 25));
  for (int r = 1; r <= 10; ++r) of.push_back(fmt::format("fem.law({})='neo-hookean'", r));
  const DeckRun run = run_deck("coupled-toy", of);
  EXPECT_LE(run.summary.at("energy_drift"), 1e-9);
  EXPECT_LE(run.summary.at("interface_mismatch"), 1e-9);
  EXPECT_EQ(run.summary.at("nodes_inside"), 0);
  EXPECT_NEAR(run.last("volume_sheet_2"), run.first("volume_sheet_2"), 0.02 * run.first("volume_sheet_2"));
}

}  // namespace
}  // namespace tether::cases
