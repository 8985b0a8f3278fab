// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/drag.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double nearest = 1e-6;  // cells: nearer than that the velocities are the same

/// Its cells' middles are the middles of the faces across an axis.
StaggeredGrid grid_of_faces(StaggeredGrid grid, int axis) {
  grid.low[at(axis)] -= 0.5 * grid.d[at(axis)];
  ++grid.n[at(axis)];
  return grid;
}

}  // namespace

double whole_box(const StaggeredGrid& grid, int axis, std::size_t face) {
  const int i = grid.place_of_face(axis, face)[at(axis)];
  return grid.volume() * (i == 0 || i == grid.n[at(axis)] ? 0.5 : 1);
}

SurfaceBesideFaces surface_beside_faces(const SolidSurface& surface, std::span<const double> q,
                                        const StaggeredGrid& grid) {
  SurfaceBesideFaces beside;
  for (int axis = 0; axis < grid.dim; ++axis) beside[at(axis)] = find_crossings(surface, q, grid_of_faces(grid, axis));
  return beside;
}

/// The first crossing that the way from a face's middle to the next one meets.
const Crossing* NearSurface::first(std::array<int, 3> face, std::size_t b, bool up) const {
  if (up) ++face[b];
  std::array<int, 3> lattice = grid_.faces(axis_);
  ++lattice[b];
  const std::size_t line = at(face[0]) + at(lattice[0]) * (at(face[1]) + at(lattice[1]) * at(face[2]));
  const int number = up ? crossings_.lowest[b][line] : crossings_.highest[b][line];
  return number < 0 ? nullptr : &crossings_.all[at(number)];
}

std::optional<SurfaceNear> NearSurface::between(const std::array<int, 3>& face, std::size_t b, bool up) const {
  const Crossing* crossing = first(face, b, up);
  if (crossing == nullptr) return {};
  const int axis = static_cast<int>(b);
  const double middle = axis == axis_ ? grid_.face_place(axis, face[b]) : grid_.middle(axis, face[b]);
  return SurfaceNear{crossing, std::max(std::abs(crossing->place - middle) / grid_.d[b], nearest)};
}

std::optional<SurfaceNear> NearSurface::closing(const std::array<int, 3>& face, std::size_t b, bool up) const {
  auto next = face;
  next[b] += up ? 1 : -1;
  const auto own = at(axis_);
  const auto below = between(next, own, false), above = between(next, own, true);
  const bool take_above = above && (!below || above->cells < below->cells);
  const auto& near = take_above ? above : below;
  if (!near) return {};
  const bool ahead = b == own;
  return SurfaceNear{near->crossing, ahead && take_above == up ? 1 + near->cells : 1};
}

void Drag::join(std::size_t face, double volume, std::size_t b, const SurfaceNear& near, bool within) {
  const double cells = within ? nearest : near.cells;
  if (stars_.empty() || stars_.back().face != face) stars_.push_back({face, links_.size(), volume});
  const double part = volume / whole_box(grid_, static_cast<int>(axis_), face);
  links_.push_back({near.crossing->side, near.crossing->share, 1 / (grid_.d[b] * grid_.d[b] * cells * part)});
}

void Drag::act(double nu, double h, StickingBodies& bodies, std::vector<double>& v) const {
  for (std::size_t s = 0; s < stars_.size(); ++s) {
    const std::size_t end = s + 1 < stars_.size() ? stars_[s + 1].first : links_.size();
    act_on(stars_[s], end, h * nu, bodies, v[stars_[s].face]);
  }
}

/// Lets a star's links act. With m of the face, w = sum of share^2 / mass of the surface's place, and x = h nu / (d
/// distance), a link's impulse is J = m x (v1 - u1), u1 = u + J w, so that J = m y (v1 - u) with y = x / (1 + m x w);
/// and m (v1 - v) = -sum J. As links may have nodes in common, each counts w for all of them: none then overshoots.
void Drag::act_on(const Star& star, std::size_t end, double by, StickingBodies& bodies, double& v) const {
  const auto dim = at(grid_.dim);
  const double mass = bodies.density * star.volume, count = static_cast<double>(end - star.first);
  constexpr std::size_t most = 6;  // links of a face
  std::array<double, most> y{}, u{};
  double sum = v, weights = 1;
  for (std::size_t l = star.first, k = 0; l < end; ++l, ++k) {
    const auto nodes = bodies.surface.side(at(links_[l].side));
    double w = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double share = links_[l].share[a];
      u[k] += share * bodies.u[at(nodes[a]) * dim + axis_];
      w += share * share * bodies.mobility[at(nodes[a]) * dim + axis_];
    }
    const double x = by * links_[l].per_area;
    y[k] = x / (1 + count * mass * x * w);
    sum += y[k] * u[k], weights += y[k];
  }
  v = sum / weights;
  for (std::size_t l = star.first, k = 0; l < end; ++l, ++k) {
    const auto nodes = bodies.surface.side(at(links_[l].side));
    const double impulse = mass * y[k] * (v - u[k]);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const std::size_t i = at(nodes[a]) * dim + axis_;
      bodies.impulse[i] += links_[l].share[a] * impulse;
      bodies.u[i] += links_[l].share[a] * impulse * bodies.mobility[i];
    }
  }
}

}  // namespace tether::coupled
