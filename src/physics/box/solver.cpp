// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/solver.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "physics/box/splitting_limit.hpp"
#include "physics/solids/contact_report.hpp"
#include "physics/solids/fields.hpp"
#include "physics/step_clock.hpp"
#include "results/summary_keys.hpp"

namespace tether::coupled {
namespace {

/// No solids, in the dimensions of the box.
Solids no_solids(const Coupled& scene) {
  Solids none;
  none.mesh.kind = scene.grid.dim == 2 ? ElementKind::tri3 : ElementKind::tet4;
  return none;
}

const Solids& solids_of(const Plan& plan, const Solids& none) {
  return plan.scene.solids() ? *plan.scene.solids() : none;
}

}  // namespace

CoupledSolver::CoupledSolver(const Plan& plan, int threads)
    : plan_(plan),
      none_(no_solids(*plan.scene.coupled())),
      team_(threads),
      step_(plan.scene, solids_of(plan, none_), team_),
      fields_(plan.scene, step_),
      state_(step_.start()),
      overlaps_(step_.solids().system.solids) {
  std::vector<std::string> told_by_the_deck;
  overlaps_.look(state_.q, 0, state_.overlap, told_by_the_deck);
  if (plan.scene.coupled()->coupling.simultaneous) return;
  const auto outlook = splitting_outlook(plan.scene, plan.step.deck_step);
  if (!outlook) return;
  ratio_ = outlook->ratio;
  if (!outlook->holds) messages_.push_back("mode='splitting' is likely to fail " + outlook->why);
}

void CoupledSolver::advance(double until, long long most) {
  const double tmax = plan_.scene.clock.tmax;
  while (state_.time < until && state_.time < tmax && most-- > 0) {
    const double h = step_before_end(plan_.step.deck_step, state_.time, tmax);
    fem::clock_step(
        state_, h, tmax, [this](double part) { return advanced(part); },
        [this](double part, const fem::NewtonReport& report) { refuse_step(part, report); }, messages_);
    look_for_overlaps();
  }
}

/// A step that keeps the energy may not be found: the state then is as before. One that cannot be halved again takes
/// backward Euler.
fem::NewtonReport CoupledSolver::advanced(double h) {
  const CoupledState before = step_.keeps_energy() ? state_ : CoupledState{};
  fem::NewtonReport end = step_.advance(state_, h);
  if (!end.converged) go_back(before, state_);
  if (!end.converged && step_.can_take_euler() && h <= fem::shortest_halved * plan_.step.deck_step) {
    end = step_.advance(state_, h, true);
    if (!end.converged) go_back(before, state_);
  }
  if (end.converged) fem::report_contact(before.contact.doubts, state_.contact.doubts, state_.time + h, messages_);
  return end;
}

void CoupledSolver::refuse_step(double h, const fem::NewtonReport& report) const {
  fem::SolidState solids;
  solids.time = state_.time, solids.steps = state_.steps;
  solids.q = state_.q, solids.v = state_.u;
  fem::refuse_step(solids, step_.solids().system.solids, h, report);
}

void CoupledSolver::look_for_overlaps() { overlaps_.look(state_.q, state_.time, state_.overlap, messages_); }

RunCounts CoupledSolver::counts() const {
  RunCounts counts;
  counts.steps = state_.steps;
  counts.points = plan_.scene.coupled()->grid.cell_count() + step_.solids().system.lumped.size();
  counts.point_steps = state_.steps * static_cast<long long>(counts.points);
  counts.dt_min = state_.dt_min, counts.dt_last = state_.dt_last;
  return counts;
}

std::size_t CoupledSolver::cells_active() const { return step_.flow().fluid_cells(); }

std::vector<std::string> CoupledSolver::take_messages() {
  std::vector<std::string> messages = std::exchange(messages_, {});
  for (std::string& message : step_.take_messages()) messages.push_back(std::move(message));
  return messages;
}

std::string CoupledSolver::worst_element() const {
  return plan_.scene.solids() ? fem::worst_element(step_.solids().system, state_.q) : std::string();
}

SavedState CoupledSolver::save() const {
  StateSaver saver;
  CoupledState state = state_;
  state.orders = step_.orders();
  exchange(saver, state);
  return saver.take();
}

void CoupledSolver::restore(const SavedState& saved) {
  StateRestorer restorer(saved);
  exchange(restorer, state_);
  take_messages();  // of the start: the run has them
  step_.resume(state_);
}

std::vector<CostPart> CoupledSolver::cost_parts() const { return {{"solve", step_.system().cost().solve}}; }

Summary CoupledSolver::more_summary() const {
  const SystemCost& cost = step_.system().cost();
  const Coupled& scene = *plan_.scene.coupled();
  Summary summary{line_of("mode", word_of(scene.coupling.mode)),
                  line_of("linear_solver", step_.system().solver_name()),
                  line_of("unknowns", state_.q.size() + step_.flow().row_count()),
                  line_of("krylov_iterations", state_.iterations),
                  line_of("lu_solutions", state_.lu_solutions),
                  line_of("factor_nonzeros", cost.factor_nonzeros),
                  line_of("contact_solutions", state_.contact_solutions),
                  line_of("contact_unsettled", state_.contact_unsettled),
                  line_of("thin_cells", state_.thin_cells),
                  line_of("volume_unswept", state_.unswept),
                  line_of("cfl_largest", state_.cfl_largest),
                  line_of("nodes_inside", state_.overlap.most),
                  line_of("bodies_left", std::count(state_.left.begin(), state_.left.end(), 1)),
                  line_of("bodies_slip", scene.viscosity > 0 && scene.bodies_slip ? state_.left.size() : 0),
                  line_of("interface_mismatch", state_.worst_mismatch)};
  if (scene.viscosity > 0) {
    summary.push_back(line_of("friction_passes", state_.passes));
    summary.push_back(line_of("friction_unsettled", state_.unsettled_friction));
    if (scene.mesh) summary.push_back(line_of("narrow_cells", state_.narrow_cells));
  }
  if (!step_.keeps_energy()) summary.push_back(line_of("linear_gain", state_.linear_gain));
  if (step_.keeps_energy()) {
    if (scene.viscosity > 0) summary.push_back(line_of("calmed_steps", state_.calmed));
    summary.push_back(line_of("newton_iterations", state_.newton_steps));
    summary.push_back(line_of("halvings", state_.halvings));
    fem::add_contact_summary(step_.solids().system.solids, state_.contact.doubts, summary);
  }
  step_.flow().add_summary(summary);
  if (ratio_) summary.push_back(line_of("added_mass_ratio", *ratio_));
  return summary;
}

}  // namespace tether::coupled
