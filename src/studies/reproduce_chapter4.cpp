// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/radial_gas.hpp"
#include "reference/riemann.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// Sod's shock tube: 4.1, Fig. 11 and Box 1, with pressures .4 rho i.

constexpr double left_density = 1, right_density = 0.125, left_energy = 2.5, right_energy = 2.0, gm1 = 0.4;
constexpr double diaphragm = 0.5, sod_time = 0.143;
constexpr double right_pressure = gm1 * right_density * right_energy;

RiemannSolution sod() {
  return solve_riemann(
      {{left_density, 0, gm1 * left_density * left_energy}, {right_density, 0, right_pressure}, 1 + gm1, diaphragm});
}

/// Mass through the shock: rho1 s = rho2 (s - u).
double exact_shock_speed() {
  const StarRegion star = sod().star;
  return star.density_right * star.velocity / (star.density_right - right_density);
}

double exact_strength() { return sod().star.pressure / right_pressure; }

/// Where the density, seen from the right end, first passes the middle between before and behind the shock.
double shock_place(const RunFiles& run) {
  const ColumnMeans density = column_means(run, "density");
  const double level = 0.5 * (right_density + sod().star.density_right);
  for (std::size_t c = density.x.size(); c-- > 1;) {
    const double here = density.mean[c - 1], right = density.mean[c];
    if (here < level) continue;
    return density.x[c - 1] + (density.x[c] - density.x[c - 1]) * (here - level) / (here - right);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double shock_travel(const RunFiles& run) { return shock_place(run) - diaphragm; }
double shock_speed(const RunFiles& run) { return shock_travel(run) / run.time(run.snapshots() - 1); }

/// The mean pressure in the middle half between contact and shock, as they are exactly, over the right one.
double strength(const RunFiles& run) {
  const double contact = diaphragm + sod().star.velocity * sod_time;
  const double shock = diaphragm + exact_shock_speed() * sod_time;
  const ColumnMeans pressure = column_means(run, "pressure");
  std::vector<double> between;
  for (std::size_t c = 0; c < pressure.x.size(); ++c) {
    const double part = (pressure.x[c] - contact) / (shock - contact);
    if (part > 0.25 && part < 0.75) between.push_back(pressure.mean[c]);
  }
  return mean(between) / right_pressure;
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

std::vector<Problem> shock_tubes() {
  Problem quadratic{.name = "sod", .place = "4.1, Figs 13, 14", .deck = "sod"};
  quadratic.quantities = {{.name = "shock strength p2/p1",
                           .reading = strength,
                           .published = {{3.0, "4.1"}},
                           .exact = exact_strength,
                           .thesis = within_part(0.02),
                           .robust = within_part(0.02)},
                          {.name = "shock speed",
                           .reading = shock_speed,
                           .published = {{1.75, "4.1"}},
                           .exact = exact_shock_speed,
                           .thesis = within_part(0.02),
                           .robust = within_part(0.02)},
                          {.name = "way of the shock",
                           .reading = shock_travel,
                           .published = {{0.25, "4.1"}},
                           .exact = [] { return exact_shock_speed() * sod_time; },
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
                           l1_error("density", 0.015)};
  Problem cell{.name = "sod-cell", .place = "4.1, Fig. 13", .deck = "sod-cell", .robust = std::nullopt};
  cell.quantities = {l1_error("density", 0.06)};
  return {quadratic, continuity, cell};
}

// The expansion of a gas: 4.2, Fig. 15 and Box 2.

constexpr double gas_radius = 0.376, gas_energy = 250, gas_time = 0.005;

double exact_rms_radius() { return expanded(shells_of({gas_radius, 1, gas_energy, gm1}), gas_time).rms_radius(); }

double exact_radius_95() {
  return expanded(shells_of({gas_radius, 1, gas_energy, gm1}), gas_time).radius_of_share(0.95);
}

double first_pressure(const RunFiles& run) { return mean(run.points("pressure", 0)); }

/// Of the quarter of a cylinder that has the volume of the points.
double first_radius(const RunFiles& run) { return std::sqrt(4 * sum(run.points("volume", 0)) / std::numbers::pi); }

Problem gas_expansion() {
  Problem problem{.name = "gas-expansion", .place = "4.2, Figs 15 to 18", .deck = "gas-expansion"};
  problem.thesis.overrides = {"in.tmax=0.005", "reference.solution='radial-gas'"};
  problem.robust->overrides = problem.thesis.overrides;
  problem.quantities = {
      {.name = "cell size",
       .reading = summary_value("dx"),
       .published = {{0.025, "4.2"}, {0.05, "Box 2"}},
       .thesis = within_part(1e-6),
       .robust = within_part(1e-6)},
      {.name = "radius at t = 0",
       .reading = first_radius,
       .published = {{0.38, "4.2"}, {0.376, "Box 2"}},
       .thesis = within_part(0.005),
       .robust = within_part(0.005)},
      {.name = "pressure at t = 0",
       .reading = first_pressure,
       .published = {{100, "Fig. 15"}},
       .exact = constant(gm1 * gas_energy),
       .thesis = within_part(0.01),
       .robust = within_part(0.01)},
      {.name = "rms radius at t = .005",
       .reading = summary_value("rms_radius"),
       .exact = exact_rms_radius,
       .thesis = within_part(0.01),
       .robust = within_part(0.01)},
      {.name = "radius of 95 % of the mass at t = .005",
       .reading = summary_value("radius_95"),
       .exact = exact_radius_95,
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
