// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "physics/flow/unknowns.hpp"
#include "unit/alone.hpp"
#include "unit/physics/flow/support.hpp"

// Solids immersed in a flow: derivatives against differences, and what their forces do.

namespace tether::fem {
namespace {

/// A block of nx x ny elements from (x0, y0) to (x1, y1).
Solids block(double x0, double y0, double x1, double y1, int nx, int ny, double density, double stiffness) {
  Block shape;
  const std::array<std::array<double, 2>, 4> corners{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  for (std::size_t k = 0; k < 4; ++k) shape.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  shape.cells = {nx, ny, 1};
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({shape}, ElementKind::quad4, flaws);
  const Lame l = lame(stiffness, 0.4);
  solids.regions.push_back({"region 2", NeoHookean{l.lambda, l.mu, Volumetric::log, Plane::strain}, density, {}, {}});
  return solids;
}

Flow box(FlowElement element, double penalty = 0) {
  Flow flow = rectangle_flow(element, 8, 8, 1, 1, {});
  flow.viscosity = 0.1, flow.volume_penalty = {penalty}, flow.volume_by_fluid = {true};
  return flow;
}

/// What a tangent is checked of: how flow and solids go, and how fine the solids are, whose volume is their own or the
/// fluid's.
struct TangentCase {
  FlowElement element = FlowElement::q2q1;
  Integrator integrator = Integrator::energy;
  FlowIntegrator flow_integrator = FlowIntegrator::midpoint;
  int nx = 3, ny = 2;
  bool own_volume = true;
};

/// The residuals at all unknowns that solids add for velocities v1 and pressures p.
std::vector<double> residuals(ImmersedSolids& immersed, const FlowUnknowns& unknowns, const FlowState& state,
                              const std::vector<double>& v1, const std::vector<double>& p) {
  std::vector<double> f(v1.size(), 0.0), g(p.size(), 0.0), all(unknowns.count(), 0.0);
  immersed.move(state.v, v1);
  immersed.add_forces(p, f, g);
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (unknowns.velocity[k] >= 0) all[static_cast<std::size_t>(unknowns.velocity[k])] = f[k];
  }
  for (std::size_t n = 0; n < g.size(); ++n) {
    if (unknowns.pressure[n] >= 0) all[static_cast<std::size_t>(unknowns.pressure[n])] = g[n];
  }
  return all;
}

/// The tangent of the solids alone.
SparseMatrix tangent_of(ImmersedSolids& immersed, const FlowUnknowns& unknowns) {
  immersed.end_correction();  // the predicted stress ...
  immersed.end_correction();  // ... and from there without a change that of the places themselves
  immersed.linearise();
  Lists clusters = clusters_of(unknowns.flow);
  const std::size_t first = clusters.size();
  const Lists of_solids = immersed.clusters();
  for (std::size_t c = 0; c < of_solids.size(); ++c) clusters.add(of_solids[c]);
  const ClusterPattern pattern(unknowns.first, clusters);
  SparseMatrix K = pattern.matrix();
  immersed.add_tangent(first, pattern, K);
  return K;
}

/// Largest difference between the tangent's columns and central differences, over its largest number; of the solids
/// alone(), in a flow that is neither smooth nor symmetric.
double tangent_error(const TangentCase& of) {
  Flow flow = box(of.element, 7);
  flow.integrator = of.flow_integrator, flow.volume_by_fluid = {!of.own_volume};
  const FlowUnknowns unknowns(flow);
  Solids solids = block(0.22, 0.31, 0.55, 0.62, of.nx, of.ny, 3, 40);
  solids.integrator = of.integrator;
  solids.supports.push_back({{0}, {true, true, false}, {}, {}, 1});
  ImmersedSolids immersed(solids, unknowns, -1, alone());
  FlowState state;
  state.v.resize(unknowns.velocity.size());
  for (std::size_t k = 0; k < state.v.size(); ++k) state.v[k] = 0.1 * std::sin(3.0 * static_cast<double>(k));
  immersed.start(state, 0.1);
  immersed.begin(state, {.dt = 0.1,
                         .theta = of.flow_integrator == FlowIntegrator::midpoint ? 0.5 : 1,
                         .rate = 10,
                         .viscosity = flow.viscosity});
  std::vector<double> v1 = state.v, p(flow.twin.size());
  for (std::size_t k = 0; k < v1.size(); ++k) v1[k] += 0.05 * std::cos(2.0 * static_cast<double>(k));
  for (std::size_t n = 0; n < p.size(); ++n) p[n] = std::cos(3.0 * static_cast<double>(n));
  immersed.move(state.v, v1);
  const SparseMatrix K = tangent_of(immersed, unknowns);
  double worst = 0, largest = 0;
  const auto check = [&](int unknown, double& value) {
    if (unknown < 0) return;
    const double there = value, h = 1e-6;
    value = there + h;
    const auto up = residuals(immersed, unknowns, state, v1, p);
    value = there - h;
    const auto down = residuals(immersed, unknowns, state, v1, p);
    value = there;
    std::vector<double> unit(unknowns.count(), 0.0), column(unknowns.count());
    unit[static_cast<std::size_t>(unknown)] = 1;
    K.multiply(unit, column);
    for (std::size_t row = 0; row < column.size(); ++row) {
      worst = std::max(worst, std::abs(column[row] - (up[row] - down[row]) / (2 * h)));
      largest = std::max(largest, std::abs(column[row]));
    }
  };
  for (std::size_t k = 0; k < v1.size(); ++k) check(unknowns.velocity[k], v1[k]);
  for (std::size_t n = 0; n < p.size(); ++n) check(unknowns.pressure[n], p[n]);
  return worst / largest;
}

TEST(Immersed, TangentIsTheForcesDerivative) {
  EXPECT_LT(tangent_error({.element = FlowElement::q1q1}), 1e-7);
  EXPECT_LT(tangent_error({.integrator = Integrator::midpoint, .own_volume = false}), 1e-7);
  EXPECT_LT(tangent_error({.flow_integrator = FlowIntegrator::euler}), 1e-7);
}

/// Bodies finer than the fluid, whose nodes follow those that it carries.
TEST(Immersed, TangentIsThatOfCarriedNodes) {
  EXPECT_LT(tangent_error({.nx = 15, .ny = 12}), 1e-7);
  EXPECT_LT(tangent_error({.element = FlowElement::q1q1, .nx = 9, .ny = 11, .own_volume = false}), 1e-7);
}

/// What the solids do to the fluid and the fluid's velocity at their nodes are of one map: powers agree.
TEST(Immersed, ForcesDoTheSameWorkOnBothSides) {
  const Flow flow = box(FlowElement::q2q1);
  ImmersedMap map(flow);
  const std::vector<double> places{0.13, 0.2, 0.5, 0.5, 0.77, 0.93, 0.125, 0.125};
  ASSERT_FALSE(map.place(places));
  std::vector<double> v(2 * flow.twin.size()), F(places.size()), V(places.size()), f(v.size(), 0.0);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = std::sin(3.0 * static_cast<double>(k));
  for (std::size_t k = 0; k < F.size(); ++k) F[k] = std::cos(5.0 * static_cast<double>(k));
  map.velocities(v, V);
  map.add_forces(F, f);
  EXPECT_NEAR(std::inner_product(f.begin(), f.end(), v.begin(), 0.0),
              std::inner_product(F.begin(), F.end(), V.begin(), 0.0), 1e-13);
}

/// A block in a closed box at rest: as heavy as the fluid it stays, heavier it sinks and lighter it rises.
TEST(Immersed, BlocksSinkByWhatTheyWeighMore) {
  for (const double density : {1.0, 2.0, 0.5}) {
    Flow flow = box(FlowElement::q1q1);
    flow.tolerance = 1e-9;
    const Solids solids = block(0.35, 0.35, 0.65, 0.65, 4, 4, density, 100);
    RunningFlow run(flow, -1, &solids);
    ASSERT_TRUE(run.run(0.5, 0.05));
    double rise = 0;
    for (std::size_t n = 0; n < solids.mesh.node_count(); ++n)
      rise += (run.state.q[2 * n + 1] - solids.mesh.x[2 * n + 1]) / static_cast<double>(solids.mesh.node_count());
    const double against = density == 1 ? std::abs(rise) : (density > 1 ? -1 : 1) * rise;  // the way it should go
    EXPECT_EQ(against > 1e-3, density != 1) << density << " " << rise;
    EXPECT_TRUE(density != 1 || against < 1e-9) << rise;
  }
}

/// Energy that came in less what is there, over the former: of a heavy block whose left edge, or all of it, is led with
/// a constant acceleration.
double missing_energy(bool all, double dt) {
  Flow flow = box(FlowElement::q2q1);
  flow.tolerance = 1e-10;
  Solids solids = block(0.4, 0.4, 0.6, 0.6, 4, 4, 50, 1000);
  Support support{{}, {true, true, false}, {0.1, 0, 0}, {}, 1};
  support.amplitude.expression = std::make_shared<const Expression>("25*t^2", std::vector<std::string>{"t"});
  for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
    if (all || solids.mesh.x[2 * n] < 0.4 + 1e-9) support.nodes.push_back(static_cast<int>(n));
  }
  solids.supports.push_back(support);
  RunningFlow run(flow, 0, &solids);
  EXPECT_TRUE(run.run(0.2, dt));
  const FlowState& state = run.state;
  const ImmersedSolids& immersed = *run.step.immersed();
  const double there = run.step.elements().kinetic_energy(state.v) + immersed.kinetic_energy(state) +
                       immersed.strain_energy(state) + state.exchanged.viscosity;
  const double in = state.exchanged.walls + state.exchanged.inflows + state.exchanged.open + state.exchanged.supports;
  return (in - there) / in;
}

/// Supports that accelerate a body feel its inertia, and so do the nodes beside them: where none is free to the last
/// digits that the slope of their way has, else to what the fluid's functions lose.
TEST(Immersed, SupportsFeelTheInertiaOfWhatTheyLead) {
  EXPECT_NEAR(missing_energy(true, 0.02), 0, 1e-3);
  for (const double dt : {0.02, 0.01}) EXPECT_NEAR(missing_energy(false, dt), 0, 0.012) << dt;
}

/// A body that the flow carries out of its mesh stops the run, which names where and when.
TEST(Immersed, BodiesThatLeaveTheMeshAreNamed) {
  const RectangleSide slip{Boundary::slip, {}}, open{Boundary::open, {}};
  const RectangleSide inflow{Boundary::inflow, flow_vector("1", "0")};
  Flow flow = rectangle_flow(FlowElement::q1q1, 8, 4, 1, 0.5, {slip, open, slip, inflow});
  flow.volume_penalty = {0}, flow.volume_by_fluid = {false}, flow.tolerance = 1e-6, flow.start = flow_vector("1", "0");
  const Solids solids = block(0.7, 0.2, 0.9, 0.3, 4, 2, 1, 10);
  RunningFlow run(flow, 0, &solids);
  try {
    run.run(0.5, 0.05);
    FAIL() << "it went through the end of the mesh";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("leaves the fluid's mesh at (1.0"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tether::fem
