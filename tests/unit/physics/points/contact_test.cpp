// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that share nodes: what an impulse does at a node, and what bodies do that meet.
#include "physics/points/contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "physics/points/balance.hpp"
#include "physics/points/steps_of_scheme.hpp"
#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;
using Splines = Scheme<SplineKernel, Apic, Geometry::plane>;

const BackgroundGrid grid(21, 21, 0, 4, 0, 4);  // cells of .2

/// The thesis' method with contact by a criterion, or the robust set.
Method method_of(ContactRule rule, int criterion = 1) {
  Method method = rule == ContactRule::gap ? robust_set() : Method{};
  method.contact = rule, method.criterion = criterion;
  return method;
}

struct NodeOf {  // of one body at one node, before and after the impulses
  double m = 0;
  Pair alone{}, after{};
};

/// The velocities of all bodies at a scene's shared nodes after one solve.
class Meeting {
 public:
  explicit Meeting(Scene scene) : scene_(std::move(scene)), state_(start(scene_)) {
    StepWork work{state_, scene_, {}};
    mapped_velocity(state_);
    open_contact<Splines>(work, dt_);
    solve_with_contact<Splines>(work, dt_, Sums::kept);
    for (std::size_t n = 0; n < state_.grid.frame.shape.nodes(); ++n) read_node(n);
  }
  const std::vector<std::vector<NodeOf>>& nodes() const { return nodes_; }

 private:
  void read_node(std::size_t n) {
    const int slot = state_.contact.slot(n);
    if (slot < 0) return;
    std::vector<NodeOf> bodies;
    for (int g = 0; g < static_cast<int>(scene_.bodies.size()); ++g) {
      const NodeSums& sum = state_.contact.sums(slot, g);
      NodeOf body;
      body.m = sum.m;
      if (sum.m > 0) body.alone = (sum.momentum + dt_ * sum.force) * (1 / sum.m) + pair(0, dt_ * scene_.gravity);
      hold(state_.grid.frame.held[n], body.alone);
      state_.contact.exchange(state_.grid, g);
      body.after = state_.grid.motion.u[n];
      state_.contact.exchange(state_.grid, g);
      bodies.push_back(body);
    }
    nodes_.push_back(bodies);
  }
  static constexpr double dt_ = 0.01;
  Scene scene_;
  State state_;
  std::vector<std::vector<NodeOf>> nodes_;
};

/// Discs that overlap, in random motion; the third lies on both.
Scene overlapping(int bodies) {
  Scene scene = scene_on(grid, all_walls(Wall::free_slip), 0.01, method_of(ContactRule::gap));
  scene.gravity = -1;
  const double centres[3][2] = {{0.9, 1.1}, {1.7, 1.3}, {1.3, 0.5}};
  for (int b = 0; b < bodies; ++b) {
    const double x = centres[b][0], y = centres[b][1];
    add_body(scene, plane_strain(3, 0.3),
             lattice(0.1 - 0.01 * b, 0, 4, 0, 4, [=](double a, double c) { return std::hypot(a - x, c - y) < 0.5; }),
             1.0 + b);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (std::size_t p = 0; p < scene.points.size(); ++p)
    scene.points.vx[p] = any(random), scene.points.vy[p] = any(random), scene.points.sxx[p] = any(random);
  return scene;
}

TEST(Impulse, KeepsANodesMomentumAndNeverAddsEnergy) {
  for (const int bodies : {2, 3}) {
    int pushed = 0, with_three = 0;
    const Meeting meeting(overlapping(bodies));
    for (const auto& node : meeting.nodes()) {
      Pair before{}, after{};
      double energy_before = 0, energy_after = 0;
      int there = 0;
      for (const NodeOf& body : node) {
        before += body.m * body.alone, after += body.m * body.after;
        energy_before += 0.5 * body.m * squared(body.alone), energy_after += 0.5 * body.m * squared(body.after);
        there += body.m > 0;
      }
      EXPECT_NEAR(after[0], before[0], 1e-15);
      EXPECT_NEAR(after[1], before[1], 1e-15);
      EXPECT_LE(energy_after, energy_before + 1e-15);
      pushed += energy_after < energy_before - 1e-6;
      with_three += there == 3;
    }
    EXPECT_GT(pushed, 5);
    EXPECT_EQ(with_three > 5, bodies == 3);
  }
}

// What is left of two bodies' approach along the push is nothing, and across it everything is as it was.
TEST(Impulse, ActsAlongOneLineWithoutFriction) {
  int pushed = 0;
  const Meeting meeting(overlapping(2));
  for (const auto& node : meeting.nodes()) {
    const NodeOf &a = node[0], &b = node[1];
    const Pair push = a.after - a.alone;
    const double length = std::sqrt(squared(push));
    if (a.m <= 0 || b.m <= 0 || length < 1e-9) continue;
    const Pair n = push * (1 / length), across = pair(-n[1], n[0]);
    EXPECT_NEAR(dot(a.after - b.after, n), 0, 1e-13);
    EXPECT_LT(dot(a.alone - b.alone, n), 0);  // they did approach
    EXPECT_NEAR(dot(a.after, across), dot(a.alone, across), 1e-14);
    EXPECT_NEAR(dot(b.after, across), dot(b.alone, across), 1e-14);
    ++pushed;
  }
  EXPECT_GT(pushed, 5);
}

/// Two blocks of the same height with faces at these places, moving at these velocities; `fine` cells to the length .2.
Scene two_blocks(const Method& method, double face_a, double face_b, double va, double vb, double E = 100,
                 int fine = 1) {
  const BackgroundGrid cells(20 * fine + 1, 20 * fine + 1, 0, 4, 0, 4);
  Scene scene = scene_on(cells, all_walls(Wall::open), 0.4 * cells.dx / std::sqrt(E), method);
  const auto block = [&](double x0, double x1) {
    auto points = lattice(cells.dx / 2, 0, x1 - x0, 1, 3);
    for (PointAt& at : points) at.x += x0;
    add_body(scene, plane_stress(E, 0), points, 1);
  };
  block(face_a - 1, face_a), block(face_b, face_b + 1);
  for (std::size_t p = 0; p < scene.points.size(); ++p) scene.points.vx[p] = p < scene.bodies[1].first ? va : vb;
  return scene;
}

// Faces a cell and less apart share nodes. By the gap's rule they know nothing of each other until they meet.
TEST(Gap, BodiesThatShareNodesDoNotTouch) {
  Running run(two_blocks(method_of(ContactRule::gap), 1.63, 1.81, 1, 0));
  const std::size_t b = run.scene().bodies[1].first;
  const auto face = [&](std::size_t from, std::size_t to, double sense) {
    const auto x = run.field("x");
    double edge = -1e300;
    for (std::size_t p = from; p < to; ++p) edge = std::max(edge, sense * x[p] + 0.05);
    return sense * edge;
  };
  for (;;) {
    const double gap = face(b, run.scene().points.size(), -1) - face(0, b, 1);
    if (gap <= 0) break;
    const auto vx = run.field("vx");
    for (std::size_t p = 0; p < vx.size(); ++p) ASSERT_NEAR(vx[p], p < b ? 1 : 0, 1e-12) << gap;
    run.steps(1);
  }
  EXPECT_NEAR(run.time(), 0.18, 0.01);
  run.steps(3);
  EXPECT_GT(run.field("vx")[b], 0.01);  // and then they do
  EXPECT_NEAR(run.value("momentum_x"), 2, 1e-12);
}

struct Rule {
  ContactRule rule;
  int criterion;
};
void PrintTo(const Rule& r, std::ostream* out) { *out << static_cast<int>(r.rule) << "/" << r.criterion; }

class EveryRule : public testing::TestWithParam<Rule> {};
INSTANTIATE_TEST_SUITE_P(Contact, EveryRule,
                         testing::Values(Rule{ContactRule::release, 1}, Rule{ContactRule::release, 2},
                                         Rule{ContactRule::release, 3}, Rule{ContactRule::gap, 1}));

// Equal bars: the one that came stays, the other goes on with its velocity, but for what the impact costs and leaves
// as vibration. On five cells the criteria leave .35 and .65 (the thesis' .15 and .85 are those of its cells and its
// step), the gap .086 and .914.
TEST_P(EveryRule, EqualBarsSwapTheirMomenta) {
  Running run(two_blocks(method_of(GetParam().rule, GetParam().criterion), 1.6, 1.9, 1, 0));
  const double energy = run.value("energy_total");
  run.until(1);  // they meet at .3 and part .2 later
  EXPECT_NEAR(run.value("momentum_x"), 2, 1e-12);
  EXPECT_NEAR(run.value("momentum_y"), 0, 1e-12);
  const double kept = GetParam().rule == ContactRule::gap ? 0.1 : 0.4;
  EXPECT_LT(run.value("body_vx_1"), kept);
  EXPECT_GT(run.value("body_vx_2"), 1 - kept);
  EXPECT_LT(run.value("energy_total"), energy);
}

// A membrane between two blocks that close on it: at its nodes there are three bodies. Neither block passes it.
TEST_P(EveryRule, AMembranePinchedBetweenTwoSolids) {
  Scene scene = two_blocks(method_of(GetParam().rule, GetParam().criterion), 1.45, 2.15, 1, -1);
  add_body(scene, Membrane{100, 0, true}, line(1.8, 0.8, 1.8, 3.2, 49, 0.04), 1);
  Running run(std::move(scene));
  const auto& bodies = run.scene().bodies;
  for (int k = 0; k < 12; ++k) {
    run.until(0.1 * (k + 1));
    EXPECT_NEAR(run.value("momentum_x"), 0, 1e-12);
    EXPECT_NEAR(run.value("momentum_y"), 0, 1e-12);
    const auto x = run.field("x"), y = run.field("y");
    for (std::size_t m = bodies[2].first; m < x.size(); ++m) {
      for (std::size_t p = 0; p < bodies[2].first; ++p) {
        if (std::abs(y[p] - y[m]) > 0.05) continue;
        const double beyond = p < bodies[1].first ? x[p] - x[m] : x[m] - x[p];
        ASSERT_LT(beyond, 0) << run.time();
      }
    }
  }
  EXPECT_LT(run.value("body_vx_1"), 0);  // they have met and go apart again
  EXPECT_GT(run.value("body_vx_2"), 0);
}

TEST(Release, CriteriaOneAndTwoAgreeForTwoBodies) {
  Running one(two_blocks(method_of(ContactRule::release, 1), 1.6, 1.9, 1, 0));
  Running two(two_blocks(method_of(ContactRule::release, 2), 1.6, 1.9, 1, 0));
  one.until(1), two.until(1);
  EXPECT_EQ(one.field("x"), two.field("x"));
  EXPECT_EQ(one.field("vx"), two.field("vx"));
}

/// Two discs of different size that meet aslant: their grid normals at a node are not each other's opposites.
Scene two_discs(const Method& method) {
  Scene scene = scene_on(grid, all_walls(Wall::open), 0.008, method);
  const auto disc = [&](double x, double y, double r) {
    add_body(scene, plane_stress(100, 0.3),
             lattice(0.1, 0, 4, 0, 4, [=](double a, double b) { return std::hypot(a - x, b - y) < r; }), 1);
  };
  disc(1.3, 1.7, 0.6), disc(2.4, 2.2, 0.5);
  for (std::size_t p = 0; p < scene.bodies[1].first; ++p) scene.points.vx[p] = 1;
  return scene;
}

// (9.9): the state changes only when both bodies agree; what a node holds must outlast a restart. Without it some runs
// go on otherwise.
TEST(Release, CriterionThreeRemembers) {
  const auto scene = [] { return two_discs(method_of(ContactRule::release, 3)); };
  Running whole(scene()), first(scene());
  whole.until(0.6);
  int otherwise = 0;
  for (double time = 0.1; time < 0.6; time += 0.02) {
    Running second(scene()), forgetful(scene());
    first.until(time);
    SavedState saved = first.solver().save();
    second.solver().restore(saved);
    second.until(0.6);
    EXPECT_EQ(second.field("vx"), whole.field("vx"));
    saved.at("apart").clear();
    forgetful.solver().restore(saved);
    forgetful.until(0.6);
    otherwise += forgetful.field("vx") != whole.field("vx");
  }
  EXPECT_GT(otherwise, 0);
}

// Blocks that slide along each other give nothing across their faces; what is not level any more, the corners and faces
// that have bent, gives 3 % of what passes along the normal, and less on finer cells.
TEST(Gap, FacesSlide) {
  double given[2];
  for (int k = 0; k < 2; ++k) {
    Scene scene = two_blocks(method_of(ContactRule::gap), 1.6, 1.7, 1, -1, 100, 1 << k);
    for (std::size_t p = 0; p < scene.points.size(); ++p) scene.points.vy[p] = p < scene.bodies[1].first ? 0.2 : -0.2;
    Running run(std::move(scene));
    run.until(0.4);
    const double turned = run.value("body_vx_2") + 1;
    EXPECT_GT(turned, 1.5);
    EXPECT_NEAR(run.value("momentum_y"), 0, 1e-12);
    given[k] = std::abs(run.value("body_vy_1") - 0.2) / turned;
  }
  EXPECT_LT(given[0], 0.04);
  EXPECT_LT(given[1], 0.8 * given[0]);
}

}  // namespace
}  // namespace tether::mpm
