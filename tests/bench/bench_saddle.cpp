// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds and memory for one linear system of an incompressible flow, a step of half a cell's transit time: LU factors
// of the whole against GMRES with the preconditioner of SaddleSolver. `first` has the analysis of the pattern, `next`
// is the same system again as the next step would bring it: new factors of the whole, or the preconditioner kept.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>

#include "algebra/krylov.hpp"
#include "algebra/saddle_solver.hpp"
#include "unit/algebra/flow_matrices.hpp"

namespace {

using namespace tether;

constexpr double tolerance = 1e-8;

double seconds_of(const auto& work) {
  const auto from = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// VmRSS, what the process holds, or VmHWM, the most it has held since `forget_peak` [MB].
double memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(key + ":", 0) == 0) return std::stod(line.substr(key.size() + 1)) / 1024;
  return 0;
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

struct Row {
  double first = 0, next = 0;
  int iterations = 0;
  bool solved = true;
};

Row direct(const FlowProblem& problem, std::vector<double>& x) {
  SparseSolver solver(problem.unknowns.first);
  const auto solve = [&] {
    solver.factorise(problem.K, Definite::general);
    solver.solve(problem.b, x);
  };
  Row row;
  row.first = seconds_of(solve), row.next = seconds_of(solve);
  return row;
}

Row by_krylov(const FlowProblem& problem, VelocityMethod method, std::vector<double>& x) {
  SaddleSolver solver(problem.unknowns, problem.Mp, problem.Lp, method);
  solver.scales(problem.viscous, problem.inertial);
  Row row;
  const auto solve = [&] {
    x.assign(x.size(), 0.0);
    row.solved = solver.solve(problem.K, problem.b, x, tolerance);
  };
  row.first = seconds_of(solve), row.next = seconds_of(solve);
  row.iterations = solver.iterations();
  return row;
}

void measure(const FlowCase& flow, int method) {
  const FlowProblem problem = FlowAssembly(flow).problem();
  std::vector<double> x(problem.b.size()), r(problem.b.size());
  const double before = memory("VmRSS");
  forget_peak();
  const Row row = method == 2 ? direct(problem, x) : by_krylov(problem, static_cast<VelocityMethod>(method), x);
  const double peak = memory("VmHWM");
  problem.K.multiply(x, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= problem.b[i];
  constexpr const char* names[] = {"complete", "incomplete", "direct"};
  fmt::print("{:7} {:>9} {:6} {:7} {:13} {:8.2f} {:8.2f} {:6} {:7.0f} {:9.1e}{}\n",
             flow.element == ElementPair::q1q1 ? "Q1Q1" : "Q2Q1", problem.K.n, flow.reynolds, flow.dt * flow.cells,
             names[method], row.first, row.next, row.iterations, peak - before, norm(r) / norm(problem.b),
             row.solved ? "" : " not solved");
}

/// In a process of its own, so that no row has memory of the one before. False where that ends badly.
bool measure_apart(const FlowCase& flow, int method) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    measure(flow, method);
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace

/// bench_saddle [MOST_UNKNOWNS [REYNOLDS [COURANT]]]
int main(int count, char** words) {
  const double most = count > 1 ? std::atof(words[1]) : 2e5, reynolds = count > 2 ? std::atof(words[2]) : 100;
  const double courant = count > 3 ? std::atof(words[3]) : 0.5;
  fmt::print("{:7} {:>9} {:6} {:7} {:13} {:>8} {:>8} {:>6} {:>7} {:>9}\n", "element", "unknowns", "Re", "U dt/h",
             "method", "first s", "next s", "steps", "MB", "residual");
  for (const double unknowns : {1e4, 5e4, 2e5, 5e5, 1e6}) {
    for (const ElementPair element : {ElementPair::q2q1, ElementPair::q1q1}) {
      const int cells = static_cast<int>(std::sqrt(unknowns / (element == ElementPair::q1q1 ? 3 : 9)));
      for (int method = 0; method < 3 && unknowns <= most; ++method) {
        if (!measure_apart({element, cells, reynolds, courant / cells}, method)) fmt::print("failed\n");
      }
    }
  }
}
