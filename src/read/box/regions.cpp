// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/crossings.hpp"
#include "model/coupled.hpp"
#include "model/solids.hpp"
#include "read/box/checks.hpp"

namespace tether {
namespace {

constexpr double most = 1e-6;  // net over gross flux of a fluid that cannot leave
constexpr int times = 20;      // at which the balance is looked at, beside those of tables

/// What the box holds, bodies left aside: regions of cells that faces join, closed or not.
class Regions {
 public:
  explicit Regions(const Coupled& coupled) : coupled_(coupled), grid_(coupled.grid), sides_(coupled) {
    region_.assign(grid_.cell_count(), none);
    mark(coupled.voids, empty), mark(coupled.obstacles, wall);
    for (std::size_t c = 0; c < region_.size(); ++c) {
      if (region_[c] == none) fill(c);
    }
  }

  int count() const { return static_cast<int>(closed_.size()); }
  bool closed(int region) const { return closed_[static_cast<std::size_t>(region)]; }
  /// The middle of the region's first cell.
  Vec<3> place(int region) const {
    const auto found = std::find(region_.begin(), region_.end(), region) - region_.begin();
    const auto cell = grid_.place_of_cell(static_cast<std::size_t>(found));
    return {grid_.middle(0, cell[0]), grid_.middle(1, cell[1]), grid_.middle(2, cell[2])};
  }
  /// Area of the faces to a region that a jet, by its place among them, has.
  double area(std::size_t k, int region) const {
    const Jet& jet = coupled_.jets[k];
    const int axis = axis_of_side(jet.side);
    double area = 0;
    for (const FacePart& of_jet : faces_of(jet.side, jet.patch, grid_)) {
      if (region_[cell_at(jet.side, grid_, of_jet.face)] != region) continue;
      for (const JetShare& share : sides_.jets(axis, of_jet.face))
        area += share.jet == static_cast<int>(k) ? share.part * grid_.area(axis) : 0;
    }
    return area;
  }

 private:
  enum : int { none = -1, empty = -2, wall = -3 };

  void mark(const std::vector<Box<3>>& boxes, int kind) {
    for (std::size_t c = 0; c < region_.size() && !boxes.empty(); ++c) {
      const auto at = grid_.place_of_cell(c);
      const Vec<3> middle{grid_.middle(0, at[0]), grid_.middle(1, at[1]), grid_.middle(2, at[2])};
      if (std::any_of(boxes.begin(), boxes.end(), [&](const Box<3>& box) { return box.contains(middle); }))
        region_[c] = kind;
    }
  }
  /// Returns whether the fluid may leave through the box's side at a cell.
  bool open_side(const std::array<int, 3>& cell, int side) const {
    auto face = cell;
    const int axis = axis_of_side(side);
    if (!is_low_side(side)) ++face[static_cast<std::size_t>(axis)];
    return sides_.open(axis, grid_.face(axis, face)) > 0;
  }
  /// A new region of all cells that faces join with this one.
  void fill(std::size_t first) {
    const int region = count();
    closed_.push_back(true);
    std::vector<std::size_t> front{first};
    region_[first] = region;
    while (!front.empty()) {
      const auto cell = grid_.place_of_cell(front.back());
      front.pop_back();
      for (int side = 0; side < 2 * grid_.dim; ++side) {
        auto next = cell;
        next[static_cast<std::size_t>(axis_of_side(side))] += is_low_side(side) ? -1 : 1;
        if (!grid_.has_cell(next)) {
          if (open_side(cell, side)) closed_.back() = false;
          continue;
        }
        int& beside = region_[grid_.cell(next)];
        if (beside == empty) closed_.back() = false;
        if (beside != none) continue;
        beside = region;
        front.push_back(grid_.cell(next));
      }
    }
  }

  const Coupled& coupled_;
  const StaggeredGrid& grid_;
  SideFaces sides_;
  std::vector<int> region_;  // of each cell, or what it holds
  std::vector<bool> closed_;
};

/// Times at which the jets' balance is looked at [time].
std::vector<double> times_of(const Coupled& coupled, double tmax) {
  std::vector<double> all;
  for (int k = 0; k <= times; ++k) all.push_back(k * tmax / times);
  for (const Jet& jet : coupled.jets) {
    std::copy_if(jet.amplitude.time.begin(), jet.amplitude.time.end(), std::back_inserter(all),
                 [&](double t) { return t >= 0 && t <= tmax; });
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// What jets bring into a region.
struct Balance {
  double net = 0, gross = 0;
};

Balance balance_at(const Coupled& coupled, const std::vector<double>& areas, double t) {
  Balance balance;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (areas[k] == 0) continue;
    const double flux = areas[k] * coupled.jets[k].speed * coupled.jets[k].amplitude.at(t);
    balance.net += flux, balance.gross += std::abs(flux);
  }
  return balance;
}

/// "(x, y)" or "(x, y, z)".
std::string text_of(const Vec<3>& place, int dim) {
  return dim == 2 ? fmt::format("({:.6g}, {:.6g})", place[0], place[1])
                  : fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]);
}

void check_region(const Deck& deck, const Clock& clock, const Coupled& coupled, const Regions& regions, int region,
                  Diagnostics& diagnostics) {
  std::vector<double> areas;
  for (std::size_t k = 0; k < coupled.jets.size(); ++k) areas.push_back(regions.area(k, region));
  const auto first = std::find_if(areas.begin(), areas.end(), [](double area) { return area > 0; }) - areas.begin();
  for (const double t : times_of(coupled, clock.tmax)) {
    try {
      const Balance balance = balance_at(coupled, areas, t);
      if (std::abs(balance.net) <= most * balance.gross) continue;
      return diagnostics.add(deck.remark(
          Severity::error, "coupled.jet_on", {coupled.jets[static_cast<std::size_t>(first)].number, 1},
          fmt::format("the region about {} is closed, and at t = {:.6g} jets bring {:.6g} into it",
                      text_of(regions.place(region), coupled.grid.dim), t, balance.net),
          "a fluid keeps its volume: open a side, or let as much out by a jet of negative speed (volume per time)"));
    } catch (const RunError&) {
      // An expression without a value at a time that no step may ever ask for: the run reports it if one does.
    }
  }
}

}  // namespace

void check_coupled_regions(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics) {
  const Regions regions(coupled);
  if (regions.count() == 0) {
    const AnyVariable name = coupled.obstacles.empty() ? AnyVariable("coupled.void") : "coupled.obstacle";
    diagnostics.add(deck.remark(Severity::error, name, deck.given_elements(name).front(),
                                "no cell of the grid holds fluid: obstacles and voids fill the box",
                                "a cell belongs to the box that its middle lies in"));
  }
  if (coupled.cavities_only) {  // around which is nothing
    if (!encloses_cells(coupled, scene.solids()->mesh))
      diagnostics.add(deck.remark(Severity::error, "coupled.fluid_in", {1, 1},
                                  "the grid is all void: no body encloses a cell of it",
                                  "write fluid_in='box', or use more nodes"));
    return;
  }
  if (coupled.liquid && coupled.liquid->air == Air::empty) return;  // which a liquid takes the place of
  if (coupled.mesh && (!coupled.obstacles.empty() || !coupled.shaped.empty())) return;  // which leave gaps below a cell
  for (int region = 0; region < regions.count(); ++region) {
    if (regions.closed(region)) check_region(deck, scene.clock, coupled, regions, region, diagnostics);
  }
}

namespace {

/// Marks a cell that is not marked and all that steps from it lead to.
void fill(const StaggeredGrid& grid, const Crossings& crossings, std::size_t first, std::vector<bool>& marked) {
  if (marked[first]) return;
  std::vector<std::size_t> front{first};
  marked[first] = true;
  while (!front.empty()) {
    const auto cell = grid.place_of_cell(front.back());
    front.pop_back();
    for (int side = 0; side < 2 * grid.dim; ++side) {
      const int axis = axis_of_side(side);
      auto next = cell, face = cell;
      next[at(axis)] += is_low_side(side) ? -1 : 1;
      if (!is_low_side(side)) ++face[at(axis)];
      if (!grid.has_cell(next) || marked[grid.cell(next)] || crossings.lowest[at(axis)][grid.face(axis, face)] >= 0)
        continue;
      marked[grid.cell(next)] = true;
      front.push_back(grid.cell(next));
    }
  }
}

bool at_a_side(const StaggeredGrid& grid, const std::array<int, 3>& cell) {
  for (int axis = 0; axis < grid.dim; ++axis) {
    if (cell[at(axis)] == 0 || cell[at(axis)] == grid.n[at(axis)] - 1) return true;
  }
  return false;
}

}  // namespace

bool encloses_cells(const Coupled& coupled, const Mesh& mesh) {
  const StaggeredGrid& grid = coupled.grid;
  const Crossings crossings = find_crossings(surface_of(mesh), mesh.x, grid);
  std::vector<bool> marked(crossings.inside.begin(), crossings.inside.end());
  for (std::size_t c = 0; c < marked.size(); ++c) {
    const auto cell = grid.place_of_cell(c);
    const std::array middle{grid.middle(0, cell[0]), grid.middle(1, cell[1]), grid.middle(2, cell[2])};
    const auto holds = [&](const Box<3>& box) { return box.contains(middle); };
    if (std::any_of(coupled.obstacles.begin(), coupled.obstacles.end(), holds) ||
        std::any_of(coupled.voids.begin(), coupled.voids.end(), holds))
      marked[c] = true;
  }
  for (std::size_t c = 0; c < marked.size(); ++c) {
    if (at_a_side(grid, grid.place_of_cell(c))) fill(grid, crossings, c, marked);
  }
  return std::find(marked.begin(), marked.end(), false) != marked.end();
}

}  // namespace tether
