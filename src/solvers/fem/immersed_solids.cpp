// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/immersed_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "solvers/fem/make_elements.hpp"
#include "solvers/fem/solid_step.hpp"

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

StressAt rule_of(const Flow& flow, const Solids& solids) {
  if (flow.integrator != FlowIntegrator::midpoint) return StressAt::end;
  return solids.integrator == Integrator::midpoint ? StressAt::middle : StressAt::gradient;
}

double norm(const std::vector<double>& f) {
  double sum = 0;
  for (const double value : f) sum += value * value;
  return std::sqrt(sum);
}

}  // namespace

ImmersedSolids::ImmersedSolids(const Solids& solids, const FlowUnknowns& unknowns, double gravity)
    : solids_(solids),
      unknowns_(unknowns),
      excess_(with_excess_density(solids, unknowns.flow.density)),
      system_(excess_, gravity),
      inertia_(make_excess_inertia(excess_)),
      rule_(rule_of(unknowns.flow, solids)),
      map_(unknowns.flow),
      S_(system_.pattern.matrix()) {
  const std::size_t n = system_.unknowns();
  for (auto* numbers :
       {&q0_, &middle_, &q1_, &supported_, &led_, &led_rate_, &V_, &rate_, &F_, &free_, &outer_, &change_})
    numbers->resize(n);
  difference_.resize(unknowns.velocity.size());
  if (!any(unknowns.flow.volume_penalty)) return;
  penalised_ = with_penalty(solids, unknowns.flow.volume_penalty);
  penalty_ = make_elements(penalised_);
}

void ImmersedSolids::place(std::span<const double> x, double time) {
  const auto outside = map_.place(x);
  if (!outside) return;
  const std::size_t n = *outside;
  throw RunError(
      fmt::format("t = {:.9g}: node {} of the solids, at the start at ({:.6g}, {:.6g}), leaves the fluid's mesh at "
                  "({:.6g}, {:.6g}): likely cause, a body that the flow carries out, or steps too long",
                  time, n + 1, solids_.mesh.x[2 * n], solids_.mesh.x[2 * n + 1], x[2 * n], x[2 * n + 1]));
}

void ImmersedSolids::start(FlowState& state, double dt) {
  state.q = solids_.mesh.x;
  state.w.assign(state.q.size(), 0.0);
  system_.place_supports(0, state.q);
  place(state.q, 0);
  map_.velocities(state.v, state.w);
  system_.move_supports(0, slope_width * dt, state.w);
  q0_ = q1_ = state.q;
  state.drift = state.w;
}

/// The middle is predicted by the mean velocities of the step before, without what alternates from step to step.
void ImmersedSolids::begin(const FlowState& state, double dt, double theta, bool sudden) {
  time_ = state.time, dt_ = dt, theta_ = theta;
  q0_ = state.q, supported_ = state.q, led_ = state.w;
  system_.place_supports(state.time + dt, supported_);
  if (!sudden) system_.move_supports(state.time + dt, slope_width * dt, led_);
  for (std::size_t k = 0; k < led_.size(); ++k) led_rate_[k] = (led_[k] - state.w[k]) / dt;
  for (std::size_t k = 0; k < q0_.size(); ++k)
    middle_[k] = system_.held[k] ? q0_[k] + theta * (supported_[k] - q0_[k]) : q0_[k] + theta * dt * state.drift[k];
  place(middle_, state.time);
  system_.external_forces(state.time + theta * dt, outer_);
  std::fill(change_.begin(), change_.end(), 0.0);
  system_.elements->predict_stress(StressAt::end, q0_, q0_, change_, stresses_);
  corrected_ = q0_;
}

/// (51): v_t and dv/dt at the nodes; of supported ones what they are given (52), whose inertia their neighbours feel.
void ImmersedSolids::move(std::span<const double> v0, std::span<const double> v1) {
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] = (v1[k] - v0[k]) / dt_;
  map_.velocities(difference_, rate_);
  for (std::size_t k = 0; k < difference_.size(); ++k) difference_[k] = (1 - theta_) * v0[k] + theta_ * v1[k];
  map_.velocities(difference_, V_);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    if (system_.held[k]) V_[k] = (supported_[k] - q0_[k]) / dt_, rate_[k] = led_rate_[k];
    q1_[k] = q0_[k] + dt_ * V_[k];
  }
}

void ImmersedSolids::end_correction() {
  for (std::size_t k = 0; k < rate_.size(); ++k) change_[k] = q1_[k] - corrected_[k];
  stresses_.swap(stresses_before_);
  system_.elements->predict_stress(rule_, q0_, corrected_, change_, stresses_);
  corrected_ = q1_;
}

double ImmersedSolids::least_change_of_volume() const {
  double least = system_.elements->shape(q1_).least;
  if (rule_ != StressAt::middle) return least;
  std::vector<double> middle(q0_.size());
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (q0_[k] + q1_[k]);
  return std::min(least, system_.elements->shape(middle).least);
}

/// (55): I^T of stress, penalty, excess inertia and weight. What acts on supported nodes their supports take.
double ImmersedSolids::add_forces(std::span<double> f) {
  std::fill(F_.begin(), F_.end(), 0.0);
  system_.elements->add_forces(rule_, q0_, q1_, F_);
  if (penalty_) penalty_->add_forces(rule_, q0_, q1_, F_);
  const double elastic = norm(F_);
  if (inertia_) inertia_->add_forces(middle_, V_, rate_, F_);
  for (std::size_t k = 0; k < F_.size(); ++k) F_[k] -= outer_[k];
  for (std::size_t k = 0; k < F_.size(); ++k) free_[k] = system_.held[k] ? 0 : F_[k];
  map_.add_forces(free_, f);
  return std::max(elastic, norm(outer_));
}

/// By v1 of solid nodes: of the stress, which sees q1 = q0 + dt V, and of the inertia.
void ImmersedSolids::find_tangent() {
  S_.set_zero();
  system_.elements->add_tangent(rule_, q0_, q1_, 0, system_.pattern, S_, stresses_);
  if (penalty_) penalty_->add_tangent(rule_, q0_, q1_, 0, system_.pattern, S_);
  for (double& value : S_.value) value *= theta_ * dt_;
  if (inertia_) inertia_->add_tangent(middle_, V_, 1 / dt_, theta_, system_.pattern, S_);
  hold(S_, system_.held, 0);
}

/// Pairs of cells, the lower one first, whose solid nodes an element joins.
std::vector<std::pair<std::size_t, std::size_t>> ImmersedSolids::cell_pairs() const {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t d = 0; d < q0_.size() / 2; ++d) {
    const std::size_t column = 2 * d;
    for (auto k = S_.start[column]; k < S_.start[column + 1]; k += 2) {
      const auto c = static_cast<std::size_t>(S_.row[static_cast<std::size_t>(k)]) / 2;
      pairs.push_back(std::minmax({map_.cell_of(c), map_.cell_of(d)}));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

Lists ImmersedSolids::clusters() const {
  Lists clusters;
  for (const auto& [c, d] : cell_pairs()) {
    std::vector<int> nodes(map_.nodes(c).begin(), map_.nodes(c).end());
    if (c != d) nodes.insert(nodes.end(), map_.nodes(d).begin(), map_.nodes(d).end());
    clusters.add(nodes);
  }
  return clusters;
}

/// The 2 x 2 numbers s of solid nodes whose functions of the fluid are of_c, of_d, spread over a block of `size` rows.
void ImmersedSolids::spread(const double (&s)[2][2], std::span<const double> of_c, std::span<const double> of_d,
                            double* block, std::size_t size) {
  for (std::size_t m = 0; m < of_c.size(); ++m) {
    for (std::size_t n = 0; n < of_d.size(); ++n) {
      double* to = block + 2 * m * size + 2 * n;
      const double part = of_c[m] * of_d[n];
      to[0] += part * s[0][0], to[1] += part * s[0][1];
      to[size] += part * s[1][0], to[size + 1] += part * s[1][1];
    }
  }
}

/// I^T S I as dense blocks, one for each pair of cells.
std::vector<std::vector<double>> ImmersedSolids::blocks_of(
    const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
  const auto per_cell = static_cast<std::size_t>(map_.nodes_per_cell());
  const auto size_of = [&](const auto& pair) { return (pair.first == pair.second ? 2 : 4) * per_cell; };
  std::vector<std::vector<double>> blocks;
  blocks.reserve(pairs.size());
  for (const auto& pair : pairs) blocks.emplace_back(size_of(pair) * size_of(pair), 0.0);
  for (std::size_t d = 0; d < q0_.size() / 2; ++d) {
    const auto rows = static_cast<std::size_t>(S_.start[2 * d + 1] - S_.start[2 * d]);
    for (auto at = static_cast<std::size_t>(S_.start[2 * d]); at < static_cast<std::size_t>(S_.start[2 * d + 1]);
         at += 2) {
      const auto c = static_cast<std::size_t>(S_.row[at]) / 2;
      const std::size_t row = map_.cell_of(c), column = map_.cell_of(d);
      const std::pair<std::size_t, std::size_t> pair = std::minmax({row, column});
      const auto b = static_cast<std::size_t>(std::lower_bound(pairs.begin(), pairs.end(), pair) - pairs.begin());
      const double s[2][2] = {{S_.value[at], S_.value[at + rows]}, {S_.value[at + 1], S_.value[at + rows + 1]}};
      const std::size_t size = size_of(pair), half = 2 * per_cell;
      double* block = &blocks[b][(row == pair.first ? 0 : half) * size + (column == pair.first ? 0 : half)];
      spread(s, map_.parts(c), map_.parts(d), block, size);
    }
  }
  return blocks;
}

/// K += I^T S I, pair of cells by pair of cells.
void ImmersedSolids::add_tangent(std::size_t first, const ClusterPattern& pattern, SparseMatrix& K) {
  find_tangent();
  const auto pairs = cell_pairs();
  const auto blocks = blocks_of(pairs);
  std::vector<int> nodes, number;
  for (std::size_t b = 0; b < pairs.size(); ++b) {
    const auto members = pattern.clusters()[first + b];
    nodes.clear(), number.clear();
    for (std::size_t m = 0; m < members.size(); ++m) {
      for (std::size_t i = 0; i < 2; ++i) {
        nodes.push_back(static_cast<int>(m));
        number.push_back(unknowns_.velocity[2 * static_cast<std::size_t>(members[m]) + i]);
      }
    }
    pattern.add(first + b, nodes, number, blocks[b], K);
  }
}

/// Loads do work on the way of their nodes, supports what holds theirs. Stress and inertia work on all of them: what of
/// it is neither strain nor kinetic energy afterwards, the step has lost, by its rule or as the nodes take the velocity
/// that the fluid has where they have come to.
void ImmersedSolids::accept(FlowState& state) {
  double loads = system_.gravity_energy(q1_) - system_.gravity_energy(q0_);  // which outer_ has with the other sign
  double supports = 0, lost = strain_energy(q0_) - strain_energy(q1_) + kinetic_energy(state);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - q0_[k];
    loads += outer_[k] * way, lost += (F_[k] + outer_[k]) * way;
    if (system_.held[k]) supports += F_[k] * way;
  }
  state.q = q1_, state.drift = V_;
  place(state.q, state.time + dt_);
  map_.velocities(state.v, state.w);
  for (std::size_t k = 0; k < state.w.size(); ++k) {
    if (system_.held[k]) state.w[k] = led_[k];
  }
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

std::string ImmersedSolids::worst_element() const {
  const ShapeVolumes shape = system_.elements->shape(q1_);
  const int node = solids_.mesh.element(shape.worst)[0];
  const double* at = &q1_[2 * static_cast<std::size_t>(node)];
  return fmt::format("element {} of the solids near ({:.6g}, {:.6g}) has {:.3g} of its volume", shape.worst + 1, at[0],
                     at[1], shape.least);
}

}  // namespace tether::fem
