// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// The box about face i of a row of n cells, from one middle to the next, as places along the axis.
struct FaceBox {
  double low = 0, high = 0;
  double size() const { return high - low; }
};
FaceBox box_of(const StaggeredGrid& grid, int axis, int i) {
  const double place = grid.face_place(axis, i), half = 0.5 * grid.d[at(axis)];
  return {std::max(place - half, grid.low[at(axis)]), std::min(place + half, grid.high(axis))};
}

/// Adds to the boxes of a row what each piece of surface encloses beyond it along the axis: the solid's section grows
/// by -n dA there.
void add_enclosed(const SurfacePieces& pieces, const StaggeredGrid& grid, int axis, std::vector<double>& within,
                  std::vector<double>& sections) {
  for (const SurfacePiece& piece : pieces.pieces) {
    auto row = piece.cell;
    row[at(axis)] = 0;
    if (!grid.has_cell(row)) continue;
    const double normal = pieces.area[at(piece.side)][at(axis)];
    for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
      const double x = pieces.points[k].x[at(axis)], grows = -normal * pieces.points[k].part;
      const double box = std::floor((x - grid.low[at(axis)]) / grid.d[at(axis)] + 0.5);
      row[at(axis)] = static_cast<int>(std::clamp(box, 0.0, static_cast<double>(grid.n[at(axis)])));
      const FaceBox about = box_of(grid, axis, row[at(axis)]);
      const std::size_t f = grid.face(axis, row);
      within[f] += grows * std::clamp(about.high - x, 0.0, about.size());
      sections[f] += grows;
    }
  }
}

/// The fluid in the boxes of all faces across an axis.
std::vector<double> fluid_about_faces(const SurfacePieces& pieces, const StaggeredGrid& grid, int axis) {
  constexpr double rounding = 1e-9;  // of a box
  std::vector<double> solid(grid.face_count(axis), 0.0), sections(solid.size(), 0.0);
  add_enclosed(pieces, grid, axis, solid, sections);
  std::array<int, 3> rows = grid.n;
  rows[at(axis)] = 1;
  std::array<int, 3> place{};
  for (place[2] = 0; place[2] < rows[2]; ++place[2]) {
    for (place[1] = 0; place[1] < rows[1]; ++place[1]) {
      for (place[0] = 0; place[0] < rows[0]; ++place[0]) {
        double section = 0;
        for (auto face = place; face[at(axis)] <= grid.n[at(axis)]; ++face[at(axis)]) {
          const std::size_t f = grid.face(axis, face);
          const double length = box_of(grid, axis, face[at(axis)]).size(), whole = length * grid.area(axis);
          const double fluid = whole - solid[f] - section * length;
          section += sections[f];
          solid[f] = fluid < rounding * whole ? 0 : fluid > (1 - rounding) * whole ? whole : fluid;
        }
      }
    }
  }
  return solid;
}

/// Cells about a cell with how its fluid hangs together.
class Neighbourhood {
 public:
  explicit Neighbourhood(const FlowDomain& whole) : whole_(whole) {}

  /// Returns whether the fluid cells next to a cell (along `longer` next to it and to the one below it), corners
  /// included, hang together by way of cells no farther away than three. A wall hides what is on one side of a plate
  /// that meets it at an angle: there those one farther away count as well, where some are next to the cell.
  bool joined(const std::array<int, 3>& middle, int longer) {
    set_window(middle, longer, 1);
    if (meets_wall(middle, longer) && has_fluid()) set_window(middle, longer, 2);
    const auto first = low_, last = high_;
    set_window(middle, longer, reach);
    seen_.fill(0);
    bool started = false;
    std::array<int, 3> cell{};
    for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
      for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
        for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
          if (whole_.kind[whole_.grid.cell(cell)] != CellKind::fluid || seen_[number(cell)] != 0) continue;
          if (started) return false;
          started = true;
          reach_from(cell);
        }
      }
    }
    return true;
  }

 private:
  void set_window(const std::array<int, 3>& middle, int longer, int by) {
    low_ = middle, high_ = middle;
    for (int axis = 0; axis < whole_.grid.dim; ++axis) {
      low_[at(axis)] = std::max(middle[at(axis)] - by - (axis == longer ? 1 : 0), 0);
      high_[at(axis)] = std::min(middle[at(axis)] + by, whole_.grid.n[at(axis)] - 1);
    }
  }

  bool has_fluid() const {
    bool found = false;
    each_in_window([&](const std::array<int, 3>& cell) { found |= kind_of(cell) == CellKind::fluid; });
    return found;
  }

  /// Returns whether the window of those next to the cell leaves the box or has walls in it.
  bool meets_wall(const std::array<int, 3>& middle, int longer) const {
    for (int axis = 0; axis < whole_.grid.dim; ++axis) {
      const int below = 1 + (axis == longer ? 1 : 0);
      if (middle[at(axis)] < below || middle[at(axis)] + 1 == whole_.grid.n[at(axis)]) return true;
    }
    bool found = false;
    each_in_window([&](const std::array<int, 3>& cell) { found |= kind_of(cell) == CellKind::wall; });
    return found;
  }

  CellKind kind_of(const std::array<int, 3>& cell) const { return whole_.kind[whole_.grid.cell(cell)]; }

  template <class Function>
  void each_in_window(const Function& f) const {
    std::array<int, 3> cell{};
    for (cell[2] = low_[2]; cell[2] <= high_[2]; ++cell[2]) {
      for (cell[1] = low_[1]; cell[1] <= high_[1]; ++cell[1]) {
        for (cell[0] = low_[0]; cell[0] <= high_[0]; ++cell[0]) f(cell);
      }
    }
  }

  void reach_from(const std::array<int, 3>& seed) {
    reached_.assign(1, seed);
    seen_[number(seed)] = 1;
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      for (int axis = 0; axis < whole_.grid.dim; ++axis) {
        for (const int end : {0, 1}) {
          auto face = reached_[next], other = face;
          face[at(axis)] += end, other[at(axis)] += end == 0 ? -1 : 1;
          if (other[at(axis)] < low_[at(axis)] || other[at(axis)] > high_[at(axis)]) continue;
          if (whole_.face[at(axis)][whole_.grid.face(axis, face)] != FaceKind::open) continue;
          if (whole_.kind[whole_.grid.cell(other)] != CellKind::fluid) continue;
          if (std::exchange(seen_[number(other)], 1) == 0) reached_.push_back(other);
        }
      }
    }
  }

  std::size_t number(const std::array<int, 3>& cell) const {
    return at(cell[0] - low_[0] + most * (cell[1] - low_[1] + most * (cell[2] - low_[2])));
  }

  static constexpr int reach = 3, most = 2 * reach + 2;
  const FlowDomain& whole_;
  std::array<int, 3> low_{}, high_{};
  std::vector<std::array<int, 3>> reached_;
  std::array<std::uint8_t, std::size_t{most} * most * most> seen_{};
};

/// Returns whether the first and the last surface between two middles face away from each other, as a plate's do, not
/// as those at a corner.
bool is_plate(const SurfacePieces& pieces, const Crossings& crossings, int lowest, int highest) {
  constexpr double facing = -0.5;
  const Vec<3>&a = pieces.area[at(crossings.all[at(lowest)].side)],
        &b = pieces.area[at(crossings.all[at(highest)].side)];
  return dot(a, b) < facing * std::sqrt(dot(a, a) * dot(b, b));
}

/// Returns whether a plate lies in a cell: along some axis a surface is entered before and left after the cell's
/// middle.
bool holds_plate(const SurfacePieces& pieces, const Crossings& crossings, const StaggeredGrid& grid, std::size_t cell) {
  const auto place = grid.place_of_cell(cell);
  for (int axis = 0; axis < grid.dim; ++axis) {
    auto behind = place;
    ++behind[at(axis)];
    const int entered = crossings.highest[at(axis)][grid.face(axis, place)];
    const int left = crossings.lowest[at(axis)][grid.face(axis, behind)];
    if (entered >= 0 && left >= 0 && is_plate(pieces, crossings, entered, left)) return true;
  }
  return false;
}

/// Returns whether a plate lies between two cells of fluid; or between two of a solid is fluid of one side of it, and
/// that of the other is next to them: by way of the two, which it fills, both would join.
bool divides(const SurfacePieces& pieces, const Crossings& crossings, const FlowDomain& whole, const FaceValues& fluid,
             int axis, std::size_t f, Neighbourhood& about) {
  const auto [low, high] = cells_beside(whole.grid, axis, f);
  if (low < 0 || high < 0 || whole.kind[at(low)] != whole.kind[at(high)]) return false;
  const int lowest = crossings.lowest[at(axis)][f];
  switch (whole.kind[at(low)]) {
    case CellKind::fluid:
      if (lowest < 0) return false;
      if (is_plate(pieces, crossings, lowest, crossings.highest[at(axis)][f])) return true;
      break;
    case CellKind::solid:
      if (fluid[at(axis)][f] == 0) return false;
      break;
    default:
      return false;
  }
  return !about.joined(whole.grid.place_of_face(axis, f), axis);
}

std::vector<std::uint8_t> thin_cells(const SurfacePieces& pieces, const Crossings& crossings, const FlowDomain& whole,
                                     const FaceValues& fluid) {
  const StaggeredGrid& grid = whole.grid;
  std::vector<std::uint8_t> thin(grid.cell_count(), 0);
  Neighbourhood about(whole);
  for (std::size_t c = 0; c < thin.size(); ++c) {
    if (whole.kind[c] != CellKind::solid) continue;
    thin[c] = holds_plate(pieces, crossings, grid, c) || !about.joined(grid.place_of_cell(c), -1) ? 1 : 0;
  }
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t f = 0; f < grid.face_count(axis); ++f) {
      if (divides(pieces, crossings, whole, fluid, axis, f, about)) {
        for (const int cell : cells_beside(grid, axis, f)) thin[at(cell)] = 1;
      }
    }
  }
  return thin;
}

}  // namespace

CutCells cut_cells(const SurfacePieces& pieces, const Crossings& crossings, const FlowDomain& whole) {
  CutCells cut;
  for (int axis = 0; axis < whole.grid.dim; ++axis) cut.fluid[at(axis)] = fluid_about_faces(pieces, whole.grid, axis);
  cut.thin = thin_cells(pieces, crossings, whole, cut.fluid);
  return cut;
}

}  // namespace tether::coupled
