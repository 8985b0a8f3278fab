// SPDX-License-Identifier: GPL-3.0-or-later
// What the plan says of a deck with $coupled, and the estimate of whether splitting would hold.
#include "plan/coupled_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/reader.hpp"
#include "plan/added_mass.hpp"
#include "plan/make_plan.hpp"
#include "plan/plan_text.hpp"
#include "read/build.hpp"

namespace tether {
namespace {

/// A box of 4 x 2, open on the right, of a fluid of density 2, with a body from x = 1 to 1.5 and y = .5 to 1.5 of two
/// triangles, whose four nodes are all on its surface: its mass is .5 times its density.
Scene scene_of(const std::string& coupled, const std::string& fem = "", const std::string& reg = "densir=3.",
               const std::string& mesh = "", const std::string& element = "p1") {
  Diagnostics diagnostics;
  const std::string text =
      "$in\nnx=9,ny=5,xleft=0.,xright=4.,ybot=0.,ytop=2.,tmax=1.,tstep=.5\n$\n$coupled density=2.,side(2)='open'," +
      coupled + "$\n$reg nreg=1,nvi=4,xvi(1,1)=1.,1.5,1.5,1.,yvi(1,1)=.5,.5,1.5,1.5,matr(1,1)=100.,0.," + reg +
      "\n$\n$mesh element='" + element + "'," + mesh + " $\n$fem " + fem + " $\n";
  const Deck deck = read_deck(text, "a.in", {}, diagnostics);
  Scene scene = build_scene(deck, std::nullopt, Path::coupled, diagnostics);
  diagnostics.throw_if_errors();
  return scene;
}

std::string term_of(const Scene& scene, const std::string& name) {
  const auto terms = coupled_terms(scene);
  const auto found = std::find_if(terms.begin(), terms.end(), [&](const Term& term) { return term.name == name; });
  return found == terms.end() ? "none" : (found->on ? "" : "not: ") + found->reason;
}

/// The surface, 3, drives fluid through a channel 2 wide to the right side, 2.5 away.
TEST(SplittingEstimate, OfASurfaceIsThatOfTheChannelToTheOpening) {
  const auto estimate = splitting_estimate(scene_of(""));
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->body, 1);
  EXPECT_EQ(estimate->motion, BodyMotion::swelling);
  EXPECT_NEAR(estimate->added, 2 * 3 * 3 * 2.5 / 2, 1e-12);
  EXPECT_NEAR(estimate->mass, 1.5 / std::numbers::sqrt3, 1e-12);
  EXPECT_EQ(estimate->damping, 0);
  EXPECT_FALSE(estimate->holds());
  EXPECT_NEAR(splitting_estimate(scene_of("side(4)='open'"))->added, 2 * 3 * 3 * .5 / 4, 1e-12);
  EXPECT_NEAR(splitting_estimate(scene_of("void(1,1)=2.5,3.,0.,2."))->added, 2 * 3 * 3 * 1. / 2, 1e-12);
}

/// Whatever the elements, surface and mass are those of the body; of nine nodes of q2 eight are on the surface.
TEST(SplittingEstimate, HoldsForAllElements) {
  for (const auto& [element, part] : {std::pair("q1", 1.0), {"q2", 8.0 / 9}, {"p2", 5.0 / 6}}) {
    const auto estimate = splitting_estimate(scene_of("", "", "densir=3.", "", element));
    ASSERT_TRUE(estimate) << element;
    EXPECT_NEAR(estimate->added, 2 * 3 * 3 * 2.5 / 2, 1e-12) << element;
    EXPECT_NEAR(estimate->mass, part * 1.5 / std::numbers::sqrt3, 1e-12) << element;
    EXPECT_NEAR(splitting_estimate(scene_of("side(2)='wall'", "", "densir=3.", "", element))->mass, 1.5, 1e-12);
  }
}

/// Held nodes' sides do not move; the masses of the nodes beside them do. In a closed box nothing swells.
TEST(SplittingEstimate, LeavesOutWhatCannotMove) {
  const auto held = splitting_estimate(scene_of("", "fix_on='1.left',fix(1,1)=0.,0."));
  EXPECT_NEAR(held->added, 2 * 2 * 2 * 2.5 / 2, 1e-12);
  const auto closed = splitting_estimate(scene_of("side(2)='wall'"));
  EXPECT_EQ(closed->motion, BodyMotion::broadside);
  EXPECT_NEAR(closed->added, 2 * std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(closed->mass, 1.5, 1e-12);
  EXPECT_TRUE(std::isinf(splitting_estimate(scene_of("side(2)='wall',area_repair=.false."))->added));
}

/// A layer of 2 (1.5) / (3 (3)) = 1/3 of modulus 100: a stiffness of 900, times beta h/2.
TEST(SplittingEstimate, RayleighDampingResists) {
  const double mass = 1.5 / std::numbers::sqrt3;
  EXPECT_NEAR(splitting_estimate(scene_of("", "beta=.01"))->damping, .01 * 900 / 4, 1e-12);
  EXPECT_NEAR(splitting_estimate(scene_of("", "alpha=4."))->damping, 4 * mass / 4, 1e-12);
  EXPECT_FALSE(splitting_estimate(scene_of("", "beta=.0945", "densir=4."))->holds());
  EXPECT_TRUE(splitting_estimate(scene_of("", "beta=.0952", "densir=4."))->holds());
  EXPECT_EQ(splitting_estimate(scene_of("integrator='trapezoid'", "beta=.2"))->damping, 0);
}

/// The root z, next to -1, of the step of one mass on a spring with a dashpot, whose force of added mass is that of the
/// accelerations of the step before: (inertia of the step) z = (rest of the step) - M_a (1 - 1/z).
TEST(SplittingEstimate, GrowthIsThatOfTheRootBesideMinusOne) {
  const double M = 22.5, m = 22.4, c = .2, k = 30, h = .1;
  const auto root = [&](double left, double right) {
    double z = -1;
    for (int i = 0; i < 200; ++i) {  // by Newton's method on F(z) with a difference quotient
      const auto F = [&](double s) { return left * s - right + h * h * k * (s + 1) / (2 * (s - 1)) + M * (1 - 1 / s); };
      z -= F(z) * 2e-6 / (F(z + 1e-6) - F(z - 1e-6));
    }
    return -z;
  };
  SplittingEstimate paper;
  paper.added = M, paper.mass = m, paper.damping = c * h / 2, paper.inertia = m + c * h + k * h * h / 4;
  EXPECT_NEAR(paper.growth() - 1, root(m + c * h + h * h * k / 2, m - h * h * k / 2) - 1, 2e-5);
  SplittingEstimate trapezoid;
  trapezoid.added = M, trapezoid.mass = m, trapezoid.inertia = m + c * h / 2;
  EXPECT_NEAR(trapezoid.growth() - 1, root(m + c * h / 2 + h * h * k / 4, m - c * h / 2 - h * h * k / 4) - 1, 2e-5);
  EXPECT_GT(trapezoid.growth() - 1, 4e-3);
}

TEST(SplittingEstimate, IsTheWorstOfAllBodies) {
  const Scene two = scene_of("", "",
                             "densir=60.,60.,nreg=2,nvi(2)=4,xvi(1,2)=2.,2.5,2.5,2.,yvi(1,2)=.5,.5,1.5,1.5,"
                             "matr(1,2)=100.,0.");
  EXPECT_EQ(splitting_estimate(two)->body, 1);  // further from the open side
  const Scene light = scene_of("", "",
                               "densir=60.,20.,nreg=2,nvi(2)=4,xvi(1,2)=2.,2.5,2.5,2.,yvi(1,2)=.5,.5,1.5,1.5,"
                               "matr(1,2)=100.,0.");
  EXPECT_EQ(splitting_estimate(light)->body, 2);
}

/// A plate 1 long, .5 wide, and a box 1 deep.
TEST(SplittingEstimate, InSpaceAPlateIsAsLongAsItIs) {
  const Scene scene = scene_of("side(2)='wall',nz=5,zback=0.,zfront=1.", "", "densir=3.", "z(1,1)=.25,.5");
  const auto estimate = splitting_estimate(scene);
  EXPECT_NEAR(estimate->added, 2 * std::numbers::pi / 4 * .25, 1e-12);
  EXPECT_NEAR(estimate->mass, 3 * .5 * .25, 1e-12);
  const Scene open = scene_of("nz=5,zback=0.,zfront=1.", "", "densir=3.", "z(1,1)=.25,.5");
  EXPECT_NEAR(splitting_estimate(open)->added, 2 * 1.75 * 1.75 * 2.5 / 2, 1e-12);
}

TEST(SplittingEstimate, IsToldWithWhatItComparesAndByWhatErrorsGrow) {
  const auto text = [](const Scene& scene) { return estimate_text(*splitting_estimate(scene)); };
  EXPECT_EQ(text(scene_of("")),
            "moving body 1's surface outwards, the added mass 22.5 is above m + c h/2 = 0.866, and errors grow about "
            "1.54 times a step");
  EXPECT_EQ(text(scene_of("", "", "densir=80.")),
            "moving body 1's surface outwards, the added mass 22.5 is below m + c h/2 = 23.1");
  EXPECT_EQ(text(scene_of("side(2)='wall',area_repair=.false.")),
            "moving body 1's surface outwards, fluid has no way out");
}

TEST(CoupledPlan, SaysByWhichMode) {
  EXPECT_EQ(term_of(scene_of(""), "mode"),
            "cut-cell: simultaneous, with the open parts of faces; power balances to rounding");
  EXPECT_EQ(term_of(scene_of("mode='symmetric'"), "mode"),
            "symmetric: simultaneous, power across the interface balances to rounding");
  EXPECT_EQ(term_of(scene_of("mode='splitting'"), "mode"), "splitting: solids and fluid one after the other");
  EXPECT_EQ(term_of(scene_of("mode='paper'"), "mode"),
            "paper: simultaneous by two maps, whose powers differ; would take cut-cell");
}

TEST(CoupledPlan, SaysWhatIsModelled) {
  const Scene scene = scene_of("jet_on='left',jet(1,1)=.5,1.5,jet_speed=3.,jet_smoke=1.,smoke_weight=.1,friction=.2");
  EXPECT_EQ(term_of(scene, "jets"), "jet 1 on the left (area 1, speed 3)");
  EXPECT_EQ(term_of(scene, "smoke"), "weight 0.1, lift 0");
  EXPECT_EQ(term_of(scene, "open sides"), "right");
  EXPECT_EQ(term_of(scene, "viscosity"), "not: mu = 0: the fluid slips along walls");
  EXPECT_EQ(term_of(scene, "contact"), "with walls and obstacles, friction 0.2");
  EXPECT_EQ(term_of(scene, "linear systems"), "factors: the box is plane");
  EXPECT_EQ(term_of(scene_of("solver='krylov'"), "linear systems"), "conjugate gradients, as the deck says");
  EXPECT_EQ(term_of(scene, "closed regions"), "found each step, their volumes held");
}

TEST(CoupledPlan, StepsAreTheDecks) {
  const Plan plan = make_plan(scene_of(""));
  EXPECT_EQ(plan.step.first_step(), .5);
  EXPECT_EQ(plan.cost.steps, 2);
  EXPECT_EQ(plan.cost.point_steps, 64);
  const std::string text = to_text(plan);
  EXPECT_EQ(text.find("path: coupled (plane, incompressible flow and solids)\ngrid: 8 x 4 cells of 0.5 x 0.5\n"), 0u);
  EXPECT_NE(text.find("solids: 2 elements p1, 4 nodes, 1 bodies\nregion 1: density 3, St Venant"), std::string::npos);
  EXPECT_NE(text.find("\nstep: 0.5, the deck's\n"), std::string::npos);
}

/// A plate 1 long, 0.5 wide and 0.05 thick: 0.043 as a sheet of its volume and surface.
TEST(CoupledPlan, WarnsOfTetrahedraThatAreLongForAThinPlate) {
  const auto warnings = [](const std::string& coupled) {
    const Plan plan = make_plan(scene_of(coupled + ",nz=5,zback=0.,zfront=1.", "", "densir=3.", "z(1,1)=.25,.3"));
    return std::ranges::count_if(plan.warnings, [](const std::string& warning) {
      return warning.find("size_near = 0.087 or less") != std::string::npos;
    });
  };
  EXPECT_EQ(warnings("flow='mesh',size_near=.14"), 1);
  EXPECT_EQ(warnings("flow='mesh',size_near=.12"), 0);
  EXPECT_EQ(warnings("flow='grid'"), 0);
}

TEST(CoupledPlan, OfAFluidAlone) {
  Scene scene = scene_of("");
  set_solids(scene.physics, nullptr);
  const Plan plan = make_plan(scene);
  EXPECT_EQ(term_of(scene, "mode"), "not: there is no body: one projection a step");
  EXPECT_EQ(term_of(scene, "contact"), "none");
  EXPECT_EQ(to_text(plan).find("path: coupled (plane, incompressible flow)\n"), 0u);
}

/// Measured in trials: .14 s by conjugate gradients for 27,000 cells, .011 s by factors for 96 x 48.
TEST(CoupledPlan, CostsAreThoseOfTrials) {
  const auto seconds = [](int dim, std::array<int, 3> n) {
    Scene scene = scene_of("");
    Coupled coupled = *scene.coupled();
    coupled.grid.dim = dim, coupled.grid.n = n;
    std::get<BoxFlow>(scene.physics).box = std::make_shared<Coupled>(coupled);
    StepRule rule;
    rule.deck_step = .5;
    const Cost cost = coupled_cost(scene, rule);
    return cost.seconds / cost.steps;
  };
  EXPECT_NEAR(seconds(3, {30, 30, 30}), .16, .03);
  EXPECT_NEAR(seconds(2, {96, 48, 1}), .015, .005);
}

}  // namespace
}  // namespace tether
