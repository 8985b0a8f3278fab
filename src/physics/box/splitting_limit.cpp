// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/splitting_limit.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "algebra/krylov.hpp"
#include "algebra/quasidefinite_solver.hpp"
#include "base/numbers.hpp"
#include "physics/box/matrix.hpp"
#include "plan/added_mass.hpp"

namespace tether::coupled {
namespace {

constexpr int most_powers = 500;
constexpr double settled = 1e-9;  // change of the ratio in an iteration

/// y = M_a x by factors of L.
class AddedMass {
 public:
  explicit AddedMass(const Flow::Equations& at) : B_(at.B), flux_(at.regions.of.size()) {
    exists_ = L_.factorise(at.L);
  }
  bool exists() const { return exists_; }
  void apply(std::span<const double> x, std::span<double> y) {
    std::fill(flux_.begin(), flux_.end(), 0.0);
    std::fill(y.begin(), y.end(), 0.0);
    add_product(B_, 1, x, flux_);
    L_.solve(flux_, flux_);
    add_transposed_product(B_, 1, flux_, y);
  }

 private:
  const CouplingMatrix& B_;
  QuasidefiniteSolver L_;
  std::vector<double> flux_;
  bool exists_ = false;
};

/// The motion of all nodes along the outward surface, as one pressure pushes them.
std::vector<double> outwards(const Flow::Equations& at, std::size_t unknowns) {
  const std::vector<double> ones(at.regions.of.size(), 1.0);
  std::vector<double> x(unknowns, 0.0);
  add_transposed_product(at.B, 1, ones, x);
  for (std::size_t k = 0; k < unknowns; ++k) x[k] += 1e-3 * std::sin(1.0 + static_cast<double>(k)) * std::abs(x[k]);
  return x;
}

bool any_closed(const FlowRegions& regions) {
  return std::ranges::any_of(regions.of, [&](int region) { return regions.closed[at(region)] != 0; });
}

}  // namespace

/// Uses the power method: the motion that swells the solids drives most fluid, and is alone in that.
std::optional<double> added_mass_ratio(const CoupledStep& step, std::span<const double> q, double density, double h) {
  const Flow::Equations at = step.flow().equations_at(q, 1 / density);
  if (any_closed(at.regions)) return std::nullopt;
  const SolidEquations& solids = step.solids();
  AddedMass added(at);
  QuasidefiniteSolver resistance;
  const SparseMatrix R = held_matrix(solids.resistance(q, h), solids.held);
  if (!added.exists() || !resistance.factorise(R)) return std::nullopt;
  std::vector<double> x = outwards(at, q.size()), y(q.size()), resisted(q.size());
  double ratio = 0;
  for (int i = 0; i < most_powers; ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = solids.held[k] != 0 ? 0 : x[k];
    added.apply(x, y);
    R.multiply(x, resisted);
    const double before = ratio, resists = dot(x, resisted);
    ratio = resists > 0 ? dot(x, y) / resists : 0;
    if (std::abs(ratio - before) <= settled * ratio) break;
    for (std::size_t k = 0; k < x.size(); ++k) y[k] = solids.held[k] != 0 ? 0 : y[k] / ratio;
    resistance.solve(y, x);
  }
  return ratio;
}

std::optional<double> added_mass_ratio(const Scene& scene, double h) {
  if (!scene.coupled() || !scene.solids() || systems_of(*scene.coupled()) != Systems::direct) return std::nullopt;
  Coupled box = *scene.coupled();  // whose own mode may have another map
  box.coupling = coupling_of(CouplingMode::splitting);
  Scene split = scene;
  std::get<BoxFlow>(split.physics).box = std::make_shared<const Coupled>(box);
  Team alone;
  const CoupledStep step(split, *split.solids(), alone);
  return added_mass_ratio(step, scene.solids()->mesh.x, scene.coupled()->density, h);
}

std::optional<SplittingOutlook> splitting_outlook(const Scene& scene, double h) {
  if (!scene.coupled() || !scene.solids()) return std::nullopt;
  if (const auto ratio = added_mass_ratio(scene, h)) {
    return SplittingOutlook{
        *ratio < 1, ratio,
        fmt::format("by theory: in the worst motion of the bodies their added mass is {:.3g} times m + c h/2", *ratio)};
  }
  const auto estimate = splitting_estimate(scene);
  if (!estimate) return std::nullopt;
  return SplittingOutlook{estimate->holds(), std::nullopt, "by estimate: " + estimate_text(*estimate)};
}

std::string splitting_text(const Plan& plan) {
  const auto outlook = splitting_outlook(plan.scene, plan.step.deck_step);
  if (!outlook) return "";
  return fmt::format("splitting: would {} {}\n", outlook->holds ? "hold" : "fail", outlook->why);
}

}  // namespace tether::coupled
