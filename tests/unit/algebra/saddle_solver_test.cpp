// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/saddle_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "algebra/krylov.hpp"
#include "unit/algebra/flow_matrices.hpp"

namespace tether {
namespace {

constexpr auto both_elements = {ElementPair::q1q1, ElementPair::q2q1};
constexpr auto both_methods = {VelocityMethod::complete, VelocityMethod::incomplete};

struct Solver : SaddleSolver {
  Solver(const FlowProblem& flow, VelocityMethod method) : SaddleSolver(flow.unknowns, flow.Mp, flow.Lp, method) {
    scales(flow.viscous, flow.inertial);
  }
};

/// Iterations from nothing to a residual of `tolerance`, or 1000.
int iterations(const FlowCase& flow, VelocityMethod method, double tolerance = 1e-8) {
  const FlowProblem problem = FlowAssembly(flow).problem();
  Solver solver(problem, method);
  std::vector<double> x(problem.b.size());
  return solver.solve(problem.K, problem.b, x, tolerance) ? solver.iterations() : 1000;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a);
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] -= b[i];
  return norm(difference) / norm(b);
}

std::vector<double> solved_directly(const FlowProblem& flow) {
  SparseSolver solver(flow.unknowns.first);
  EXPECT_TRUE(solver.factorise(flow.K, Definite::general));
  std::vector<double> x(flow.b.size());
  solver.solve(flow.b, x);
  return x;
}

TEST(SaddleSolver, AgreesWithTheDirectSolution) {
  for (const ElementPair element : both_elements) {
    for (const bool open : {false, true}) {
      for (const double reynolds : {1.0, 100.0, 1000.0}) {
        const FlowProblem flow = FlowAssembly({element, 16, reynolds, 1.0 / 32, 0, open}).problem();
        const auto exact = solved_directly(flow);
        for (const VelocityMethod method : both_methods) {
          Solver solver(flow, method);
          std::vector<double> x(flow.b.size());
          ASSERT_TRUE(solver.solve(flow.K, flow.b, x, 1e-12));
          EXPECT_LT(distance(x, exact), 1e-8);
          EXPECT_GT(solver.factor_nonzeros(), static_cast<double>(x.size()));
        }
      }
    }
  }
}

/// Iterations on 16, 32 and 64 cells a side, dt for a cell's width of 1.
struct Refined {
  int coarse, middle, fine;
  Refined(ElementPair element, VelocityMethod method, double reynolds, double courant, bool open) {
    const auto of = [&](int cells) { return iterations({element, cells, reynolds, courant / cells, 0, open}, method); };
    coarse = of(16), middle = of(32), fine = of(64);
  }
  int most() const { return std::max({coarse, middle, fine}); }
};

/// In steps of half a cell's transit time neither finer meshes nor thinner fluids take more iterations.
TEST(SaddleSolver, NeedsNoMoreIterationsOnFinerMeshes) {
  for (const ElementPair element : both_elements) {
    const Refined complete(element, VelocityMethod::complete, 1000, 0.5, false);
    EXPECT_LE(complete.most(), 13);
    EXPECT_LE(complete.fine, complete.coarse);
    for (const double reynolds : {100.0, 1000.0}) {
      for (const bool open : {false, true}) {
        const Refined incomplete(element, VelocityMethod::incomplete, reynolds, 0.5, open);
        EXPECT_LE(incomplete.most(), open ? 25 : 17);
        EXPECT_LE(incomplete.fine, incomplete.coarse + 2);
      }
    }
  }
}

TEST(SaddleSolver, NeedsFewIterationsInViscousFlowOfAnyStep) {
  for (const ElementPair element : both_elements) {
    for (const double courant : {0.5, 1e6}) {
      const Refined refined(element, VelocityMethod::complete, 1, courant, courant > 1);
      EXPECT_LE(refined.most(), 16);
      EXPECT_LE(refined.fine, refined.coarse + 1);
    }
  }
}

/// Steps in which the fluid crosses five cells: finer meshes take fewer iterations, as viscosity gains on convection.
TEST(SaddleSolver, NeedsMoreIterationsInLongSteps) {
  for (const ElementPair element : both_elements) {
    const Refined refined(element, VelocityMethod::incomplete, 1000, 5, false);
    EXPECT_LE(refined.coarse, 80);
    EXPECT_LE(refined.middle, refined.coarse);
    EXPECT_LE(refined.fine, refined.middle);
  }
  const Refined complete(ElementPair::q1q1, VelocityMethod::complete, 1000, 5, false);
  EXPECT_LE(complete.most(), 28);
}

/// A pressure held in one place of a closed flow: a mistake in the constant takes hardly any residual.
TEST(SaddleSolver, FindsThePressuresConstant) {
  for (const ElementPair element : both_elements) {
    const FlowProblem flow = FlowAssembly({element, 32, 1, 1.0 / 64, 0, false}).problem();
    Solver solver(flow, VelocityMethod::complete);
    std::vector<double> x(flow.b.size());
    ASSERT_TRUE(solver.solve(flow.K, flow.b, x, 1e-8));
    EXPECT_LE(solver.iterations(), 11);
    EXPECT_LT(distance(x, solved_directly(flow)), 1e-4);
  }
}

/// Steady flow of Reynolds number 1000 is beyond it, and it says so.
TEST(SaddleSolver, SaysWhereItDoesNotConverge) {
  const FlowProblem flow = FlowAssembly({ElementPair::q2q1, 16, 1000, 1e4, 0, false}).problem();
  Solver solver(flow, VelocityMethod::complete);
  std::vector<double> x(flow.b.size());
  EXPECT_FALSE(solver.solve(flow.K, flow.b, x, 1e-8));
  EXPECT_EQ(solver.iterations(), 200);
}

TEST(SaddleSolver, SaysWhereVelocitiesAreUndetermined) {
  FlowProblem flow = FlowAssembly({ElementPair::q2q1, 4, 100, 0.1, 0, false}).problem();
  std::vector<std::uint8_t> held(flow.b.size(), 0);
  held[45] = 1;
  hold(flow.K, held, 0);
  for (const VelocityMethod method : both_methods) {
    Solver solver(flow, method);
    std::vector<double> x(flow.b.size());
    EXPECT_FALSE(solver.solve(flow.K, flow.b, x, 1e-8));
  }
}

/// A solid in the middle, 1e4 times as stiff as the whole flow is viscous.
TEST(SaddleSolver, SolvesForAStiffBodyInTheFlow) {
  for (const ElementPair element : both_elements) {
    for (const int cells : {20, 40}) {
      FlowCase flow{element, cells, 100, 0.5 / cells, 0, true};
      const int without = iterations(flow, VelocityMethod::complete);
      flow.stiff = 100;
      EXPECT_LE(iterations(flow, VelocityMethod::complete), without + 4);
    }
  }
}

TEST(SaddleSolver, SolvesForInviscidAndSteadyFlow) {
  const FlowCase inviscid{ElementPair::q2q1, 16, std::numeric_limits<double>::infinity(), 1.0 / 32, 0, false};
  ASSERT_EQ(FlowAssembly(inviscid).problem().viscous, 0);
  for (const VelocityMethod method : both_methods) EXPECT_LE(iterations(inviscid, method), 16);
  for (const ElementPair element : both_elements) {
    FlowProblem steady = FlowAssembly({element, 16, 1, 1e12, 0, true}).problem();
    steady.inertial = 0;
    Solver solver(steady, VelocityMethod::complete);
    std::vector<double> x(steady.b.size());
    EXPECT_TRUE(solver.solve(steady.K, steady.b, x, 1e-8));
    EXPECT_LE(solver.iterations(), 20);
  }
}

/// The continuity equation with the other sign: D = G^T.
TEST(SaddleSolver, TakesEitherSignOfTheContinuityEquation) {
  for (const ElementPair element : both_elements) {
    FlowProblem flow = FlowAssembly({element, 16, 100, 1.0 / 32, 0, true}).problem();
    const int before = iterations({element, 16, 100, 1.0 / 32, 0, true}, VelocityMethod::complete);
    for (std::size_t k = 0; k < flow.K.row.size(); ++k)
      if (flow.unknowns.is_pressure[static_cast<std::size_t>(flow.K.row[k])]) flow.K.value[k] = -flow.K.value[k];
    flow.viscous = -flow.viscous, flow.inertial = -flow.inertial;
    Solver solver(flow, VelocityMethod::complete);
    std::vector<double> x(flow.b.size());
    ASSERT_TRUE(solver.solve(flow.K, flow.b, x, 1e-8));
    EXPECT_NEAR(solver.iterations(), before, 1);
  }
}

TEST(SaddleSolver, KeepsItsFactorsWhileTheyDo) {
  const auto flow_of = [](double reynolds, double dt) {
    return FlowAssembly({ElementPair::q2q1, 16, reynolds, dt, 0, false}).problem();
  };
  const FlowProblem flow = flow_of(100, 0.03), near = flow_of(90, 0.033), far = flow_of(0.2, 3);
  for (const VelocityMethod method : both_methods) {
    Solver solver(flow, method);
    const auto solve = [&](const FlowProblem& problem) {
      std::vector<double> x(problem.b.size());
      solver.scales(problem.viscous, problem.inertial);
      EXPECT_TRUE(solver.solve(problem.K, problem.b, x, 1e-10));
      EXPECT_LT(distance(x, solved_directly(problem)), 1e-5);
      return solver.renewed();
    };
    EXPECT_TRUE(solve(flow));
    EXPECT_FALSE(solve(flow));
    EXPECT_FALSE(solve(near));
    EXPECT_TRUE(solve(far));
    EXPECT_GT(solver.iterations(), 30);
  }
}

/// The stabilising C of another step, and no other scales: with new factors it is as if the solver were new.
TEST(SaddleSolver, RenewsWhatItKnowsOfPressures) {
  const FlowProblem before = FlowAssembly({ElementPair::q1q1, 32, 1, 1e-3, 0, true}).problem();
  const FlowProblem flow = FlowAssembly({ElementPair::q1q1, 32, 1000, 0.1, 0, true}).problem();
  Solver fresh(flow, VelocityMethod::complete), used(flow, VelocityMethod::complete);
  std::vector<double> x(flow.b.size());
  ASSERT_TRUE(fresh.solve(flow.K, flow.b, x, 1e-8));
  used.solve(before.K, before.b, x, 1e-2);
  std::fill(x.begin(), x.end(), 0.0);
  ASSERT_TRUE(used.solve(flow.K, flow.b, x, 1e-8));
  ASSERT_TRUE(used.renewed());
  EXPECT_LE(used.iterations() - 30, fresh.iterations() + 2);
}

/// The same flow without the unknowns that are prescribed.
FlowProblem without_prescribed(const FlowProblem& flow) {
  FlowProblem less{{}, {}, {}, {}, {{}, {0}, flow.unknowns.closed}, flow.viscous, flow.inertial};
  std::vector<std::int64_t> kept, kept_pressures;
  const auto& [is_pressure, first, closed] = flow.unknowns;
  std::int64_t pressure = 0;
  for (std::size_t node = 0; node + 1 < first.size(); ++node) {
    for (auto j = static_cast<std::size_t>(first[node]); j < static_cast<std::size_t>(first[node + 1]); ++j) {
      const auto from = flow.K.value.begin() + flow.K.start[j], to = flow.K.value.begin() + flow.K.start[j + 1];
      if (std::count(from, to, 0.0) < to - from - 1) {
        kept.push_back(static_cast<std::int64_t>(j));
        less.unknowns.is_pressure.push_back(is_pressure[j]);
        less.b.push_back(flow.b[j]);
        if (is_pressure[j]) kept_pressures.push_back(pressure);
      }
      pressure += is_pressure[j];
    }
    less.unknowns.first.push_back(static_cast<int>(kept.size()));
  }
  less.K = principal_block(flow.K, kept);
  less.Mp = principal_block(flow.Mp, kept_pressures), less.Lp = principal_block(flow.Lp, kept_pressures);
  return less;
}

TEST(SaddleSolver, DoesAsWellWithoutPrescribedUnknowns) {
  for (const ElementPair element : both_elements) {
    for (const VelocityMethod method : both_methods) {
      const FlowProblem flow = FlowAssembly({element, 16, 10, 1.0 / 32, 0, false}).problem();
      const FlowProblem less = without_prescribed(flow);
      ASSERT_EQ(flow.b.size() - less.b.size(), element == ElementPair::q1q1 ? 2 * 64 + 1 : 2 * 128 + 1);
      Solver solver(flow, method), lesser(less, method);
      std::vector<double> x(flow.b.size()), y(less.b.size());
      ASSERT_TRUE(solver.solve(flow.K, flow.b, x, 1e-10));
      ASSERT_TRUE(lesser.solve(less.K, less.b, y, 1e-10));
      EXPECT_NEAR(lesser.iterations(), solver.iterations(), 2);
      EXPECT_LT(distance(y, solved_directly(less)), 1e-5);
    }
  }
}

/// Where new factors took many iterations, too, a step's worth of them is no reason to make new ones.
TEST(SaddleSolver, HasPatienceWhereNewFactorsNeedIt) {
  const FlowProblem flow = FlowAssembly({ElementPair::q2q1, 16, 1000, 5.0 / 16, 0, false}).problem();
  Solver solver(flow, VelocityMethod::incomplete);
  for (const bool first : {true, false}) {
    std::vector<double> x(flow.b.size());
    ASSERT_TRUE(solver.solve(flow.K, flow.b, x, 1e-8));
    EXPECT_GT(solver.iterations(), 40);
    EXPECT_EQ(solver.renewed(), first);
  }
}

TEST(SaddleSolver, GivesTheSameBitsAgain) {
  const FlowProblem flow = FlowAssembly({ElementPair::q1q1, 16, 100, 1.0 / 32, 0, false}).problem();
  std::vector<double> first(flow.b.size()), second(flow.b.size());
  for (auto* x : {&first, &second}) ASSERT_TRUE(Solver(flow, VelocityMethod::complete).solve(flow.K, flow.b, *x, 1e-8));
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace tether
