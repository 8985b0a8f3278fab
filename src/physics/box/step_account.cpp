// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/krylov.hpp"
#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "physics/box/bodies.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/step.hpp"
#include "physics/box/turning.hpp"

namespace tether::coupled {

// What a step says of its energy: powers on both sides of the surface, and what goes into the books.

namespace {

// What solids take is found as a difference, whose smallest parts are lost in these shares of its terms: ten units of
// rounding, and the tolerance of iterations, over the 1e-9 to which it is looked at.
constexpr double rounded = 1e-6, solved = 1e-3;

}  // namespace

/// The power that the solids take, once by their own equations, A u1 - b at velocities that are not held or what they
/// are in a step that keeps the energy, and once by the fluid's: what its kinetic energy, the pressure's step,
/// prescribed faces and the volume term leave.
void CoupledStep::account(const FaceValues& free, const Solution& solution, CoupledState& state, double h) {
  double taken = 0, size = 0;
  for (std::size_t k = 0; k < solution.taken.size(); ++k) {
    const double power = solution.working[k] * solution.taken[k];
    taken += power, size += std::abs(power);
  }
  FaceValues change = state.v;
  for (std::size_t axis = 0; axis < change.size(); ++axis) {
    for (std::size_t f = 0; f < change[axis].size(); ++f) change[axis][f] -= free[axis][f];
  }
  const double moving = flow_->kinetic_energy(state.v, change) * 2 / h,
               let_in = flow_->prescribed_power(solution.p, state.v);
  double sources = 0;
  for (std::size_t k = 0; k < solution.p.size(); ++k)
    sources += solution.p[k] * solution.regions.source[at(flow_->regions().of[k])];
  state.last.interface_power = taken;
  const double in_motion = energy_of(state.v) / h,
               passing = energy_of(change) / h + std::abs(moving) + std::abs(let_in) + std::abs(sources);
  const double least = std::max(rounded * (in_motion + solution.terms), solved * passing);
  state.last.mismatch = size > 0 ? (sources - moving - let_in - taken) / std::max(size, least) : 0;
  state.worst_mismatch = std::max(state.worst_mismatch, std::abs(state.last.mismatch));
  state.work += h * taken;
  book_fluid(solution, moving, let_in, sources, state, h);
}

/// Books the change of the fluid's kinetic energy from before the forces, that is h times their power at v1 and the
/// pressures', less what v1 takes more than the mean velocity would. `moving` is the pressures' power on the fluid,
/// `let_in` the fluid's at prescribed faces. By splitting with repaired velocities of walls the solids get what these
/// leave; or else what their own velocities displace.
void CoupledStep::book_fluid(const Solution& solution, double moving, double let_in, double sources,
                             CoupledState& state, double h) {
  EnergyBooks& books = state.books;
  FaceValues& change = change_;
  for (std::size_t axis = 0; axis < change.size(); ++axis) {
    for (std::size_t f = 0; f < change[axis].size(); ++f) change[axis][f] = state.v[axis][f] - change[axis][f];
  }
  books.projected += energy_of(change);
  flow_->book_forces(state, h);
  books.jets -= h * let_in;
  books.sources -= h * sources;
  double given = sources - moving - let_in;
  if (coupled_.coupling.simultaneous) {
    std::vector<double> displaced(solution.p.size(), 0.0);
    add_product(flow_->flux_map(), 1, solution.working, displaced);
    given = dot(solution.p, displaced);
  }
  books.coupling += h * given;
  state.last.gave = h * given;
}

/// The equations (4), multiplied by the way h (u0 + u1)/2: what each force does on it. Supports move as the deck says;
/// what else is held, contact holds. What the solids' own forces take and what is then stored of it differ by the
/// step's own error, as do ways that contact and supports end otherwise than by (5).
void CoupledStep::book_solids(std::span<const double> q0, std::span<const double> u0, const Solution& solution,
                              CoupledState& state, double h) {
  EnergyBooks& books = state.books;
  std::vector<double> way(u0.size()), farther(u0.size());
  for (std::size_t k = 0; k < way.size(); ++k) {
    way[k] = 0.5 * h * (u0[k] + state.u[k]);
    farther[k] = state.q[k] - q0[k] - way[k];
    const double held = way[k] * solution.wall_force[k];
    solids_.held[k] != 0 ? books.loads += held : books.contact -= held;
  }
  const SolidEquations::Taken taken = solids_.taken(u0, state.u, solution.lifts, h);
  books.contact -= dot(way, solution.friction);
  books.projected -= dot(way, drag_);  // of what friction took of the fluid the solids have this
  state.work += dot(way, drag_), state.last.gave += dot(way, drag_);
  books.open_sides += dot(way, flow_->map().outside);
  books.gravity += dot(way, flow_->map().film_weight);
  books.loads += dot(way, solids_.external) + solids_.system.gravity_energy(way);
  books.damped += taken.damping;
  books.coupling -= dot(way, solution.fluid_force);
  books.solid_step += taken.inside - (stored(state.q) - stored(q0)) - solids_.system.gravity_energy(farther);
}

/// Strain energy, with that of springs.
double CoupledStep::stored(std::span<const double> q) const {
  return solids_.system.elements->strain_energy(q) + solids_.spring_energy(q);
}

// What a step finds wrong or doubtful.

namespace {

constexpr int farthest = 1000;  // sizes of the box that a node may be away from it

}  // namespace

/// A solid that ran away, or is turned inside out, leaves nothing to go on with.
void CoupledStep::check(const CoupledState& state) const {
  if (state.q.empty()) return;
  constexpr const char* too_much_added_mass =
      "added mass above what splitting bears, which shorter steps do not cure: mode='cut-cell' of $coupled holds";
  const bool splitting = !coupled_.coupling.simultaneous;
  const auto d = static_cast<std::size_t>(surface_.dim);
  const StaggeredGrid& grid = coupled_.grid;
  for (std::size_t k = 0; k < state.q.size(); ++k) {
    const std::size_t axis = k % d;
    const double most = farthest * grid.n[axis] * grid.d[axis];  // beyond, cells cannot be counted
    if (std::abs(state.q[k] - grid.low[axis]) <= most && std::isfinite(state.u[k])) continue;
    throw RunError(fmt::format("t = {:.9g}, step {}: node {} is {} box sizes away: likely cause, {}", state.time,
                               state.steps + 1, k / d + 1, farthest,
                               splitting
                                   ? too_much_added_mass
                                   : "an open side that a body leaves through, or values of the deck that run away"));
  }
  const fem::ShapeVolumes shape = solids_.system.elements->shape(state.q);
  if (shape.least > 0) return;
  const int node = solids_.system.solids.mesh.element(shape.worst)[0];
  const Vec<3> x = place_of(state.q, node, surface_.dim);
  throw RunError(
      fmt::format(
          "t = {:.9g}, step {}: element {} at ({:.6g}, {:.6g}{}) is turned inside out: likely cause, {}", state.time,
          state.steps + 1, shape.worst + 1, x[0], x[1], surface_.dim == 3 ? fmt::format(", {:.6g}", x[2]) : "",
          splitting ? too_much_added_mass : "a solid too soft for what acts on it, or steps too long for its motion"),
      Failure::inverts);
}

/// A warning once. What the last solution holds is then not what its forces ask for.
void CoupledStep::tell_of_unsettled_contact(CoupledState& state) {
  if (state.contact_unsettled++ > 0) return;
  messages_.push_back(fmt::format(
      "t = {:.6g}, step {}: which nodes touch walls and slide there was not settled in {} solutions: such a "
      "step may give a body energy, or put nodes that went through a wall back onto it; contact_unsettled of "
      "summary.txt counts these steps, shorter ones help",
      state.time, state.steps + 1, most_contact_solutions));
}

/// Once: the volume term has nothing to act on there.
void CoupledStep::tell_of_unmeasured_volume(const Regions& regions, CoupledState& state) {
  if (!coupled_.volume_term || !coupled_.coupling.simultaneous || state.unmeasured != 0) return;
  const int region = unmeasured_region(flow_->regions_of_jets(state.v), flow_->map(), regions, surface_.cavity);
  if (region < 0) return;
  state.unmeasured = 1;
  const std::vector<int>& of = flow_->regions().of;
  const Vec<3> x = flow_->place_of_pressure(static_cast<std::size_t>(std::ranges::find(of, region) - of.begin()));
  messages_.push_back(
      fmt::format("t = {:.6g}: the fluid about ({:.6g}, {:.6g}{}) is closed in by a body and sides of the box, and "
                  "jets fill or empty "
                  "it: volume_term does not hold its volume, which may drift from what the jets bring",
                  state.time, x[0], x[1], coupled_.grid.dim == 3 ? fmt::format(", {:.6g}", x[2]) : ""));
}

/// A warning once: a linear step stretches what turns in it.
void CoupledStep::note_turning(CoupledState& state, double h) {
  constexpr double much = 0.1;
  const double gain = gain_by_turning(solids_.system, state.q, state.u, h);
  if (state.linear_gain <= much && gain > much)
    messages_.push_back(fmt::format(
        "t = {:.6g}, step {}: bodies turn so fast, and are so stiff, that a linear step gives them {:.2g} of their "
        "energy of motion, and the next ones damp that away: step='energy' of $coupled keeps it, or shorter steps "
        "(linear_gain of summary.txt has the most)",
        state.time, state.steps + 1, gain));
  state.linear_gain = std::max(state.linear_gain, gain);
}

/// A warning once: what surfaces sweep lacks what is of higher order in their way. In closed regions the volume term
/// brings it back; where there is an opening, fluid comes in or goes out for it.
void CoupledStep::note_unswept(const std::vector<double>& q0, const Solution& solution, CoupledState& state) {
  constexpr double much = 0.05;
  if (!solution.regions.has_openings()) return;
  const std::vector<double> before = enclosed_volumes(surface_, q0), after = enclosed_volumes(surface_, state.q);
  const std::vector<double> swept = swept_volumes(surface_, solid_step_ ? middle_of(q0, state.q) : q0, q0, state.q);
  double lacking = 0, whole = 0;
  for (std::size_t s = 0; s < swept.size(); ++s)
    lacking += after[s] - before[s] - swept[s], whole += std::abs(first_volumes_[s]);
  if (whole == 0) return;
  const double last = std::abs(state.unswept), now = std::abs(state.unswept += lacking / whole);
  if (last > much || now <= much) return;
  messages_.push_back(fmt::format(
      "t = {:.6g}, step {}: bodies turn or ripple so far in single steps that {:.2g} of their volume went through "
      "openings of the box for it, and with it energy of gravity: step='energy' of $coupled, or shorter steps, with "
      "whose length it falls (volume_unswept of summary.txt has the sum)",
      state.time, state.steps + 1, now));
}

/// A warning once for each body.
void CoupledStep::note_bodies_that_left(double time, CoupledState& state) {
  const std::vector<int> sides = sides_left_by(surface_, state.q, coupled_.grid);
  for (std::size_t b = 0; b < sides.size(); ++b) {
    if (sides[b] < 0 || state.left[b] != 0) continue;
    state.left[b] = 1;
    messages_.push_back(
        fmt::format("t = {:.6g}: {}", time, leaving_text(coupled_, surface_, state.q, static_cast<int>(b), sides[b])));
  }
}

std::vector<std::string> CoupledStep::take_messages() {
  std::vector<std::string> messages = std::exchange(messages_, {});
  for (std::string& message : flow_->take_messages()) messages.push_back(std::move(message));
  for (std::string& message : system_.take_messages()) messages.push_back(std::move(message));
  return messages;
}

}  // namespace tether::coupled
