// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction_passes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/anderson.hpp"
#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr int most_passes = 40;
constexpr double most_kept = 8e6;  // numbers of a list of passes that are kept
constexpr double settled = 2e-3;   // what velocities may miss those of the end by, over their size
constexpr double bearable = 0.03;  // what they may where passes do not settle
constexpr double rough = 1e-6;     // of the momentum that friction moves, which passes before the last may miss
constexpr double bent = 3e-3;      // of what passes change in another, where bodies deform as they are found
constexpr double left = 0.03;      // of what another friction changed in the solids' motion, which these may leave

/// How much they may miss after so many passes: where these settle slowly, the last digits are not worth their time.
double enough_after(int passes) {
  constexpr int quick = 12;
  return passes <= quick ? settled : 5 * settled;
}

/// The accelerations of velocities, axis by axis, and of the nodes that the fluid sticks to.
std::vector<double> drive_of(const CoupledState& state) {
  std::vector<double> drive;
  for (const std::vector<double>& along : state.driven) drive.insert(drive.end(), along.begin(), along.end());
  drive.insert(drive.end(), state.driven_nodes.begin(), state.driven_nodes.end());
  return drive;
}

/// A warning once. Without a drive friction takes more than it may of what pressures keep up, but never gives energy.
void note_unsettled(double miss, CoupledState& state, std::vector<std::string>& messages) {
  if (state.unsettled_friction++ > 0) return;
  messages.push_back(fmt::format(
      "t = {:.6g}, step {}: friction and pressures are not found together in {} passes: velocities that friction acts "
      "on differ from those of the step's end by {:.2g} of them{}; friction_unsettled of summary.txt counts such "
      "steps, "
      "and shorter ones help",
      state.time, state.steps + 1, most_passes, miss,
      miss < bearable ? "" : ", and this step has friction first and pressures after it, which slows down what moves"));
}

}  // namespace

/// Has friction act before pressures, which are not known. Then a node's velocity may change by an impulse on it as
/// much as it can at most, the consistent mass of linear triangles and tetrahedra being nowhere less than 1 / (dim + 2)
/// of the lumped one: it is dragged along at once and no further.
void FrictionPasses::let_friction_be_first(const Step& step, double h, std::vector<double>& drive,
                                           const CoupledState& state) const {
  std::vector<double> masses = masses_as_one(step.nodes, scene_.grid.dim);
  for (double& mass : masses) mass /= scene_.grid.dim + 2;
  friction_.begin_friction(state, loose_nodes(masses, step.nodes.held), h);
  drive.assign(drive.size(), 0.0);
}

void FrictionPasses::drive_by(std::span<const double> drive, CoupledState& state) const {
  for (std::vector<double>& along : state.driven) {
    std::copy_n(drive.begin(), along.size(), along.begin());
    drive = drive.subspan(along.size());
  }
  std::copy(drive.begin(), drive.end(), state.driven_nodes.begin());
  friction_.extend_drive(state);
}

/// The roots of masses; 0 of velocities that no pressure moves.
std::vector<double> FrictionPasses::weights(const CoupledState& state) const {
  std::vector<double> weights = flow_.masses();
  for (std::size_t k = 0; k < state.driven_nodes.size(); ++k)
    weights.push_back(solids_.system.lumped[k / at(scene_.grid.dim)]);
  for (double& weight : weights) weight = std::sqrt(weight);
  return weights;
}

/// What the drive of this pass lacks of that which it ended with; a node's is by how much friction missed its end.
std::vector<double> FrictionPasses::missed_drive(const Step& step, std::span<const double> drive,
                                                 std::span<const double> rubbed, double h, CoupledState& state) const {
  friction_.take_drive(step.change, h, state);
  for (std::size_t k = 0; k < rubbed.size(); ++k) state.driven_nodes[k] += (step.working[k] - rubbed[k]) / h;
  std::vector<double> missed = drive_of(state);
  for (std::size_t k = 0; k < missed.size(); ++k) missed[k] -= drive[k];
  return missed;
}

/// Over the size of the velocities; those of a fluid at rest count as what gravity makes of them in a part of the step.
double FrictionPasses::miss_of(std::span<const double> missed, std::span<const double> weights, double h,
                               const CoupledState& state) const {
  constexpr double part = 1e-8;
  double miss = 0, size = 0;
  std::size_t k = 0;
  const auto add = [&](double velocity, double least) {
    miss += std::pow(weights[k] * h * missed[k], 2);
    size += std::pow(weights[k] * (std::abs(velocity) + least), 2);
    ++k;
  };
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (const double v : state.v[axis]) add(v, part * h * std::abs(gravity_[axis]));
  }
  for (std::size_t i = 0; i < state.driven_nodes.size(); ++i) add(state.u[i], 0);
  return miss > 0 ? std::sqrt(miss / size) : 0;
}

/// Where friction acted on a flow that was not free of divergence, a pressure of 2 mu times the divergence was lacking
/// (2 mu D of a velocity grad phi has the force 2 mu grad div grad phi): the projection does not see it, but it is most
/// of what very viscous fluids lack (J. Cahouet, J.-P. Chabard, Int. J. Numer. Meth. Fluids 8 (1988) 869-895). Bodies
/// that are free to move answer the pressure, which it knows nothing of: with them passes do without.
void FrictionPasses::add_viscous_pressure(double h, std::span<double> missed) const {
  if (std::ranges::count(solids_.held, 0) == 0) friction_.add_viscous_pressure(h, missed);
}

FrictionPasses::Pass FrictionPasses::pass(const Step& step, double h, const Digits& digits, CoupledState& state) const {
  ++state.passes;
  std::vector<double> rubbed = friction_.add_friction(state, h, digits.friction, step.drag);
  return {step.find(state, digits.left), std::move(rubbed)};
}

fem::NewtonReport FrictionPasses::find(const Step& step, double h, CoupledState& state,
                                       std::vector<std::string>& messages) const {
  liquid::Particles particles = std::exchange(state.particles, {});  // which have no part in it
  const CoupledState before = state;
  const std::size_t said = messages.size();
  const std::vector<double> weights = this->weights(state);
  std::vector<double> drive = drive_of(state), best;
  const double kept = std::clamp(most_kept / static_cast<double>(drive.size()), 5.0, 40.0);
  AndersonMixing mixing(weights, static_cast<int>(kept), step.linear ? 0 : bent);
  double least = std::numeric_limits<double>::infinity();
  friction_.begin_friction(state, step.nodes, h);
  const Digits exact{std::max(scene_.tolerance, 1e-10), 0};
  const bool saves = friction_.has_dear_digits() && exact.friction < rough;
  const Digits between = saves ? Digits{rough, left} : exact;
  Pass last = pass(step, h, exact, state);
  const auto pass_again = [&](const Digits& digits, std::span<const double> drive_of_pass) {
    go_back(before, state), messages.resize(said);
    drive_by(drive_of_pass, state);
    last = pass(step, h, digits, state);
  };
  for (int number = 1; last.report.converged; ++number) {
    std::vector<double> missed = missed_drive(step, drive, last.rubbed, h, state);
    const double miss = miss_of(missed, weights, h, state);
    const bool enough = miss <= enough_after(number);
    if (enough && (number == 1 || !saves)) break;
    if (miss < least) least = miss, best = drive;
    if (enough || number == most_passes) {
      if (!enough && least >= bearable) let_friction_be_first(step, h, best, before);
      pass_again(exact, enough ? drive : best);
      missed_drive(step, drive, last.rubbed, h, state);
      if (!enough) note_unsettled(least, state, messages);
      break;
    }
    add_viscous_pressure(h, missed);
    mixing.next(missed, drive);
    pass_again(between, drive);
  }
  state.particles = std::move(particles);
  return last.report;
}

}  // namespace tether::coupled
