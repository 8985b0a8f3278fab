// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <stdexcept>

#include "reference/riemann_tube.hpp"
#include "results/compare_parts.hpp"

namespace tether {
namespace {

/// Places at which the exact profiles are tabulated.
constexpr int table_rows = 1001;

/// Whether a column of cells is wholly inside.
bool is_inside(const BackgroundGrid& grid, const TubePart& part, std::size_t column) {
  const double slip = 1e-6 * grid.dx, left = grid.x0 + static_cast<double>(column) * grid.dx;
  return left >= part.from - slip && left + grid.dx <= part.to + slip;
}

/// L1 error of the profile over the columns of cells that hold points and are inside the part compared: the mean of a
/// column's points, against the exact value at its middle. A single point's value scatters about that mean as points
/// cross cells (A.2).
template <class Exact>
Merit l1(const char* name, const BackgroundGrid& grid, const TubePart& part, const Snapshot& snapshot,
         const char* field, const Exact& exact) {
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
    if (count[c] == 0 || !is_inside(grid, part, c)) continue;
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
  const RiemannTube tube = riemann_tube(scene);
  const double t = last.time;
  const TubePart part = compared_part(scene, tube, t);
  const auto exact = [&](double GasSample::*member) {
    return [&tube, t, member](double x) { return sample(tube.solution, x, t).*member; };
  };
  const auto error = [&](const char* name, const char* field, double GasSample::*member) {
    return l1(name, scene.grid, part, last, field, exact(member));
  };
  return {{error("density", "density", &GasSample::density), error("velocity", "vx", &GasSample::velocity),
           error("pressure", "pressure", &GasSample::pressure),
           error("specific_energy", "specific_energy", &GasSample::specific_energy)},
          table_of(scene, tube.solution, t),
          {{part.from, part.to}}};
}

}  // namespace tether
