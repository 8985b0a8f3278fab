// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "reference/radial_gas.hpp"
#include "reference/riemann.hpp"
#include "results/compare.hpp"

namespace tether {
namespace {

/// Part of the mass whose radius gives the gas' size; its edge is too thin to be known from points.
constexpr double most = 0.95;
/// While this part of it is inside the grid, the scene is one of gas in endless vacuum.
constexpr double nearly_all = 0.99;

/// The quarter's gas as the cylinder of the same mass: points on a lattice do not fill a circle exactly.
GasCylinder cylinder_of(const Scene& scene, const Body& gas) {
  const auto first = scene.points.volume.begin() + static_cast<std::ptrdiff_t>(gas.first);
  double area = 0;
  std::for_each(first, first + static_cast<std::ptrdiff_t>(gas.count), [&](double volume) { area += volume; });
  return {std::sqrt(4 * area / std::numbers::pi), gas.density, gas.specific_energy,
          std::get<IdealGas>(gas.material).gm1};
}

/// A point's distance from the axis, and its mass.
using PointAtRadius = std::pair<double, double>;

/// The points, the nearest to the axis first.
std::vector<PointAtRadius> by_radius(const Scene& scene, const Snapshot& last) {
  const auto &x = values_of(last, "x"), &y = values_of(last, "y");
  std::vector<PointAtRadius> points;
  for (std::size_t p = 0; p < x.size(); ++p) {
    points.emplace_back(std::hypot(x[p] - scene.grid.x0, y[p] - scene.grid.y0), scene.points.mass[p]);
  }
  std::sort(points.begin(), points.end());
  return points;
}

double mass_of(const std::vector<PointAtRadius>& points) {
  double mass = 0;
  for (const auto& point : points) mass += point.second;
  return mass;
}

double rms_radius(const std::vector<PointAtRadius>& points) {
  double moment = 0;
  for (const auto& [r, m] : points) moment += m * r * r;
  return std::sqrt(moment / mass_of(points));
}

/// The radius that holds a share of the mass, half of a point's own mass being inside its radius.
double radius_of_share(const std::vector<PointAtRadius>& points, double share) {
  const double wanted = share * mass_of(points);
  double inside = 0, r_before = 0, inside_before = 0;
  for (const auto& [r, m] : points) {
    const double inside_here = inside + m / 2;
    if (inside_here >= wanted) {
      return r_before + (r - r_before) * (wanted - inside_before) / (inside_here - inside_before);
    }
    inside += m, r_before = r, inside_before = inside_here;
  }
  return r_before;
}

void refuse_gas_at_the_edges(const Scene& scene, const GasShells& exact) {
  const BackgroundGrid& grid = scene.grid;
  if (exact.radius_of_share(nearly_all) > std::min(grid.x1 - grid.x0, grid.y1 - grid.y0)) {
    throw std::domain_error("by then the gas has reached an edge of the grid");
  }
}

Table table_of(const GasShells& exact) {
  RadialProfile profile = profile_of(exact);
  return {{"radius", "density", "velocity", "pressure", "specific_energy", "mass_inside"},
          {std::move(profile.radius), std::move(profile.density), std::move(profile.velocity),
           std::move(profile.pressure), std::move(profile.specific_energy), std::move(profile.mass_inside)}};
}

}  // namespace

Comparison compare_radial_gas(const Scene& scene, const Snapshot& last) {
  const GasShells exact = expanded(shells_of(cylinder_of(scene, scene.bodies.front())), last.time);
  refuse_gas_at_the_edges(scene, exact);
  const auto points = by_radius(scene, last);
  return {{relative_merit("rms_radius", rms_radius(points), exact.rms_radius()),
           relative_merit("radius_95", radius_of_share(points, most), exact.radius_of_share(most))},
          table_of(exact)};
}

namespace {

/// Places at which the exact profiles are tabulated.
constexpr int table_rows = 1001;

/// Returns whether a column of cells is wholly inside.
bool is_inside(const BackgroundGrid& grid, const TubePart& part, std::size_t column) {
  const double slip = 1e-6 * grid.dx, left = grid.x0 + static_cast<double>(column) * grid.dx;
  return left >= part.from - slip && left + grid.dx <= part.to + slip;
}

/// L1 error of the profile over the columns of cells that hold points and are inside the part compared: the mean of a
/// column's points, against the exact value at its middle. A single point's value scatters about that mean as points
/// cross cells (A.2).
template <class Exact>
Merit l1(FigureName name, const BackgroundGrid& grid, const TubePart& part, const Snapshot& snapshot, const char* field,
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
    if (count[c] == 0 || !is_inside(grid, part, c)) continue;
    error += std::abs(sum[c] / count[c] - exact(grid.x0 + (static_cast<double>(c) + 0.5) * grid.dx));
    columns += 1;
  }
  return {name.text(), 0, 0, error / columns, true};
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
  const auto error = [&](FigureName name, const char* field, double GasSample::*member) {
    return l1(name, scene.grid, part, last, field, exact(member));
  };
  return {{error("density", "density", &GasSample::density), error("velocity", "vx", &GasSample::velocity),
           error("pressure", "pressure", &GasSample::pressure),
           error("specific_energy", "specific_energy", &GasSample::specific_energy)},
          table_of(scene, tube.solution, t),
          {{part.from, part.to}}};
}

}  // namespace tether
