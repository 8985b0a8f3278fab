// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cases/run_deck.hpp"

// Elastic plates in liquids with a surface, against the same fluid without one and against themselves on finer grids.

namespace tether::cases {
namespace {

/// What the tip of a plate does along x.
struct Swing {
  double most = 0, mean = 0, period = 0;
};

Swing swing_of(const DeckRun& run, double from) {
  const auto t = run.history.column("time"), x = run.history.column("point_x_1");
  Swing swing;
  for (const double place : x) {
    swing.most = std::max(swing.most, place - from);
    swing.mean += (place - from) / static_cast<double>(x.size());
  }
  double first = 0, last = 0;
  int count = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double before = x[i - 1] - from - swing.mean, now = x[i] - from - swing.mean;
    if (before >= 0 || now < 0) continue;
    last = t[i - 1] - (t[i] - t[i - 1]) * before / (now - before);
    if (count++ == 0) first = last;
  }
  if (count > 1) swing.period = (last - first) / (count - 1);
  return swing;
}

/// A plate that stands in water below its surface is pushed and swings. Gravity is so small that the surface gives way
/// freely, as does that to a void, which stays where it is.
Swing pushed_plate(const std::string& water) {
  constexpr int cells = 32;
  return swing_of(
      run_text("plate", fmt::format("$in nx={0}, ny={0}, xleft=0., xright=1., ybot=0., ytop=1., tmax=3., tstep=.005, "
                                    "gravc=-.02, units='si', iout(33)=1, tiout(33)=.005 $\n",
                                    cells + 1) +
                            "$reg nreg=1, nvi=4, densir(1)=2000., xvi(1,1)=.47,.53,.53,.47, yvi(1,1)=0.,0.,.42,.42, "
                            "matr(1,1)=1e6,.3 $\n"
                            "$mesh cells(1,1)=2,14, side(1,1)='foot','','tip','' $\n"
                            "$points tracked_at(1,1)=.47,.42 $\n"
                            "$fem law(1)='neo-hookean', fix_on(1)='foot', fix(1:2,1)=0.,0., load_on(1)='tip', "
                            "load(1:2,1)=120.,0. $\n"
                            "$coupled density=1000., " +
                            water + " $\n"),
      0.47);
}

TEST(LiquidPlate, SwingsAsUnderAVoid) {
  const Swing liquid = pushed_plate("liquid=.true., liquid_box(1,1)=0.,1.,0.,.625"),
              filled = pushed_plate("void(1,1)=0.,1.,.625,1.");
  EXPECT_NEAR(liquid.most / filled.most, 1, 0.05);
  EXPECT_NEAR(liquid.mean / filled.mean, 1, 0.01);
  EXPECT_NEAR(liquid.period / filled.period, 1, 0.03);
  EXPECT_GT(liquid.period, 1);
}

/// A column of water falls and strikes it: a plate that is more than two cells wide.
double struck_plate(int cells) {
  const double cell = 0.584 / cells;
  return swing_of(
             run_text(
                 "plate",
                 fmt::format("$in nx={}, ny={}, xleft=0., xright=.584, ybot=0., ytop=.438, tmax=.26, tstep={:.9g}, "
                             "gravc=-9.81, units='si', iout(33)=1, tiout(33)={:.9g} $\n",
                             cells + 1, cells * 3 / 4 + 1, 0.44 * cell, 0.44 * cell) +
                     "$reg nreg=1, nvi=4, densir(1)=2500., xvi(1,1)=.292,.304,.304,.292, yvi(1,1)=0.,0.,.08,.08, "
                     "matr(1,1)=1e6,0. $\n"
                     "$mesh cells(1,1)=1,8, side(1,1)='foot','','tip','' $\n"
                     "$points tracked_at(1,1)=.292,.08 $\n"
                     "$fem fix_on(1)='foot', fix(1:2,1)=0.,0. $\n"
                     "$coupled density=1000., liquid=.true., liquid_box(1,1)=0.,.146,0.,.292 $\n"),
             0.292)
      .most;
}

TEST(LiquidPlate, BendsAlikeOnFinerGrids) {
  const double coarse = struck_plate(at_full_length() ? 128 : 112), fine = struck_plate(at_full_length() ? 160 : 128);
  EXPECT_NEAR(coarse / fine, 1, 0.05);
  EXPECT_GT(fine, 0.04);
}

}  // namespace
}  // namespace tether::cases
