// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/solids.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "grid/solid_surface.hpp"
#include "physics/solids/make_elements.hpp"
#include "physics/solids/step.hpp"

namespace tether::fem {
namespace {

Solids with_excess_density(Solids solids, double fluid) {
  for (SolidRegion& region : solids.regions) region.density -= fluid;
  return solids;
}

/// kappa/2 (J - 1)^2
Solids with_penalty(Solids solids, const std::vector<double>& penalty) {
  for (std::size_t r = 0; r < solids.regions.size(); ++r)
    solids.regions[r].law = NeoHookean{penalty[r], 0, Volumetric::square, Plane::strain};
  return solids;
}

bool any(const std::vector<double>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [](double number) { return number > 0; });
}

bool any_open(const Flow& flow) {
  return std::ranges::any_of(flow.sides, [](const FlowSide& side) { return side.boundary == Boundary::open; });
}

StressAt rule_of(const Flow& flow, const Solids& solids) {
  if (flow.integrator != FlowIntegrator::midpoint) return StressAt::end;
  return solids.integrator == Integrator::midpoint ? StressAt::middle : StressAt::gradient;
}

}  // namespace

ImmersedSolids::ImmersedSolids(const Solids& solids, const FlowUnknowns& unknowns, double gravity, Team& team)
    : solids_(solids),
      unknowns_(unknowns),
      excess_(with_excess_density(solids, unknowns.flow.density)),
      system_(excess_, gravity, team),
      inertia_(make_excess_inertia(excess_)),
      rule_(rule_of(unknowns.flow, solids)),
      carried_(unknowns.flow.mesh, solids.mesh, lighter_regions(unknowns.flow, solids)),
      map_(unknowns.flow),
      S_(system_.pattern.matrix()) {
  const std::size_t n = system_.unknowns();
  for (auto* numbers :
       {&q0_, &middle_, &q1_, &supported_, &led_, &led_rate_, &V_, &V1_, &rate_, &F_, &free_, &outer_, &change_})
    numbers->resize(n);
  difference_.resize(unknowns.velocity.size());
  touching_.assign(n, 0.0);
  if (any_own_volume(unknowns.flow)) pressure_.emplace(unknowns.flow, solids, gravity);
  if (solids.contact) contact_.emplace(solids, gravity, team);
  if (!any(unknowns.flow.volume_penalty)) return;
  penalised_ = with_penalty(solids, unknowns.flow.volume_penalty);
  penalty_ = make_elements(penalised_, team);
}

/// Chooses the nodes that the fluid carries and finds where these are in it.
void ImmersedSolids::place(std::span<const double> x, double time) {
  carried_.choose(x);
  const std::vector<int>& nodes = carried_.nodes();
  std::vector<double> places;
  for (const int n : nodes) places.insert(places.end(), {x[2 * at(n)], x[2 * at(n) + 1]});
  at_carried_.resize(places.size());
  const auto outside = map_.place(places);
  if (!outside) return;
  const std::size_t n = at(nodes[*outside]);
  throw RunError(
      fmt::format("t = {:.9g}: node {} of the solids, at the start at ({:.6g}, {:.6g}), leaves the fluid's mesh at "
                  "({:.6g}, {:.6g}): likely cause, a body that the flow carries out, or steps too long",
                  time, n + 1, solids_.mesh.x[2 * n], solids_.mesh.x[2 * n + 1], x[2 * n], x[2 * n + 1]),
      Failure::loses_points);
}

void ImmersedSolids::start(FlowState& state, double dt) {
  state.q = solids_.mesh.x;
  state.w.assign(state.q.size(), 0.0);
  system_.place_supports(0, state.q);
  place(state.q, 0);
  system_.move_supports(0, slope_width * dt, state.w);
  velocities(state.v, state.w, state.w);
  q0_ = q1_ = state.q;
  state.drift = state.w;
  if (!contact_) return;
  contact_->begin(state.q, 0);
  state.contact.last = contact_->numbers(state.q);
}

/// The middle is predicted by the mean velocities of the step before, without what alternates from step to step.
void ImmersedSolids::begin(const FlowState& state, const ImmersedMoment& moment) {
  const double dt = moment.dt, theta = moment.theta;
  time_ = state.time, moment_ = moment, open_ = open_before_ = 0;
  const double drifting = moment.rest ? 0 : theta * dt, loads_at = moment.rest ? moment.rest->time : time_ + theta * dt;
  const double part = moment.rest ? moment.rest->part : 1;
  q0_ = state.q, supported_ = state.q, led_ = state.w;
  system_.place_supports(state.time + dt, supported_);
  if (!moment.sudden) system_.move_supports(state.time + dt, slope_width * dt, led_);
  for (std::size_t k = 0; k < led_.size(); ++k) led_rate_[k] = (led_[k] - state.w[k]) / dt;
  for (std::size_t k = 0; k < q0_.size(); ++k)
    middle_[k] = system_.held[k] ? q0_[k] + theta * (supported_[k] - q0_[k]) : q0_[k] + drifting * state.drift[k];
  place(middle_, state.time);
  if (pressure_)
    pressure_->place(middle_, {.time = loads_at,
                               .rate = moment.rate,
                               .viscosity = moment.viscosity,
                               .loaded = part,
                               .sudden = moment.sudden});
  if (pressure_ && moment.rest && !any_open(unknowns_.flow)) pressure_->restore_volume(dt);
  system_.external_forces(loads_at, outer_);
  system_.add_pressures(loads_at, StressAt::end, middle_, middle_, outer_);
  for (double& force : outer_) force *= part;
  if (contact_) contact_->begin(q0_, moment.sudden ? 0 : dt);
  std::fill(change_.begin(), change_.end(), 0.0);
  system_.elements->predict_stress(StressAt::end, q0_, q0_, change_, stresses_);
  corrected_ = q0_;
}

/// (51): of carried nodes the fluid's velocity v there, of supported ones what they are given (52), of others by the
/// carried ones. `given` may be V itself.
void ImmersedSolids::velocities(std::span<const double> v, std::span<const double> given, std::span<double> V) {
  const std::vector<int>& nodes = carried_.nodes();
  map_.velocities(v, at_carried_);
  for (std::size_t k = 0; k < at_carried_.size(); ++k) {
    const std::size_t of = 2 * at(nodes[k / 2]) + k % 2;
    if (system_.held[of]) at_carried_[k] = given[of];
  }
  carried_.follow(at_carried_, change_);
  for (std::size_t k = 0; k < V.size(); ++k) V[k] = system_.held[k] ? given[k] : change_[k];
}

/// v_t, dv/dt and v1 at the nodes, for supports' neighbours feel their inertia.
void ImmersedSolids::move(std::span<const double> v0, std::span<const double> v1) {
  const double dt = moment_.dt, theta = moment_.theta;
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] = (v1[k] - v0[k]) / dt;
  velocities(difference_, led_rate_, rate_);
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] = (1 - theta) * v0[k] + theta * v1[k];
  for (std::size_t k = 0; k < V_.size(); ++k) V_[k] = (supported_[k] - q0_[k]) / dt;
  velocities(difference_, V_, V_);
  if (pressure_) velocities(v1, led_, V1_);
  for (std::size_t k = 0; k < q1_.size(); ++k) q1_[k] = q0_[k] + dt * V_[k];
  for (std::size_t k = 0; open_ > 0 && k < q1_.size(); ++k) q1_[k] -= open_ * gap_[k];
}

void ImmersedSolids::open_gap() {
  gap_.resize(V_.size());
  for (std::size_t k = 0; k < V_.size(); ++k) gap_[k] = moment_.dt * V_[k];
  open_ = open_before_ = 1, q1_ = q0_;
}

void ImmersedSolids::stop_guess() {
  if (!contact_) return;
  gap_.resize(V_.size());
  for (std::size_t k = 0; k < V_.size(); ++k) gap_[k] = q1_[k] - q0_[k];
  const double part = contact_->part_of_guess(q0_, gap_);
  if (!(part < 1)) return;
  for (std::size_t k = 0; k < V_.size(); ++k) gap_[k] *= 1 - part, q1_[k] -= gap_[k];
  open_ = open_before_ = 1;
}

double ImmersedSolids::part_before_surfaces() {
  if (!contact_) return 1;
  for (std::size_t k = 0; k < q1_.size(); ++k) change_[k] = q1_[k] - corrected_[k];
  return contact_->part_of_correction(corrected_, change_);
}

bool ImmersedSolids::press() const {
  return contact_ && std::ranges::any_of(touching_, [](double force) { return force != 0; });
}

void ImmersedSolids::note_contact(FlowState& state) {
  double work = 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) work += touching_[k] * (q1_[k] - q0_[k]);
  state.contact.note(contact_->numbers(q1_), work, solids_.contact->gap);
}

void ImmersedSolids::end_correction() {
  for (std::size_t k = 0; k < rate_.size(); ++k) change_[k] = q1_[k] - corrected_[k];
  stresses_.swap(stresses_before_);
  system_.elements->predict_stress(rule_, q0_, corrected_, change_, stresses_);
  corrected_ = q1_, open_before_ = open_;
}

double ImmersedSolids::least_change_of_volume() const {
  double least = system_.elements->shape(q1_).least;
  if (rule_ != StressAt::middle) return least;
  return std::min(least, system_.elements->shape(middle_of(q0_, q1_)).least);
}

/// Loads do work on the way of their nodes, supports what holds theirs. Stress and inertia work on all of them: what of
/// it is neither strain nor kinetic energy afterwards, the step has lost, by its rule or as the nodes take the velocity
/// that the fluid has where they have come to.
void ImmersedSolids::accept(FlowState& state) {
  double loads = system_.gravity_energy(q1_) - system_.gravity_energy(q0_);  // which outer_ has with the other sign
  double supports = 0, lost = strain_energy(q0_) - strain_energy(q1_) + kinetic_energy(state);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - q0_[k];
    loads += outer_[k] * way, lost += (F_[k] + outer_[k] - touching_[k]) * way;
    if (system_.held[k]) supports += F_[k] * way;
  }
  if (contact_) note_contact(state);
  state.q = q1_, state.drift = V_;
  place(state.q, moment_.rest ? state.time : state.time + moment_.dt);
  velocities(state.v, led_, state.w);
  lost -= kinetic_energy(state);
  state.exchanged.loads += loads, state.exchanged.supports += supports, state.exchanged.immersed += lost;
}

double ImmersedSolids::kinetic_energy(const FlowState& state) const {
  std::vector<double> momenta(state.w.size());
  system_.multiply_mass(state.w, momenta);
  double energy = 0;
  for (std::size_t k = 0; k < momenta.size(); ++k) energy += 0.5 * momenta[k] * state.w[k];
  return energy;
}

double ImmersedSolids::strain_energy(std::span<const double> q) const {
  return system_.elements->strain_energy(q) + (penalty_ ? penalty_->strain_energy(q) : 0);
}

}  // namespace tether::fem
