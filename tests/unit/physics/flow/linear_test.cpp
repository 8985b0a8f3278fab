// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/linear.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "algebra/krylov.hpp"
#include "physics/flow/make_elements.hpp"
#include "physics/flow/solver.hpp"
#include "physics/flow/unknowns.hpp"
#include "plan/load.hpp"
#include "unit/alone.hpp"
#include "unit/physics/flow/support.hpp"

// The same flows by factors and by GMRES, and what GMRES is made of.

namespace tether::fem {
namespace {

constexpr auto both_elements = {FlowElement::q1q1, FlowElement::q2q1};

Flow cavity(FlowElement element, int n, double density = 1) {
  const RectangleSide wall{}, lid{Boundary::moving, flow_vector("1", "0")};
  Flow flow = rectangle_flow(element, n, n, 1, 1, {wall, wall, lid, wall});
  flow.viscosity = 0.01 * density, flow.density = density, flow.tolerance = 1e-10;
  return flow;
}

Flow channel(FlowElement element) {
  const RectangleSide wall{}, open{Boundary::open, {}}, inflow{Boundary::inflow, flow_vector("4*y*(1-y)", "0")};
  Flow flow = rectangle_flow(element, 24, 12, 2, 1, {wall, open, wall, inflow});
  flow.viscosity = 0.01, flow.tolerance = 1e-10;
  return flow;
}

/// Around a pipe of 12 x 8 cells whose left and right sides are one, driven along.
Flow ring(FlowElement element) {
  const RectangleSide wall{}, around{Boundary::periodic, {}};
  Flow flow = rectangle_flow(element, 12, 8, 1.5, 1, {wall, around, wall, around});
  flow.viscosity = 0.01, flow.tolerance = 1e-10;
  flow.acceleration = flow_vector("1", "sin(4*x)");
  const std::size_t line = element == FlowElement::q1q1 ? 13 : 25;
  for (std::size_t n = line - 1; n < flow.twin.size(); n += line) flow.twin[n] = static_cast<int>(n - line + 1);
  return flow;
}

struct Difference {
  double velocity = 0, pressure = 0;
};

/// After some steps, over the largest; GMRES takes its part in it.
Difference difference(Flow flow, double dt) {
  flow.systems = Systems::direct;
  RunningFlow direct(flow);
  flow.systems = Systems::krylov;
  RunningFlow krylov(flow);
  EXPECT_TRUE(direct.run(6 * dt, dt) && krylov.run(6 * dt, dt));
  EXPECT_GT(krylov.state.krylov_iterations, 6);
  EXPECT_EQ(krylov.state.krylov_failures + direct.state.krylov_iterations, 0);
  const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> d(a);
    for (std::size_t k = 0; k < d.size(); ++k) d[k] -= b[k];
    return norm(d) / norm(b);
  };
  return {distance(krylov.state.v, direct.state.v), distance(krylov.state.p, direct.state.p)};
}

TEST(FlowLinear, GivesTheFlowsThatFactorsGive) {
  for (const FlowElement element : both_elements) {
    for (const Flow& flow : {cavity(element, 16), channel(element), ring(element)}) {
      for (const FlowIntegrator integrator : {FlowIntegrator::midpoint, FlowIntegrator::euler}) {
        Flow of = flow;
        of.integrator = integrator;
        const Difference by = difference(of, 0.03);
        EXPECT_LT(by.velocity, 1e-8);
        EXPECT_LT(by.pressure, 1e-7);
      }
    }
    Flow steady = cavity(element, 8);
    steady.integrator = FlowIntegrator::steady;
    EXPECT_LT(difference(steady, 1).velocity, 1e-8);
  }
}

/// A density 1024 times as large with such a viscosity is another unit of mass: the same bits but for the exponents.
TEST(FlowLinear, DependsOnNoUnits) {
  for (const FlowElement element : both_elements) {
    const auto run = [&](double density) {
      Flow flow = cavity(element, 12, density);
      flow.systems = Systems::krylov;
      RunningFlow result(flow);
      EXPECT_TRUE(result.run(0.2, 0.04));
      return result.state;
    };
    const FlowState one = run(1), other = run(1024);
    EXPECT_EQ(one.krylov_iterations, other.krylov_iterations);
    EXPECT_EQ(one.newton_steps, other.newton_steps);
    EXPECT_EQ(one.v, other.v);
  }
}

/// Steps depend on their starts alone(), not on what GMRES kept from before.
TEST(FlowLinear, StepsForgetThoseBefore) {
  Flow flow = cavity(FlowElement::q1q1, 12);
  flow.systems = Systems::krylov;
  RunningFlow whole(flow), rest(flow);
  ASSERT_TRUE(whole.run(0.08, 0.04));
  rest.state = whole.state;
  rest.step.resume(rest.state, 0.2);
  ASSERT_TRUE(whole.run(0.2, 0.04) && rest.run(0.2, 0.04));
  EXPECT_EQ(whole.state.v, rest.state.v);
  EXPECT_EQ(whole.state.p, rest.state.p);
  EXPECT_EQ(whole.state.krylov_iterations, rest.state.krylov_iterations);
}

/// A flow's elements and first K.
struct System {
  explicit System(const Flow& flow) : unknowns(flow), elements(make_flow_elements(unknowns, alone())) {
    v.resize(2 * flow.twin.size()), p.resize(flow.twin.size());
    unknowns.prescribe(0, v);
    b = elements->accelerations(0, 0);
    const ClusterPattern pattern(unknowns.first, clusters_of(flow));
    K = pattern.matrix();
    elements->add_tangent(moment(), pattern, K);
  }
  FlowMoment moment() const { return {v, v, p, 0.5, 50, unknowns.flow.viscosity, b, Linearisation::newton}; }
  FlowScales scales() const { return {unknowns.flow.viscosity + elements->mean_lsic(moment()), 50}; }

  FlowUnknowns unknowns;
  std::unique_ptr<FlowElements> elements;
  std::vector<double> v, p, b;
  SparseMatrix K;
};

/// A residual of nothing is never reached: the system is solved by factors, and so are the others of the step.
TEST(FlowLinear, FactorsDoWhereGmresDoesNot) {
  for (const FlowElement element : both_elements) {
    const Flow flow = cavity(element, 8);
    System of(flow);
    const SparseMatrix K = of.K;
    FlowLinear linear(of.unknowns, *of.elements, of.K, Systems::krylov);
    std::vector<double> b(of.unknowns.count(), 1.0), x(b.size()), r(b.size());
    const auto solve = [&](double tolerance) {
      of.K = K;
      EXPECT_TRUE(linear.factorise(of.K, of.scales()) && linear.solve(b, x, tolerance));
      K.multiply(x, r);
      for (std::size_t i = 0; i < r.size(); ++i) r[i] -= b[i];
      EXPECT_LT(norm(r), std::max(1e-9, 100 * tolerance) * norm(b));
      return linear.take_counts();
    };
    const LinearCounts failed = solve(0), after = solve(1e-3);
    EXPECT_EQ(failed.failures, 1);
    EXPECT_GE(failed.iterations, 200);
    EXPECT_EQ(failed.factorisations, 2);
    EXPECT_EQ(after.iterations + after.failures, 0);
    linear.begin_step();
    const LinearCounts later = solve(1e-6);
    EXPECT_GT(later.iterations, 0);
    EXPECT_EQ(later.failures, 0);
  }
}

TEST(FlowLinear, ASingularSystemIsNotSolved) {
  const Flow flow = cavity(FlowElement::q1q1, 4);
  System of(flow);
  of.K.set_zero();
  FlowLinear linear(of.unknowns, *of.elements, of.K, Systems::krylov);
  std::vector<double> x(of.unknowns.count(), 1.0);
  EXPECT_TRUE(linear.factorise(of.K, of.scales()));
  EXPECT_FALSE(linear.solve(x, x, 1e-3));
}

/// Steady flows of Reynolds numbers up to 1000: the run is that by factors, and one message tells why.
TEST(FlowLinear, ARunInWhichGmresFailsGoesOnByFactors) {
  const auto kinetic_energy = [](const std::string& solver, std::vector<std::string>& messages) {
    const std::vector<std::string> overrides{
        "in.tstep=.1",         "reg.matr(1,1)=.001",  "mesh.cells(1,1)=8",           "mesh.cells(2,1)=8",
        "flow.element='q2q1'", "flow.tolerance=1e-9", "flow.solver='" + solver + "'"};
    const Plan plan = load(std::string(TETHER_SOURCE_DIR) + "/decks/cavity.in", {overrides, "", ""}).plan;
    FlowSolver run(plan);
    run.advance(1);
    messages = run.take_messages();
    const auto summary = run.more_summary();
    const auto failures = std::find_if(summary.begin(), summary.end(),
                                       [](const auto& entry) { return entry.first == "krylov_failures"; });
    EXPECT_EQ(failures->second == "0", solver == "direct");
    return run.record()[2];
  };
  std::vector<std::string> told, untold;
  EXPECT_NEAR(kinetic_energy("krylov", told), kinetic_energy("direct", untold), 1e-9);
  EXPECT_EQ(told.size(), untold.size() + 1);
}

/// x A y of functions at the pressures' nodes, which are unknown but where they are pinned.
double product(const FlowUnknowns& unknowns, const SparseMatrix& A, double (*f)(double, double),
               double (*g)(double, double)) {
  const Mesh& mesh = unknowns.flow.mesh;
  std::vector<double> x, y, Ay(static_cast<std::size_t>(A.n));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (unknowns.pressure[n] < 0) continue;
    x.push_back(f(mesh.x[2 * n], mesh.x[2 * n + 1])), y.push_back(g(mesh.x[2 * n], mesh.x[2 * n + 1]));
  }
  EXPECT_EQ(x.size(), Ay.size());
  A.multiply(y, Ay);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * Ay[i];
  return sum;
}

/// Bilinear functions have their integrals; (0, 0) is pinned, where they are zero.
TEST(FlowLinear, MatricesOfPressuresAreExact) {
  const auto x = [](double at, double) { return at; };
  const auto y = [](double, double at) { return at; };
  for (const FlowElement element : both_elements) {
    const Flow flow = rectangle_flow(element, 3, 2, 2, 0.5, {});
    const FlowUnknowns unknowns(flow);
    const auto elements = make_flow_elements(unknowns, alone());
    const SparseMatrix Mp = elements->pressure_mass(), Lp = elements->pressure_laplacian();
    EXPECT_NEAR(product(unknowns, Mp, x, x), 8.0 / 3 * 0.5, 1e-13);
    EXPECT_NEAR(product(unknowns, Mp, x, y), 2 * 0.125, 1e-13);
    EXPECT_NEAR(product(unknowns, Lp, x, x), 1, 1e-13);
    EXPECT_NEAR(product(unknowns, Lp, y, y), 1, 1e-13);
    EXPECT_NEAR(product(unknowns, Lp, x, y), 0, 1e-13);
  }
}

/// Where a side is open the Laplacian's rows and columns are those of the identity.
TEST(FlowLinear, LaplacianHoldsPressuresOfOpenSides) {
  for (const FlowElement element : both_elements) {
    const Flow flow = channel(element);
    const FlowUnknowns unknowns(flow);
    const SparseMatrix Lp = make_flow_elements(unknowns, alone())->pressure_laplacian();
    const auto one = [](double, double) { return 1.0; };
    const auto at_the_end = [](double at, double) { return at > 2 - 1e-9 ? 1.0 : 0.0; };
    const auto before = [](double at, double) { return at > 2 - 1e-9 ? 0.0 : 1.0; };
    EXPECT_NEAR(product(unknowns, Lp, at_the_end, one), 13, 1e-12);
    EXPECT_NEAR(product(unknowns, Lp, at_the_end, before), 0, 1e-12);
    EXPECT_NEAR(product(unknowns, Lp, before, before), 12, 1e-9);  // a fall by 1 over the last of the cells, h high
  }
}

/// tau_L = rho/(tau tr G) of squares at rest, tau = [4/dt^2 + 4.5 nu^2 G : G]^(-1/2).
TEST(FlowLinear, MeanOfLsicIsThatOfSquares) {
  Flow flow = rectangle_flow(FlowElement::q1q1, 4, 4, 1, 1, {});
  flow.density = 3, flow.viscosity = 0.6;
  const double metric = 4 * 16, nu = 0.2;
  const System of(flow);
  const double tau = 1 / std::sqrt(4 * 2500 + 4.5 * nu * nu * 2 * metric * metric);
  EXPECT_NEAR(of.elements->mean_lsic(of.moment()), 3 / (tau * 2 * metric), 1e-12);
  EXPECT_EQ(System(rectangle_flow(FlowElement::q2q1, 2, 2, 1, 1, {})).scales().viscous, 1);
}

TEST(FlowLinear, AutomaticIsByUnknownsTimeAndBodies) {
  Flow flow;
  flow.element = FlowElement::q1q1;
  const auto of = [&](std::size_t nodes, bool solids) {
    flow.mesh.x.resize(2 * nodes);
    return systems_of(flow, solids);
  };
  const auto few = static_cast<std::size_t>(most_unknowns_of_factors / 3), many = few + 1;
  EXPECT_EQ(of(few, false), Systems::direct);
  EXPECT_EQ(of(many, false), Systems::krylov);
  EXPECT_EQ(of(many, true), Systems::direct);
  flow.integrator = FlowIntegrator::steady;
  EXPECT_EQ(of(many, false), Systems::direct);
  flow.systems = Systems::krylov;
  EXPECT_EQ(of(few, true), Systems::krylov);
}

}  // namespace
}  // namespace tether::fem
