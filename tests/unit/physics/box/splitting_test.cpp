// SPDX-License-Identifier: GPL-3.0-or-later
// When fluid and solids that are solved one after the other hold: theory against steps taken.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "algebra/dense.hpp"
#include "deck/reader.hpp"
#include "physics/box/splitting_limit.hpp"
#include "plan/make_plan.hpp"
#include "read/build.hpp"
#include "unit/algebra/support.hpp"
#include "unit/alone.hpp"

namespace tether::coupled {
namespace {

/// A bar, held at its foot, in a box of 16 x 8 cells, open on the right, of a fluid of density 1, at rest but for the
/// bar, which creeps. Its stiffness K' is E times a number that is alike in all of these scenes.
Scene scene_of(double density, const std::string& coupled = "", const std::string& fem = "",
               const std::string& modulus = "100.") {
  Diagnostics diagnostics;
  const std::string text =
      "$in\nnx=17,ny=9,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=9.,tstep=.05\n$\n$coupled density=1.,side(2)='open',"
      "mode='splitting'" +
      coupled + "$\n$reg nreg=1,nvi=4,xvi(1,1)=.7,.95,.95,.7,yvi(1,1)=0.,0.,.6,.6,vrx(1)=1.e-9,matr(1,1)=" + modulus +
      ",.3,densir=" + std::to_string(density) + "\n$\n$mesh element='p1',cells(1,1)=2,3 $\n$fem fix_on='1.bottom'," +
      "fix(1,1)=0.,0." + fem + " $\n";
  const Deck deck = read_deck(text, "a.in", {}, diagnostics);
  Scene scene = build_scene(deck, std::nullopt, Path::coupled, diagnostics);
  diagnostics.throw_if_errors();
  return scene;
}

double ratio_of(const Scene& scene, double h = 0.05) {
  const CoupledStep step(scene, *scene.solids(), alone());
  return added_mass_ratio(step, scene.solids()->mesh.x, scene.coupled()->density, h).value();
}

double size_of(const std::vector<double>& u) {
  double sum = 0;
  for (const double x : u) sum += x * x;
  return std::sqrt(sum);
}

/// By what the velocities grow in a step, from the steps 40 to 50.
double growth_of(const Scene& scene, double h = 0.05) {
  CoupledStep step(scene, *scene.solids(), alone());
  CoupledState state = step.start();
  double before = 0;
  for (int n = 0; n < 50; ++n) {
    if (n == 40) before = size_of(state.u);
    step.advance(state, h);
  }
  return std::pow(size_of(state.u) / before, 0.1);
}

using Dense = Eigen::MatrixXd;

/// A^-1 B
Dense solution(const Dense& A, const Dense& B) {
  Dense X(B.rows(), B.cols());
  for (Eigen::Index k = 0; k < B.cols(); ++k) X.col(k) = solve(A, B.col(k));
  return X;
}

/// M, C, K and M_a of the velocities that are free.
struct Matrices {
  Dense M, C, K, Ma;

  explicit Matrices(const Scene& scene) {
    const CoupledStep step(scene, *scene.solids(), alone());
    const SolidEquations& solids = step.solids();
    const auto& q = scene.solids()->mesh.x;
    SparseMatrix stiffness = solids.system.pattern.matrix();
    solids.system.elements->add_stiffness(q, true, solids.system.pattern, stiffness);
    K = full_of(stiffness);
    const Dense mass = full_of(solids.system.mass);
    M = Dense::Zero(K.rows(), K.rows());
    for (int a = 0; a < K.rows(); ++a) {
      for (int b = 0; b < K.rows(); ++b) M(a, b) = a % 2 == b % 2 ? mass(a / 2, b / 2) : 0;
    }
    C = scene.solids()->alpha * M + scene.solids()->beta * K;
    const Flow::Equations at = step.flow().equations_at(q, 1 / scene.coupled()->density);
    const Dense B(at.B);
    Ma = B.transpose() * solution(full_of(at.L), B);
    std::vector<int> free;
    for (int k = 0; k < K.rows(); ++k) {
      if (solids.held[std::size_t(k)] == 0) free.push_back(k);
    }
    for (Dense* A : {&M, &C, &K, &Ma}) *A = (*A)(free, free).eval();
  }
};

/// The largest size of an eigenvalue, the limit of |A^n|^(1/n): with n doubled forty times.
double spectral_radius(Dense A) {
  double radius = 1;
  for (double n = 1; n < 1e12; n *= 2) {
    const double size = A.norm();
    radius *= std::pow(size, 1 / n), A /= size;
    A = (A * A).eval();
  }
  return radius;
}

/// The largest size of a root z of z^3 P3 + z^2 P2 + z P1 + P0.
double spectral_radius(const Dense& P3, const Dense& P2, const Dense& P1, const Dense& P0) {
  const Eigen::Index n = P3.rows();
  Dense companion = Dense::Zero(3 * n, 3 * n);
  companion.block(0, n, 2 * n, 2 * n).setIdentity();
  companion.block(2 * n, 0, n, n) = -solution(P3, P0);
  companion.block(2 * n, n, n, n) = -solution(P3, P1);
  companion.block(2 * n, 2 * n, n, n) = -solution(P3, P2);
  return spectral_radius(companion);
}

/// The paper's step with the force of the step before: the powers of z of what splitting_limit.hpp says.
double paper_radius(const Matrices& of, double h) {
  const Dense S = of.K * h * h / 2, D = of.C * h;
  return spectral_radius(of.M + D + S, of.Ma - 2 * of.M - D + S, of.M - 2 * of.Ma, of.Ma);
}

/// By the trapezoidal rule C and K take the means of both ends.
double trapezoidal_radius(const Matrices& of, double h) {
  const Dense S = of.K * h * h / 4, D = of.C * h / 2;
  return spectral_radius(of.M + D + S, of.Ma - 2 * of.M + 2 * S, of.M - 2 * of.Ma - D + S, of.Ma);
}

TEST(SplittingLimit, IsTheLargestEigenvalue) {
  const Scene scene = scene_of(3, "", ",alpha=.2,beta=.001");
  const Matrices of(scene);
  const EigenParts mass = eigen_parts(of.M + of.C * .025);  // of Ma x = lambda (M + C h/2) x, by its root
  const Dense root = mass.vectors * mass.values.cwiseSqrt().cwiseInverse().asDiagonal() * mass.vectors.transpose();
  EXPECT_NEAR(ratio_of(scene) / eigen_parts(root * of.Ma * root).values.maxCoeff(), 1, 1e-6);
}

/// The solid's density at which the ratio is one.
double limit_of(const std::string& coupled, const std::string& fem, const std::string& modulus, double h) {
  double low = 1, high = 1000;
  for (int k = 0; k < 30; ++k) {
    const double middle = std::sqrt(low * high);
    (ratio_of(scene_of(middle, coupled, fem, modulus), h) > 1 ? low : high) = middle;
  }
  return low;
}

TEST(SplittingLimit, StepsGrowAsTheRootsSay) {
  for (const std::string coupled : {"", ",integrator='trapezoid'"}) {
    for (const std::string fem : {"", ",beta=.004", ",alpha=9."}) {
      const Scene scene = scene_of(limit_of(coupled, fem, "100.", .05) / 1.6, coupled, fem);
      const Matrices of(scene);
      const double radius = coupled.empty() ? paper_radius(of, .05) : trapezoidal_radius(of, .05);
      EXPECT_GT(radius, 1.1) << coupled << fem;
      EXPECT_NEAR(growth_of(scene), radius, 2e-4) << coupled << fem;
    }
  }
}

/// Scenes whose ratio is 1.03 and .97: the first grow, the others do not, soft or stiff, damped or not, by any step.
TEST(SplittingLimit, OneIsWhereSplittingFails) {
  for (const double h : {.2, .05, .0125}) {
    for (const std::string coupled : {"", ",integrator='trapezoid'"}) {
      for (const std::string fem : {"", ",beta=.004", ",alpha=9."}) {
        for (const std::string modulus : {"1.", "300."}) {
          const double limit = limit_of(coupled, fem, modulus, h);
          const auto radius = [&](double density) {
            const Matrices of(scene_of(density, coupled, fem, modulus));
            return coupled.empty() ? paper_radius(of, h) : trapezoidal_radius(of, h);
          };
          EXPECT_GT(radius(limit / 1.03), 1) << h << coupled << fem << modulus;
          EXPECT_LT(radius(limit * 1.03), 1 + 1e-12) << h << coupled << fem << modulus;
        }
      }
    }
  }
}

/// What fails by a step fails by any shorter one, and without damping the step has no part.
TEST(SplittingLimit, ShorterStepsDoNotHelp) {
  const Scene bare = scene_of(3), damped = scene_of(3, "", ",beta=.004");
  EXPECT_NEAR(ratio_of(bare, .2), ratio_of(bare, .001), 1e-7 * ratio_of(bare));
  EXPECT_NEAR(ratio_of(bare), ratio_of(scene_of(3, "", "", "1.e7")), 1e-7 * ratio_of(bare));
  EXPECT_GT(ratio_of(damped, .05), 1.2 * ratio_of(damped, .2));
  EXPECT_GT(ratio_of(damped, .0125), 1.2 * ratio_of(damped, .05));
}

/// A block across a channel, open at both ends, .3 of water on both sides. When its sides move apart or as one, water
/// of 1000 (.3) moves with a square unit of each. The block's linear elements, .1 wide, form a chain of which a side
/// feels the mass 3 (.1)/(2 sqrt 3), when the nodes behind it give way. Motions that are uneven over a side add a
/// little.
TEST(SplittingLimit, OfAPistonIsThatOfItsSidesByHand) {
  Diagnostics diagnostics;
  const Deck deck = read_deck(
      "$in\nnx=21,ny=5,xleft=0.,xright=1.,ybot=0.,ytop=.2,tmax=1.,tstep=.05\n$\n$coupled density=1000.,"
      "side='open','open',mode='splitting'\n$\n$reg nreg=1,nvi=4,xvi(1,1)=.3,.7,.7,.3,yvi(1,1)=0.,0.,.2,.2,"
      "matr(1,1)=1.e6,.3,densir=3000.\n$\n$mesh element='p1',cells(1,1)=4,4 $\n",
      "a.in", {}, diagnostics);
  const Scene scene = build_scene(deck, std::nullopt, Path::coupled, diagnostics);
  diagnostics.throw_if_errors();
  const double ratio = 1000 * .3 / (3000 * .1 / (2 * std::sqrt(3.)));
  EXPECT_GT(ratio_of(scene), ratio);
  EXPECT_LT(ratio_of(scene), 1.05 * ratio);
}

/// In space only boxes that factors solve have it, and a fluid alone has none.
TEST(SplittingLimit, IsToldOfScenes) {
  Scene scene = scene_of(3);
  EXPECT_EQ(added_mass_ratio(scene, .05), ratio_of(scene));
  const double limit = limit_of("", "", "100.", .05);
  EXPECT_EQ(splitting_text(make_plan(scene_of(2 * limit))),
            "splitting: would hold by theory: in the worst motion of the bodies their added mass is 0.5 times m + c "
            "h/2\n");
  EXPECT_EQ(splitting_text(make_plan(scene_of(limit / 2))).find("splitting: would fail by theory: "), 0u);
  const Scene iterated = scene_of(3, ",solver='krylov'");
  EXPECT_FALSE(added_mass_ratio(iterated, .05).has_value());
  EXPECT_EQ(splitting_text(make_plan(iterated)).find("splitting: would fail by estimate: moving body 1"), 0u);
  set_solids(scene.physics, nullptr);
  EXPECT_EQ(splitting_text(make_plan(scene)), "");
}

TEST(SplittingLimit, AClosedBoxHasNone) {
  const Scene scene = scene_of(3, ",side(2)='wall'");
  const CoupledStep step(scene, *scene.solids(), alone());
  EXPECT_FALSE(added_mass_ratio(step, scene.solids()->mesh.x, 1, .05).has_value());
}

}  // namespace
}  // namespace tether::coupled
