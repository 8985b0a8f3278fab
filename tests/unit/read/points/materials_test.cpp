// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/materials.hpp"

#include <gtest/gtest.h>

#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

constexpr const char* gas_constants = "$fluid gm1=.5,mu=.1,lambda=.7,coef1=.2,coef2=.3,siep(1)=9. $\n";

/// The law of region 1 with these values behind those of the square region, and with $fluid and $mpm groups.
Material law_of(const std::string& reg, const std::string& groups = gas_constants) {
  const Built built = build(square_region("", reg) + groups);
  EXPECT_EQ(built.errors(), Texts{});
  return built.scene.bodies.at(0).material;
}

TEST(RegionMaterial, PlaneStrain) {  // E = 10, nu = .25: lambda = 4, G = 4
  const auto law = std::get<PlaneElastic>(law_of("ipath(1,1)=3,3,3,0"));
  EXPECT_EQ(law.plane, PlaneElastic::Plane::strain);
  EXPECT_EQ(law.E, 10);
  EXPECT_EQ(law.nu, 0.25);
  EXPECT_NEAR(law.lambda, 4, 1e-15);
  EXPECT_NEAR(law.G, 4, 1e-15);
}

TEST(RegionMaterial, PlaneStress) {  // lambda = E nu / (1 - nu^2) = 8/3
  const auto law = std::get<PlaneElastic>(law_of("ipath(4,1)=2"));
  EXPECT_EQ(law.plane, PlaneElastic::Plane::stress);
  EXPECT_NEAR(law.lambda, 8.0 / 3, 1e-15);
  EXPECT_NEAR(law.G, 4, 1e-15);
}

TEST(RegionMaterial, LinearFluid) { EXPECT_EQ(std::get<LinearFluid>(law_of("ipath(4,1)=8")).beta, 10); }

TEST(RegionMaterial, GasByContinuityOrQuadraticDensity) {
  const auto continuity = std::get<IdealGas>(law_of("ipath(4,1)=7"));
  EXPECT_EQ(continuity.rule, DensityRule::continuity);
  EXPECT_EQ(continuity.gm1, .5);
  EXPECT_EQ(continuity.mu, .1);
  EXPECT_EQ(continuity.lambda, .7);
  EXPECT_EQ(continuity.coef1, .2);
  EXPECT_EQ(continuity.coef2, .3);
  EXPECT_EQ(std::get<IdealGas>(law_of("ipath(4,1)=9")).rule, DensityRule::quadratic);
}

TEST(RegionMaterial, DensityOfTheMpmGroupWinsOverIpath) {
  const auto rule = [](const char* ipath, const std::string& density) {
    return std::get<IdealGas>(law_of(ipath, gas_constants + ("$mpm density='" + density + "' $\n"))).rule;
  };
  EXPECT_EQ(rule("ipath(4,1)=9", "cell"), DensityRule::cell);
  EXPECT_EQ(rule("ipath(4,1)=9", "continuity"), DensityRule::continuity);
  EXPECT_EQ(rule("ipath(4,1)=7", "quadratic"), DensityRule::quadratic);
}

TEST(RegionMaterial, SpecificEnergyOfAGasRegion) {
  const Built built = build(square_region("", "ipath(4,1)=7") + gas_constants);
  EXPECT_EQ(built.scene.bodies.at(0).specific_energy, 9);
}

Texts errors_of(const std::string& reg) { return build(square_region("", reg)).errors(); }

TEST(RegionMaterialErrors, LawsThatAreNone) {
  EXPECT_EQ(errors_of("ipath(4,1)=1"), (Texts{"10:12: region 1: ipath(4) = 1 names no law"}));
  EXPECT_EQ(errors_of("ipath(4,1)=-7"), (Texts{"10:12: region 1: ipath(4) = -7 names no law"}));
  const std::string no_law = on_unit_square("$\n$reg nreg=1,nvi=3,xvi=0.,1.,1.,yvi=0.,0.,1.,densir=1. $\n");
  EXPECT_EQ(build(no_law).errors(), (Texts{"4:1: region 1: ipath(4,1) is not given"}));
}

TEST(RegionMaterialErrors, ConstantsOutOfRange) {
  EXPECT_EQ(errors_of("matr(1,1)=0.,.5"), (Texts{"10:11: region 1: an elastic solid needs Young's modulus > 0, not 0",
                                                 "10:14: region 1: Poisson's ratio 0.5 is out of range"}));
  EXPECT_EQ(errors_of("matr(2,1)=-1."), (Texts{"10:11: region 1: Poisson's ratio -1 is out of range"}));
  EXPECT_EQ(errors_of("ipath(4,1)=2,matr(2,1)=.5"), Texts{});  // plane stress takes an incompressible solid
  EXPECT_EQ(errors_of("ipath(4,1)=2,matr(2,1)=.51"), (Texts{"10:24: region 1: Poisson's ratio 0.51 is out of range"}));
  EXPECT_EQ(errors_of("ipath(4,1)=8,matr(1,1)=-2."),
            (Texts{"10:24: region 1: a linear fluid needs its bulk modulus > 0, not -2"}));
}

/// A particle file of two points with this law and these two first constants, from line 5 on.
Built file_with(const std::string& ipath, const std::string& constants, const std::string& groups = "") {
  return build(on_unit_square("igen=0\n$\n" + groups + "1.\n" + constants + ",0,0,0,0,0\n3,3,3," + ipath +
                              "\n2\n2,1\n.25 .5 0 0 0 0 0\n.5 .5 0 0 0 0 0\n"));
}

TEST(FileMaterial, AStringPullsOnlyUnlessTheDeckSaysOtherwise) {
  const auto string = std::get<Membrane>(file_with("8", "7,.3").scene.bodies.at(0).material);
  EXPECT_EQ(string.E, 7);
  EXPECT_EQ(string.nu, .3);
  EXPECT_TRUE(string.wrinkle);
  const Built spring = file_with("8", "7,.3", "$membrane wrinkle=.false. $\n");
  EXPECT_FALSE(std::get<Membrane>(spring.scene.bodies.at(0).material).wrinkle);
}

TEST(FileMaterial, AMembraneInPlaneStressByTheDeck) {
  const char* group = "$membrane law(1)='plane-stress' $\n";
  const auto kind = [](const Built& built) { return std::get<Membrane>(built.scene.bodies.at(0).material).kind; };
  EXPECT_EQ(kind(file_with("8", "7,.3", group)), Membrane::Kind::plane_stress);
  EXPECT_EQ(kind(file_with("8", "7,.3")), Membrane::Kind::uniaxial);
}

TEST(FileMaterial, ElasticInPlaneStrainOrPlaneStress) {
  const auto plane = [](const char* ipath) {
    return std::get<PlaneElastic>(file_with(ipath, "10,.25").scene.bodies.at(0).material).plane;
  };
  EXPECT_EQ(plane("0"), PlaneElastic::Plane::strain);
  EXPECT_EQ(plane("2"), PlaneElastic::Plane::stress);
}

TEST(FileMaterialErrors, AtTheirLines) {
  EXPECT_EQ(file_with("7", "1,0").errors(), (Texts{"7:1: ipath(4) = 7 in a particle file names no law"}));
  EXPECT_EQ(file_with("8", "0,0").errors(), (Texts{"6:1: a string needs Young's modulus > 0, not 0"}));
  EXPECT_EQ(file_with("8", "7,.51", "$membrane law='plane-stress' $\n").errors(),
            (Texts{"7:1: Poisson's ratio 0.51 is out of range"}));
  EXPECT_EQ(file_with("8", "7,.51").errors(), Texts{});  // which a uniaxial law does not read
  EXPECT_EQ(file_with("0", "1,.5").errors(), (Texts{"6:1: Poisson's ratio 0.5 is out of range"}));
}

}  // namespace
}  // namespace tether::test
