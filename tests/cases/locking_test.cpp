// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "cases/run_deck.hpp"

// What the program says of elements that lock, against what they do: static cantilevers against the beam with shear,
// and a sheared panel against fine elements of order 2.

namespace tether::cases {
namespace {

/// Of a plate of length L and thickness 1 in plane strain, E = 1, held at its left, a shear force on its right side.
struct HeldPlate {
  std::string element;
  int across;
  double length, nu;
  std::string dilatation = "auto";
};

DeckRun bent(const HeldPlate& plate) {
  return run_text("locking",
                  fmt::format("a plate that bends\n$in nx=2,ny=2,xleft=-1.,xright=99.,ybot=-9.,ytop=9.,tmax=1.,"
                              "tstep=1.,iout(33)=1,tiout(33)=1. $\n"
                              "$reg nreg=1,nvi=4,xvi(1,1)=0.,{0},{0},0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=1.,"
                              "matr(1,1)=1.,{1} $\n$mesh element='{2}',cells(1,1)={3},{4} $\n"
                              "$fem static=.true.,law(1)='linear',dilatation='{5}',fix_on(1)='1.left',fix(1:2,1)=0.,0.,"
                              "load_on(1)='1.right',load(2,1)=1e-6 $\n$points tracked_at(1,1)={0},0.5 $\n",
                              plate.length, plate.nu, plate.element, static_cast<int>(plate.across * plate.length),
                              plate.across, plate.dilatation));
}

double deflection(const DeckRun& run) { return run.last("point_y_1") - 0.5; }

/// Timoshenko's: L^3/(3 E' I) + L/(5/6 G).
double of_the_beam(const HeldPlate& plate) {
  const double L = plate.length;
  return 1e-6 * (4 * L * L * L * (1 - plate.nu * plate.nu) + L * 2.4 * (1 + plate.nu));
}

TEST(Locking, IsSaidOfBeamsAsMuchAsItIs) {
  for (const HeldPlate& plate :
       {HeldPlate{"q1", 3, 10, 0.3, "point"}, HeldPlate{"q1", 3, 10, 0.4, "point"}, HeldPlate{"p1", 3, 10, 0.3},
        HeldPlate{"p1", 6, 10, 0.45}, HeldPlate{"q1", 2, 10, 0.49, "point"}, HeldPlate{"q1", 2, 10, 0},
        HeldPlate{"q1", 2, 10, 0.3}, HeldPlate{"q1", 2, 10, 0.45}}) {
    const DeckRun run = bent(plate);
    const double too_stiff = of_the_beam(plate) / deflection(run) - 1;
    EXPECT_EQ(run.summary.at("elements_across"), plate.across);
    EXPECT_NEAR(run.summary.at("bending_too_stiff"), too_stiff, too_stiff / 6) << plate.element << " " << plate.nu;
    ASSERT_EQ(run.warnings.size(), 1u);
    EXPECT_NE(run.warnings[0].find(fmt::format("{} {} elements across its thickness 1 with nu = {}", plate.across,
                                               plate.element, plate.nu)),
              std::string::npos)
        << run.warnings[0];
  }
}

TEST(Locking, IsSaidOfPanelsThatHardlyChangeTheirVolume) {
  for (const double nu : {0.49, 0.4999}) {
    const double right = deflection(bent({"q2", 12, 2, nu}));
    for (const int across : {4, 8}) {
      const DeckRun run = bent({"q1", across, 2, nu, "point"});
      const double too_stiff = right / deflection(run) - 1;
      EXPECT_NEAR(run.summary.at("bending_too_stiff"), too_stiff, too_stiff / 3) << nu << " " << across;
    }
  }
}

/// Elements of order 2 do not lock, and are off by little: as much as is said within 2 % of the stiffness.
TEST(Locking, OfElementsOfOrder2IsEstimated) {
  for (const double length : {5.0, 10.0}) {
    for (const double nu : {0.0, 0.3, 0.499}) {
      const double fine = deflection(bent({"q2", 6, length, nu}));
      for (const char* element : {"q2", "p2"}) {
        for (const int across : {1, 2, 3}) {
          const DeckRun run = bent({element, across, length, nu});
          const double too_stiff = fine / deflection(run) - 1;
          EXPECT_EQ(run.summary.at("elements_across"), across);
          EXPECT_NEAR(run.summary.at("bending_too_stiff"), too_stiff, 0.02 + 0.1 * std::abs(too_stiff))
              << element << " " << across << " " << nu << " " << length;
        }
      }
    }
  }
  const DeckRun soft = bent({"p2", 1, 10, 0.499});
  ASSERT_EQ(soft.warnings.size(), 1u);
  EXPECT_NE(soft.warnings[0].find("1 p2 element across its thickness 1 with nu = 0.499 gives way where it bends"),
            std::string::npos)
      << soft.warnings[0];
}

/// A quarter of a pinched ring by so many elements along, one across: elements that are curved themselves.
DeckRun pinched(int along, double thick) {
  return run_text("pinched",
                  fmt::format("a pinched ring\n$in nx=2,ny=2,xleft=-99.,xright=99.,ybot=-99.,ytop=99.,wl=1,wr=1,wb=1,"
                              "wt=1,tmax=1.,tstep=1.,iout(33)=1,tiout(33)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)={0},{1},0.,"
                              "0.,yvi(1,1)=0.,0.,{1},{0},densir(1)=1.,matr(1,1)=1e6,.3 $\n$mesh cells(1,1)=1,{2},"
                              "edge(2,1)='arc',edge(4,1)='arc' $\n$fem static=.true.,law(1)='linear',"
                              "fix_on(1)='1.bottom',fix(2,1)=0.,fix_on(2)='1.top',fix(1,2)=0.,load_on(1)='1.bottom',"
                              "load(1,1)=1e-3 $\n$points tracked_at(1,1)=10.,0. $\n",
                              10 - thick / 2, 10 + thick / 2, along));
}

TEST(Locking, OfCurvedElementsIsEstimated) {
  for (const auto& [thick, along] : {std::pair(0.2, 8), {0.2, 12}, {0.5, 6}, {1.0, 4}}) {
    const DeckRun run = pinched(along, thick);
    const double too_stiff = (pinched(64, thick).last("point_x_1") - 10) / (run.last("point_x_1") - 10) - 1;
    EXPECT_NEAR(run.summary.at("bending_too_stiff"), too_stiff, 0.02 + 0.4 * std::abs(too_stiff)) << thick << along;
  }
  EXPECT_EQ(pinched(6, 0.2).warnings.size(), 1u);
  EXPECT_EQ(pinched(24, 0.2).warnings, std::vector<std::string>{});
}

/// Parallelograms, of which the estimate knows the thickness alone.
TEST(Locking, OfElementsThatLeanIsTold) {
  const auto warnings = [](double shift) {
    return run_text("leaning", fmt::format("a panel\n$in nx=2,ny=2,xleft=-9.,xright=19.,ybot=-9.,ytop=9.,tmax=1.,"
                                           "tstep=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,10.,{0},{1},yvi(1,1)=0.,0.,1.,1.,"
                                           "densir(1)=1.,matr(1,1)=1e5,.3 $\n$mesh cells(1,1)=10,1 $\n$fem "
                                           "static=.true.,law(1)='linear',fix_on(1)='1.left',fix(1:2,1)=0.,0. $\n",
                                           10 + shift, shift))
        .warnings;
  };
  ASSERT_EQ(warnings(3).size(), 1u);
  EXPECT_NE(warnings(3)[0].find("lean by 72 degrees"), std::string::npos) << warnings(3)[0];
  EXPECT_EQ(warnings(0.5), std::vector<std::string>{});
}

/// St Venant and Kirchhoff's law holds the trace of the strain.
TEST(Locking, OfALawThatHoldsNoVolumeIsTold) {
  const auto warnings = [](const char* law, double nu) {
    return run_text("trace", fmt::format("a beam\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=1.,tstep=1. $"
                                         "\n$reg nreg=1,nvi=4,xvi(1,1)=0.,4.,4.,0.,yvi(1,1)=0.,0.,.5,.5,densir(1)=1.,"
                                         "matr(1,1)=1000.,{} $\n$mesh cells(1,1)=8,1 $\n$fem law(1)='{}',static=.true.,"
                                         "fix_on(1)='1.left',fix(1:2,1)=0.,0. $\n",
                                         nu, law))
        .warnings;
  };
  ASSERT_EQ(warnings("svk", 0.4999).size(), 1u);
  EXPECT_NE(warnings("svk", 0.4999)[0].find("holds the trace of the strain"), std::string::npos);
  for (const auto& [law, nu] : {std::pair("svk", 0.45), {"neo-hookean", 0.4999}, {"linear", 0.4999}})
    EXPECT_EQ(warnings(law, nu), std::vector<std::string>{}) << law;
}

TEST(Locking, IsNotSaidWhereThereIsNone) {
  EXPECT_EQ(bent({"q1", 6, 10, 0.3}).warnings, std::vector<std::string>{});
  EXPECT_EQ(bent({"p1", 12, 10, 0.3}).warnings, std::vector<std::string>{});
  const DeckRun run = bent({"q2", 1, 10, 0.3});
  EXPECT_EQ(run.warnings, std::vector<std::string>{});
  EXPECT_NEAR(deflection(run) / of_the_beam({"q2", 1, 10, 0.3}), 1, 0.02);
}

/// A block that flies, and one that is held at a side.
std::vector<std::string> warnings_of(const std::string& name, double length, bool held) {
  return run_text(name, fmt::format("a block\n$in nx=2,ny=2,xleft=-1.,xright=99.,ybot=-9.,ytop=9.,tmax=1e-3,"
                                    "tstep=1e-3,iout(33)=1,tiout(33)=1e-3 $\n"
                                    "$reg nreg=1,nvi=4,xvi(1,1)=0.,{0},{0},0.,yvi(1,1)=0.,0.2,1.2,1.,densir(1)=1.,"
                                    "matr(1,1)=1.,.3,vrx(1)=.1 $\n$mesh element='p1',cells(1,1)=6,6 $\n$fem {1} $\n",
                                    length, held ? "fix_on(1)='1.left',fix(1:2,1)=0.,0." : ""))
      .warnings;
}

/// What is as long as it is thick and free is squeezed, not bent.
TEST(Locking, IsNotSaidOfBlocksThatNothingBends) {
  EXPECT_EQ(warnings_of("locking-free", 1.3, false), std::vector<std::string>{});
  EXPECT_EQ(warnings_of("locking-held", 1.3, true).size(), 1u);
  EXPECT_EQ(warnings_of("locking-long", 3, false).size(), 1u);
}

}  // namespace
}  // namespace tether::cases
