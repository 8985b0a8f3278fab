// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled equations and their three solutions.
#include "physics/box/system.hpp"

#include <gtest/gtest.h>

#include "algebra/quasidefinite_solver.hpp"
#include "base/diagnostics.hpp"
#include "physics/box/closed_regions.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/solid_equations.hpp"
#include "unit/alone.hpp"
#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using Values = std::vector<double>;

/// A shell with fluid inside and outside, and a plate beside it; the equations of one step with random right sides.
struct Problem {
  Coupled coupled;
  Solids solids;
  std::unique_ptr<Surroundings> about;
  std::unique_ptr<SolidEquations> equations;
  SparseMatrix L;
  Values r, known;
  std::vector<std::uint8_t> held, loose;
  std::vector<int> region;
  Regions regions;

  Problem(int dim, bool open, bool hold_all, double poisson = 0.3) : coupled(fluid_in_box(dim, dim == 2 ? 14 : 10)) {
    if (open) coupled.sides[side_right] = BoxSide::open;
    const Mesh plate = lattice(dim, {1, 4, 3}, all, [](const Vec<3>& s) {
      return Vec<3>{0.87 + 0.02 * s[0], 0.3 + 0.3 * s[1], 0.3 + 0.3 * s[2]};
    });
    solids = elastic(together(hollow_block(dim, 1, {0.42, 0.48, 0.51}, 0.6, 0.3), plate), 20, poisson, 1.5);
    about = std::make_unique<Surroundings>(coupled, solids.mesh);
    equations = std::make_unique<SolidEquations>(coupled, solids, Vec<3>{0, -1, 0}, alone());
    const std::size_t n = solids.mesh.x.size();
    equations->assemble(solids.mesh.x, random_numbers(n, 1), 0, 0.05);
    held.assign(n, hold_all ? 1 : 0), known = random_numbers(n, 2);
    for (std::size_t k = 0; k < n; k += 7) held[k] = 1;
    for (std::size_t k = 0; k < n && hold_all; ++k) known[k] = k % at(dim) == 0 ? 0.3 : 0;  // which keeps volumes
    L = pressure_matrix(about->domain, about->numbers, 0.05 / coupled.density);
    r = random_numbers(about->numbers.cell.size(), 3, 0.01);
    for (const std::size_t cell : about->numbers.cell) region.push_back(about->domain.region[cell]);
    const Values volumes = enclosed_volumes(about->surface, solids.mesh.x);
    regions = regions_of(regions_of(about->domain, about->numbers), about->map, volumes, volumes, held, 1);
    loose = regions.closed;
    for (std::size_t k = 0; k < loose.size(); ++k) loose[k] = loose[k] != 0 && regions.compliant[k] == 0 ? 1 : 0;
    Values sums(loose.size(), 0.0);
    for (std::size_t k = 0; k < r.size(); ++k) sums[at(region[k])] += r[k];
    for (std::size_t k = 0; k < r.size(); ++k) {
      if (loose[at(region[k])] != 0) r[k] -= sums[at(region[k])] / double(regions.cells[at(region[k])]);
    }
  }

  CoupledEquations all_of() const {
    return {equations->A,
            equations->b,
            about->map.B,
            about->map.B,
            L,
            r,
            held,
            about->numbers.cell,
            about->domain.kind.size(),
            region,
            regions.closed,
            loose};
  }
  /// Largest residual of the rows of free velocities and of pressures, over the largest of their terms.
  double residual(const Values& u, const Values& p) const {
    Values force(u.size()), flux(p.size());
    equations->A.multiply(u, force), L.multiply(p, flux);
    const Values pressed = transposed_product(about->map.B, p), caused = product(about->map.B, u);
    double most = 0, forces = 0, fluxes = 0;
    for (std::size_t k = 0; k < u.size(); ++k) forces = std::max(forces, std::abs(pressed[k]) + std::abs(force[k]));
    for (std::size_t k = 0; k < p.size(); ++k) fluxes = std::max(fluxes, std::abs(flux[k]) + std::abs(caused[k]));
    for (std::size_t k = 0; k < u.size(); ++k) {
      EXPECT_TRUE(held[k] == 0 || std::abs(u[k] - known[k]) < 1e-14) << k;
      if (held[k] == 0) most = std::max(most, std::abs(force[k] - pressed[k] - equations->b[k]) / forces);
    }
    for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::abs(-caused[k] - flux[k] - r[k]) / fluxes);
    return most;
  }
};

struct Answer {
  Values u, p;
};
Answer solved(const Problem& problem, CouplingMode mode, Systems systems) {
  Coupled coupled = problem.coupled;
  coupled.coupling = coupling_of(mode), coupled.systems = systems, coupled.tolerance = 1e-13;
  CoupledSystem system(coupled, alone());
  Answer answer{problem.known, Values(problem.r.size(), 0.0)};
  system.solve(problem.all_of(), 0, answer.u, answer.p);
  EXPECT_TRUE(system.take_messages().empty());
  return answer;
}

/// Up to the constants of loose regions.
double distance(const Problem& problem, const Answer& a, const Answer& b) {
  double most = 0, size = 0, pressure = 0;
  Values shift(problem.loose.size(), 0.0);
  for (std::size_t k = a.p.size(); k-- > 0;) {
    if (problem.loose[at(problem.region[k])] != 0) shift[at(problem.region[k])] = a.p[k] - b.p[k];
  }
  for (std::size_t k = 0; k < a.p.size(); ++k) {
    pressure = std::max(pressure, std::abs(a.p[k]));
    most = std::max(most, std::abs(a.p[k] - b.p[k] - shift[at(problem.region[k])]));
  }
  double moved = 0;
  for (std::size_t k = 0; k < a.u.size(); ++k)
    size = std::max(size, std::abs(a.u[k])), moved = std::max(moved, std::abs(a.u[k] - b.u[k]));
  return std::max(most / pressure, moved / size);
}

struct Kind {
  int dim;
  bool open, hold_all;
};
class System : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Coupled, System,
                         testing::Values(Kind{2, true, false}, Kind{2, false, false}, Kind{2, false, true},
                                         Kind{3, true, false}, Kind{3, false, false}, Kind{3, false, true}));

/// A material that hardly yields: BiCGSTAB does not get there, and the factors of the same matrix do.
TEST(PaperSystem, IsSolvedByFactorsWhereBicgstabIsNot) {
  for (const int dim : {2, 3}) {
    const Problem problem(dim, true, false, 0.5 - 1e-9);
    Coupled coupled = problem.coupled;
    coupled.coupling = coupling_of(CouplingMode::paper), coupled.tolerance = 1e-13;
    CoupledSystem system(coupled, alone());
    Answer answer{problem.known, Values(problem.r.size(), 0.0)};
    system.solve(problem.all_of(), 0, answer.u, answer.p);
    EXPECT_EQ(system.cost().lu_solves, 1) << dim;
    EXPECT_EQ(system.take_messages().size(), 1u) << dim;
    EXPECT_LT(problem.residual(answer.u, answer.p), 1e-10) << dim;
    system.solve(problem.all_of(), 0, answer.u, answer.p);
    EXPECT_TRUE(system.take_messages().empty()) << dim;
  }
}

TEST_P(System, HasOneSolutionByThreeWays) {
  const Problem problem(GetParam().dim, GetParam().open, GetParam().hold_all);
  ASSERT_EQ(problem.about->domain.regions, 2);
  ASSERT_EQ(problem.regions.closed,
            (GetParam().open ? std::vector<std::uint8_t>{0, 1} : std::vector<std::uint8_t>{1, 1}));
  ASSERT_EQ(problem.loose[0], GetParam().hold_all ? 1 : 0);
  const Answer direct = solved(problem, CouplingMode::symmetric, Systems::direct);
  EXPECT_LT(problem.residual(direct.u, direct.p), 1e-12);
  EXPECT_LT(distance(problem, direct, solved(problem, CouplingMode::symmetric, Systems::krylov)), 1e-9);
  EXPECT_LT(distance(problem, direct, solved(problem, CouplingMode::paper, Systems::automatic)), 1e-9);
}

/// Solids that hardly yield need constant pressures in closed regions beside which all others are rounding.
TEST(Systems, FindTheConstantsThatStiffSolidsNeed) {
  for (const int dim : {2, 3}) {
    Problem problem(dim, false, false);
    for (double& value : problem.equations->A.value) value *= 1e9;
    const Answer direct = solved(problem, CouplingMode::symmetric, Systems::direct);
    const Answer krylov = solved(problem, CouplingMode::symmetric, Systems::krylov);
    EXPECT_GT(*std::max_element(direct.p.begin(), direct.p.end()), 1e6);
    EXPECT_LT(distance(problem, direct, krylov), 1e-9);
  }
}

/// Another force and other held velocities with the factors of the solution before, as contact's friction needs them.
TEST_P(System, IsSolvedAgainWithTheFactorsThatItHas) {
  Problem problem(GetParam().dim, GetParam().open, GetParam().hold_all);
  for (const Systems systems : {Systems::direct, Systems::krylov}) {
    for (const CouplingMode mode : {CouplingMode::symmetric, CouplingMode::splitting}) {
      Coupled coupled = problem.coupled;
      coupled.coupling = coupling_of(mode), coupled.systems = systems, coupled.tolerance = 1e-13;
      const auto solve = [&](CoupledSystem& system, bool same) {
        Answer answer{problem.known, Values(problem.r.size(), 0.0)};
        CoupledEquations equations = problem.all_of();
        equations.same_matrices = same;
        if (mode == CouplingMode::splitting) equations.loose = equations.closed;
        if (mode == CouplingMode::symmetric) {
          system.solve(equations, 0, answer.u, answer.p);
        } else {
          system.solve_solids(equations, 0, answer.u, answer.p);
          system.solve_fluid(equations, 0, answer.u, answer.p);
        }
        return answer;
      };
      CoupledSystem kept(coupled, alone()), fresh(coupled, alone());
      solve(kept, false);
      problem.equations->b = random_numbers(problem.equations->b.size(), 11);
      for (double& u : problem.known) u *= 1.5;
      EXPECT_LT(distance(problem, solve(fresh, false), solve(kept, true)), 1e-12);
    }
  }
}

TEST_P(System, HasANegativePivotForEachCell) {
  const Problem problem(GetParam().dim, GetParam().open, GetParam().hold_all);
  const CoupledEquations equations = problem.all_of();
  QuasidefiniteSolver solver;
  ASSERT_TRUE(solver.factorise(matrix_by_cells(equations, first_pressures(equations, equations.closed))));
  EXPECT_EQ(solver.negative_pivots(), static_cast<std::int64_t>(equations.cells));
}

/// A flow into a closed region whose walls do not yield has nowhere to go.
TEST(Systems, RefuseWhatDoesNotBalance) {
  Problem problem(2, false, true);
  problem.r[0] += 0.01;
  for (const Systems systems : {Systems::direct, Systems::krylov}) {
    try {
      solved(problem, CouplingMode::symmetric, systems);
      ADD_FAILURE() << "a flow into a closed region";
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("flows out of closed region 1 of the fluid"), std::string::npos);
    }
  }
}

/// A of a solid that has lost its stiffness is told by the pivots: an error where K' was made convex, else a message.
TEST(Systems, TellPivotsThatAreMissing) {
  Problem problem(2, true, false);
  for (std::int64_t k = 0; k < problem.equations->A.n; ++k) {
    auto& A = problem.equations->A;
    for (auto e = A.start[std::size_t(k)]; e < A.start[std::size_t(k + 1)]; ++e) A.value[std::size_t(e)] *= -1;
  }
  EXPECT_THROW(solved(problem, CouplingMode::symmetric, Systems::direct), RunError);
  problem.coupled.convex = false, problem.coupled.systems = Systems::direct;
  CoupledSystem system(problem.coupled, alone());
  Answer answer{problem.known, Values(problem.r.size(), 0.0)};
  system.solve(problem.all_of(), 0, answer.u, answer.p);
  const auto messages = system.take_messages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("K' is not convex"), std::string::npos);
}

/// One after the other: the solids with pressures given, then the fluid with velocities given.
TEST_P(System, OneAfterTheOtherSolvesEachAlone) {
  const Problem problem(GetParam().dim, GetParam().open, GetParam().hold_all);
  for (const Systems systems : {Systems::direct, Systems::krylov}) {
    Coupled coupled = problem.coupled;
    coupled.coupling = coupling_of(CouplingMode::splitting), coupled.systems = systems, coupled.tolerance = 1e-13;
    CoupledSystem system(coupled, alone());
    CoupledEquations equations = problem.all_of();
    const CoupledEquations split{equations.A,     equations.b,      equations.B,      equations.flux,
                                 equations.L,     equations.r,      equations.held,   equations.cell,
                                 equations.cells, equations.region, equations.closed, equations.closed};
    Values u = problem.known, force(u.size());
    const Values given = random_numbers(problem.r.size(), 8), pressed = transposed_product(problem.about->map.B, given);
    system.solve_solids(split, 0, u, given);
    problem.equations->A.multiply(u, force);
    for (std::size_t k = 0; k < u.size(); ++k) {
      if (problem.held[k] != 0) continue;
      EXPECT_NEAR(force[k], problem.equations->b[k] + pressed[k], 1e-10);
    }
    Values p(problem.r.size(), 0.0), flux(p.size());
    system.solve_fluid(split, 0, u, p);
    problem.L.multiply(p, flux);
    const Values caused = product(problem.about->map.B, u);
    Values left(problem.loose.size(), 0.0), area(left.size(), 0.0);
    const Values seen = areas_seen(problem.about->map.B);
    for (std::size_t k = 0; k < p.size(); ++k)
      left[at(problem.region[k])] += problem.r[k] + caused[k], area[at(problem.region[k])] += seen[k];
    for (std::size_t k = 0; k < p.size(); ++k) {  // of closed regions the sum is taken off by the area that cells see
      const std::size_t region = at(problem.region[k]);
      const double repair = equations.closed[region] != 0 ? left[region] * seen[k] / area[region] : 0;
      EXPECT_NEAR(-flux[k], problem.r[k] + caused[k] - repair, 1e-11);
    }
  }
}

TEST(Systems, AreChosenByDimensionAndSize) {
  const auto name = [](int dim, int n, CouplingMode mode) {
    Coupled coupled = fluid_in_box(dim, n);
    coupled.coupling = coupling_of(mode);
    return std::string(CoupledSystem(coupled, alone()).solver_name());
  };
  EXPECT_EQ(name(2, 100, CouplingMode::symmetric), "direct");
  EXPECT_EQ(name(3, 12, CouplingMode::symmetric), "direct");
  EXPECT_EQ(name(3, 13, CouplingMode::symmetric), "krylov");
  EXPECT_EQ(name(2, 10, CouplingMode::paper), "bicgstab");
}

}  // namespace
}  // namespace tether::coupled
