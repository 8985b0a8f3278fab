// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "reference/hung_string.hpp"
#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// 5.5 and Boxes 3 and 4; the string of 5.6 and Box 5 is the same spring, six points of which begin slack by -.1. The
// theory is that of 5.5.1, a massless spring as long as what is between the first and the last point. The decks' spring
// goes on to the wall and has a mass of its own: that is what the exact values are of.

constexpr double mass = 3.33, area = 0.1, young = 1e6, length = 0.3, gravity = 250;
constexpr double stiffness = area * young / length;
constexpr double spacing = length / 9, slack = 6 * 0.1 * spacing;

const SpringMass spring{mass, stiffness, gravity, 0};
const StringBounce string{mass, stiffness, gravity, slack};
constexpr const char* by_spring = "5.11";
constexpr const char* by_string = "5.11 after a fall";

/// E A over the length between the first and the last point, as 5.5.2 counts it.
double spring_constant(const RunFiles& run) {
  const HungString spring = hung_string(run.scene());
  const PointSet& P = run.scene().points;
  return spring.stiffness * spring.length / std::hypot(P.x.back() - P.x.front(), P.y.back() - P.y.front());
}

Quantity constant_of_spring() {
  return {.name = "spring constant E A/L",
          .reading = spring_constant,
          .of_deck = true,
          .published = {following(stiffness, "5.5.2")},
          .by_published = Judged::both};
}

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
                         .theory = following(spring.period(), by_spring),
                         .theory_for = TheoryFor::runs,
                         .thesis_by_theory = within_part(0.01),
                         .robust_by_theory = within_part(0.03),
                         .exact = summary_value("exact_period"),
                         .robust = within_part(0.03)},
                        {.name = "largest displacement",
                         .reading = summary_value("largest_drop"),
                         .published = {printed("0.005", "5.6")},
                         .by_published = Judged::both,
                         .theory = following(spring.largest_drop(), by_spring),
                         .theory_for = TheoryFor::runs,
                         .thesis_by_theory = within_part(0.01),
                         .robust_by_theory = within_part(0.02),
                         .exact = summary_value("exact_largest_drop"),
                         .robust = within_part(0.02)},
                        constant_of_spring(),
                        {.name = "cross-section",
                         .reading = thickness(1),
                         .published = {stated(area, "5.5.2")},
                         .by_published = Judged::both},
                        {.name = "heavy mass over another point's",
                         .reading = mass_ratio,
                         .published = {following(10000, "5.5.2", 0.005)},
                         .by_published = Judged::both}};
  return problem;
}

/// The way that the mass falls before the string is taut.
double slack_of(const RunFiles& run) { return hung_string(run.scene()).slack; }
/// The way that the taut string goes.
double stretch(const RunFiles& run) { return run.summary("largest_drop") - slack_of(run); }

Problem string_mass() {
  Problem problem{.name = "string-mass", .place = "5.6, Fig. 29", .deck = "string-mass", .robust = pinned()};
  problem.quantities = {{.name = "slack taken up",
                         .reading = summary_value("taut_time"),
                         .published = {printed("0.013", "5.6")},
                         .by_published = Judged::thesis,
                         .theory = following(string.taut_time(), by_string),
                         .exact = summary_value("exact_taut_time"),
                         .thesis = within_part(0.01),
                         .robust = within_part(0.04)},
                        {.name = "displacement in tension",
                         .reading = stretch,
                         .published = {printed("0.01", "5.6")},
                         .by_published = Judged::both,
                         .theory = following(string.largest_drop() - slack, by_string),
                         .theory_for = TheoryFor::nothing,
                         .exact = [](const RunFiles& run) { return run.summary("exact_largest_drop") - slack_of(run); },
                         .thesis = within_part(0.1),
                         .robust = within_part(0.1)},
                        {.name = "tension until",
                         .reading = summary_value("slack_again_time"),
                         .published = {printed("0.023", "5.6")},
                         .theory = following(string.slack_again_time(), by_string),
                         .theory_for = TheoryFor::nothing,
                         .exact = summary_value("exact_slack_again_time"),
                         .thesis = within_part(0.05)},
                        {.name = "apex",
                         .reading = summary_value("apex_time"),
                         .published = {printed("0.0375", "5.6")},
                         .theory = following(string.apex_time(), by_string),
                         .theory_for = TheoryFor::nothing,
                         .exact = summary_value("exact_apex_time"),
                         .thesis = within_part(0.05)},
                        constant_of_spring()};
  return problem;
}

}  // namespace

std::vector<Problem> problems_of_chapter5() { return {spring_mass(), string_mass()}; }

}  // namespace tether::published
