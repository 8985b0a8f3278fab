// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "model/size.hpp"
#include "plan/make_plan.hpp"
#include "plan/plan_text.hpp"
#include "unit/plan/plan_support.hpp"

namespace tether::test {
namespace {

TEST(CostTest, CountsStepsPointsAndMemory) {
  const Cost cost = make_plan(elastic_scene()).cost;  // tmax = 1, steps of 1/16, one point, 25 nodes
  EXPECT_EQ(cost.steps, 16);
  EXPECT_EQ(cost.point_steps, 16);
  EXPECT_NEAR(cost.megabytes, megabytes_of_program + 1e-6 * (25 * bytes_per_node + bytes_per_point), 1e-12);
  Scene scene = elastic_scene();
  scene.outputs.checkpoint = 0.5;
  EXPECT_NEAR(make_plan(scene).cost.megabytes - cost.megabytes,
              1e-6 * (25 * more_bytes_per_node + more_bytes_per_point), 1e-12);
  EXPECT_GT(cost.seconds, 0);
}

TEST(CostTest, TheLastStepMayBeShorter) {
  Scene scene = elastic_scene();
  scene.clock.tmax = 1.001;
  EXPECT_EQ(make_plan(scene).cost.steps, 17);
  scene.clock = {0.3, 0.1 / 3, 1};  // 9 steps, whatever their rounding
  EXPECT_EQ(make_plan(scene).cost.steps, 9);
}

TEST(CostTest, GrowsWithThePoints) {
  Scene scene = elastic_scene();
  add_body(scene, plane_strain(4, 0.25), 0.25, 0, {{0, 0}, {0, 0}});
  const Cost one = make_plan(elastic_scene()).cost, three = make_plan(scene).cost;
  EXPECT_EQ(three.point_steps, 48);
  EXPECT_NEAR(three.seconds, 3 * one.seconds, 1e-18);
  EXPECT_NEAR(three.megabytes - one.megabytes, 1e-6 * 2 * bytes_per_point, 1e-12);
}

Term term_of(const Scene& scene, const std::string& name) {
  for (const Term& term : terms_of(scene)) {
    if (term.name == name) return term;
  }
  throw std::out_of_range(name);
}

void expect_term(const Scene& scene, const char* name, bool on, const char* reason) {
  const Term term = term_of(scene, name);
  EXPECT_EQ(term.on, on) << name;
  EXPECT_EQ(term.reason, reason) << name;
}

TEST(Terms, OfASolid) {
  Scene scene = elastic_scene();
  expect_term(scene, "stress update", true, "last, from the point momenta mapped back (musl, the thesis')");
  expect_term(scene, "gravity", false, "gravc = 0");
  expect_term(scene, "energy equation (4.8)", false, "no gas");
  expect_term(scene, "viscosity (4.1)", false, "no gas");
  expect_term(scene, "artificial viscosity (4.11)", false, "no gas");
  expect_term(scene, "tangents (7.1)", false, "no string");
  scene.gravity = -9.8;
  scene.method.order = StressOrder::usf;
  expect_term(scene, "gravity", true, "gravc = -9.8 in y");
  expect_term(scene, "stress update", true, "first, from the mapped velocity (usf)");
}

TEST(Terms, OfAGas) {
  IdealGas gas = simple_gas();
  const auto scene = [&gas] {
    Scene all = empty_scene();
    add_body(all, gas, 1, 8, {{0, 0}});
    return all;
  };
  expect_term(scene(), "energy equation (4.8)", true, "a gas is there");
  expect_term(scene(), "viscosity (4.1)", false, "mu = 0");
  expect_term(scene(), "artificial viscosity (4.11)", false, "lambda or both coefficients are 0");
  gas.mu = 0.1, gas.lambda = 1;
  expect_term(scene(), "viscosity (4.1)", true, "mu > 0");
  expect_term(scene(), "artificial viscosity (4.11)", false, "lambda or both coefficients are 0");
  gas.coef2 = 1;
  expect_term(scene(), "artificial viscosity (4.11)", true, "lambda and a coefficient > 0");
}

TEST(Terms, OfAString) {
  Scene scene = empty_scene();
  add_body(scene, Membrane{16, 0.3, true}, 1, 0, {{0, 0}, {0, 0}});
  expect_term(scene, "tangents (7.1)", true, "a string is there, connected in file order");
}

TEST(Terms, WhatNoSceneHas) {
  for (const char* name : {"contact and release", "heat conduction", "third dimension"}) {
    EXPECT_FALSE(term_of(elastic_scene(), name).on) << name;
    EXPECT_NE(term_of(elastic_scene(), name).reason, "") << name;
  }
}

TEST(MaterialName, OfEveryLaw) {
  IdealGas gas;
  gas.rule = DensityRule::cell;
  EXPECT_EQ(material_name(plane_strain(4, 0.25), Geometry::plane), "linear elastic, plane strain (E 4, nu 0.25)");
  EXPECT_EQ(material_name(plane_stress(1e6, 0.3), Geometry::plane), "linear elastic, plane stress (E 1e+06, nu 0.3)");
  EXPECT_EQ(material_name(gas, Geometry::plane), "ideal gas, gamma 1.4, density by cell (4.5)");
  gas.rule = DensityRule::quadratic;
  EXPECT_EQ(material_name(gas, Geometry::plane), "ideal gas, gamma 1.4, density by quadratic interpolation (4.6)");
  gas.rule = DensityRule::continuity;
  EXPECT_EQ(material_name(gas, Geometry::plane), "ideal gas, gamma 1.4, density by continuity (4.7)");
  EXPECT_EQ(material_name(LinearFluid{1.58e6}, Geometry::plane), "linear fluid, beta 1.58e+06 (6.1)");
  EXPECT_EQ(material_name(Membrane{2010, 0, true}, Geometry::plane), "string, E 2010, one-way");
  EXPECT_EQ(material_name(Membrane{2010, 0, false}, Geometry::plane), "string, E 2010, two-way");
}

TEST(PlanText, SaysWhatIsModelledAndWhatIsLeftOutAndWhy) {
  Scene scene = elastic_scene();
  scene.gravity = -9.8;
  const std::string text = to_text(make_plan(scene));
  const std::string expected =
      "path: mpm (material points, plane)\n"
      "grid: 5 x 5 nodes, cells 0.5 x 0.25\n"
      "body 1: a body, 1 points, linear elastic, plane strain (E 4, nu 0.25)\n"
      "modelled:\n"
      "  stress update: last, from the point momenta mapped back (musl, the thesis')\n"
      "  shape functions and transfer: bilinear shape functions, velocities by increments (flip)\n"
      "  gravity: gravc = -9.8 in y\n"
      "left out:\n"
      "  energy equation (4.8): no gas\n"
      "  viscosity (4.1): no gas\n"
      "  artificial viscosity (4.11): no gas\n"
      "  tangents (7.1): no string\n"
      "  membrane elements: no string\n"
      "  contact and release: bodies share one velocity field where they share a node, as in the thesis' basic method\n"
      "  heat ledger: no gas\n"
      "  open edges: no gas passes the edges of the grid\n"
      "  pressure outside: pambient = 0\n"
      "  heat conduction: not in the source's energy equation (4.8)\n"
      "  third dimension: the scene is plane, one unit deep\n"
      "step: 0.0625 at the start (deck 0.125, limit dx/c 0.0625, cfl 1)\n"
      "cost: 16 steps, 16 point-steps, 30 MB, about ";
  EXPECT_EQ(text.substr(0, expected.size()), expected);
  EXPECT_NE(text.find(" CPU s on one core (an estimate by formulas: no steps were made on trial)\nwarning: the deck's "
                      "step 0.125 is 2.00 times the limit dx/c = 0.0625: steps are "
                      "limited to 0.0625\n"),
            std::string::npos);
}

TEST(PlanText, OwnsTheScene) {
  const Plan plan = make_plan(elastic_scene());
  EXPECT_EQ(plan.scene.bodies.size(), 1u);
  EXPECT_EQ(plan.scene.points.size(), 1u);
}

}  // namespace
}  // namespace tether::test
