// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "results/signal.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// 5.7, Table 1 and Boxes 6 and 7. The period hardly depends on E (the string stretches by 7e-4): what tells another E
// from Table 1's is the row of its own.

/// The angle is negative to the left, where the pendulum begins: its first return is the lowest angle behind the
/// highest.
double amplitude_kept(const RunFiles& run) {
  const auto time = run.history("time");
  auto angle = run.history("tracked_angle");
  for (double& value : angle) value = -value;
  const auto turn = first_minimum(time, angle);
  return first_maximum_after(time, angle, turn.time).value / angle.front();
}

double start_angle(const RunFiles& run) { return std::abs(run.history("tracked_angle").front()); }

std::vector<Quantity> swing(double thesis_period, double robust_period, double robust_amplitude) {
  return {{.name = "period",
           .reading = summary_value("period"),
           .exact = summary_value("exact_period"),
           .thesis = within_part(thesis_period),
           .robust = within_part(robust_period)},
          {.name = "amplitude after one swing over the first",
           .reading = amplitude_kept,
           .exact = constant(1),
           .robust = within_part(robust_amplitude)},
          stated_modulus("Young's modulus of the string", 1, 1e6, "Table 1")};
}

Problem pendulum(const char* points, std::vector<Quantity> quantities) {
  Problem problem{.name = std::string("pendulum-") + points, .place = "5.7, Fig. 37"};
  problem.deck = problem.name;
  problem.robust->overrides = {"points.pinned(1)=.true."};
  problem.quantities = std::move(quantities);
  return problem;
}

/// Points that change cell shake the strings of the finer grids: their runs differ with the last bit of the step.
Problem shaken(Problem problem) {
  problem.thesis.varied = true;
  return problem;
}

/// Where Table 1, Box 7 and the notes of Box 6 differ, and what the thesis says of its own computers.
std::vector<Quantity> particulars_of_40() {
  return {{.name = "angle at the start [degrees]",
           .reading = start_angle,
           .published = {printed("19.8", "Table 1"), printed("18.44", "Box 7")},
           .by_published = Judged::both},
          {.name = "thickness",
           .reading = thickness(1),
           .published = {printed("0.1", "Table 1"), printed("0.175", "np2 of Box 7")},
           .by_published = Judged::both},
          {.name = "processor time [s]",
           .reading = summary_value("cpu_seconds"),
           .published = {printed("1020", "PowerPC 604"), printed("570", "Pentium II")}}};
}

}  // namespace

std::vector<Problem> pendulums() {
  auto of_40 = swing(0.03, 0.004, 0.02);
  for (Quantity& quantity : particulars_of_40()) of_40.push_back(std::move(quantity));
  Problem two_way = shaken(pendulum("40-two-way", swing(0.06, 0.004, 0.02)));
  two_way.place = "5.7.3, Fig. 38";
  return {pendulum("20", swing(0.1, 0.015, 0.1)), shaken(pendulum("40", std::move(of_40))),
          shaken(pendulum("80", swing(0.03, 0.001, 0.01))), pendulum("320", swing(0.01, 0.0002, 0.01)),
          std::move(two_way)};
}

}  // namespace tether::published
