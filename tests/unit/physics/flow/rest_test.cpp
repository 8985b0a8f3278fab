// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid at rest under gravity stays at rest next to open sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/physics/flow/support.hpp"

namespace tether::fem {
namespace {

double fastest(const RunningFlow& running) {
  double speed = 0;
  for (const double v : running.state.v) speed = std::max(speed, std::abs(v));
  return speed;
}

/// 2 x 1.5 with these of its sides bottom, right, top, left open.
Flow box(FlowElement element, int open, double level) {
  std::array<RectangleSide, 4> sides{};
  for (std::size_t k = 0; k < 4; ++k) {
    if ((open >> k & 1) != 0) sides[k].boundary = Boundary::open;
  }
  Flow flow = rectangle_flow(element, 6, 4, 2, 1.5, sides);
  flow.density = 1.2, flow.viscosity = 0.01, flow.level = level;
  flow.start = flow_vector("0", "0");
  return flow;
}

class FlowRest : public testing::TestWithParam<FlowElement> {};
INSTANTIATE_TEST_SUITE_P(Elements, FlowRest, testing::Values(FlowElement::q1q1, FlowElement::q2q1));

TEST_P(FlowRest, BesideAnyOpenSides) {
  for (int open = 1; open < 16; ++open) {
    const Flow flow = box(GetParam(), open, 1.5);
    RunningFlow running(flow, -9.81);
    ASSERT_TRUE(running.run(0.3, 0.02)) << open;
    EXPECT_LE(fastest(running), 1e-10) << open;
    EXPECT_NEAR(running.state.exchanged.open, 0, 1e-10) << open;
    EXPECT_NEAR(running.state.exchanged.body_forces, 0, 1e-10) << open;
  }
}

TEST_P(FlowRest, AtAnyLevel) {
  for (const double level : {-4.0, 0.6, 9.0}) {
    const Flow flow = box(GetParam(), 2, level);
    RunningFlow running(flow, -9.81);
    ASSERT_TRUE(running.run(0.1, 0.02));
    EXPECT_LE(fastest(running), 1e-10);
    EXPECT_NEAR(running.step.elements().pressure_at_nodes(running.state.p)[0], 1.2 * 9.81 * level, 1e-9);
  }
}

/// Where nothing is beyond, the fluid falls out.
TEST_P(FlowRest, IsLostBesideNothing) {
  Flow flow = box(GetParam(), 2, 1.5);
  flow.fluid_outside = false;
  RunningFlow running(flow, -9.81);
  ASSERT_TRUE(running.run(0.1, 0.02));
  EXPECT_GT(fastest(running), 0.5);
}

}  // namespace
}  // namespace tether::fem
