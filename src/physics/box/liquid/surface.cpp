// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/cut_faces.hpp"
#include "physics/box/flow_box.hpp"

namespace tether::liquid {
namespace {

using coupled::CellKind;
using coupled::FaceKind;
using coupled::FlowDomain;

constexpr double least_open = 0.5;     // of a hat: with less a cell takes the surface from those next to it
constexpr int layers_in_solids = 3;    // of cells that do
constexpr double least_liquid = 1e-3;  // of a face's box between liquid and air
constexpr double light_air = 1e-3;     // density of sealed air over the liquid's
constexpr double far_off = 0.5;        // cells from the surface, of cells that nothing reaches

/// The numbers of a row of cells along an axis with those beyond its ends, which walls mirror onto the last ones.
int mirrored(int i, int n) { return std::clamp(i, 0, n - 1); }

/// Adds to the hats of a row along x what a piece of surface at x, in cells from the first middle, has of the solid
/// beyond it: `grows` of the section, times the row's hat. `beyond` has what all cells from there on have.
void add_beyond(const StaggeredGrid& grid, const std::array<int, 3>& row, double x, double grows,
                std::vector<double>& within, std::vector<double>& beyond) {
  const int low = static_cast<int>(std::floor(x)), n = grid.n[0];
  const double s = x - low;
  const auto cell = [&](int i) { return grid.cell({mirrored(i, n), row[1], row[2]}); };
  within[cell(low)] += grows * 0.5 * (1 - s) * (1 - s);
  within[cell(low + 1)] += grows * ((low + 1 < n ? 1 : 0) - 0.5 * s * s);  // of the hat beyond the box its part in it
  if (low + 2 < n) beyond[cell(low + 2)] += grows;
}

/// Weights of a row of hats along an axis at a place: of the one below and the one above.
struct TwoHats {
  std::array<int, 2> cell;
  std::array<double, 2> weight;
};
TwoHats hats_at(const StaggeredGrid& grid, int axis, double x) {
  const double place = (x - grid.low[at(axis)]) / grid.d[at(axis)] - 0.5;
  const int low = static_cast<int>(std::floor(place)), n = grid.n[at(axis)];
  return {{mirrored(low, n), mirrored(low + 1, n)}, {low + 1 - place, place - low}};
}

void take_solids(const StaggeredGrid& grid, const coupled::SurfacePieces& pieces, std::vector<double>& open) {
  std::vector<double> within(open.size(), 0.0), beyond(open.size(), 0.0);
  for (const coupled::SurfacePiece& piece : pieces.pieces) {
    auto row = piece.cell;
    row[0] = 0;
    if (!grid.has_cell(row)) continue;
    const double section = -pieces.area[at(piece.side)][0] / grid.area(0);
    for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
      const coupled::SurfacePoint& point = pieces.points[k];
      const double x = std::clamp((point.x[0] - grid.low[0]) / grid.d[0], 0.0, double(grid.n[0])) - 0.5;
      const TwoHats y = hats_at(grid, 1, point.x[1]);
      const TwoHats z = grid.dim == 3 ? hats_at(grid, 2, point.x[2]) : TwoHats{{0, 0}, {1, 0}};
      for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t l = 0; l < 2; ++l) {
          const double weight = y.weight[j] * z.weight[l];
          if (weight != 0)
            add_beyond(grid, {0, y.cell[j], z.cell[l]}, x, section * point.part * weight, within, beyond);
        }
      }
    }
  }
  for (std::size_t c = 0; c < open.size(); ++c) {
    if (c % at(grid.n[0]) != 0) beyond[c] += beyond[c - 1];
    open[c] -= within[c] + beyond[c];
  }
}

/// An obstacle's cell takes its part of its own hat and of those around it.
void take_obstacles(const FlowDomain& room, std::vector<double>& open) {
  constexpr std::array parts{0.125, 0.75, 0.125};
  const StaggeredGrid& grid = room.grid;
  for (std::size_t c = 0; c < open.size(); ++c) {
    if (room.kind[c] != CellKind::wall) continue;
    const auto place = grid.place_of_cell(c);
    for (int k = grid.dim == 3 ? -1 : 0; k <= (grid.dim == 3 ? 1 : 0); ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const double part = parts[at(i + 1)] * parts[at(j + 1)] * (grid.dim == 3 ? parts[at(k + 1)] : 1);
          open[grid.cell({mirrored(place[0] + i, grid.n[0]), mirrored(place[1] + j, grid.n[1]),
                          mirrored(place[2] + k, grid.n[2])})] -= part;
        }
      }
    }
  }
}

}  // namespace

std::vector<double> open_parts(const FlowDomain& room, const coupled::SurfacePieces& pieces) {
  std::vector<double> open(room.grid.cell_count(), 1.0);
  take_solids(room.grid, pieces, open);
  take_obstacles(room, open);
  for (double& part : open) part = std::max(part, 0.0);  // solids may overlap
  return open;
}

namespace {

/// Makes hats of one cell hats of two: 1/4, 1/2, 1/4 along each axis.
std::vector<double> widened(const StaggeredGrid& grid, std::span<const double> hats) {
  std::vector<double> wide(hats.begin(), hats.end()), before;
  for (int axis = 0; axis < grid.dim; ++axis) {
    before = wide;
    const int n = grid.n[at(axis)];
    const std::size_t stride = grid.stride(axis);
    for (std::size_t c = 0; c < wide.size(); ++c) {
      const int i = grid.place_of_cell(c)[at(axis)];
      const double low = before[i == 0 ? c : c - stride], high = before[i == n - 1 ? c : c + stride];
      wide[c] = 0.25 * (low + 2 * before[c] + high);
    }
  }
  return wide;
}

/// The distance of a flat surface from the middle of a hat of so many cells that it leaves filled so far [cells].
double distance_of(double filled, double cells) {
  const double part = std::clamp(filled, 0.0, 1.0);
  return cells * (part >= 0.5 ? std::sqrt(2 * (1 - part)) - 1 : 1 - std::sqrt(2 * part));
}

/// The distance by a hat of one cell, which sees no farther than that: towards its end that by a hat of two, if it is
/// farther on the same side.
double with_range_of(double by_two, double by_one) {
  constexpr double sure = 0.5;  // cells
  const double doubt = std::clamp((std::abs(by_one) - sure) / (1 - sure), 0.0, 1.0);
  const double farther = std::max(std::copysign(by_two, by_one * by_two) - std::abs(by_one), 0.0);
  return by_one + std::copysign(doubt * farther, by_one);
}

}  // namespace

std::vector<double> surface_distances(const StaggeredGrid& grid, std::span<const double> filled,
                                      std::span<const double> open) {
  constexpr double least_divisor = 0.1, next_to_solid = 0.125;  // what a solid a cell away takes of a hat of two cells
  const std::vector<double> wide = widened(grid, filled), wide_open = widened(grid, open);
  std::vector<double> distance(wide.size());
  std::vector<std::uint8_t> known(wide.size());
  for (std::size_t c = 0; c < wide.size(); ++c) {
    const double narrow = std::clamp((1 - wide_open[c]) / next_to_solid, 0.0, 1.0);
    const double by_two = distance_of(wide[c] / std::max(wide_open[c], least_divisor), 2),
                 by_one = distance_of(filled[c] / std::max(open[c], least_divisor), 1);
    distance[c] = (1 - narrow) * by_two + narrow * with_range_of(by_two, by_one);
    known[c] = open[c] >= least_open ? 1 : 0;
  }
  known = coupled::extend_known(grid.dim, grid.n, std::move(known), layers_in_solids, distance, 1);
  for (std::size_t c = 0; c < known.size(); ++c) distance[c] = known[c] != 0 ? distance[c] : far_off;
  return distance;
}

namespace {

/// Marks the empty cells from which no open face leads out of the box, by way of others.
std::vector<std::uint8_t> sealed_cells(const FlowDomain& room, const std::vector<CellKind>& kind) {
  enum : std::uint8_t { unseen, seen, sealed };
  const StaggeredGrid& grid = room.grid;
  std::vector<std::uint8_t> mark(kind.size(), unseen);
  for (std::size_t seed = 0; seed < kind.size(); ++seed) {
    if (kind[seed] != CellKind::empty || mark[seed] != unseen) continue;
    std::vector<std::size_t> pocket{seed};
    mark[seed] = seen;
    bool open = false;
    for (std::size_t next = 0; next < pocket.size(); ++next) {
      const auto place = grid.place_of_cell(pocket[next]);
      for (int side = 0; side < 2 * grid.dim; ++side) {
        const int axis = axis_of_side(side);
        auto face = place, other = place;
        face[at(axis)] += side % 2, other[at(axis)] += side % 2 == 0 ? -1 : 1;
        if (room.face[at(axis)][grid.face(axis, face)] != FaceKind::open) continue;
        open = open || !grid.has_cell(other);
        if (!grid.has_cell(other) || kind[grid.cell(other)] != CellKind::empty) continue;
        if (std::exchange(mark[grid.cell(other)], seen) == unseen) pocket.push_back(grid.cell(other));
      }
    }
    for (const std::size_t cell : pocket) mark[cell] = open ? seen : sealed;
  }
  for (std::uint8_t& m : mark) m = m == sealed ? 1 : 0;
  return mark;
}

/// What a face between two cells at these distances moves, over a box full of liquid.
double moved_part(double a, double b) {
  if (a < 0 && b < 0) return 1;
  if (a >= 0 && b >= 0) return light_air;
  return std::max(std::min(a, b) / (std::min(a, b) - std::max(a, b)), least_liquid);
}

}  // namespace

bool moves_liquid(const FlowDomain& liquid, std::span<const double> distance, int axis, std::size_t face) {
  if (liquid.face[at(axis)][face] != FaceKind::open) return false;
  const auto [low, high] = coupled::cells_beside(liquid.grid, axis, face);
  return (low >= 0 && distance[at(low)] < 0) || (high >= 0 && distance[at(high)] < 0);
}

FlowDomain liquid_in(const FlowDomain& room, std::span<const double> distance, Air air) {
  FlowDomain domain = room;
  const StaggeredGrid& grid = room.grid;
  for (std::size_t c = 0; c < domain.kind.size(); ++c) {
    if (domain.kind[c] == CellKind::fluid && distance[c] >= 0) domain.kind[c] = CellKind::empty;
  }
  if (air == Air::sealed) {
    const std::vector<std::uint8_t> sealed = sealed_cells(room, domain.kind);
    for (std::size_t c = 0; c < sealed.size(); ++c) {
      if (sealed[c] != 0) domain.kind[c] = CellKind::fluid;
    }
  }
  const auto flows = [&](int c) { return c >= 0 && domain.kind[at(c)] == CellKind::fluid; };
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t f = 0; f < domain.face[at(axis)].size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::open) continue;
      const auto [low, high] = coupled::cells_beside(grid, axis, f);
      if (!flows(low) && !flows(high)) {
        domain.face[at(axis)][f] = FaceKind::closed;
        domain.area[at(axis)][f] = domain.volume[at(axis)][f] = 0;
        continue;
      }
      domain.volume[at(axis)][f] *= moved_part(distance[at(low < 0 ? high : low)], distance[at(high < 0 ? low : high)]);
    }
  }
  find_regions(domain);
  return domain;
}

}  // namespace tether::liquid
