// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/riemann.hpp"
#include "results/compare_parts.hpp"

namespace tether {
namespace {

/// Places at which the exact profiles are tabulated.
constexpr int table_rows = 1001;

GasState state_of(const Scene& scene, const Body& body) {
  const auto& gas = std::get<IdealGas>(body.material);
  return {body.density, scene.points.vx[body.first], gas.pressure(body.density, body.specific_energy)};
}

std::pair<double, double> extent_x(const Scene& scene, const Body& body) {
  const auto first = scene.points.x.begin() + static_cast<std::ptrdiff_t>(body.first);
  const auto [low, high] = std::minmax_element(first, first + static_cast<std::ptrdiff_t>(body.count));
  return {*low, *high};
}

/// The body further left is the left state; the diaphragm stands in the middle of the gap between the two.
RiemannSolution solution_of(const Scene& scene) {
  const Body* left = &scene.bodies[0];
  const Body* right = &scene.bodies[1];
  if (extent_x(scene, *left).first > extent_x(scene, *right).first) std::swap(left, right);
  const double diaphragm = 0.5 * (extent_x(scene, *left).second + extent_x(scene, *right).first);
  return solve_riemann(
      {state_of(scene, *left), state_of(scene, *right), std::get<IdealGas>(left->material).gm1 + 1, diaphragm});
}

/// The solution is that of an endless tube: once a wave is at an end of the grid the run shows something else.
void refuse_waves_at_the_ends(const Scene& scene, const RiemannSolution& solution, double t) {
  const double left = sample(solution, scene.grid.x0, t).density, right = sample(solution, scene.grid.x1, t).density;
  if (left == solution.problem.left.density && right == solution.problem.right.density) return;
  throw std::domain_error("by then a wave has reached an end of the tube");
}

/// L1 error of the profile over the columns of cells that hold points: the mean of a column's points, against the exact
/// value at its middle. A single point's value scatters about that mean as points cross cells (A.2).
template <class Exact>
Merit l1(const char* name, const BackgroundGrid& grid, const Snapshot& snapshot, const char* field,
         const Exact& exact) {
  const auto& x = values_of(snapshot, "x");
  const auto& here = values_of(snapshot, field);
  std::vector<double> sum(static_cast<std::size_t>(grid.cells_x()), 0.0), count(sum);
  const Locator locator(grid);
  for (std::size_t p = 0; p < x.size(); ++p) {
    const auto column = static_cast<std::size_t>(locator.locate(x[p], grid.y0).i);
    sum[column] += here[p], count[column] += 1;
  }
  double error = 0, columns = 0;
  for (std::size_t c = 0; c < sum.size(); ++c) {
    if (count[c] == 0) continue;
    error += std::abs(sum[c] / count[c] - exact(grid.x0 + (static_cast<double>(c) + 0.5) * grid.dx));
    columns += 1;
  }
  return {name, 0, 0, error / columns, true};
}

Table table_of(const Scene& scene, const RiemannSolution& solution, double t) {
  Table table{{"x", "density", "velocity", "pressure", "specific_energy"}, std::vector<std::vector<double>>(5)};
  for (int k = 0; k < table_rows; ++k) {
    const double x = scene.grid.x0 + (scene.grid.x1 - scene.grid.x0) * k / (table_rows - 1);
    const GasSample gas = sample(solution, x, t);
    const double row[] = {x, gas.density, gas.velocity, gas.pressure, gas.specific_energy};
    for (std::size_t c = 0; c < 5; ++c) table.columns[c].push_back(row[c]);
  }
  return table;
}

}  // namespace

Comparison compare_riemann(const Scene& scene, const Snapshot& last) {
  const RiemannSolution solution = solution_of(scene);
  const double t = last.time;
  refuse_waves_at_the_ends(scene, solution, t);
  const auto exact = [&](double GasSample::*member) {
    return [&solution, t, member](double x) { return sample(solution, x, t).*member; };
  };
  return {{l1("density", scene.grid, last, "density", exact(&GasSample::density)),
           l1("velocity", scene.grid, last, "vx", exact(&GasSample::velocity)),
           l1("pressure", scene.grid, last, "pressure", exact(&GasSample::pressure)),
           l1("specific_energy", scene.grid, last, "specific_energy", exact(&GasSample::specific_energy))},
          table_of(scene, solution, t)};
}

}  // namespace tether
