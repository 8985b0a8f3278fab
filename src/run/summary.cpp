// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/summary.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "grid/mesh_extent.hpp"
#include "model/coupled.hpp"
#include "model/flow.hpp"
#include "model/solids.hpp"
#include "results/energy_drift.hpp"
#include "results/summary_keys.hpp"

namespace tether {
namespace {

std::string number(double value) { return fmt::format("{}", value); }

/// The least of elements across, and how much the body that is most off is too stiff.
void add_bending(const Plan& plan, Summary& summary) {
  if (plan.bending.empty()) return;
  int across = plan.bending.front().across;
  double too_stiff = 0;
  for (const Bending& body : plan.bending)
    across = std::min(across, body.across),
    too_stiff = std::abs(body.too_stiff) > std::abs(too_stiff) ? body.too_stiff : too_stiff;
  summary.push_back(line_of("elements_across", across));
  summary.push_back(line_of("bending_too_stiff", too_stiff));
}

/// Whether nothing but its loads acts on the scene's body, whose momenta stay when these are gone.
struct MovesFreely {
  bool operator()(const MaterialPoints&) const { return false; }
  bool operator()(const Bars&) const { return false; }
  bool operator()(const ElasticBodies& bodies) const {
    const Solids& solids = *bodies.solids;
    return solids.supports.empty() && solids.alpha == 0 && solids.beta == 0 &&
           solids.integrator != Integrator::equilibrium;
  }
  bool operator()(const RigidBody& body) const { return !body.rigid->pin; }
  bool operator()(const MeshFlow&) const { return false; }
  bool operator()(const BoxFlow&) const { return false; }
};

bool any_load(const Scene& scene, double t) {
  const auto acts = [t](const auto& load) { return load.amplitude.at(t) != 0; };
  const auto any = [&](const auto& loads) { return std::any_of(loads.begin(), loads.end(), acts); };
  return any(scene.solids()->loads) || (scene.rigid() && (any(scene.rigid()->forces) || any(scene.rigid()->torques)));
}

/// The first record after which no load acts any more, as far as records show; a load that ends there has acted in the
/// step before.
std::size_t first_without_loads(const Scene& scene, const std::vector<double>& time) {
  std::size_t first = time.size();
  while (first > 0 && !any_load(scene, time[first - 1])) --first;
  return first == 0 ? 0 : first + 1;
}

/// Columns name_x, name_y and name_z, as far as there are such.
std::vector<std::vector<double>> components(const History& history, const std::string& name) {
  std::vector<std::vector<double>> all;
  for (const Quantity& quantity : history.layout.quantities) {
    for (const char* axis : {"x", "y", "z"}) {
      if (quantity.name == name + axis) all.push_back(history.column(quantity.name));
    }
  }
  return all;
}

/// The largest size of a vector's change since record `from`, or with `whole` of the vector itself.
double largest(const std::vector<std::vector<double>>& vector, std::size_t from, bool whole) {
  double most = 0;
  for (std::size_t k = from; k < vector.front().size(); ++k) {
    double square = 0;
    for (const auto& component : vector) square += std::pow(component[k] - (whole ? 0 : component[from]), 2);
    most = std::max(most, std::sqrt(square));
  }
  return most;
}

/// Largest changes of the momenta since the loads are gone, over the momentum sqrt(2 m E) that the kinetic energy could
/// be of, and its moment about the body's longest extent.
void add_momenta(const Plan& plan, const History& history, Summary& summary) {
  if (plan.scene.gravity != 0 || !std::visit(MovesFreely{}, plan.scene.physics)) return;
  const auto kinetic = history.column("energy_kinetic");
  const std::size_t from = first_without_loads(plan.scene, history.column("time"));
  if (from + 1 >= kinetic.size()) return;
  const double most = *std::max_element(kinetic.begin() + static_cast<std::ptrdiff_t>(from), kinetic.end());
  const double momentum = std::sqrt(2 * history.column("mass").front() * most);
  const auto linear = components(history, "momentum_"), angular = components(history, "angular_momentum_");
  const double moment = std::max(largest(angular, from, true), momentum * MeshExtent(plan.scene.solids()->mesh).size());
  const bool moves = most > history.layout.rounding_energy;
  const auto part = [&](double change, double of) { return moves && of > 0 ? change / of : 0; };
  summary.push_back(line_of("momentum_drift", part(largest(linear, from, false), momentum)));
  summary.push_back(line_of("angular_momentum_drift", part(largest(angular, from, false), moment)));
}

/// Drag and lift at the end.
void add_coefficients(const History& history, Summary& summary) {
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.name.starts_with("drag_") || quantity.name.starts_with("lift_"))
      summary.emplace_back(quantity.name, number(history.column(quantity.name).back()));
  }
}

/// Whether a physics' records hold all terms of the balance of energy.
struct Balances {
  const HistoryLayout& layout;
  bool operator()(const MaterialPoints&) const { return true; }
  bool operator()(const Bars&) const { return true; }
  bool operator()(const ElasticBodies& bodies) const { return bodies.solids->integrator != Integrator::equilibrium; }
  bool operator()(const RigidBody&) const { return true; }
  bool operator()(const MeshFlow& flow) const { return flow.flow->integrator != FlowIntegrator::steady; }
  bool operator()(const BoxFlow&) const {
    return std::ranges::any_of(layout.quantities, [](const Quantity& q) { return q.book != Book::none; });
  }
};

}  // namespace

bool balances_energy(const Scene& scene, const HistoryLayout& layout) {
  return std::visit(Balances{layout}, scene.physics);
}

Summary scene_summary(const Plan& plan, const History& history) {
  Summary summary;
  add_bending(plan, summary);
  add_momenta(plan, history, summary);
  if (plan.scene.flow()) add_coefficients(history, summary);
  return summary;
}

namespace {

/// Parts of the largest energy exchanged that no deck that comes with the program loses. Of points the nearest is
/// cyl-500-ambient by 0.71, then two-bar by 0.30; of fluids in a box the largest is 0.18.
constexpr double much_of_points = 0.75, much_of_fluids = 0.3;

double sum_of_losses(const History& history) {
  double lost = 0;
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.book == Book::lost) lost += history.column(quantity.name).back();
  }
  return lost;
}

/// The kinetic energy of all mass next to rest. [energy]
double rest_energy(const Scene& scene, const History& history) {
  const double speed = resting * scene.grid.dx / scene.clock.tstep;
  return 0.5 * history.column("mass").front() * speed * speed;
}

/// The strips beyond open edges lose at their outer ends, and that is no loss of the gas inside.
std::vector<std::string> points_lost(const Scene& scene, const History& history) {
  const double part = energy_lost(history);
  if (scene.edges.any() || part <= much_of_points || sum_of_losses(history) <= rest_energy(scene, history)) return {};
  const bool robust = scene.method.transfer == Transfer::apic;
  return {fmt::format(
      "the method itself lost {:.2g} of the largest energy exchanged (columns energy_transfer to energy_contact): the "
      "grid damped the motion, not what the deck describes: use finer cells, more of them across each body{}",
      part, robust ? " and gap" : ", or method='robust' of $mpm")};
}

/// Says where cells damp the motion that the run is about.
std::string lost_on_the_way(const Scene& scene, double part) {
  return fmt::format(
      "the fluid lost {:.2g} of the largest energy exchanged as it carried its velocity along and as bodies opened and "
      "closed its cells (energy_advected, energy_remeshed): its cells damp the motion as a drag would; finer cells and "
      "shorter steps help{}",
      part, scene.coupled()->advection == Advection::maccormack ? "" : ", and advection='maccormack'");
}

/// Says where closed parts of the fluid take the motion: a linear step stretches what turns, and the next ones take the
/// volume of that back.
std::string lost_to_volumes(const Scene& scene, double part) {
  const bool linear = !keeps_energy(*scene.coupled(), *scene.solids(), scene.clock.tstep);
  return fmt::format(
      "closed parts of the fluid took {:.2g} of the largest energy exchanged as their volume was kept "
      "(energy_sources): {}shorter steps help",
      part, linear ? "linear steps stretch bodies that turn, and brake them so: step='energy' of $coupled, or " : "");
}

std::vector<std::string> fluid_lost(const Scene& scene, const History& history) {
  std::vector<std::string> lost;
  const double on_the_way = energy_lost_by(history, {"energy_advected", "energy_remeshed"}),
               to_volumes = energy_lost_by(history, {"energy_sources"});
  if (on_the_way > much_of_fluids) lost.push_back(lost_on_the_way(scene, on_the_way));
  if (to_volumes > much_of_fluids) lost.push_back(lost_to_volumes(scene, to_volumes));
  return lost;
}

}  // namespace

std::vector<std::string> lost_energy_warnings(const Scene& scene, const History& history) {
  if (scene.path() == Path::mpm) return points_lost(scene, history);
  if (scene.path() == Path::coupled) return fluid_lost(scene, history);
  return {};
}

}  // namespace tether
