// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/contact_report.hpp"

#include <fmt/format.h>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "results/summary_keys.hpp"

namespace tether::fem {

void report_contact(const ContactDoubts& before, const ContactDoubts& now, double time,
                    std::vector<std::string>& messages) {
  if (before.slid <= 1 && now.slid > 1)
    messages.push_back(fmt::format(
        "t = {:.6g}: surfaces slide {:.3g} gaps past each other in a step: damped contact brakes them, the less the "
        "shorter the steps (with the square) and the larger the gap; step='energy' of $contact does not",
        time, now.slid));
  if (before.euler_steps == 0 && now.euler_steps > 0)
    messages.push_back(fmt::format(
        "t = {:.6g}: no step that keeps the energy leads on: backward Euler takes this one, and others like it "
        "(contact_euler_steps of summary.txt counts them; energy_damped and energy_contact_damped have what they took)",
        time));
  if (before.eased == 0 && now.eased > 0)
    messages.push_back(fmt::format(
        "t = {:.6g}: friction as steep as stick of $contact asks has no solution here: it comes up at up to a hundred "
        "times that speed (contact_eased_steps of summary.txt counts the steps)",
        time));
}

void add_contact_summary(const Solids& solids, const ContactDoubts& doubts, Summary& summary) {
  if (!solids.contact) return;
  summary.push_back(line_of("contact_gap", solids.contact->gap));
  summary.push_back(line_of("contact_slid", doubts.slid));
  summary.push_back(line_of("contact_euler_steps", doubts.euler_steps));
  summary.push_back(line_of("contact_eased_steps", doubts.eased));
}

namespace {

/// Says why a step may not converge.
const char* likely_cause(const Solids& solids) {
  if (!solids.contact) return "a step or a load increment too long, or an element turned inside out";
  if (solids.integrator == Integrator::equilibrium)
    return "a body that neither supports nor contact hold (one that starts farther than the gap from what is to hold "
           "it, too), or a load increment too long";
  return "bodies that squeeze each other by more than their elements bear, or a step too long: shorter steps, finer "
         "elements or a larger gap";
}

}  // namespace

void refuse_step(const SolidState& state, const Solids& solids, double dt, const NewtonReport& report) {
  std::size_t worst = 0;
  double fastest = 0;
  for (std::size_t k = 0; k < state.v.size(); ++k) {
    if (std::abs(state.v[k]) > fastest) fastest = std::abs(state.v[k]), worst = k;
  }
  const std::size_t dim = at(solids.mesh.dim()), node = worst / dim;
  throw RunError(
      fmt::format("t = {:.9g}, step {}: Newton's method does not converge in a step of {:.3g}, halved {} "
                  "times; residuals over the largest force{}; fastest is node {} at ({:.6g}, {:.6g}): likely "
                  "cause, {}",
                  state.time, state.steps + 1, dt, most_halvings, residuals_text(report.residuals), node + 1,
                  state.q[node * dim], state.q[node * dim + 1], likely_cause(solids)),
      Failure::does_not_converge);
}

}  // namespace tether::fem
