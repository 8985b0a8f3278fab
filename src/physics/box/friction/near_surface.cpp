// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/near_surface.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// Its cells' middles are the middles of the faces across an axis.
StaggeredGrid grid_of_faces(StaggeredGrid grid, int axis) {
  grid.low[at(axis)] -= 0.5 * grid.d[at(axis)];
  ++grid.n[at(axis)];
  return grid;
}

std::optional<SurfaceNear> nearer(const std::optional<SurfaceNear>& a, const std::optional<SurfaceNear>& b) {
  return !a || (b && b->cells < a->cells) ? b : a;
}

}  // namespace

double whole_box(const StaggeredGrid& grid, int axis, std::size_t face) {
  const int i = grid.place_of_face(axis, face)[at(axis)];
  return grid.volume() * (i == 0 || i == grid.n[at(axis)] ? 0.5 : 1);
}

SurfaceNearFaces surface_near_faces(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid) {
  SurfaceNearFaces found;
  for (int axis = 0; axis < grid.dim; ++axis) found[at(axis)] = find_crossings(surface, q, grid_of_faces(grid, axis));
  return found;
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
  return SurfaceNear{crossing, std::abs(crossing->place - middle) / grid_.d[b]};
}

std::optional<SurfaceNear> NearSurface::along(const std::array<int, 3>& face, std::size_t b) const {
  return nearer(between(face, b, false), between(face, b, true));
}

std::optional<SurfaceNear> NearSurface::nearest(const std::array<int, 3>& face) const {
  std::optional<SurfaceNear> found;
  for (std::size_t b = 0; b < at(grid_.dim); ++b) found = nearer(found, along(face, b));
  return found;
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

}  // namespace tether::coupled
