// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// Two bars: A.1.2 and A.1.5, Figs 93 to 96, Box 15. The left one, body 1, comes with a velocity of 2.

constexpr double approach = 2, impact_over = 0.3;

/// Of the velocities at the end: 1 for what bounces, 0 for what sticks.
double restitution(const RunFiles& run) {
  return (run.history("body_vx", 2).back() - run.history("body_vx", 1).back()) / approach;
}

double mean_since_impact(const RunFiles& run, std::size_t body) {
  const auto time = run.history("time"), v = run.history("body_vx", body);
  std::vector<double> since;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] > impact_over) since.push_back(v[k]);
  }
  return mean(since);
}

/// As above, of the means since the impact, about which bars that stick swing.
double mean_restitution(const RunFiles& run) {
  return (mean_since_impact(run, 2) - mean_since_impact(run, 1)) / approach;
}

/// What remains after an elastic impact does not depend on E, but when it is over does.
Quantity modulus_of_bars(const char* place) { return stated_modulus("Young's modulus of the bars", 1, 1e5, place); }

Problem released() {
  Problem problem{.name = "two-bar", .place = "A.1.5, Figs 95, 96a", .deck = "two-bar", .thesis = {{}, true}};
  problem.robust = MethodRuns{{"mpm.contact='gap'"}, true};  // the deck asks for the thesis' contact
  problem.quantities = {{.name = "velocity of the left bar",
                         .reading = last_value("body_vx", 1),
                         .published = {printed("0.3", "A.1.5")},
                         .by_published = Judged::thesis},
                        {.name = "velocity of the right bar",
                         .reading = last_value("body_vx", 2),
                         .published = {printed("1.7", "A.1.5")},
                         .by_published = Judged::thesis},
                        {.name = "restitution",
                         .reading = restitution,
                         .published = {printed("0.7", "A.1.5")},
                         .by_published = Judged::thesis},
                        {.name = "energy lost [%]",
                         .reading = energy_lost_percent,
                         .published = {printed("11", "Fig. 96a")},
                         .by_published = Judged::thesis},
                        modulus_of_bars("Fig. 92")};
  return problem;
}

/// Without lateral strain the bars are as in one dimension: alike, they change their velocities and keep their energy.
Problem without_poisson(const char* name) {
  Problem problem{.name = name, .place = "A.1.5, Fig. 96b", .deck = name, .thesis = {{}, true}};
  problem.robust = MethodRuns{{"mpm.contact='gap'"}, true};
  problem.quantities = {{.name = "energy lost [%]",
                         .reading = energy_lost_percent,
                         .published = {printed("2", "A.1.5")},
                         .exact = constant(0)},
                        {.name = "restitution", .reading = restitution, .exact = constant(1)},
                        modulus_of_bars("Fig. 92")};
  return problem;
}

Problem sticking() {
  Problem problem{.name = "two-bar-stick", .place = "A.1.2, Fig. 93", .deck = "two-bar-stick", .thesis = {{}, true}};
  problem.robust = std::nullopt;  // which does not stick
  problem.quantities = {{.name = "restitution, of the means since the impact",
                         .reading = mean_restitution,
                         .published = {{0, "A.1.5", 0.2}},
                         .by_published = Judged::thesis},
                        modulus_of_bars("Fig. 92")};
  return problem;
}

// A ball, body 1, and a net, body 2: 5.9 with Box 8, A.1.6 with Box 16.

constexpr int ball = 1, net = 2;
constexpr double steady = 0.02;  // of the ball's first velocity: as near it is to the one that it ends with

double ball_radius(const RunFiles& run) { return std::sqrt(sum(run.points("volume", 0, ball)) / std::numbers::pi); }
double release_time(const RunFiles& run) { return first_near_the_end(run, "body_vx", ball, steady); }

Quantity modulus_of_ball() { return stated_modulus("Young's modulus of the ball", ball, 1e4, "Tables 2, 11"); }
Quantity modulus_of_net() { return stated_modulus("Young's modulus of the net", net, 1e4, "Tables 2, 11"); }

std::vector<Quantity> of_ball_and_net(bool thesis_is_judged) {
  const Judged by_runs = thesis_is_judged ? Judged::thesis : Judged::none;
  const Judged by_start = thesis_is_judged ? Judged::both : Judged::robust;
  return {{.name = "velocity of the ball at the end",
           .reading = last_value("body_vx", ball),
           .published = {printed("-0.7", "Fig. 42")},
           .by_published = by_runs},
          {.name = "released from the net at",
           .reading = release_time,
           .published = {printed("2.8", "5.9"), printed("0.8", "A.1.6")},
           .by_published = by_runs},
          {.name = "radius of the ball",
           .reading = ball_radius,
           .published = {printed("3", "A.1.6"), printed("1.5", "Boxes 8, 16")},
           .by_published = by_start},
          {.name = "thickness of the net", .reading = thickness(net), .published = {printed("0.0125", "Table 11")}},
          modulus_of_ball(),
          modulus_of_net()};
}

/// Of the deck with the thin net, which the thesis' method loses, that method is not judged.
Problem ball_and_net(const char* deck, const char* place, bool thesis_is_judged) {
  Problem problem{.name = deck, .place = place, .deck = deck};
  problem.thesis = {{"mpm.contact='release'", "mpm.criterion=3"}, true};
  problem.robust = MethodRuns{{}, true};
  problem.quantities = of_ball_and_net(thesis_is_judged);
  return problem;
}

Problem ball_without_release() {
  Problem problem{.name = "ball-net-stick", .place = "A.1.6, Fig. 98", .deck = "ball-net-orig"};
  problem.thesis = {{"mpm.contact='none'"}, true};
  problem.robust = std::nullopt;
  problem.quantities = {{.name = "velocity of the ball at the end",
                         .reading = last_value("body_vx", ball),
                         .published = {printed("-0.1", "A.1.6")}},
                        modulus_of_ball(),
                        modulus_of_net()};
  return problem;
}

// A point that changes cells: A.2, Figs 102 to 104. The two nodes of a row share its force; point 6 crosses in the
// first step.

constexpr double row_tolerance = 1e-6;

Readout row_force(double height, std::size_t snapshot) {
  return [=](const RunFiles& run) {
    const auto y = run.node_y(), forces = run.nodes("force_y", snapshot);
    double force = 0;
    for (std::size_t n = 0; n < y.size(); ++n) force += std::abs(y[n] - height) < row_tolerance ? forces[n] : 0;
    return force;
  };
}

Readout stress(std::size_t point, std::size_t snapshot) {
  return [=](const RunFiles& run) { return run.points("syy", snapshot).at(point - 1); };
}

/// The figures print the state of a run of the thesis, which the deck is made up after to a part of it.
Quantity judged(const std::string& name, Readout reading, double value, const char* place, double part) {
  return {.name = name,
          .reading = std::move(reading),
          .published = {following(value, place, part)},
          .by_published = Judged::thesis};
}

}  // namespace

std::vector<Problem> two_bars() {
  return {released(), without_poisson("two-bar-nu0"), without_poisson("two-bar-nu0-fine"), sticking()};
}

std::vector<Problem> balls_and_nets() {
  return {ball_and_net("ball-net", "5.9, Fig. 42", true), ball_and_net("ball-net-orig", "A.1.6, Fig. 100", false),
          ball_without_release()};
}

std::vector<Problem> noise() {
  Problem problem{.name = "noise", .place = "A.2, Figs 103, 104", .deck = "noise"};
  problem.thesis.overrides = {"in.tmax=1.8d-5", "in.tiout(13)=1.8d-6"};  // each step of the first ten
  problem.robust = std::nullopt;  // its splines have no such noise, and other forces at the nodes
  problem.quantities = {judged("force at y = 1.9 before", row_force(1.9, 0), 66, "Fig. 103", 0.02),
                        judged("force at y = 1.8 before", row_force(1.8, 0), 111, "Fig. 103", 0.02),
                        judged("force at y = 1.7 before", row_force(1.7, 0), 3114, "Fig. 103", 0.02),
                        judged("force at y = 1.9 after", row_force(1.9, 1), 2183, "Fig. 104", 0.05),
                        judged("force at y = 1.8 after", row_force(1.8, 1), -3940, "Fig. 104", 0.05),
                        judged("force at y = 1.7 after", row_force(1.7, 1), 5123, "Fig. 104", 0.05),
                        judged("stress of point 6 before", stress(6, 0), 123034, "Fig. 103", 0.001),
                        judged("stress of point 7 before", stress(7, 0), 181170, "Fig. 103", 0.001),
                        judged("stress of point 6 after", stress(6, 1), 123274, "Fig. 104", 0.01),
                        judged("stress of point 7 after", stress(7, 1), 179802, "Fig. 104", 0.01)};
  return {std::move(problem)};
}

}  // namespace tether::published
