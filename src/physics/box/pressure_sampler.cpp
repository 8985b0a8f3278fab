// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/pressure_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "model/coupled.hpp"

namespace tether::coupled {
namespace {

std::size_t at_index(int i) { return static_cast<std::size_t>(i); }

/// Returns whether the way from `from` to `to` meets the side, its ends left out by rounding's measure.
bool meets_edge(const Vec<3>& a, const Vec<3>& b, const Vec<3>& from, const Vec<3>& to) {
  const Vec<3> way = minus(to, from), edge = minus(b, a), gap = minus(a, from);
  const double det = way[0] * edge[1] - way[1] * edge[0];
  if (det == 0) return false;
  const double t = (gap[0] * edge[1] - gap[1] * edge[0]) / det, s = (gap[0] * way[1] - gap[1] * way[0]) / det;
  return t > 1e-9 && t <= 1 && s >= 0 && s <= 1;
}

/// T. Moeller and B. Trumbore, J. Graphics Tools 2 (1997) 21-28.
bool meets_triangle(const std::array<Vec<3>, 3>& x, const Vec<3>& from, const Vec<3>& to) {
  const Vec<3> way = minus(to, from), e = minus(x[1], x[0]), f = minus(x[2], x[0]), p = cross(way, f);
  const double det = dot(e, p);
  if (det == 0) return false;
  const Vec<3> gap = minus(from, x[0]), r = cross(gap, e);
  const double u = dot(gap, p) / det, v = dot(way, r) / det, t = dot(f, r) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-9 && t <= 1;
}

}  // namespace

PressureSampler::PressureSampler(const SolidSurface& surface, std::span<const double> q, const SurfacePieces& pieces,
                                 const FlowDomain& domain)
    : surface_(surface), q_(q), pieces_(pieces), domain_(domain), first_(domain.grid.cell_count() + 1, 0) {
  const StaggeredGrid& grid = domain.grid;
  std::vector<std::size_t> cell;  // of each piece
  for (const SurfacePiece& piece : pieces.pieces) {
    cell.push_back(grid.has_cell(piece.cell) ? grid.cell(piece.cell) : grid.cell_count());
    if (cell.back() < grid.cell_count()) ++first_[cell.back() + 1];
  }
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
  sides_.resize(at_index(first_.back()));
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < cell.size(); ++k) {
    if (cell[k] < grid.cell_count()) sides_[at_index(next[cell[k]]++)] = pieces.pieces[k].side;
  }
}

bool PressureSampler::is_hidden_by(int side, const Vec<3>& from, const Vec<3>& to) const {
  std::array<Vec<3>, 3> x{};
  const auto nodes = surface_.side(at_index(side));
  for (std::size_t a = 0; a < nodes.size(); ++a) x[a] = place_of(q_, nodes[a], surface_.dim);
  return surface_.dim == 2 ? meets_edge(x[0], x[1], from, to) : meets_triangle(x, from, to);
}

bool PressureSampler::sees(const SurfacePiece& piece, const Vec<3>& to) const {
  const StaggeredGrid& grid = domain_.grid;
  std::array<int, 3> low{}, high{};
  for (std::size_t i = 0; i < at_index(grid.dim); ++i) {
    const auto [a, b] = std::minmax(piece.middle[i], to[i]);
    low[i] = std::max(static_cast<int>(std::floor((a - grid.low[i]) / grid.d[i])), 0);
    high[i] = std::min(static_cast<int>(std::floor((b - grid.low[i]) / grid.d[i])), grid.n[i] - 1);
  }
  std::array<int, 3> c{};
  for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) {
    for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
      for (c[0] = low[0]; c[0] <= high[0]; ++c[0]) {
        const std::size_t cell = grid.cell(c);
        for (int k = first_[cell]; k < first_[cell + 1]; ++k) {
          if (sides_[at_index(k)] != piece.side && is_hidden_by(sides_[at_index(k)], piece.middle, to)) return false;
        }
      }
    }
  }
  return true;
}

int PressureSampler::nearest(const SurfacePiece& piece, const std::array<int, 3>& middle, int reach) const {
  const StaggeredGrid& grid = domain_.grid;
  struct Candidate {
    double square;
    std::size_t cell;
  };
  std::vector<Candidate> candidates;
  std::array<int, 3> by{}, c{};
  const int across = grid.dim == 3 ? reach : 0;
  for (by[2] = -across; by[2] <= across; ++by[2]) {
    for (by[1] = -reach; by[1] <= reach; ++by[1]) {
      for (by[0] = -reach; by[0] <= reach; ++by[0]) {
        for (std::size_t i = 0; i < 3; ++i) c[i] = middle[i] + by[i];
        if (!grid.has_cell(c)) continue;
        const CellKind kind = domain_.kind[grid.cell(c)];
        if (kind != CellKind::fluid && kind != CellKind::empty) continue;
        const Vec<3> way = minus(grid.middle(c), piece.middle);
        if (dot(way, pieces_.area[at_index(piece.side)]) > 0) candidates.push_back({dot(way, way), grid.cell(c)});
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.square < b.square || (a.square == b.square && a.cell < b.cell);
  });
  for (const Candidate& candidate : candidates) {
    if (sees(piece, grid.middle(grid.place_of_cell(candidate.cell)))) return static_cast<int>(candidate.cell);
  }
  return -1;
}

int PressureSampler::cell_before(const SurfacePiece& piece) const {
  const StaggeredGrid& grid = domain_.grid;
  for (std::size_t i = 0; i < at_index(grid.dim); ++i) {
    if (piece.middle[i] < grid.low[i] || piece.middle[i] > grid.high(static_cast<int>(i))) return -1;
  }
  const Vec<3>& area = pieces_.area[at_index(piece.side)];
  const double size = std::sqrt(dot(area, area));
  if (size == 0) return -1;
  std::array<int, 3> middle{};
  for (std::size_t i = 0; i < at_index(grid.dim); ++i) {
    const double before = piece.middle[i] + 0.5 * grid.d[i] * area[i] / size;
    middle[i] = static_cast<int>(std::floor((before - grid.low[i]) / grid.d[i]));
  }
  const int near = nearest(piece, middle, 1);
  return near >= 0 ? near : nearest(piece, middle, 2);
}

int PressureSampler::joined(const std::array<int, 3>& cell, int axis, int end) const {
  auto face = cell, other = cell;
  face[at_index(axis)] += end, other[at_index(axis)] += end == 0 ? -1 : 1;
  if (!domain_.grid.has_cell(other)) return -1;
  const bool open = domain_.face[at_index(axis)][domain_.grid.face(axis, face)] == FaceKind::open;
  return open ? static_cast<int>(domain_.grid.cell(other)) : -1;
}

PressureStencil PressureSampler::at(const Vec<3>& x, std::size_t cell, double behind) const {
  const StaggeredGrid& grid = domain_.grid;
  const auto place = grid.place_of_cell(cell);
  const Vec<3> middle = grid.middle(place);
  PressureStencil stencil;
  stencil.add(cell, 1);
  for (int axis = 0; axis < grid.dim; ++axis) {
    const double away = std::clamp((x[at_index(axis)] - middle[at_index(axis)]) / grid.d[at_index(axis)], -1.0, 1.0);
    if (away == 0) continue;
    const int towards = joined(place, axis, away > 0 ? 1 : 0);
    const int away_from = towards < 0 ? joined(place, axis, away > 0 ? 0 : 1) : -1;
    if (towards < 0 && away_from < 0) continue;
    const double weight = towards >= 0 ? std::abs(away) : -behind * std::abs(away);
    stencil.weight[0] -= weight;
    stencil.add(at_index(towards >= 0 ? towards : away_from), weight);
  }
  return stencil;
}

namespace {

constexpr double at_side = 1e-6;  // of a cell: so near to a side a piece is at it

class BeforePieces {
 public:
  BeforePieces(const SurfacePieces& pieces, const FlowDomain& domain, const PressureSampler& sampler)
      : pieces_(pieces), domain_(domain), grid_(domain.grid), sampler_(sampler) {}

  /// `before` is the cell that the piece faces, or -1; a side counts where it is nearer than that one's middle.
  int side_before(const SurfacePiece& piece, int before) const {
    const Vec<3>& area = pieces_.area[at(piece.side)];
    const double size = std::sqrt(dot(area, area));
    if (size == 0 || !is_near_a_side(piece.middle)) return -1;
    const Vec<3> normal{area[0] / size, area[1] / size, area[2] / size};
    double nearest = before < 0 ? INFINITY : distance(piece.middle, before);
    int found = -1;
    for (int side = 0; side < 2 * grid_.dim; ++side) {
      const int axis = axis_of_side(side);
      if (std::abs(gap_to(side, piece.middle)) <= at_side * grid_.d[at(axis)] && is_open(side, piece.middle))
        return side;
      if ((normal[at(axis)] > 0) == is_low_side(side)) continue;
      const double way = way_to(side, piece.middle, normal);
      if (way < 0 || way >= nearest || !lets_out(side, piece, normal, way)) continue;
      found = side, nearest = way;
    }
    return found;
  }

 private:
  bool is_near_a_side(const Vec<3>& x) const {
    bool near = false;
    for (int side = 0; side < 2 * grid_.dim; ++side)
      near = near || std::abs(gap_to(side, x)) <= 0.5 * grid_.d[at(axis_of_side(side))];
    return near;
  }

  double distance(const Vec<3>& x, int cell) const {
    const Vec<3> way = minus(grid_.middle(grid_.place_of_cell(at(cell))), x);
    return std::sqrt(dot(way, way));
  }

  double gap_to(int side, const Vec<3>& x) const {
    const int axis = axis_of_side(side);
    return is_low_side(side) ? x[at(axis)] - grid_.low[at(axis)] : grid_.high(axis) - x[at(axis)];
  }

  /// Along the normal; -1: the side is half a cell away or more, or the normal does not lead there within a cell.
  double way_to(int side, const Vec<3>& x, const Vec<3>& normal) const {
    const int axis = axis_of_side(side);
    const double gap = gap_to(side, x), along = std::abs(normal[at(axis)]), d = grid_.d[at(axis)];
    return gap >= 0 && gap <= 0.5 * d && gap <= along * d && along > 0 ? gap / along : -1;
  }

  /// Returns whether the side is open at a place next to it but for solids, and no obstacle or void is before it.
  bool is_open(int side, const Vec<3>& x) const {
    const int axis = axis_of_side(side);
    std::array<int, 3> cell{};
    for (std::size_t i = 0; i < at(grid_.dim); ++i)
      cell[i] = static_cast<int>(std::floor((x[i] - grid_.low[i]) / grid_.d[i]));
    cell[at(axis)] = is_low_side(side) ? 0 : grid_.n[at(axis)] - 1;
    if (!grid_.has_cell(cell)) return false;
    const CellKind kind = domain_.kind[grid_.cell(cell)];
    if (kind != CellKind::fluid && kind != CellKind::solid) return false;
    if (!is_low_side(side)) ++cell[at(axis)];
    return domain_.sides->open(axis, grid_.face(axis, cell)) > 0;
  }

  /// Returns whether the side is open where the normal meets it, and no other solid is before it.
  bool lets_out(int side, const SurfacePiece& piece, const Vec<3>& normal, double way) const {
    Vec<3> x = piece.middle;
    for (std::size_t i = 0; i < at(grid_.dim); ++i) x[i] += way * normal[i];
    return is_open(side, x) && sampler_.sees(piece, x);
  }

  const SurfacePieces& pieces_;
  const FlowDomain& domain_;
  const StaggeredGrid& grid_;
  const PressureSampler& sampler_;
};

}  // namespace

std::vector<int> open_sides_before(Team& team, const SurfacePieces& pieces, const FlowDomain& domain,
                                   const PressureSampler& sampler, std::span<const int> before) {
  std::vector<int> sides(before.size(), -1);
  if (!domain.sides) return sides;
  const BeforePieces of(pieces, domain, sampler);
  team.each(0, sides.size(), [&](std::size_t k) { sides[k] = of.side_before(pieces.pieces[k], before[k]); });
  return sides;
}

}  // namespace tether::coupled
