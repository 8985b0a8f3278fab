// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/solid_equations.hpp"

#include <algorithm>

#include "algebra/sparse_entries.hpp"
#include "base/numbers.hpp"
#include "physics/box/matrix.hpp"

namespace tether::coupled {
namespace {

/// Each spring's stiffness, in shares of its nodes' masses.
std::vector<double> spring_stiffness(const Coupled& scene, const fem::SolidSystem& system) {
  const std::size_t d = at(system.dim());
  std::vector<double> stiffness(system.unknowns(), 0.0);
  for (const Spring& spring : scene.springs) {
    double mass = 0;
    for (const int node : spring.nodes) mass += system.lumped[at(node)];
    for (const int node : spring.nodes) {
      for (std::size_t i = 0; i < d; ++i)
        stiffness[at(node) * d + i] += spring.stiffness[i] * system.lumped[at(node)] / mass;
    }
  }
  return stiffness;
}

}  // namespace

SolidEquations::SolidEquations(const Coupled& scene, const Solids& solids, const Vec<3>& gravity, Team& team)
    : system(solids, gravity, team),
      A(system.pattern.matrix()),
      b(system.unknowns()),
      external(system.unknowns()),
      held(system.held),
      scene_(scene),
      stiffness_(A),
      internal_(system.unknowns()),
      spring_(spring_stiffness(scene, system)),
      work_(system.unknowns()) {}

/// Springs are part of K and K'.
void SolidEquations::add_springs(std::span<const double> q, double factor, std::span<double> internal) {
  for (std::size_t k = 0; k < spring_.size(); ++k) internal[k] += spring_[k] * (q[k] - system.solids.mesh.x[k]);
  add_spring_stiffness(factor, A);
}

/// The paper's step is (18), of order 1 in the velocity: A = M/h + C + h/2 K', b = M u0/h - h/2 K' u0 - K(d0) + f, with
/// C = alpha M + beta K'. The trapezoidal rule has the mean of damping and stiffness at both ends: A = M/h + C/2 + h/4
/// K', b = M u0/h - C u0/2 - h/4 K' u0 - K(d0) + f. (The paper's appendix calls the former trapezoidal; it takes the
/// velocity's change from the acceleration at the end alone.) Springs are not damped.
void SolidEquations::assemble(std::span<const double> q, std::span<const double> u, double time, double h) {
  const Solids& solids = system.solids;
  const bool paper = scene_.integrator == CoupledIntegrator::paper;
  const double part = paper ? 1 : 0.5;                // of damping that u1 has
  const double elastic = paper ? 0.5 * h : 0.25 * h;  // K' by u1, and by u0
  const double loads_at = paper ? time + h : time + 0.5 * h;
  system.external_forces(loads_at, external);
  if (system.has_pressures()) {  // in the middle of the way that the velocity at the start leads
    for (std::size_t k = 0; k < work_.size(); ++k) work_[k] = q[k] + 0.5 * h * u[k];
    system.add_pressures(loads_at, fem::StressAt::end, work_, work_, external);
  }
  stiffness_.set_zero();
  system.elements->add_stiffness(q, scene_.convex, system.pattern, stiffness_);
  for (std::size_t k = 0; k < A.value.size(); ++k) A.value[k] = (part * solids.beta + elastic) * stiffness_.value[k];
  system.add_mass(1 / h + part * solids.alpha, A);
  std::fill(internal_.begin(), internal_.end(), 0.0);
  system.elements->add_forces(fem::StressAt::end, q, q, internal_);  // K(d0)
  add_springs(q, elastic, internal_);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = external[k] - internal_[k];
  system.multiply_mass(u, work_);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] += (1 / h - (1 - part) * solids.alpha) * work_[k];
  stiffness_.multiply(u, work_);
  for (std::size_t k = 0; k < b.size(); ++k)
    b[k] -= ((1 - part) * solids.beta + elastic) * work_[k] + elastic * spring_[k] * u[k];
}

/// K' acts on the step's way by the paper's step, by the trapezoidal rule on half of it.
void SolidEquations::add_lifts(std::span<const double> lifts, std::span<double> right) const {
  if (std::all_of(lifts.begin(), lifts.end(), [](double lift) { return lift == 0; })) return;
  const double part = scene_.integrator == CoupledIntegrator::paper ? 1 : 0.5;
  std::vector<double> force(right.size());
  stiffness_.multiply(lifts, force);
  for (std::size_t k = 0; k < right.size(); ++k) right[k] -= part * (force[k] + spring_[k] * lifts[k]);
}

/// The paper's step has K' act on the whole of the way and damping by u1, the trapezoidal rule on half of the way and
/// by the mean velocity.
SolidEquations::Taken SolidEquations::taken(std::span<const double> u0, std::span<const double> u1,
                                            std::span<const double> lifts, double h) {
  const bool paper = scene_.integrator == CoupledIntegrator::paper;
  const double part = paper ? 1 : 0.5;
  std::vector<double> way(b.size()), farther(b.size()), rate(b.size()), force(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    way[k] = 0.5 * h * (u0[k] + u1[k]), farther[k] = way[k] + lifts[k];
    rate[k] = paper ? u1[k] : 0.5 * (u0[k] + u1[k]);
  }
  Taken taken;
  stiffness_.multiply(farther, force);
  for (std::size_t k = 0; k < b.size(); ++k)
    taken.inside += way[k] * (internal_[k] + part * (force[k] + spring_[k] * farther[k]));
  stiffness_.multiply(rate, force);
  system.multiply_mass(rate, work_);
  for (std::size_t k = 0; k < b.size(); ++k)
    taken.damping += way[k] * (system.solids.beta * force[k] + system.solids.alpha * work_[k]);
  return taken;
}

/// masses M + stiffnesses K'.
SparseMatrix SolidEquations::sum_of(std::span<const double> q, bool convex, double masses, double stiffnesses) const {
  SparseMatrix sum = system.pattern.matrix();
  system.elements->add_stiffness(q, convex, system.pattern, sum);
  for (double& value : sum.value) value *= stiffnesses;
  system.add_mass(masses, sum);
  return sum;
}

SparseMatrix SolidEquations::resistance(std::span<const double> q, double h) const {
  const double half = scene_.integrator == CoupledIntegrator::paper ? 0.5 * h : 0;
  return sum_of(q, scene_.convex, 1 + half * system.solids.alpha, half * system.solids.beta);
}

/// The linear step has h A. An impulse changes w half as much as u1: 2 M + h C + h^2/2 K'. A calm step has M + h C +
/// h^2/2 K', Euler's M + h C + h^2 K'.
SparseMatrix SolidEquations::inertia(SolidRule rule, std::span<const double> q, double h) const {
  double masses = rule == SolidRule::energy ? 2 : 1, damped = h, elastic = (rule == SolidRule::euler ? 1 : 0.5) * h * h;
  if (rule == SolidRule::linear) {
    const double part = scene_.integrator == CoupledIntegrator::paper ? 1 : 0.5;
    damped *= part, elastic *= part;
  }
  SparseMatrix inertia = sum_of(q, true, masses + damped * system.solids.alpha, damped * system.solids.beta + elastic);
  add_spring_stiffness(elastic, inertia);
  return inertia;
}

void SolidEquations::add_spring_forces(std::span<const double> q0, std::span<const double> q1,
                                       std::span<double> f) const {
  for (std::size_t k = 0; k < spring_.size(); ++k)
    f[k] -= spring_[k] * (0.5 * (q0[k] + q1[k]) - system.solids.mesh.x[k]);
}

void SolidEquations::add_spring_stiffness(double factor, SparseMatrix& K) const {
  for (std::size_t k = 0; k < spring_.size(); ++k) {
    const auto unknown = static_cast<std::int64_t>(k);
    if (spring_[k] != 0) add_to_entry(K, unknown, unknown, factor * spring_[k]);
  }
}

double SolidEquations::spring_energy(std::span<const double> q) const {
  double energy = 0;
  for (std::size_t k = 0; k < spring_.size(); ++k) {
    const double stretch = q[k] - system.solids.mesh.x[k];
    energy += 0.5 * spring_[k] * stretch * stretch;
  }
  return energy;
}

}  // namespace tether::coupled
