// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/anderson.hpp"
#include "base/numbers.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// Friction and pressures are found together: friction acts on velocities that are driven by the pressures of the step's
// end, and these are found for what friction left. Passes over both go on until the velocities that friction acted on
// are those of the end. One pass alone, with the pressures of the step before, has bodies in a fluid of much viscosity
// swing to and fro.

namespace {

constexpr int most_passes = 40;
constexpr double most_kept = 8e6;  // numbers of a list of passes that are kept
constexpr double settled = 2e-3;   // what velocities may miss those of the end by, over their size
constexpr double bearable = 0.03;  // what they may where passes do not settle

/// How much they may miss after so many passes: where these settle slowly, the last digits are not worth their time.
double enough_after(int passes) {
  constexpr int quick = 12;
  return passes <= quick ? settled : 5 * settled;
}

}  // namespace

/// The accelerations of open faces, axis by axis, and of the nodes that the fluid sticks to.
std::vector<double> CoupledStep::drive_of(const CoupledState& state) const {
  std::vector<double> drive;
  for (const std::vector<double>& faces : state.driven) drive.insert(drive.end(), faces.begin(), faces.end());
  drive.insert(drive.end(), state.driven_nodes.begin(), state.driven_nodes.end());
  return drive;
}

void CoupledStep::drive_by(std::span<const double> drive, CoupledState& state) const {
  for (std::vector<double>& faces : state.driven) {
    std::copy_n(drive.begin(), faces.size(), faces.begin());
    drive = drive.subspan(faces.size());
  }
  std::copy(drive.begin(), drive.end(), state.driven_nodes.begin());
  extend_drive(state);
}

/// The roots of masses; 0 of faces that no pressure moves.
std::vector<double> CoupledStep::weights_of_drive(const CoupledState& state) const {
  std::vector<double> weights;
  for (std::size_t axis = 0; axis < state.driven.size(); ++axis) {
    for (std::size_t f = 0; f < state.driven[axis].size(); ++f) {
      const bool open = at_.domain.face[axis][f] == FaceKind::open;
      weights.push_back(open ? std::sqrt(coupled_.density * at_.domain.volume[axis][f]) : 0);
    }
  }
  for (std::size_t k = 0; k < state.driven_nodes.size(); ++k)
    weights.push_back(std::sqrt(solids_.system.lumped[k / at(surface_.dim)]));
  return weights;
}

/// What the drive of this pass lacks of that which it ended with. A node's is what all but friction gave it.
std::vector<double> CoupledStep::missed_drive(std::span<const double> drive, std::span<const double> u0, double h,
                                              CoupledState& state) const {
  take_drive(h, state);
  extend_drive(state);
  for (std::size_t k = 0; k < state.driven_nodes.size(); ++k)
    state.driven_nodes[k] = (state.u[k] - u0[k]) / h - drag_[k] * mobility_of(k);
  std::vector<double> missed = drive_of(state);
  for (std::size_t k = 0; k < missed.size(); ++k) missed[k] -= drive[k];
  return missed;
}

/// Over the size of the velocities; those of a fluid at rest count as what gravity makes of them in a part of the step.
double CoupledStep::miss_of(std::span<const double> missed, std::span<const double> weights, double h,
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

/// Where friction acted on a flow that was not free of divergence, a pressure of chi mu times the divergence was
/// lacking: the projection does not see it, but it is most of what very viscous fluids lack (J. Cahouet, J.-P. Chabard,
/// Int. J. Numer. Meth. Fluids 8 (1988) 869-895). Bodies that are free to move answer the pressure, which it knows
/// nothing of: with them passes do without.
void CoupledStep::add_viscous_pressure(double h, std::span<double> missed) const {
  constexpr double chi = 1;
  if (std::ranges::count(solids_.held, 0) > 0) return;
  FaceValues faces = face_values(coupled_.grid), more = faces;
  std::size_t k = 0;
  for (std::size_t axis = 0; axis < faces.size(); ++axis) {
    for (std::size_t f = 0; f < faces[axis].size(); ++f, ++k)
      faces[axis][f] = at_.domain.face[axis][f] == FaceKind::open ? missed[k] : 0;
  }
  std::vector<double> p = net_flux(at_.domain, at_.numbers, faces);
  if (k < missed.size()) add_product(at_.map.B, 1, missed.subspan(k), p);
  for (double& value : p) value *= chi * h * coupled_.viscosity / coupled_.grid.volume();
  add_pressure_within(at_.domain, at_.numbers, p, 1 / coupled_.density, more);
  k = 0;
  for (const std::vector<double>& axis : more) {
    for (const double value : axis) missed[k++] += value;
  }
}

/// Finds what friction left, and pressures with it, from where a step begins.
fem::NewtonReport CoupledStep::pass(CoupledState& state, double h, bool by_euler, Solution& solution) {
  ++state.passes;
  add_friction(state, h);
  return find_step(state, h, by_euler, solution);
}

fem::NewtonReport CoupledStep::find_with_friction(CoupledState& state, double h, bool by_euler, Solution& solution) {
  liquid::Particles particles = std::exchange(state.particles, {});  // which have no part in it
  const CoupledState before = state;
  const CouplingMap map = solid_step_ ? at_.map : CouplingMap{};  // which such a step takes in its middle
  const std::size_t said = messages_.size();
  const std::vector<double> weights = weights_of_drive(state);
  std::vector<double> drive = drive_of(state), best;
  AndersonMixing mixing(weights,
                        static_cast<int>(std::clamp(most_kept / static_cast<double>(drive.size()), 5.0, 40.0)));
  double least = std::numeric_limits<double>::infinity();
  const auto go_back = [&] {
    CoupledState begin = before;
    begin.iterations = state.iterations, begin.lu_solutions = state.lu_solutions, begin.passes = state.passes;
    begin.newton_steps = state.newton_steps, begin.contact_solutions = state.contact_solutions;
    state = std::move(begin);
    if (solid_step_) at_.map = map;
    messages_.resize(said);
  };
  begin_friction(state, h, beyond_open_sides());
  fem::NewtonReport report = pass(state, h, by_euler, solution);
  for (int number = 1; report.converged; ++number) {
    std::vector<double> missed = missed_drive(drive, before.u, h, state);
    const double miss = miss_of(missed, weights, h, state);
    if (miss <= enough_after(number)) break;
    if (miss < least) least = miss, best = drive;
    if (number == most_passes) {
      go_back();
      note_unsettled_friction(least, state);
      drive_by(least < bearable ? best : std::vector<double>(drive.size(), 0.0), state);
      report = pass(state, h, by_euler, solution);
      missed_drive(drive, before.u, h, state);
      break;
    }
    add_viscous_pressure(h, missed);
    mixing.next(missed, drive);
    go_back();
    drive_by(drive, state);
    report = pass(state, h, by_euler, solution);
  }
  state.particles = std::move(particles);
  return report;
}

/// A warning once. Without a drive friction takes more than it may of what pressures keep up, but never gives energy.
void CoupledStep::note_unsettled_friction(double miss, CoupledState& state) {
  if (state.unsettled_friction++ > 0) return;
  messages_.push_back(fmt::format(
      "t = {:.6g}, step {}: friction and pressures are not found together in {} passes: velocities that friction acts "
      "on differ from those of the step's end by {:.2g} of them{}; friction_unsettled of summary.txt counts such "
      "steps, "
      "and shorter ones help",
      state.time, state.steps + 1, most_passes, miss,
      miss < bearable ? "" : ", and this step has friction first and pressures after it, which slows down what moves"));
}

}  // namespace tether::coupled
