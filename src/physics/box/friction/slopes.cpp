// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/slopes.hpp"

#include <algorithm>

namespace tether::coupled {
namespace {

std::array<int, 3> next(const std::array<int, 3>& place, int axis, bool up) { return moved(place, axis, up ? 1 : -1); }

}  // namespace

Slopes::Slopes(const FlowDomain& domain, const FrictionUnknowns& unknowns, const SolidsNearFaces* solids)
    : domain_(domain), grid_(domain.grid), unknowns_(unknowns), solids_(solids) {
  for (int axis = 0; solids != nullptr && axis < grid_.dim; ++axis)
    near_.emplace_back(grid_, axis, solids->crossings[at(axis)]);
}

bool Slopes::is_face(int axis, const std::array<int, 3>& face) const {
  const auto size = grid_.faces(axis);
  for (std::size_t b = 0; b < size.size(); ++b) {
    if (face[b] < 0 || face[b] >= size[b]) return false;
  }
  return true;
}

bool Slopes::sticks(const SurfaceNear& near) const {
  const auto node = at(solids_->surface.side(at(near.crossing->side))[0]);
  return solids_->bodies_stick || node * at(grid_.dim) >= solids_->moving;
}

/// Obstacles' nodes rest.
void Slopes::add_velocity(int axis, const SurfaceNear& near, double by, Combination& rate) const {
  const auto nodes = solids_->surface.side(at(near.crossing->side));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const std::size_t k = at(nodes[a]) * at(grid_.dim) + at(axis);
    if (k < unknowns_.nodes) rate.add(unknowns_.node(k), by * near.crossing->share[a]);
  }
}

bool Slopes::is_attached(int axis, const std::array<int, 3>& face, Combination* rate) const {
  if (solids_ == nullptr || !near_[at(axis)].holds(grid_.face(axis, face))) return false;
  const auto near = near_[at(axis)].nearest(face);
  if (!near || !sticks(*near)) return false;
  if (rate == nullptr) return true;
  const double by = 1 / (nearest_surface * *std::min_element(grid_.d.begin(), grid_.d.begin() + grid_.dim));
  rate->add(unknowns_.face(axis, face), -by);
  add_velocity(axis, *near, by, *rate);
  return true;
}

bool Slopes::has_fluid(int axis, const std::array<int, 3>& face) const {
  return is_face(axis, face) && kind(axis, face) != FaceKind::closed && !is_attached(axis, face);
}

double Slopes::part(int axis, const std::array<int, 3>& face) const {
  if (solids_ == nullptr) return 1;
  const std::size_t f = grid_.face(axis, face);
  return domain_.volume[at(axis)][f] / whole_box(grid_, axis, f);
}

Slope Slopes::to_surface(int a, const std::array<int, 3>& face, int b, bool up, const SurfaceNear& near) const {
  if (!sticks(near)) return {};
  const double cells = std::max(near.cells, nearest_surface), by = (up ? 1 : -1) / (cells * grid_.d[at(b)]);
  Slope slope{Slope::Kind::fluid, cells, {}};
  slope.rate.add(unknowns_.face(a, face), -by);
  add_velocity(a, near, by, slope.rate);
  return slope;
}

Slope Slopes::to_next(int a, const std::array<int, 3>& face, int b, bool up) const {
  const auto other = next(face, b, up);
  const double by = (up ? 1 : -1) / grid_.d[at(b)];
  Slope slope{Slope::Kind::fluid, std::max(part(a, face), part(a, other)), {}};
  slope.rate.add(unknowns_.face(a, face), -by);
  slope.rate.add(unknowns_.face(a, other), by);
  return slope;
}

Slope Slopes::across(int a, const std::array<int, 3>& face, int b, bool up, const std::array<int, 3>& way) const {
  constexpr double wall_away = 0.5;  // cells
  if (!has_fluid(a, face)) return within_solid(a, face, b, up, way);
  const auto other = next(face, b, up);
  const bool wall = kind(b, way) == FaceKind::prescribed, at_side = !is_face(a, other);
  auto near = solids_ == nullptr ? std::nullopt : near_[at(a)].between(face, at(b), up);
  if (near && near->cells > wall_away && (wall || at_side)) near.reset();
  if (!near && (wall || at_side)) {
    if (!wall) return {Slope::Kind::outside, 0, {}};
    if (at_side && domain_.slips[at(2 * b + (up ? 1 : 0))]) return {};
    Slope held{Slope::Kind::fluid, 1, {}};
    held.rate.add(unknowns_.face(a, face), (up ? -1 : 1) / (wall_away * grid_.d[at(b)]));
    return held;
  }
  if (!near && !has_fluid(a, other)) {
    if (solids_ != nullptr) near = near_[at(a)].closing(face, at(b), up);
    if (!near) return {};
  }
  if (near) {
    Slope slope = to_surface(a, face, b, up, *near);
    slope.part *= 2;  // a quarter goes half a cell far
    return slope;
  }
  if (kind(b, way) == FaceKind::closed && solids_ == nullptr) return {};
  return to_next(a, face, b, up);
}

/// The fluid's on the other side of the surface, which is where the velocity is the solid's. Where no face has fluid it
/// is by where lines through the faces' middles across the slope meet the surface: so a turning body has its own.
Slope Slopes::within_solid(int a, const std::array<int, 3>& face, int b, bool up, const std::array<int, 3>& way) const {
  const auto other = next(face, b, up);
  Slope slope{Slope::Kind::solid, 0, {}};
  if (!is_face(a, other)) return slope;
  if (has_fluid(a, other)) {
    const Slope other_way = across(a, other, b, !up, way);
    if (other_way.kind == Slope::Kind::free) return {};
    slope.rate = other_way.rate;
    return slope;
  }
  const auto here = surface_at(a, face), there = surface_at(a, other);
  if (!here || !there) return slope;
  if (!sticks(*here) || !sticks(*there)) return {};
  const double by = (up ? 1 : -1) / grid_.d[at(b)];
  add_velocity(a, *here, -by, slope.rate);
  add_velocity(a, *there, by, slope.rate);
  return slope;
}

std::optional<SurfaceNear> Slopes::surface_at(int axis, const std::array<int, 3>& face) const {
  if (solids_ == nullptr) return {};
  return near_[at(axis)].along(face, at(axis));
}

bool Slopes::is_whole(int a, const std::array<int, 3>& face, int b) const {
  const auto other = next(face, b, true);
  if (!has_fluid(a, face) || !has_fluid(a, other)) return false;
  return solids_ == nullptr || !near_[at(a)].between(face, at(b), true);
}

std::array<Slope, 2> Slopes::ahead(int a, const std::array<int, 3>& cell) const {
  const auto upper = next(cell, a, true);
  if (is_whole(a, cell, a)) return {to_next(a, cell, a, true), {}};
  std::array<Slope, 2> slopes;
  for (const bool up : {true, false}) {
    const auto& face = up ? cell : upper;
    if (solids_ == nullptr || !has_fluid(a, face)) continue;
    auto near = near_[at(a)].between(face, at(a), up);
    if (!near) near = near_[at(a)].closing(face, at(a), up);
    if (near) slopes[up ? 0 : 1] = to_surface(a, face, a, up, *near);
  }
  return slopes;
}

}  // namespace tether::coupled
