// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/strips.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "loops/points.hpp"
#include "reference/riemann.hpp"

namespace tether::mpm {

static_assert(lists_each_number_once<Passed>(Passed::rows()), "a number of what passed has no row, or two");
namespace {

bool has_waves(const EdgeGas& gas) {
  return gas.density > 0 && gas.pressure > 0 && std::isfinite(gas.density) && std::isfinite(gas.pressure) &&
         std::isfinite(gas.across);
}

/// Returns whether the two part so fast that nothing is left between them, Toro (4.40).
bool parts(const EdgeGas& outside, const EdgeGas& inside, double gamma) {
  const auto c = [gamma](const EdgeGas& gas) { return std::sqrt(gamma * gas.pressure / gas.density); };
  return inside.across - outside.across >= 2 / (gamma - 1) * (c(outside) + c(inside));
}

}  // namespace

EdgeGas gas_on_edge(const Edge& edge, const EdgeGas& outside, const EdgeGas& inside, double gamma) {
  if (edge.kind == EdgeKind::outflow && !edge.has_outside) return inside;
  if (!has_waves(inside) || !has_waves(outside) || parts(outside, inside, gamma))
    return edge.kind == EdgeKind::inflow ? outside : inside;
  const RiemannSolution solution = solve_riemann({{outside.density, outside.across, outside.pressure},
                                                  {inside.density, inside.across, inside.pressure},
                                                  gamma,
                                                  0});
  const GasSample here = sample(solution, 0, 1);
  return {here.density, here.velocity, here.velocity > 0 ? outside.along : inside.along, here.pressure};
}

namespace {

/// Of a cell: a place this much beyond the strip's end is at its end still.
constexpr double rounding = 1e-9;

}  // namespace

Strips::Strips(const Scene& scene, const Points& points)
    : on_(scene.edges.any()), grid_(scene.grid), geometry_(scene.geometry), edges_(scene.edges) {
  if (!on_) return;
  if (scene.method.kernel == Kernel::bspline) D_ = 0.25 * pair(grid_.dx * grid_.dx, grid_.dy * grid_.dy);
  gm1_ = std::get<IdealGas>(find_body<IdealGas>(scene)->material).gm1;  // $fluid has one for all gases
  next_id_ = static_cast<int>(points.size());
}

double Strips::line(std::size_t k) const {
  return k == 0 ? grid_.x0 : k == 1 ? grid_.x1 : k == 2 ? grid_.y0 : grid_.y1;
}

/// The left and the right edge own the corners.
int Strips::edge_of(double x, double y) const {
  const bool left = x < grid_.x0 && edges_.of[0].open(), right = x > grid_.x1 && edges_.of[1].open();
  const bool bottom = y < grid_.y0 && edges_.of[2].open(), top = y > grid_.y1 && edges_.of[3].open();
  if (left || right) return (bottom || top ? corner_ : 0) + (left ? 0 : 1);
  return bottom ? 2 : top ? 3 : inside_;
}

std::size_t Strips::cell_of(std::size_t k, double along) const {
  const double cell = std::floor((along - first_along(k)) / cell_along(k));
  return static_cast<std::size_t>(std::clamp(cell, 0.0, cells_along(k) - 1.0));
}

double Strips::total_energy(const Points& P, std::size_t p, const Scene& scene) const {
  const bool about = !P.vxx.empty();
  const double field =
      about ? D_[0] * (P.vxx[p] * P.vxx[p] + P.vyx[p] * P.vyx[p]) + D_[1] * (P.vxy[p] * P.vxy[p] + P.vyy[p] * P.vyy[p])
            : 0;
  const double kinetic = 0.5 * (P.vx[p] * P.vx[p] + P.vy[p] * P.vy[p] + field);
  return P.mass[p] * (kinetic + P.energy[p] - scene.gravity * P.y[p]);
}

void Strips::before_step(const Points& P, const std::vector<Slots>& ranges, const Scene& scene) {
  notes_.clear();
  noted_.assign(P.size(), 0), gone_.assign(P.size(), 0);
  for (std::size_t b = 0; b < ranges.size(); ++b) {
    const auto* gas = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!gas) continue;
    for_points(ranges[b].full(), [&](std::size_t p) {
      const int edge = edge_of(P.x[p], P.y[p]);
      if (edge == inside_) return;
      noted_[p] = 1;
      notes_.push_back({p, edge, gas->rule == DensityRule::continuity, P.x[p], P.y[p], P.vx[p], P.vy[p], P.rho[p],
                        P.energy[p], total_energy(P, p, scene)});
    });
  }
}

EdgeFindings Strips::after_step(const BodyPoints& bodies, const Scene& scene, double dt, double time) {
  EdgeFindings edges;
  time_ = time;
  energy_of_step_ = {};
  return_to_reservoir(bodies, scene, dt);
  edges.found.trouble = let_pass(bodies, scene);
  if (edges.found.trouble.kind != TroubleKind::none) return edges;
  for (std::size_t k = 0; k < 4; ++k) {
    if (edges_.of[k].open()) feed(k, bodies, scene, dt);
  }
  edges.regrouped = !made_.empty() || std::find(gone_.begin(), gone_.end(), 1) != gone_.end();
  if (edges.regrouped) regroup(bodies, scene);
  look_inside(bodies, scene);
  edges.found = set_strips(bodies, scene);
  book_energy();
  return edges;
}

/// Gives points of strips back to the gas outside. What a point of a strip gave to the nodes in the step is what the
/// gas inside took from it; gravity gave some of the momentum. Then it stands where the velocity on the edge carries
/// it.
void Strips::return_to_reservoir(const BodyPoints& bodies, const Scene& scene, double dt) {
  Points& P = bodies.points;
  for (const Note& note : notes_) {
    const std::size_t p = note.slot;
    const auto k = static_cast<std::size_t>(note.edge % corner_);
    passed_.momentum_x += P.mass[p] * (note.vx - P.vx[p]);
    passed_.momentum_y += P.mass[p] * (note.vy - P.vy[p] + dt * scene.gravity);
    energy_of_step_[k] += note.total - total_energy(P, p, scene);
    passed_.stored += P.mass[p] * (note.energy - P.energy[p]);
    const bool moves = note.edge < corner_;
    P.x[p] = moves && k < 2 ? note.x + dt * note.vx : note.x;
    P.y[p] = moves && k >= 2 ? note.y + dt * note.vy : note.y;
    P.vx[p] = note.vx, P.vy[p] = note.vy, P.energy[p] = note.energy;
    P.forget_field(p);
    if (note.keeps_density) P.rho[p] = note.rho;
  }
}

Trouble Strips::let_pass(const BodyPoints& bodies, const Scene& scene) {
  const Points& P = bodies.points;
  for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
    const bool gas = std::holds_alternative<IdealGas>(scene.bodies[b].material);
    if (!gas) {
      const Trouble trouble = find_at_points(bodies.ranges[b].full(), Trouble{}, [&](std::size_t p, Trouble& found) {
        if (edge_of(P.x[p], P.y[p]) != inside_) found.note(TroubleKind::at_open_edge, p);
      });
      if (trouble.kind != TroubleKind::none) return trouble;
      continue;
    }
    for_points(bodies.ranges[b].full(), [&](std::size_t p) {
      const int edge = edge_of(P.x[p], P.y[p]);
      if (edge == inside_) return;  // what enters: below, where its edge is known
      const auto k = static_cast<std::size_t>(edge % corner_);
      if (!noted_[p]) leave(k, P, scene, p);
      const bool at_end = inward(k, P.x[p], P.y[p]) < -(strip_cells + rounding) * cell_across(k);
      if (at_end || (edge >= corner_ && !noted_[p])) gone_[p] = 1;
    });
  }
  for (const Note& note : notes_) {
    if (edge_of(P.x[note.slot], P.y[note.slot]) == inside_)
      enter(static_cast<std::size_t>(note.edge % corner_), P, scene, note.slot);
  }
  return {};
}

void Strips::enter(std::size_t k, const Points& P, const Scene& scene, std::size_t p) {
  passed_.mass_in += P.mass[p];
  passed_.momentum_x += P.mass[p] * P.vx[p], passed_.momentum_y += P.mass[p] * P.vy[p];
  energy_of_step_[k] += total_energy(P, p, scene);
  passed_.stored += P.mass[p] * P.energy[p];
  if (edges_.of[k].kind == EdgeKind::outflow) tell_wrong_way(k, P, p);
}

void Strips::leave(std::size_t k, const Points& P, const Scene& scene, std::size_t p) {
  passed_.mass_out += P.mass[p];
  passed_.momentum_x -= P.mass[p] * P.vx[p], passed_.momentum_y -= P.mass[p] * P.vy[p];
  energy_of_step_[k] -= total_energy(P, p, scene);
  passed_.stored -= P.mass[p] * P.energy[p];
  if (edges_.of[k].kind == EdgeKind::inflow) tell_wrong_way(k, P, p);
  const auto id = static_cast<std::size_t>(P.id[p]);
  if (std::find(scene.tracked.begin(), scene.tracked.end(), id) == scene.tracked.end()) return;
  news_.push_back(
      fmt::format("t = {:.6g}: the tracked point {} leaves by the {} edge: from now on its columns hold no number",
                  time_, id + 1, edge_names[k]));
}

void Strips::tell_wrong_way(std::size_t k, const Points& P, std::size_t p) {
  passed_.back += P.mass[p];
  if (!note_warning(warned_, k)) return;
  const Edge& edge = edges_.of[k];
  const char* what = edge.kind == EdgeKind::inflow
                         ? "gas leaves by the {} edge, an inflow: the pressure inside is above what drives it in"
                     : edge.has_outside ? "gas comes in at the {} edge, an outflow, with the state given for outside"
                                        : "gas comes in at the {} edge, an outflow: it is what left there, or has the "
                                          "state of the gas at the edge";
  news_.push_back(fmt::format("t = {:.6g}, ({:.6g}, {:.6g}): {}", time_, P.x[p], P.y[p],
                              fmt::format(fmt::runtime(what), edge_names[k])));
}

void Strips::book_energy() {
  for (const double energy : energy_of_step_) (energy > 0 ? passed_.energy_in : passed_.energy_out) += std::abs(energy);
}

std::vector<std::string> Strips::take_news() { return std::exchange(news_, {}); }

}  // namespace tether::mpm
