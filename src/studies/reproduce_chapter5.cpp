// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "reference/spring.hpp"
#include "reference/string_bounce.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// 5.5 and Boxes 3 and 4; the string of 5.6 and Box 5 is the same spring, six points of which begin slack by -.1.

constexpr double mass = 3.33, area = 0.1, young = 1e6, length = 0.3, gravity = 250;
constexpr double stiffness = area * young / length;
constexpr double spacing = length / 9, slack = 6 * 0.1 * spacing;

SpringMass spring() { return {mass, stiffness, gravity}; }
StringBounce string() { return {mass, stiffness, gravity, slack}; }

/// What holds the first point is a pin where strain is measured by elements: without it the point slides in its cell.
MethodRuns pinned() { return {{"points.pinned(1)=.true."}}; }

double mass_ratio(const RunFiles& run) {
  const auto masses = run.points("mass", 0);
  return masses.back() / masses.front();
}

Problem spring_mass() {
  Problem problem{.name = "spring-mass", .place = "5.5, Fig. 26", .deck = "spring-mass", .robust = pinned()};
  problem.quantities = {{.name = "period",
                         .reading = summary_value("period"),
                         .exact = [] { return spring().period(); },
                         .thesis = within_part(0.01),
                         .robust = within_part(0.03)},
                        {.name = "largest displacement",
                         .reading = summary_value("largest_drop"),
                         .published = {{0.005, "5.6"}},
                         .exact = [] { return spring().largest_drop(); },
                         .thesis = within_part(0.01),
                         .robust = within_part(0.02)},
                        {.name = "cross-section",
                         .reading = thickness(1),
                         .published = {{area, "5.5.2"}},
                         .thesis = within_part(0.001),
                         .robust = within_part(0.001)},
                        {.name = "heavy mass over another point's",
                         .reading = mass_ratio,
                         .published = {{10000, "5.5.2"}},
                         .thesis = within_part(0.01),
                         .robust = within_part(0.01)}};
  return problem;
}

/// The way that the taut string goes.
double stretch(const RunFiles& run) { return run.summary("largest_drop") - slack; }

Problem string_mass() {
  Problem problem{.name = "string-mass", .place = "5.6, Fig. 29", .deck = "string-mass", .robust = pinned()};
  problem.quantities = {{.name = "slack taken up",
                         .reading = summary_value("taut_time"),
                         .published = {{0.013, "5.6"}},
                         .exact = [] { return string().taut_time(); },
                         .thesis = within_part(0.01),
                         .robust = within_part(0.04)},
                        {.name = "displacement in tension",
                         .reading = stretch,
                         .published = {{0.01, "5.6"}},
                         .exact = [] { return string().largest_drop() - slack; },
                         .thesis = within_part(0.1),
                         .robust = within_part(0.1)},
                        {.name = "tension until",
                         .reading = summary_value("slack_again_time"),
                         .published = {{0.023, "5.6"}},
                         .exact = [] { return string().slack_again_time(); },
                         .thesis = within_part(0.05)},
                        {.name = "apex",
                         .reading = summary_value("apex_time"),
                         .published = {{0.0375, "5.6"}},
                         .exact = [] { return string().apex_time(); },
                         .thesis = within_part(0.05)}};
  return problem;
}

}  // namespace

std::vector<Problem> problems_of_chapter5() { return {spring_mass(), string_mass()}; }

}  // namespace tether::published
