// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cases/run_deck.hpp"

// Stress and energy density at the nodes, against those of bending.

namespace tether::cases {
namespace {

constexpr double beam_length = 0.3, height = 0.02, beam_modulus = 7e10, shear = 1e5;

/// A cantilever under a shear load of 1e5 on its end, with nu = 0, so that its law is the same in the plane and in
/// space.
DeckRun cantilever(const char* element, int along, int across, bool space = false) {
  const std::string text = fmt::format(
      "a cantilever\n$in "
      "nx=2,ny=2,xleft=-1.,xright=1.,ybot=-1.,ytop=1.,wl=1,wr=1,wb=1,wt=1,tmax=1.,tstep=1.,iout(33)=1,"
      "tiout(33)=1.,iout(39)=1,tiout(39)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,{0},{0},0.,yvi(1,1)=-{1},-{1},{1},{1},"
      "densir(1)=2700.,matr(1,1)={2},0. $\n$mesh element='{3}',cells(1,1)={4},{5}{6} $\n$fem "
      "static=.true.,law(1)='linear',"
      "fix_on(1)='1.left',fix(1,1)=0.,fix(2,1)=0.,{7}load_on(1)='1.right',load(2,1)={8} $\n",
      beam_length, height / 2, beam_modulus, element, along, across, space ? ",2, z(1,1)=0.,.02" : "",
      space ? "fix(3,1)=0.," : "", shear);
  return run_text("cantilever", text);
}

/// A field at the end at the node on top at x = 0.1, over its exact number: by the moment M = shear h (L - x) a unit of
/// depth, sxx = 6 M / h^2, and sxx^2 / 2 E.
double ratio(const DeckRun& run, const std::string& field) {
  const std::string file = run.folder + "/mesh.nc";
  const auto x = read_variable(file, "node_x"), y = read_variable(file, "node_y"), all = read_variable(file, field);
  const double stress = -6 * shear * (beam_length - 0.1) / height,
               exact = field == "sxx" ? stress : stress * stress / (2 * beam_modulus);
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (std::abs(x[n] - 0.1) < 1e-9 && std::abs(y[n] - height / 2) < 1e-9)
      return all[all.size() - x.size() + n] / exact;
  }
  ADD_FAILURE() << "no node on top at 0.1";
  return 0;
}

TEST(NodalStress, OfBendingIsThatOfTheSurface) {
  for (const int across : {1, 2, 4}) {
    const DeckRun run = cantilever("q2", 15 * across, across);
    EXPECT_NEAR(ratio(run, "sxx"), 1, 0.003) << across;
    EXPECT_NEAR(ratio(run, "energy_density"), 1, 0.01) << across;
  }
  const DeckRun space = cantilever("q2", 15, 1, true);
  EXPECT_NEAR(ratio(space, "sxx"), 1, 0.01);
  EXPECT_NEAR(ratio(space, "energy_density"), 1, 0.02);
}

/// Elements of order 1 lock; what is left converges with order 2, where the mean over an element is half a cell off.
TEST(NodalStress, OfElementsOfOrder1Converges) {
  const double coarse = 1 - ratio(cantilever("q1", 60, 4), "sxx"), fine = 1 - ratio(cantilever("q1", 120, 8), "sxx");
  EXPECT_LT(std::abs(fine), 0.02);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

}  // namespace
}  // namespace tether::cases
