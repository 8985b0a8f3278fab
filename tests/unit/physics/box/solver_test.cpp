// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled solver: runs are the same bit by bit, whole or taken up in the middle; what its columns say.
#include "physics/box/solver.hpp"
#include "unit/full_length.hpp"
#include "unit/physics/box/plan_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tether::coupled {
namespace {

/// A bag of fluid that falls on a floor with friction, in a fluid with a jet of smoke, and a bar that is held.
const char* const smoky_bag =
    "$in nx=25,ny=21,xleft=0.,xright=1.2,ybot=0.,ytop=1.,tmax=1.,tstep=.01,gravc=-4. $\n"
    "$reg nreg=3,nvi=4,4,4,densir(1)=3*1500.,matr(1,1)=1e6,.3,matr(1,2)=1e6,.3,matr(1,3)=1e6,.3,\n"
    "xvi(1,1)=.4,.8,.8,.4,yvi(1,1)=.02,.02,.1,.1,xvi(1,2)=.4,.5,.5,.4,yvi(1,2)=.1,.1,.4,.4,\n"
    "xvi(1,3)=.7,.8,.8,.7,yvi(1,3)=.1,.1,.4,.4,vrx(1)=.6,vrx(2)=.6,vrx(3)=.6,vry(1)=-.3,vry(2)=-.3,vry(3)=-.3 $\n"
    "$mesh element='p1',cells(1,1)=8,2,cells(1,2)=2,6,cells(1,3)=2,6 $\n"
    "$coupled density=1000.,friction=.2,side(2)='open',jet_on(1)='left',jet_speed(1)=.5,\n"
    "jet_smoke(1)=1.,viscosity=1. $\n";

class Solved : public testing::TestWithParam<DeckVariant> {
 protected:
  Plan plan = plan_of(smoky_bag, GetParam().overrides);
};
INSTANTIATE_TEST_SUITE_P(
    Coupled, Solved,
    testing::Values(DeckVariant{"CutCell", {}}, DeckVariant{"Symmetric", {"coupled.mode='symmetric'"}},
                    DeckVariant{"Krylov", {"coupled.solver='krylov'"}},
                    DeckVariant{"Splitting",
                                {"coupled.mode='splitting'", "reg.densir(1)=3*9e4", "reg.matr(1,1)=1e8",
                                 "reg.matr(1,2)=1e8", "reg.matr(1,3)=1e8"}},
                    DeckVariant{"Paper", {"coupled.mode='paper'"}},
                    DeckVariant{"PaperByFactors",
                                {"coupled.mode='paper'", "reg.matr(2,1)=.4999999", "reg.matr(2,2)=.4999999",
                                 "reg.matr(2,3)=.4999999"}},
                    DeckVariant{"Slow", {"reg.vrx(1)=3*.01", "reg.vry(1)=3*-.02", "in.gravc=-.5"}}),
    [](const auto& info) { return std::string(info.param.name); });

void expect_same(const CoupledSolver& a, const CoupledSolver& b, const char* when) {
  EXPECT_EQ(a.save(), b.save()) << when;
  for (const auto& take : {&CoupledSolver::grid, &CoupledSolver::solids}) {
    const Snapshot one = (a.*take)(), other = (b.*take)();
    ASSERT_EQ(one.fields.size(), other.fields.size());
    for (std::size_t k = 0; k < one.fields.size(); ++k) EXPECT_EQ(one.fields[k].values, other.fields[k].values) << when;
  }
}

/// Bodies move by some cells meanwhile, touch the floor, slide and stick, for eight steps more or for 23.
TEST_P(Solved, GoesOnFromASavedStateToTheLastBit) {
  CoupledSolver whole(plan), fresh(plan), used(plan);
  whole.advance(0.17);
  used.advance(test::at_full_length() ? 0.3 : 0.2);
  const SavedState saved = whole.save();
  fresh.restore(saved), used.restore(saved);
  expect_same(fresh, whole, "at once"), expect_same(used, whole, "at once, in a used solver");
  for (CoupledSolver* solver : {&whole, &fresh, &used}) solver->advance(test::at_full_length() ? 0.4 : 0.25);
  expect_same(fresh, whole, "later"), expect_same(used, whole, "later, in a used solver");
}

TEST_P(Solved, IsTheSameEveryTime) {
  CoupledSolver one(plan), other(plan);
  one.advance(0.1), other.advance(0.1);
  expect_same(one, other, "behind ten steps");
}

double of(const CoupledSolver& solver, const std::string& name) {
  const HistoryLayout layout = solver.history_layout();
  const Record record = solver.record();
  for (std::size_t k = 0; k < layout.quantities.size(); ++k) {
    if (layout.quantities[k].name == name) return record[k];
  }
  ADD_FAILURE() << name;
  return 0;
}

/// A bar in a stream, that bends or, stiff, leans.
std::string bar(const std::string& top, const std::string& E) {
  return "$in nx=65,ny=33,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=2.,tstep=.0333333333333333 $\n"
         "$reg nreg=1,nvi=4,densir(1)=1000.,xvi(1,1)=.7,.8," +
         top + ",yvi(1,1)=0.,0.,.5,.5,matr(1,1)=" + E +
         ",.3 $\n"
         "$mesh element='p1',cells(1,1)=3,12 $\n$fem fix_on(1)='1.bottom',fix(1:2,1)=0.,0. $\n"
         "$coupled density=1000.,side(2)='open',jet_on(1)='left',jet_speed(1)=1. $\n";
}

/// The largest of each in a run, once the start's flow, which turns about corners, has gone by.
struct Extremes {
  double speed = 0, energy = 0;
};
Extremes extremes_of(const std::string& deck, const std::string& mode) {
  const Plan plan = plan_of(deck, {"coupled.mode='" + mode + "'"});
  CoupledSolver solver(plan);
  Extremes most;
  for (int k = 2; k <= 40; ++k) {
    solver.advance(0.05 * k);
    most.energy = std::max(most.energy, of(solver, "energy_fluid"));
    for (const auto& field : solver.grid().fields) {
      if (field.quantity.name != "vx" && field.quantity.name != "vy") continue;
      for (const double v : field.values) most.speed = std::max(most.speed, std::abs(v));
    }
  }
  return most;
}

/// Cells that solids leave a little of are no pumps: one by one they were ten times as fast as the stream, and gave
/// that to the cells beside them.
TEST(CoupledStream, PartsOfCellsMakeNoJets) {
  for (const std::string& deck : {bar(".8,.7", "1e6"), bar("1.,.9", "1e9")}) {
    const Extremes whole = extremes_of(deck, "symmetric"), cut = extremes_of(deck, "cut-cell");
    EXPECT_LT(cut.speed, 1.5 * whole.speed);
    EXPECT_LT(cut.energy, 1.2 * whole.energy);
  }
}

/// A box of fluid with a block and an obstacle in it: volumes, masses and momenta at the start. Where cells are not cut
/// the block's sides are those of cells.
TEST(CoupledColumns, AreThoseOfFluidAndSolids) {
  for (const bool cut : {false, true}) {
    const std::string body =
        cut ? "xvi(1,1)=.55,1.05,1.05,.55,yvi(1,1)=.27,.27,.77,.77" : "xvi(1,1)=.5,1.,1.,.5,yvi(1,1)=.25,.25,.75,.75";
    const Plan plan = plan_of(
        "$in nx=33,ny=17,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=1.,tstep=.01 $\n"
        "$reg nreg=1,nvi=4,densir(1)=3.,matr(1,1)=1e3,.3,vrx(1)=2.," +
        body +
        " $\n"
        "$mesh element='p1',cells(1,1)=4,4 $\n"
        "$coupled density=2.,obstacle(1,1)=1.5,2.,0.,.25,mode='" +
        std::string(cut ? "cut-cell" : "symmetric") + "' $\n");
    const CoupledSolver solver(plan);
    EXPECT_NEAR(of(solver, "fluid_volume"), 1.625, 1e-12) << cut;
    EXPECT_NEAR(of(solver, "mass"), 2 * 1.625 + 3 * 0.25, 1e-12);
    EXPECT_NEAR(of(solver, "volume_sheet_1"), 0.25, 1e-15);
    EXPECT_NEAR(of(solver, "energy_kinetic") - of(solver, "energy_fluid"), 0.5 * 3 * 0.25 * 4, 1e-13);
  }
}

/// What is over time is no energy.
TEST(CoupledHistory, ThePowerAcrossTheInterfaceIsAPower) {
  const Plan plan = plan_of(smoky_bag);
  const HistoryLayout layout = CoupledSolver(plan).history_layout();
  const auto dimension_of = [&](const std::string& name) {
    const auto found = std::find_if(layout.quantities.begin(), layout.quantities.end(),
                                    [&](const Quantity& quantity) { return quantity.name == name; });
    return found == layout.quantities.end() ? Dimension::number : found->dimension;
  };
  EXPECT_EQ(dimension_of("interface_power"), Dimension::power);
  EXPECT_EQ(dimension_of("interface_work"), Dimension::energy);
}

}  // namespace
}  // namespace tether::coupled
