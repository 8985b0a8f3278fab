// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis chapter 4: Sod's shock tube against the exact Riemann solution, and a gas that expands into a vacuum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/run_deck.hpp"

namespace tether::cases {
namespace {

TEST(Sod, QuadraticDensity) {
  const DeckRun run = run_deck("sod");
  EXPECT_LE(run.summary.at("error_density"), 0.012);
  EXPECT_LE(run.summary.at("error_velocity"), 0.034);
  EXPECT_LE(run.summary.at("error_pressure"), 0.013);
  EXPECT_EQ(run.summary.at("time_end"), 0.143);
  EXPECT_EQ(run.summary.at("steps"), 1430);
}

TEST(Sod, ContinuityDensity) {
  const DeckRun run = run_deck("sod-continuity");
  EXPECT_LE(run.summary.at("error_density"), 0.012);
  EXPECT_LE(run.summary.at("error_velocity"), 0.034);
  EXPECT_LE(run.summary.at("error_pressure"), 0.013);
}

// Fig. 13: the density by cell is the noisy one.
TEST(Sod, CellDensity) { EXPECT_NEAR(run_deck("sod-cell").summary.at("error_density"), 0.047, 0.002); }

// sigma = -p I: the nodal force is m (gamma - 1) i grad N, whatever the density.
TEST(Sod, WithoutViscositiesTheThreeDensitiesMoveAlike) {
  const auto field = [](const std::string& deck, const std::string& name) {
    const DeckRun run = run_deck(deck, {"fluid.lambda=0", "fluid.mu=0"});
    return read_variable(run.folder + "/particles.nc", name);
  };
  for (const std::string name : {"vx", "specific_energy"}) {
    const auto quadratic = field("sod", name);
    for (const std::string deck : {"sod-cell", "sod-continuity"}) {
      const auto other = field(deck, name);
      ASSERT_EQ(other.size(), quadratic.size());
      for (std::size_t k = 0; k < other.size(); ++k) ASSERT_NEAR(other[k], quadratic[k], 1e-11) << deck << " " << name;
    }
  }
}

// First order, as shocks allow, less what artificial viscosity of width g costs: L1 errors on square cells of 1/50,
// 1/100, 1/200 with the step in proportion.
TEST(Sod, ErrorsFallUnderRefinement) {
  const auto at = [](const std::string& nx, const std::string& h, const std::string& dt) {
    return run_deck("sod-continuity", {"in.nx=" + nx, "in.ytop=" + h, "reg.yvi(3,1)=" + h, "reg.yvi(4,1)=" + h,
                                       "reg.yvi(3,2)=" + h, "reg.yvi(4,2)=" + h, "in.tstep=" + dt, "in.dtmax=" + dt})
        .summary;
  };
  const auto coarse = at("51", "0.02", "2e-4"), middle = at("101", "0.01", "1e-4"), fine = at("201", "0.005", "5e-5");
  for (const std::string error : {"error_density", "error_velocity", "error_pressure"}) {
    const double order = std::log2(coarse.at(error) / fine.at(error)) / 2;
    RecordProperty("order_" + error, std::to_string(order));
    EXPECT_GT(order, 0.4) << error;  // measured .49, .65, .44: noise of points that change cell stays
    EXPECT_LT(middle.at(error), coarse.at(error)) << error;
  }
}

/// Sod's tube with gas of density 1 on the left and 1000 on the right, both of pressure 1: nothing moves.
DeckRun two_gases(std::vector<std::string> overrides) {
  for (const char* more : {"in.tmax=0.02", "fluid.siep(2)=0.0025", "reg.densir(2)=1000."}) overrides.push_back(more);
  return run_deck("sod", overrides);
}

double furthest_from(double value, const std::vector<double>& values) {
  double furthest = 0;
  for (const double one : values) furthest = std::max(furthest, std::abs(one - value));
  return furthest;
}

/// How often the run says that it writes pressures of gases that share a density.
std::ptrdiff_t of_mixing(const DeckRun& run) {
  return std::count_if(run.messages.begin(), run.messages.end(), [](const auto& text) {
    return text.find("two gases share the density of the cell") != std::string::npos;
  });
}

// What is written is what the forces have: pressures of 1, and of each point its own gas' density.
TEST(TwoGases, AtRestTheirPressuresAreWrittenAsTheForcesHaveThem) {
  for (const char* more : {"mpm.method='robust'", "mpm.density='continuity'", "mpm.density='cell'"}) {
    const DeckRun run = two_gases({more});
    EXPECT_LT(furthest_from(0, read_variable(run.folder + "/particles.nc", "vx")), 1e-12) << more;
    EXPECT_LT(furthest_from(1, read_variable(run.folder + "/particles.nc", "pressure")), 1e-3) << more;
    EXPECT_LT(run.summary.at("error_density"), 1e-3) << more;
    EXPECT_LT(run.summary.at("error_pressure"), 1e-3) << more;
  }
}

// The thesis' density by the nine cells around a point (4.6) mixes both gases there, and so do the numbers that are
// written with it; the forces, m (gamma - 1) i grad N, do not.
TEST(TwoGases, ByQuadraticDensityWhatIsWrittenMixesThem) {
  const DeckRun run = two_gases({});
  EXPECT_LT(furthest_from(0, read_variable(run.folder + "/particles.nc", "vx")), 1e-12);
  EXPECT_GT(furthest_from(1, read_variable(run.folder + "/particles.nc", "pressure")), 100);
  EXPECT_NEAR(run.summary.at("gases_apart"), 1000, 1);
  EXPECT_EQ(of_mixing(run), 1);
}

// The gases of Sod's tube differ by 1.25 at the start and 1.6 where they meet later, which is no more than the method's
// scatter; gases that share no cell, and whose density is not that of cells, mix in none.
TEST(TwoGases, ThatDoNotMixAreNotTold) {
  const DeckRun sod = run_deck("sod");
  EXPECT_EQ(of_mixing(sod), 0);
  EXPECT_GT(sod.summary.at("gases_apart"), 1.2);
  const DeckRun cell = two_gases({"mpm.density='cell'"});
  EXPECT_EQ(of_mixing(cell), 0);
  EXPECT_EQ(cell.summary.at("gases_apart"), 1);
  EXPECT_EQ(two_gases({"mpm.method='robust'"}).summary.count("gases_apart"), 0U);
}

/// Gas of ten times the pressure on the left of a membrane of so many points, from the bottom to the top of a box.
std::string parted(int points) {
  return "two gases and a membrane\n$in nx=21,ny=12,xleft=0.,xright=2.,ybot=0.,ytop=1.1,tmax=.5,tstep=.002,igen=1,wl=6,"
         "wr=6,wb=6,wt=6 $\n$fluid gm1=.4,siep(1)=5.,siep(2)=5. $\n$reg nreg=2,nvi=4,4,xvi(1,1)=0.,1.,1.,0.,"
         "yvi(1,1)=0.,0.,1.1,1.1,xvi(1,2)=1.,2.,2.,1.,yvi(1,2)=0.,0.,1.1,1.1,densir=1.,.1,nprg=4,4,\n"
         "ipath(1,1)=3,3,3,7,ipath(1,2)=3,3,3,7 $\n$membrane strain='element',curve(1)='line',x(1,1)=1.,1.,"
         "y(1,1)=0.,1.1,density(1)=10.,thickness(1)=.01,young(1)=1.e4,count(1)=" +
         std::to_string(points) + " $\n";
}

// A membrane of four points on eleven cells lets gas through, one of 33 does not.
TEST(TwoGases, ThatPassThroughAMembraneAreCounted) {
  const auto told = [](const DeckRun& run) {
    return std::count_if(run.messages.begin(), run.messages.end(),
                         [](const auto& text) { return text.find("gas seeps through it") != std::string::npos; });
  };
  const DeckRun leaks = run_text("leaks", parted(4)), holds = run_text("holds", parted(33));
  EXPECT_GT(leaks.summary.at("gas_leaked"), 5);
  EXPECT_EQ(told(leaks), 1);
  EXPECT_EQ(holds.summary.at("gas_leaked"), 0);
  EXPECT_EQ(told(holds), 0);
}

struct Expansion {
  double lost, front, asymmetry;
};

Expansion expand(const std::string& dt, const std::string& tmax) {
  const DeckRun run = run_deck("gas-expansion", {"in.tstep=" + dt, "in.dtmax=" + dt, "in.tmax=" + tmax});
  const std::string file = run.folder + "/particles.nc";
  auto x = read_variable(file, "x"), y = read_variable(file, "y");
  const std::size_t n = static_cast<std::size_t>(run.summary.at("points"));
  x.erase(x.begin(), x.end() - static_cast<std::ptrdiff_t>(n));
  y.erase(y.begin(), y.end() - static_cast<std::ptrdiff_t>(n));
  Expansion result{1 - run.last("energy_total") / run.first("energy_total"), 0, 0};
  for (std::size_t p = 0; p < n; ++p) result.front = std::max(result.front, std::hypot(x[p] - 0.5, y[p] - 0.5));
  for (std::size_t p = 0; p < n; ++p) {  // the nearest point to p's mirror image in x = y
    double nearest = 1;
    for (std::size_t q = 0; q < n; ++q) nearest = std::min(nearest, std::hypot(x[q] - y[p], y[q] - x[p]));
    result.asymmetry = std::max(result.asymmetry, nearest);
  }
  return result;
}

TEST(GasExpansion, EnergyIsLostInProportionToTheStep) {
  const Expansion deck = expand("1e-3", "0.02"), tenth = expand("1e-4", "0.02");
  RecordProperty("lost", std::to_string(deck.lost));
  RecordProperty("lost_at_a_tenth", std::to_string(tenth.lost));
  EXPECT_NEAR(deck.lost, 0.012, 0.001);
  EXPECT_LE(tenth.lost, 0.002);
  EXPECT_NEAR(std::log10(deck.lost / tenth.lost), 1, 0.05);  // first order in the step
}

TEST(GasExpansion, SymmetricAndItsFrontInPlace) {
  const Expansion at_5_ms = expand("1e-3", "0.005");
  EXPECT_GE(at_5_ms.front, 0.40);
  EXPECT_LE(at_5_ms.front, 0.67);
  EXPECT_LT(at_5_ms.asymmetry, 1e-12);
  EXPECT_LT(expand("1e-3", "0.02").asymmetry, 1e-12);
}

}  // namespace
}  // namespace tether::cases
