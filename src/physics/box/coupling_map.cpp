// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/coupling_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/blocks.hpp"
#include "base/numbers.hpp"
#include "model/coupled.hpp"
#include "physics/box/film_pressures.hpp"
#include "physics/box/pressure_sampler.hpp"

namespace tether::coupled {
namespace {

/// What pieces of the surface add to a map: entries of B and of forces, by areas, and areas that are seen.
struct MapPart {
  explicit MapPart(std::size_t carriers) : fluxes(carriers), given(carriers) {}
  SideSums fluxes, given;
  std::vector<std::pair<int, double>> seen;
};

class MapByPressures {
 public:
  MapByPressures(Team& team, const CoupledSurface& of, const PressureSampler& sampler, const CutCells* cut)
      : team_(team), of_(of), sampler_(sampler), cut_(cut), dim_(of.surface.dim) {}

  CouplingMap map() {
    std::vector<int> before(of_.pieces.pieces.size());
    team_.each(0, before.size(), [&](std::size_t k) { before[k] = sampler_.cell_before(of_.pieces.pieces[k]); });
    open_side_ = open_sides_before(team_, of_.pieces, of_.domain, sampler_, before);
    const FilmPressures films(team_, {.surface = of_.surface,
                                      .q = sampler_.places(),
                                      .pieces = of_.pieces,
                                      .domain = of_.domain,
                                      .sampler = sampler_,
                                      .before = before,
                                      .open_side = open_side_});
    std::vector<MapPart> parts((before.size() + pieces_of_a_part - 1) / pieces_of_a_part,
                               MapPart(at(side_node_count_of(of_.surface.kind))));
    each_block(
        team_, before.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) add(k, before[k], films, parts[begin / pieces_of_a_part]);
        },
        pieces_of_a_part);
    return joined(parts);
  }

 private:
  static constexpr std::size_t pieces_of_a_part = 256;

  CouplingMap joined(std::span<MapPart> parts) const {
    std::vector<double> seen(at(of_.surface.sheets * of_.domain.regions), 0.0);
    MapSums sums;
    for (MapPart& part : parts) {
      sums.fluxes.push_back(part.fluxes.take()), sums.given.push_back(part.given.take());
      for (const auto& [k, area] : part.seen) seen[at(k)] += area;
    }
    CouplingMap map = map_of_sums(team_, of_.surface, EntriesAt::carriers, std::move(sums), of_.numbers.cell.size(),
                                  sampler_.places());
    map.area_seen = std::move(seen);
    return map;
  }

  void add(std::size_t number, int before, const FilmPressures& films, MapPart& to) const {
    const SurfacePiece& piece = of_.pieces.pieces[number];
    to.fluxes.begin(piece.side), to.given.begin(piece.side);
    if (open_side_[number] >= 0) {
      add_before_side(piece, open_side_[number], to);
    } else if (before >= 0) {
      add_before_cell(piece, at(before), to);
    } else {
      const auto pressure = films.on(number);
      add_film(piece, pressure, to);
      add_film_weight(piece, films, number, pressure, to);
      add_outside(piece, films, number, to);
    }
  }

  void add_before_cell(const SurfacePiece& piece, std::size_t before, MapPart& to) const {
    if (const int region = of_.domain.region[before]; region >= 0) see(piece, region, to);
    for (const SurfacePoint& point : std::span(of_.pieces.points).subspan(piece.first, piece.count)) {
      const PressureStencil whole = sampler_.at(point.x, before);
      for (int axis = 0; axis < dim_; ++axis) {
        PressureStencil stencil = whole;
        const double p = cut_ != nullptr ? take_cut(piece.cell, axis, point.x[at(axis)], stencil) : 0;
        push(piece, point, axis, p, CouplingMap::outside_row, to);
        add(piece.side, point, stencil, axis, to);
      }
    }
  }

  /// The pressure of the side, with parts of cells linear towards it from the cell that the piece is in.
  void add_before_side(const SurfacePiece& piece, int side, MapPart& to) const {
    for (const SurfacePoint& point : std::span(of_.pieces.points).subspan(piece.first, piece.count)) {
      for (int axis = 0; axis < dim_; ++axis) {
        PressureStencil stencil;
        double p = cut_ != nullptr ? take_cut(piece.cell, axis, point.x[at(axis)], stencil) : 0;
        if (stencil.size == 0 && of_.outside != nullptr) p = of_.outside->pressure_beyond(side, point.x[1]);
        push(piece, point, axis, p, CouplingMap::outside_row, to);
        add(piece.side, point, stencil, axis, to);
      }
    }
  }

  /// One pressure all over the piece. Parts of cells say nothing about what is thinner than half a cell.
  void add_film(const SurfacePiece& piece, const std::vector<std::pair<std::size_t, double>>& pressure,
                MapPart& to) const {
    const auto nodes = of_.surface.carriers(at(piece.side));
    CarrierShares share{};
    for (const SurfacePoint& point : std::span(of_.pieces.points).subspan(piece.first, piece.count)) {
      const CarrierShares at_point = shares(piece.side, point);
      for (std::size_t a = 0; a < nodes.size(); ++a) share[a] += point.part * at_point[a];
    }
    for (const auto& [cell, weight] : pressure) {
      const int row = of_.numbers.of_cell[cell];
      if (row < 0) continue;  // void
      double* sums = to.fluxes.row(row);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        for (std::size_t i = 0; i < at(dim_); ++i) sums[3 * a + i] -= weight * share[a];
      }
    }
  }

  /// Harmonic from rim to rim is what the pressure differs by from that at rest at the same height: from the heights of
  /// the rims, and of the cells whose pressures theirs are, to that of the piece it grows as that at rest does.
  void add_film_weight(const SurfacePiece& piece, const FilmPressures& films, std::size_t number,
                       const std::vector<std::pair<std::size_t, double>>& pressure, MapPart& to) const {
    if (of_.outside == nullptr) return;
    const auto at_rest = [&](const Vec<3>& x) { return of_.outside->at_rest(x); };
    double whole = films.outside_on(number, [](std::size_t) { return 1.0; });  // parts of rims, and these at rest
    double rims = films.outside_on(number, [&](std::size_t rim) { return at_rest(of_.pieces.pieces[rim].middle); });
    for (const auto& [cell, weight] : pressure) {
      if (of_.numbers.of_cell[cell] < 0) continue;  // void
      whole += weight, rims += weight * at_rest(of_.domain.grid.middle(of_.domain.grid.place_of_cell(cell)));
    }
    for (const SurfacePoint& point : std::span(of_.pieces.points).subspan(piece.first, piece.count)) {
      const double p = whole * at_rest(point.x) - rims;
      for (int axis = 0; axis < dim_; ++axis) push(piece, point, axis, p, CouplingMap::film_weight_row, to);
    }
  }

  /// The pressure of the fluid outside on what is beyond an open side, and its share of that in a film.
  void add_outside(const SurfacePiece& piece, const FilmPressures& films, std::size_t number, MapPart& to) const {
    if (of_.outside == nullptr) return;
    const int beyond = side_before(piece.middle);
    const double in_film = beyond >= 0 ? 0 : films.outside_on(number, [&](std::size_t rim) {
      const Vec<3>& x = of_.pieces.pieces[rim].middle;
      const int side = open_side_[rim] >= 0 ? open_side_[rim] : side_before(x);
      return side < 0 ? 0 : of_.outside->pressure_beyond(side, x[1]);
    });
    for (const SurfacePoint& point : std::span(of_.pieces.points).subspan(piece.first, piece.count)) {
      const double p = beyond >= 0 ? of_.outside->pressure_beyond(beyond, point.x[1]) : in_film;
      for (int axis = 0; axis < dim_; ++axis) push(piece, point, axis, p, CouplingMap::outside_row, to);
    }
  }

  /// Of the carriers in the motion of a point, and in the force on it.
  CarrierShares shares(int side, const SurfacePoint& point) const { return of_.surface.carried(at(side), point.share); }

  /// Adds the force of a pressure p on what a point stands for to those that are given.
  void push(const SurfacePiece& piece, const SurfacePoint& point, int axis, double p, int row, MapPart& to) const {
    if (p == 0) return;
    const CarrierShares share = shares(piece.side, point);
    double* sums = to.given.row(row);
    for (std::size_t a = 0; a < of_.surface.carriers(at(piece.side)).size(); ++a)
      sums[3 * a + at(axis)] -= share[a] * point.part * p;
  }

  /// The side of the box that a place is beyond, of several the last that fluid is outside of; -1: none.
  int side_before(const Vec<3>& x) const {
    const StaggeredGrid& grid = of_.domain.grid;
    int beyond = -1;
    for (int side = 0; side < 2 * dim_; ++side) {
      const int axis = axis_of_side(side);
      const bool is_beyond = is_low_side(side) ? x[at(axis)] < grid.low[at(axis)] : x[at(axis)] > grid.high(axis);
      if (is_beyond && (beyond < 0 || of_.outside->presses(side))) beyond = side;
    }
    return beyond;
  }

  void see(const SurfacePiece& piece, int region, MapPart& to) const {
    const Vec<3>& area = of_.pieces.area[at(piece.side)];
    double part = 0;
    for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) part += of_.pieces.points[k].part;
    to.seen.emplace_back(of_.surface.sheet[at(piece.side)] * of_.domain.regions + region,
                         part * std::sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]));
  }

  void add(int side, const SurfacePoint& point, const PressureStencil& stencil, int axis, MapPart& to) const {
    const std::size_t nodes = of_.surface.carriers(at(side)).size();
    const CarrierShares share = shares(side, point);
    for (std::size_t s = 0; s < stencil.size; ++s) {
      const int row = of_.numbers.of_cell[stencil.cell[s]];
      if (row < 0) continue;  // void
      double* sums = to.fluxes.row(row);
      for (std::size_t a = 0; a < nodes; ++a) sums[3 * a + at(axis)] -= stencil.weight[s] * share[a] * point.part;
    }
  }

  /// Between the middles on both sides of x along the axis, in the row of the piece's cell; at walls, and where the
  /// other cell has no fluid or there is none between the two, constant; to that outside at open sides, whose part is
  /// returned. Nothing where a cell is thin.
  double take_cut(std::array<int, 3> cell, int axis, double x, PressureStencil& stencil) const {
    const StaggeredGrid& grid = of_.domain.grid;
    const double box = (x - grid.low[at(axis)]) / grid.d[at(axis)] - 0.5;
    const int low = static_cast<int>(std::floor(box));
    for (std::size_t i = 0; i < 3; ++i) cell[i] = std::clamp(cell[i], 0, grid.n[i] - 1);  // of a piece in a side
    std::array<int, 2> around{};
    for (const int end : {0, 1}) {
      cell[at(axis)] = low + end;
      around[at(end)] = grid.has_cell(cell) ? static_cast<int>(grid.cell(cell)) : -1;
    }
    cell[at(axis)] = low + 1;
    const bool open = of_.domain.face[at(axis)][grid.face(axis, cell)] == FaceKind::open;
    for (const int c : around) {
      if (c >= 0 && cut_->thin[at(c)] != 0) return 0;
    }
    const auto holds = [&](int c) { return c >= 0 && of_.domain.kind[at(c)] == CellKind::fluid; };
    const auto [a, b] = around;
    const double t = box - low;
    PressureStencil linear;
    if (open && a >= 0 && b >= 0) {
      linear.add(at(a), 1 - t), linear.add(at(b), t);
    } else if (open) {
      linear.add(at(std::max(a, b)), a < 0 ? 2 * t - 1 : 1 - 2 * t);
    } else if (holds(std::max(a, b)) && lets_out(axis, cell, a, b)) {
      stencil = {};  // next to nothing is left of the fluid before the side
      return pressure_beyond(axis, cell, a);
    } else if (holds(a) || holds(b)) {
      const bool lower = holds(a) && (t < 0.5 || !holds(b));  // both: at the end of a box without fluid
      linear.add(at(lower ? a : b), 1);
    } else {
      return 0;
    }
    stencil = linear;
    if (!open || of_.outside == nullptr || (a >= 0 && b >= 0)) return 0;
    return (1 - linear.weight[0]) * pressure_beyond(axis, cell, a);
  }

  /// Returns whether the face is one of the box's sides, open but for solids.
  bool lets_out(int axis, const std::array<int, 3>& face, int low, int high) const {
    if (low >= 0 && high >= 0) return false;
    return of_.domain.sides && of_.domain.sides->open(axis, of_.domain.grid.face(axis, face)) > 0;
  }
  double pressure_beyond(int axis, const std::array<int, 3>& face, int low) const {
    if (of_.outside == nullptr) return 0;
    const StaggeredGrid& grid = of_.domain.grid;
    const double y = axis == 1 ? grid.face_place(1, face[1]) : grid.middle(1, face[1]);
    return of_.outside->pressure_beyond(2 * axis + (low < 0 ? 0 : 1), y);
  }

  Team& team_;
  const CoupledSurface& of_;
  const PressureSampler& sampler_;
  const CutCells* cut_;
  int dim_;
  std::vector<int> open_side_;  // of each piece the one straight before it
};

}  // namespace

PressureNumbers number_pressures(const FlowDomain& domain) {
  PressureNumbers numbers;
  numbers.of_cell.assign(domain.kind.size(), -1);
  for (std::size_t c = 0; c < domain.kind.size(); ++c) {
    if (domain.kind[c] != CellKind::fluid) continue;
    numbers.of_cell[c] = static_cast<int>(numbers.cell.size());
    numbers.cell.push_back(c);
  }
  return numbers;
}

CouplingMap map_of_sums(Team& team, const SolidSurface& surface, EntriesAt where, MapSums sums, std::size_t pressures,
                        std::span<const double> q) {
  CouplingMap map;
  map.fluxes = SideMatrix(team, surface, where, std::move(sums.fluxes), pressures, q.size());
  map.given = SideMatrix(team, surface, where, std::move(sums.given), 2, q.size());
  map.turn(team, areas_of_sides(surface, q));
  return map;
}

void CouplingMap::turn(Team& team, std::span<const Vec<3>> area) {
  B = fluxes.with(team, area);
  const CouplingMatrix forces = given.with(team, area);
  outside.assign(static_cast<std::size_t>(B.cols()), 0.0), film_weight = outside;
  for (const auto& [row, of_nodes] : {std::pair{outside_row, &outside}, std::pair{film_weight_row, &film_weight}}) {
    for (CouplingMatrix::InnerIterator entry(forces, row); entry; ++entry)
      (*of_nodes)[static_cast<std::size_t>(entry.col())] = entry.value();
  }
}

CouplingMap map_by_pressures(Team& team, const CoupledSurface& of, const PressureSampler& sampler,
                             const CutCells* cut) {
  return MapByPressures(team, of, sampler, cut).map();
}

}  // namespace tether::coupled
