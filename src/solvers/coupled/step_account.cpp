// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "solvers/coupled/coupled_matrix.hpp"
#include "solvers/coupled/coupled_step.hpp"
#include "solvers/coupled/projection.hpp"

// What a step says of its energy: powers on both sides of the surface, and what goes into the books.

namespace tether::coupled {
namespace {

// What solids take is found as a difference, whose smallest parts are lost in these shares of its terms: ten units of
// rounding, and the tolerance of iterations, over the 1e-9 to which it is looked at.
constexpr double rounded = 1e-6, solved = 1e-3;

}  // namespace

/// Kinetic energy of the fluid.
double CoupledStep::energy_of(const FaceValues& v) const { return kinetic_energy(at_.domain, v, v, coupled_.density); }

/// The power that the solids take, once by their own equations, A u1 - b at velocities that are not held, and once by
/// the fluid's: what its kinetic energy, the pressure's step, prescribed faces and the volume term leave.
void CoupledStep::account(const FaceValues& free, const Solution& solution, CoupledState& state, double h) {
  double taken = 0, size = 0, inside = terms_size(solids_.A, state.u);
  for (std::size_t k = 0; k < state.u.size(); ++k) {
    const double force = solution.held[k] != 0 ? solution.fluid_force[k] : solution.Au[k] - solution.b[k];
    taken += state.u[k] * force, size += std::abs(state.u[k] * force);
    inside += std::abs(state.u[k] * solution.b[k]);
  }
  FaceValues change = state.v;
  for (std::size_t axis = 0; axis < change.size(); ++axis) {
    for (std::size_t f = 0; f < change[axis].size(); ++f) change[axis][f] -= free[axis][f];
  }
  const double moving = kinetic_energy(at_.domain, state.v, change, coupled_.density) * 2 / h,
               let_in = prescribed_power(at_.domain, at_.numbers, solution.p, state.v);
  double sources = 0;
  for (std::size_t k = 0; k < solution.p.size(); ++k) sources += solution.p[k] * solution.source[k];
  state.last.interface_power = taken;
  const double in_motion = energy_of(state.v) / h,
               passing = energy_of(change) / h + std::abs(moving) + std::abs(let_in) + std::abs(sources);
  const double least = std::max(rounded * (in_motion + inside), solved * passing);
  state.last.mismatch = size > 0 ? (sources - moving - let_in - taken) / std::max(size, least) : 0;
  state.worst_mismatch = std::max(state.worst_mismatch, std::abs(state.last.mismatch));
  state.work += h * taken;
  book_fluid(solution, moving, let_in, sources, state, h);
}

/// Of the fluid's kinetic energy the change from before the forces, that is h times their power at v1 and the
/// pressures', less what v1 takes more than the mean velocity would. `moving` is the pressures' power on the fluid,
/// `let_in` the fluid's at prescribed faces. By splitting with repaired velocities of walls the solids get what these
/// leave; or else what their own velocities displace.
void CoupledStep::book_fluid(const Solution& solution, double moving, double let_in, double sources,
                             CoupledState& state, double h) {
  EnergyBooks& books = state.books;
  FaceValues& change = unforced_;
  double along_y = 0;  // volume times velocity
  for (std::size_t f = 0; f < state.v[1].size(); ++f) {
    if (at_.domain.face[1][f] == FaceKind::open) along_y += at_.domain.volume[1][f] * state.v[1][f];
  }
  for (std::size_t axis = 0; axis < change.size(); ++axis) {
    for (std::size_t f = 0; f < change[axis].size(); ++f) change[axis][f] = state.v[axis][f] - change[axis][f];
  }
  books.projected += energy_of(change);
  books.gravity += h * coupled_.density * scene_.gravity * along_y;
  if (coupled_.smoke)
    books.buoyancy += h * buoyancy_power(at_.domain, state.smoke, coupled_.smoke_lift, coupled_.smoke_weight,
                                         coupled_.density, state.v);
  books.open_sides += h * outside_.power(at_.domain, state.v);
  books.jets -= h * let_in;
  books.sources -= h * sources;
  double given = sources - moving - let_in;
  if (coupled_.mode != CouplingMode::splitting) {
    std::vector<double> displaced(solution.p.size(), 0.0);
    add_product(coupled_.mode == CouplingMode::paper ? at_.crossing_map : at_.map.B, 1, state.u, displaced);
    given = product(solution.p, displaced);
  }
  books.coupling += h * given;
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
  books.contact -= product(way, solution.friction);
  books.open_sides += product(way, at_.map.outside);
  books.gravity += product(way, at_.map.film_weight);
  books.loads += product(way, solids_.external) + solids_.system.gravity_energy(way);
  books.damped += taken.damping;
  books.coupling -= product(way, solution.fluid_force);
  books.solid_step += taken.inside - (stored(state.q) - stored(q0)) - solids_.system.gravity_energy(farther);
}

/// Strain energy, with that of springs.
double CoupledStep::stored(std::span<const double> q) const {
  return solids_.system.elements->strain_energy(q) + solids_.spring_energy(q);
}

}  // namespace tether::coupled
