// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "reference/piston.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// The piston and its container: 6.1.2, with K = 100, A = 1, L = 20, rho = 1e-4, beta = 1.58e6.

constexpr double spring_stiffness = 100, area = 1, fluid_length = 20, fluid_density = 1e-4, bulk_modulus = 1.58e6;

Piston piston(double mass) { return {mass, spring_stiffness, area, fluid_length, fluid_density, bulk_modulus}; }

double vacuum_period(double mass) { return 2 * std::numbers::pi * std::sqrt(mass / spring_stiffness); }

double frequency(const RunFiles& run) { return 2 * std::numbers::pi / run.summary("period"); }

/// What Table 3 prints of a mass.
struct TableRow {
  double mass, frequency, theoretical_period, period;
};

std::vector<Quantity> of_table3(const TableRow& row) {
  return {{.name = "period",
           .reading = summary_value("period"),
           .published = {{row.period, "Table 3"}},
           .exact = [=] { return piston(row.mass).period(); },
           .thesis = within_part(0.005),
           .robust = within_part(0.01)},
          {.name = "period, the thesis' theory",
           .reading = summary_value("period"),
           .published = {{row.theoretical_period, "Table 3"}},
           .exact = [=] { return piston(row.mass).period(); },
           .thesis = within_part(0.005),
           .robust = within_part(0.01)},
          {.name = "frequency, the thesis' theory [rad/s]",
           .reading = frequency,
           .published = {{row.frequency, "Table 3"}},
           .exact = [=] { return piston(row.mass).frequency(); },
           .thesis = within_part(0.005),
           .robust = within_part(0.01)}};
}

Problem piston_problem(const char* name, const TableRow& row) {
  Problem problem{.name = name, .place = "6.1, Table 3", .deck = name};
  // One point a cell: with a velocity field of its own about each point the fluid gives way to the sides, and the
  // piston's field, which nothing resists, lets the fluid through. The robust set runs with increments here.
  problem.robust->overrides = {"points.pinned(1)=.true.", "mpm.transfer='flip'"};
  problem.quantities = of_table3(row);
  return problem;
}

Quantity speeding_up() {
  return {.name = "period in a vacuum over that with fluid",
          .reading = [](const RunFiles& run) { return vacuum_period(1) / run.summary("period"); },
          .published = {{30, "6.1.2"}},
          .exact = [] { return vacuum_period(1) / piston(1).period(); },
          .thesis = within_part(0.005),
          .robust = within_part(0.01)};
}

}  // namespace

std::vector<Problem> problems_of_chapter6() {
  Problem light = piston_problem("piston-m01", {0.1, 886.2, 0.00709, 0.0071});
  Problem heavy = piston_problem("piston-m1", {1.0, 281.2, 0.02234, 0.022});
  heavy.quantities.push_back(speeding_up());
  return {std::move(light), std::move(heavy)};
}

}  // namespace tether::published
