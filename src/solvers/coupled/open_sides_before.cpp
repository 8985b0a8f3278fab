// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/open_sides_before.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "model/side_faces.hpp"

namespace tether::coupled {
namespace {

constexpr double rounding = 1e-6;  // of a cell: so near to a side a piece is at it

class BeforePieces {
 public:
  BeforePieces(const SurfacePieces& pieces, const FlowDomain& domain, const PressureSampler& sampler)
      : pieces_(pieces), domain_(domain), grid_(domain.grid), sampler_(sampler) {}

  /// `before` is the cell that the piece faces, or -1; a side counts where it is nearer than that one's middle.
  int side_before(const SurfacePiece& piece, int before) const {
    const Vector& area = pieces_.area[at(piece.side)];
    const double size = std::sqrt(dot(area, area));
    if (size == 0 || !is_near_a_side(piece.middle)) return -1;
    const Vector normal{area[0] / size, area[1] / size, area[2] / size};
    double nearest = before < 0 ? INFINITY : distance(piece.middle, before);
    int found = -1;
    for (int side = 0; side < 2 * grid_.dim; ++side) {
      const int axis = axis_of_side(side);
      if (std::abs(gap_to(side, piece.middle)) <= rounding * grid_.d[at(axis)] && is_open(side, piece.middle))
        return side;
      if ((normal[at(axis)] > 0) == is_low_side(side)) continue;
      const double way = way_to(side, piece.middle, normal);
      if (way < 0 || way >= nearest || !lets_out(side, piece, normal, way)) continue;
      found = side, nearest = way;
    }
    return found;
  }

 private:
  bool is_near_a_side(const Vector& x) const {
    bool near = false;
    for (int side = 0; side < 2 * grid_.dim; ++side)
      near = near || std::abs(gap_to(side, x)) <= 0.5 * grid_.d[at(axis_of_side(side))];
    return near;
  }

  double distance(const Vector& x, int cell) const {
    const Vector way = minus(grid_.middle(grid_.place_of_cell(at(cell))), x);
    return std::sqrt(dot(way, way));
  }

  double gap_to(int side, const Vector& x) const {
    const int axis = axis_of_side(side);
    return is_low_side(side) ? x[at(axis)] - grid_.low[at(axis)] : grid_.high(axis) - x[at(axis)];
  }

  /// Along the normal; -1: the side is half a cell away or more, or the normal does not lead there within a cell.
  double way_to(int side, const Vector& x, const Vector& normal) const {
    const int axis = axis_of_side(side);
    const double gap = gap_to(side, x), along = std::abs(normal[at(axis)]), d = grid_.d[at(axis)];
    return gap >= 0 && gap <= 0.5 * d && gap <= along * d && along > 0 ? gap / along : -1;
  }

  /// Whether the side is open at a place next to it but for solids, and no obstacle or void is before it.
  bool is_open(int side, const Vector& x) const {
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

  /// Where the normal meets the side: whether it is open, and no other solid is before it.
  bool lets_out(int side, const SurfacePiece& piece, const Vector& normal, double way) const {
    Vector x = piece.middle;
    for (std::size_t i = 0; i < at(grid_.dim); ++i) x[i] += way * normal[i];
    return is_open(side, x) && sampler_.sees(piece, x);
  }

  const SurfacePieces& pieces_;
  const FlowDomain& domain_;
  const StaggeredGrid& grid_;
  const PressureSampler& sampler_;
};

}  // namespace

std::vector<int> open_sides_before(const SurfacePieces& pieces, const FlowDomain& domain,
                                   const PressureSampler& sampler, std::span<const int> before) {
  std::vector<int> sides(before.size(), -1);
  if (!domain.sides) return sides;
  const BeforePieces of(pieces, domain, sampler);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    sides[k] = of.side_before(pieces.pieces[k], before[k]);
  }
  return sides;
}

}  // namespace tether::coupled
