// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <span>
#include <string>
#include <vector>

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

}  // namespace tether

namespace tether::fem {

// How implicit solvers get on in time: a step whose Newton iteration does not converge is halved.

constexpr int most_halvings = 6;

/// The last residuals of Newton's method, for people: " 1.2e-3 4e-7".
std::string residuals_text(std::span<const double> residuals);

/// Takes a step by advance(dt), whose report says whether it converged; where not, two of half its length, each of
/// which may be halved again, until stop(dt, report) has to throw. Counts time, steps and halvings; the first halving
/// is told.
template <class State, class Advance, class Stop>
void halving_step(State& state, double dt, int halvings, const Advance& advance, const Stop& stop,
                  std::vector<std::string>& messages) {
  const auto report = advance(dt);
  if (report.converged) {
    add_compensated(state.time, state.time_lost, dt);
    ++state.steps;
    return;
  }
  if (halvings == most_halvings) stop(dt, report);
  if (state.halvings++ == 0) {
    messages.push_back(fmt::format("t = {:.6g}: a step of {:.4g} does not converge and is halved", state.time, dt));
  }
  halving_step(state, 0.5 * dt, halvings + 1, advance, stop, messages);
  halving_step(state, 0.5 * dt, halvings + 1, advance, stop, messages);
}

/// The same, as one step of the clock that ends at tmax [time] to the last bit.
template <class State, class Advance, class Stop>
void clock_step(State& state, double dt, double tmax, const Advance& advance, const Stop& stop,
                std::vector<std::string>& messages) {
  const bool last = tmax - state.time <= dt;
  halving_step(state, dt, 0, advance, stop, messages);
  if (last) state.time = tmax, state.time_lost = 0;
  state.dt_last = dt;
  if (state.dt_min == 0 || (!last && dt < state.dt_min)) state.dt_min = dt;
}

}  // namespace tether::fem
