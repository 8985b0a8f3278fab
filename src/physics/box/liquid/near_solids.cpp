// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/near_solids.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "grid/contact/distance_slopes.hpp"
#include "physics/box/liquid/particles.hpp"

namespace tether::liquid {

/// Calls f(cell) for the cells that a side's box reaches into, and those about them.
template <class Function>
void NearSolids::each_cell_about(std::size_t side, const Function& f) const {
  std::array<int, 3> low{}, high{}, cell{};
  for (std::size_t a = 0; a < at(grid_.dim); ++a) {
    double least = INFINITY, most = -INFINITY;
    for (const int node : surface_.side(side)) {
      const double x = tether::place_of(q_, node, surface_.dim)[a];
      least = std::min(least, x), most = std::max(most, x);
    }
    const double first = std::floor((least - grid_.low[a]) / grid_.d[a]) - 1,
                 last = std::floor((most - grid_.low[a]) / grid_.d[a]) + 1;
    if (last < 0 || first >= grid_.n[a]) return;
    low[a] = static_cast<int>(std::max(first, 0.0)), high[a] = static_cast<int>(std::min(last, grid_.n[a] - 1.0));
  }
  for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
      for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) f(grid_.cell(cell));
    }
  }
}

NearSolids::NearSolids(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid,
                       const Crossings& crossings)
    : surface_(surface), q_(q), grid_(grid), crossings_(crossings), first_(grid.cell_count() + 1, 0) {
  for (std::size_t s = 0; s < surface.side_count(); ++s) each_cell_about(s, [&](std::size_t c) { ++first_[c + 1]; });
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
  sides_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < surface.side_count(); ++s)
    each_cell_about(s, [&](std::size_t c) { sides_[next[c]++] = static_cast<int>(s); });
}

namespace {

/// The shares of a triangle's corners in its place nearest to another: r has the ways from the first corner to that
/// place and to the other corners.
Vec<3> shares_on_triangle(const PairVectors<3, 3>& r) {
  const Products<3> products = products_of<3, 3>(r);
  const SmallMatrix<3, 1> parts = nearest_way(products, nearest_on_triangle(products)).parts;
  return {1 + parts[1] + parts[2], -parts[1], -parts[2]};
}

double sixfold_volume(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) { return dot(a, cross(b, c)); }

}  // namespace

/// Returns 1 where a way goes into a solid through a side, -1 where it comes out of one, and 0 where it does not meet
/// it. Of the ends of a way, and of a side's, each lies on one side of the other: what is exactly on it counts as
/// above.
int NearSolids::turns(int side, const Vec<3>& from, const Vec<3>& to) const {
  const auto nodes = surface_.side(at(side));
  const Vec<3> a = minus(tether::place_of(q_, nodes[0], surface_.dim), from),
               b = minus(tether::place_of(q_, nodes[1], surface_.dim), from), way = minus(to, from);
  if (surface_.dim == 2) {
    if ((cross(way, a)[2] > 0) == (cross(way, b)[2] > 0)) return 0;
  } else {
    const Vec<3> c = minus(tether::place_of(q_, nodes[2], 3), from);
    const bool ab = sixfold_volume(way, a, b) > 0, bc = sixfold_volume(way, b, c) > 0,
               ca = sixfold_volume(way, c, a) > 0;
    if (ab != bc || bc != ca) return 0;
  }
  const Vec<3> normal = area_of_side(surface_, at(side), q_);
  const bool begins_above = dot(normal, a) <= 0, ends_above = dot(normal, minus(a, way)) <= 0;
  return begins_above == ends_above ? 0 : begins_above ? 1 : -1;
}

bool NearSolids::hold(const Vec<3>& x) const {
  const auto place = cell_of(grid_, x);
  const std::size_t cell = grid_.cell(place);
  int solids = crossings_.inside[cell];
  const Vec<3> middle = grid_.middle(place);
  for (std::size_t k = first_[cell]; k < first_[cell + 1]; ++k) solids += turns(sides_[k], middle, x);
  return solids > 0;
}

NearestSurface NearSolids::nearest_of_side(int side, const Vec<3>& x) const {
  const auto nodes = surface_.side(at(side));
  std::array<Vec<3>, 3> corner{};
  for (std::size_t a = 0; a < nodes.size(); ++a) corner[a] = tether::place_of(q_, nodes[a], surface_.dim);
  NearestSurface near{side, {}, {1, 0, 0}, 0};
  const Vec<3> to = minus(x, corner[0]), e = minus(corner[1], corner[0]);
  if (surface_.dim == 2) {
    const double t = std::clamp(dot(to, e) / dot(e, e), 0.0, 1.0);
    near.share = {1 - t, t, 0};
  } else {
    PairVectors<3, 3> r;
    const Vec<3> f = minus(corner[2], corner[0]);
    for (int i = 0; i < 3; ++i) r(i, 0) = to[at(i)], r(i, 1) = e[at(i)], r(i, 2) = f[at(i)];
    near.share = shares_on_triangle(r);
  }
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    for (std::size_t i = 0; i < 3; ++i) near.place[i] += near.share[a] * corner[a][i];
  }
  const Vec<3> off = minus(x, near.place);
  near.distance = std::sqrt(dot(off, off));
  return near;
}

Vec<3> NearSolids::velocity(const NearestSurface& near, std::span<const double> u) const {
  Vec<3> velocity{};
  const auto nodes = surface_.side(at(near.side));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const std::size_t first = at(nodes[a]) * at(surface_.dim);
    for (std::size_t i = 0; i < at(surface_.dim) && first < u.size(); ++i) velocity[i] += near.share[a] * u[first + i];
  }
  return velocity;
}

/// Returns whether just before a place of the surface another solid is.
bool NearSolids::is_buried(const NearestSurface& near) const {
  constexpr double away = 1e-3;  // of a cell
  const Vec<3> normal = area_of_side(surface_, at(near.side), q_);
  const double length = std::sqrt(dot(normal, normal));
  Vec<3> before = near.place;
  for (std::size_t a = 0; a < at(grid_.dim); ++a) {
    before[a] += away * grid_.d[a] * normal[a] / length;
    if (before[a] < grid_.low[a] || before[a] > grid_.high(static_cast<int>(a))) return true;  // outside of the box
  }
  return hold(before);
}

std::optional<NearestSurface> NearSolids::nearest(const Vec<3>& x) const {
  const std::size_t cell = grid_.cell(cell_of(grid_, x));
  std::vector<NearestSurface> all;
  for (std::size_t k = first_[cell]; k < first_[cell + 1]; ++k) all.push_back(nearest_of_side(sides_[k], x));
  std::ranges::sort(all, {}, &NearestSurface::distance);
  const auto found = std::ranges::find_if(all, [&](const NearestSurface& near) { return !is_buried(near); });
  if (found != all.end()) return *found;
  return all.empty() ? std::nullopt : std::optional(all.front());
}

}  // namespace tether::liquid
