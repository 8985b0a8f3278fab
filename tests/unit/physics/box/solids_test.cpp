// SPDX-License-Identifier: GPL-3.0-or-later
// The solids' equations of a step, and the stiffness in them.
#include "physics/box/solid_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <numbers>

#include "algebra/dense.hpp"
#include "unit/algebra/support.hpp"
#include "unit/alone.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using Values = std::vector<double>;

Eigen::VectorXd vector(const Values& x) { return Eigen::Map<const Eigen::VectorXd>(x.data(), std::ssize(x)); }
Values sum(const Values& x, double factor, const Values& y) {
  Values out = x;
  for (std::size_t k = 0; k < x.size(); ++k) out[k] += factor * y[k];
  return out;
}

/// A body of the linear law, whose forces are known at any place, on a spring, under its weight and a growing load.
struct SolidBody {
  Coupled coupled;
  Solids solids;
  SolidBody(int dim, CoupledIntegrator integrator)
      : solids(elastic(solid_block(dim, 2, {0.5, 0.5, 0.5}, 0.4, 0.3), 50, 0.3, 3)) {
    coupled = fluid_in_box(dim, 8);
    coupled.integrator = integrator, coupled.convex = false;
    solids.regions[0].law = LinearElastic{std::get<StVenantKirchhoff>(solids.regions[0].law)};
    solids.alpha = 0.7, solids.beta = 0.04;
    Load load;
    load.region = 0, load.force = {1, 2, 3}, load.amplitude = {{0, 2}, {0, 1}};
    solids.loads.push_back(load);
    coupled.springs.push_back({{0, 3}, {40, 20, 30}, 1});
  }
};

class Step : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, Step, testing::Values(2, 3));

/// A u1 - b is what the step leaves of the equation of motion: with linear forces F, the paper's has them at the end,
/// the trapezoidal rule as the mean of both ends, d1 = d0 + h (u0 + u1)/2.
TEST_P(Step, IsTheEquationOfMotion) {
  for (const bool paper : {true, false}) {
    const SolidBody body(GetParam(), paper ? CoupledIntegrator::paper : CoupledIntegrator::trapezoid);
    SolidEquations equations(body.coupled, body.solids, {0, -9.81, 0}, alone());
    const std::size_t n = equations.b.size();
    const double h = 0.05, t = 0.4;
    const Values X = body.solids.mesh.x, q = sum(X, 0.02, random_numbers(n, 1)), u0 = random_numbers(n, 2),
                 u1 = random_numbers(n, 3);
    equations.assemble(q, u0, t, h);
    const auto forces = [&](const Values& at_place) {  // of elasticity and springs
      Values f(n, 0.0);
      equations.system.elements->add_forces(fem::StressAt::end, at_place, at_place, f);
      const double mass = equations.system.lumped[0] + equations.system.lumped[3];
      for (const std::size_t node : {0u, 3u}) {
        for (std::size_t i = 0; i < std::size_t(GetParam()); ++i) {
          const std::size_t k = node * std::size_t(GetParam()) + i;
          f[k] += body.coupled.springs[0].stiffness[i] * equations.system.lumped[node] / mass * (at_place[k] - X[k]);
        }
      }
      return f;
    };
    const auto elastic_of = [&](const Values& change) {
      Values f(n, 0.0), g(n, 0.0);
      const Values there = sum(X, 1, change);
      equations.system.elements->add_forces(fem::StressAt::end, there, there, f);
      return f;
    };
    const Values q1 = sum(sum(q, h / 2, u0), h / 2, u1), damped = paper ? u1 : sum(Values(n, 0.0), 0.5, sum(u0, 1, u1));
    Values external(n), inertia(n), drag(n);
    equations.system.external_forces(paper ? t + h : t + h / 2, external);
    equations.system.multiply_mass(sum(u1, -1, u0), inertia);
    equations.system.multiply_mass(damped, drag);
    Values expected = paper ? forces(q1) : sum(Values(n, 0.0), 0.5, sum(forces(q), 1, forces(q1)));
    expected = sum(sum(sum(expected, 1 / h, inertia), body.solids.alpha, drag), -1, external);
    expected = sum(expected, body.solids.beta, elastic_of(damped));
    Values found(n);
    equations.A.multiply(u1, found);
    found = sum(found, -1, equations.b);
    double size = 0;
    for (const double f : expected) size = std::max(size, std::abs(f));
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(found[k], expected[k], 1e-12 * size) << paper << " " << k;
    EXPECT_LT((full_of(equations.A) - full_of(equations.A).transpose()).norm(), 1e-12 * full_of(equations.A).norm());
  }
}

/// A body without stiffness on a spring, as a whole: u and d behind n steps.
std::array<double, 2> swing(CoupledIntegrator integrator, double omega, double h, int steps) {
  Coupled coupled = fluid_in_box(2, 8);
  coupled.integrator = integrator;
  const Solids solids = elastic(solid_block(2, 2, {0.5, 0.5, 0}, 0.4, 0), 0, 0, 2);
  Spring spring;
  for (int n = 0; n < 9; ++n) spring.nodes.push_back(n);
  spring.stiffness = {omega * omega * 0.32, 0, 0};
  coupled.springs.push_back(spring);
  SolidEquations equations(coupled, solids, {}, alone());
  Values q = solids.mesh.x, u(q.size(), 0.0);
  for (std::size_t k = 0; k < q.size(); k += 2) q[k] += 0.01;
  for (int k = 0; k < steps; ++k) {
    equations.assemble(q, u, k * h, h);
    const Eigen::VectorXd next = solve(full_of(equations.A), vector(equations.b));
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += h / 2 * (u[i] + next[std::ptrdiff_t(i)]), u[i] = next[std::ptrdiff_t(i)];
  }
  return {u[0], q[0] - solids.mesh.x[0]};
}

/// The paper's step damps by h omega/4 of the critical damping, to order 1 in h.
TEST(SwingOfTheStep, OfThePaperIsDampedByAQuarterOfHOmega) {
  const double omega = 3;
  double before = 0;
  for (const int half_period : {25, 50, 100}) {  // in steps
    const double h = std::numbers::pi / omega / half_period;
    const int steps = 10 * half_period;
    const auto [u, d] = swing(CoupledIntegrator::paper, omega, h, steps);
    const double energy = (u * u / (omega * omega) + d * d) / 1e-4,
                 damping = -std::log(energy) / (2 * omega * h * steps);
    const double error = std::abs(damping / (h * omega / 4) - 1);
    EXPECT_LT(error, 1.0 / half_period) << h;
    EXPECT_TRUE(before == 0 || before / error > 1.5) << h;
    before = error;
  }
}

/// The trapezoidal rule has none; its frequency is (2/h) atan(h omega/2), which is of order 2.
TEST(SwingOfTheStep, ByTheTrapezoidalRuleIsNotDamped) {
  const double omega = 3;
  for (const double h : {0.1, 0.05}) {
    const int steps = static_cast<int>(std::lround(10 / h));
    const auto [u, d] = swing(CoupledIntegrator::trapezoid, omega, h, steps);
    EXPECT_NEAR((u * u / (omega * omega) + d * d) / 1e-4, 1, 1e-11);
    EXPECT_NEAR(d, 0.01 * std::cos(2 * std::atan(h * omega / 2) * steps), 1e-12);
  }
}

TEST(Springs, StoreTheirEnergy) {
  const SolidBody body(2, CoupledIntegrator::paper);
  const SolidEquations equations(body.coupled, body.solids, {}, alone());
  Values q = body.solids.mesh.x;
  EXPECT_EQ(equations.spring_energy(q), 0);
  for (std::size_t k = 0; k < q.size(); k += 2) q[k] += 0.1, q[k + 1] -= 0.2;
  EXPECT_NEAR(equations.spring_energy(q), 0.5 * 40 * 0.01 + 0.5 * 20 * 0.04, 1e-14);
}

class Stiffness : public testing::TestWithParam<int> {
 protected:
  Solids solids = elastic(solid_block(GetParam(), 2, {0.5, 0.5, 0.5}, 0.4, 0.3), 50, 0.3);
  fem::SolidSystem system{solids, 0, alone()};

  Eigen::MatrixXd at_place(const Values& q, bool convex) const {
    SparseMatrix K = system.pattern.matrix();
    system.elements->add_stiffness(q, convex, system.pattern, K);
    return full_of(K);
  }
  /// The reference places times a factor along x, with a shake.
  Values stretched(double factor, double shake = 0) const {
    Values q = sum(solids.mesh.x, shake, random_numbers(solids.mesh.x.size(), 5));
    for (std::size_t k = 0; k < q.size(); k += std::size_t(GetParam())) q[k] *= factor;
    return q;
  }
};
INSTANTIATE_TEST_SUITE_P(Coupled, Stiffness, testing::Values(2, 3));

TEST_P(Stiffness, IsTheForcesDerivative) {
  const Values q = stretched(1.2, 0.02), by = random_numbers(q.size(), 9);
  const auto forces = [&](double e) {
    Values f(q.size(), 0.0);
    const Values there = sum(q, e, by);
    system.elements->add_forces(fem::StressAt::end, there, there, f);
    return vector(f);
  };
  const Eigen::VectorXd exact = at_place(q, false) * vector(by), fine = (forces(1e-5) - forces(-1e-5)) / 2e-5;
  EXPECT_LT((exact - fine).norm(), 1e-7 * exact.norm());
}

/// Under compression K' has negative eigenvalues, and convex none; they differ by what is negative alone.
TEST_P(Stiffness, MadeConvexHasNoNegativeEigenvalues) {
  const Values q = stretched(0.5, 0.01);
  const Eigen::MatrixXd raw = at_place(q, false), convex = at_place(q, true);
  const auto least = [](const Eigen::MatrixXd& K) { return eigen_parts(K).values.minCoeff() / K.norm(); };
  EXPECT_LT(least(raw), -1e-3);
  EXPECT_GT(least(convex), -1e-14);
  EXPECT_GT(least(convex - raw), -1e-14);
  EXPECT_LT((convex - convex.transpose()).norm(), 1e-14 * convex.norm());
}

TEST_P(Stiffness, IsLeftAsItIsWhereItIsConvex) {
  for (const double factor : {1.0, 1.1}) {
    Values q = solids.mesh.x;
    for (double& x : q) x *= factor;
    const Eigen::MatrixXd raw = at_place(q, false);
    EXPECT_LT((raw - at_place(q, true)).norm(), 1e-13 * raw.norm()) << factor;
  }
}

}  // namespace
}  // namespace tether::coupled
