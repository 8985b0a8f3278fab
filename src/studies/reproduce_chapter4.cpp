// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/riemann_tube.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// Sod's shock tube: 4.1, Fig. 11 and Box 1, with pressures .4 rho i. The exact solution is that of the deck that ran.

RiemannTube tube(const RunFiles& run) { return riemann_tube(run.scene()); }

/// Mass through the shock: rho1 s = rho2 (s - u).
double exact_shock_speed(const RunFiles& run) {
  const RiemannSolution solution = tube(run).solution;
  const StarRegion& star = solution.star;
  return star.density_right * star.velocity / (star.density_right - solution.problem.right.density);
}

double exact_strength(const RunFiles& run) {
  const RiemannSolution solution = tube(run).solution;
  return solution.star.pressure / solution.problem.right.pressure;
}

double end_time(const RunFiles& run) { return run.time(run.snapshots() - 1); }
double exact_travel(const RunFiles& run) { return exact_shock_speed(run) * end_time(run); }

/// Where the density, seen from the right end, first passes the middle between before and behind the shock.
double shock_place(const RunFiles& run) {
  const ColumnMeans density = column_means(run, "density");
  const RiemannSolution solution = tube(run).solution;
  const double level = 0.5 * (solution.problem.right.density + solution.star.density_right);
  for (std::size_t c = density.x.size(); c-- > 1;) {
    const double here = density.mean[c - 1], right = density.mean[c];
    if (here < level) continue;
    return density.x[c - 1] + (density.x[c] - density.x[c - 1]) * (here - level) / (here - right);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double shock_travel(const RunFiles& run) { return shock_place(run) - tube(run).solution.problem.diaphragm; }
double shock_speed(const RunFiles& run) { return shock_travel(run) / end_time(run); }

/// The mean pressure in the middle half between contact and shock, as they are exactly, over the right one.
double strength(const RunFiles& run) {
  const RiemannSolution solution = tube(run).solution;
  const double contact = solution.problem.diaphragm + solution.star.velocity * end_time(run);
  const double shock = solution.problem.diaphragm + exact_travel(run);
  const ColumnMeans pressure = column_means(run, "pressure");
  std::vector<double> between;
  for (std::size_t c = 0; c < pressure.x.size(); ++c) {
    const double part = (pressure.x[c] - contact) / (shock - contact);
    if (part > 0.25 && part < 0.75) between.push_back(pressure.mean[c]);
  }
  return mean(between) / solution.problem.right.pressure;
}

double largest_density_difference(const RunFiles& run) {
  const ColumnMeans here = column_means(run, "density"), there = column_means(run.beside(), "density");
  double largest = 0;
  for (std::size_t c = 0; c < std::min(here.mean.size(), there.mean.size()); ++c) {
    largest = std::max(largest, std::abs(here.mean[c] - there.mean[c]));
  }
  return largest;
}

Quantity l1_error(const char* field, double allowed) {
  return {.name = std::string("L1 error of ") + field,
          .reading = summary_value(std::string("error_") + field),
          .exact = constant(0),
          .thesis = within(allowed),
          .robust = within(allowed)};
}

/// What the theory says of the tube; the thesis quotes it from Liepmann.
Quantity speed_of_shock() {
  return {.name = "shock speed",
          .reading = shock_speed,
          .theory = printed("1.75", "4.1"),
          .exact = exact_shock_speed,
          .thesis = within_part(0.02),
          .robust = within_part(0.02)};
}

std::vector<Problem> shock_tubes() {
  Problem quadratic{.name = "sod", .place = "4.1, Figs 13, 14", .deck = "sod"};
  quadratic.quantities = {{.name = "shock strength p2/p1",
                           .reading = strength,
                           .theory = printed("3.0", "4.1"),
                           .exact = exact_strength,
                           .thesis = within_part(0.02),
                           .robust = within_part(0.02)},
                          speed_of_shock(),
                          {.name = "way of the shock",
                           .reading = shock_travel,
                           .theory = printed("0.25", "4.1"),
                           .exact = exact_travel,
                           .thesis = within_part(0.02),
                           .robust = within_part(0.02)},
                          l1_error("density", 0.015),
                          l1_error("velocity", 0.04),
                          l1_error("pressure", 0.02),
                          l1_error("specific_energy", 0.04)};
  Problem continuity{.name = "sod-continuity",
                     .place = "4.1, Fig. 13",
                     .deck = "sod-continuity",
                     .robust = std::nullopt,  // which has a density of its own
                     .beside = "sod"};
  continuity.quantities = {{.name = "largest density difference from quadratic",
                            .reading = largest_density_difference,
                            .upper_bound = 0.005},
                           speed_of_shock(),
                           l1_error("density", 0.015)};
  Problem cell{.name = "sod-cell", .place = "4.1, Fig. 13", .deck = "sod-cell", .robust = std::nullopt};
  Quantity speed = speed_of_shock();
  speed.thesis = std::nullopt;  // densities of single cells scatter about the shock
  cell.quantities = {std::move(speed), l1_error("density", 0.06)};
  return {quadratic, continuity, cell};
}

// The expansion of a gas: 4.2, Fig. 15 and Box 2.

/// That of the gas as the deck has it, (4.4).
double exact_pressure(const RunFiles& run) {
  const Body& gas = run.scene().bodies.front();
  return std::get<IdealGas>(gas.material).pressure(gas.density, gas.specific_energy);
}

double first_pressure(const RunFiles& run) { return mean(run.points("pressure", 0)); }

/// Of the quarter of a cylinder that has the volume of the points, which do not fill a circle exactly.
double first_radius(const RunFiles& run) { return std::sqrt(4 * sum(run.points("volume", 0)) / std::numbers::pi); }

Problem gas_expansion() {
  Problem problem{.name = "gas-expansion", .place = "4.2, Figs 15 to 18", .deck = "gas-expansion"};
  problem.thesis.overrides = {"in.tmax=0.005", "reference.solution='radial-gas'"};
  problem.robust->overrides = problem.thesis.overrides;
  problem.quantities = {
      {.name = "cell size",
       .reading = summary_value("dx"),
       .published = {printed("0.025", "4.2"), stated(0.05, "Box 2")},
       .by_published = Judged::both},
      {.name = "radius at t = 0",
       .reading = first_radius,
       .published = {printed("0.38", "4.2"), following(0.376, "Box 2", 0.005)},
       .by_published = Judged::both},
      {.name = "pressure at t = 0",
       .reading = first_pressure,
       .published = {printed("100", "Fig. 15")},
       .exact = exact_pressure,
       .thesis = within_part(0.01),
       .robust = within_part(0.01)},
      {.name = "pressure at t = 0, by (4.4)",
       .reading = exact_pressure,
       .of_deck = true,
       .published = {printed("100", "Fig. 15")},
       .by_published = Judged::both},
      {.name = "rms radius at t = .005",
       .reading = summary_value("rms_radius"),
       .exact = summary_value("exact_rms_radius"),
       .thesis = within_part(0.01),
       .robust = within_part(0.01)},
      {.name = "radius of 95 % of the mass at t = .005",
       .reading = summary_value("radius_95"),
       .exact = summary_value("exact_radius_95"),
       .thesis = within_part(0.02),
       .robust = within_part(0.01)},
      {.name = "energy lost [%]", .reading = energy_lost_percent, .exact = constant(0), .robust = within(1e-6)}};
  return problem;
}

}  // namespace

std::vector<Problem> problems_of_chapter4() {
  auto problems = shock_tubes();
  problems.push_back(gas_expansion());
  return problems;
}

}  // namespace tether::published
