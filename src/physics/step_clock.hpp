// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "fields/rows.hpp"

namespace tether {

/// The step from `time`: dt, or what is left to tmax. A last step a 1e-9 longer than dt is taken whole: rounding in the
/// sum of steps must not leave a sliver before tmax. [time]
inline double step_before_end(double dt, double time, double tmax) {
  constexpr double stretch = 1 + 1e-9;
  const double left = tmax - time;
  return left <= dt * stretch ? left : dt;
}

/// sum += term, with what rounding takes from it kept in `lost` (Kahan's sum): 1e5 equal steps must end where their
/// product says.
inline void add_compensated(double& sum, double& lost, double term) {
  const double owed = term - lost, next = sum + owed;
  lost = (next - sum) - owed;
  sum = next;
}

/// How far a run is: a part of the state of every path. A number is a member and its row.
struct StepClock {
  double time = 0, time_lost = 0;  ///< sum of the steps, and what rounding took from it [time]
  double dt_last = 0, dt_min = 0;  ///< dt_min: the shortest but for one cut by the end [time]
  long long steps = 0;             ///< parts of a halved step count as steps

  /// Name in a checkpoint, and member.
  static constexpr auto rows() {
    using C = StepClock;
    return std::tuple{
        NumberField{"time", &C::time},     NumberField{"time_lost", &C::time_lost}, NumberField{"dt_last", &C::dt_last},
        NumberField{"dt_min", &C::dt_min}, NumberField{"steps", &C::steps},
    };
  }

  /// Returns whether a step of dt from here ends at tmax. [time]
  bool ends(double dt, double tmax) const { return tmax - time <= dt; }
  /// Counts a step of dt, or a part of one that is halved. [time]
  void pass(double dt) {
    add_compensated(time, time_lost, dt);
    ++steps;
  }
  /// Notes the whole step of dt that has passed, which as the last one ended at tmax to the last bit. [time]
  void close_step(double dt, double tmax, bool last) {
    if (last) time = tmax, time_lost = 0;
    dt_last = dt;
    // A last step that tmax cuts short says nothing of the run.
    if (dt_min == 0 || (!last && dt < dt_min)) dt_min = dt;
  }
  /// Counts a step that was not halved. [time]
  void count_step(double dt, double tmax) {
    const bool last = ends(dt, tmax);
    pass(dt);
    close_step(dt, tmax, last);
  }
};

/// with(name, number) for the clock of a state: of a checkpoint, either way.
template <class Exchange, class State>
void exchange_clock(Exchange& with, State& state) {
  using Part = std::conditional_t<std::is_const_v<State>, const StepClock, StepClock>;
  exchange_numbers(with, static_cast<Part&>(state));
}

}  // namespace tether

namespace tether::fem {

// How implicit solvers get on in time: a step whose Newton iteration does not converge is halved.

constexpr int most_halvings = 6;
/// Below this part of the deck's step it is halved no more, give or take rounding.
constexpr double shortest_halved = 1.001 / (1 << most_halvings);

/// The last residuals of Newton's method, for people: " 1.2e-3 4e-7".
std::string residuals_text(std::span<const double> residuals);

/// Takes a step by advance(dt), whose report says whether it converged; where not, two of half its length, each of
/// which may be halved again, until stop(dt, report) has to throw. Counts time, steps and halvings; the first halving
/// is reported.
template <class State, class Advance, class Stop>
void halving_step(State& state, double dt, int halvings, const Advance& advance, const Stop& stop,
                  std::vector<std::string>& messages) {
  const auto report = advance(dt);
  if (report.converged) {
    state.pass(dt);
    return;
  }
  if (halvings == most_halvings) stop(dt, report);
  if (state.halvings++ == 0) {
    messages.push_back(fmt::format("t = {:.6g}: a step of {:.4g} does not converge and is halved", state.time, dt));
  }
  halving_step(state, 0.5 * dt, halvings + 1, advance, stop, messages);
  halving_step(state, 0.5 * dt, halvings + 1, advance, stop, messages);
}

/// Does the same, as one step of the clock that ends at tmax [time] to the last bit.
template <class State, class Advance, class Stop>
void clock_step(State& state, double dt, double tmax, const Advance& advance, const Stop& stop,
                std::vector<std::string>& messages) {
  const bool last = state.ends(dt, tmax);
  halving_step(state, dt, 0, advance, stop, messages);
  state.close_step(dt, tmax, last);
}

}  // namespace tether::fem
