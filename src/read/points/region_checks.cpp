// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/region_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "read/bodies.hpp"
#include "read/points/region_extent.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// A region of points: its number (from 1), what the deck draws, and the body that its points are.
struct FilledRegion {
  int number = 0;
  RegionShape shape;
  const Body* body = nullptr;
  Extent drawn, filled;  // filled: by its points
};

std::vector<FilledRegion> filled_regions(const Deck& deck, const Scene& scene) {
  std::vector<FilledRegion> regions;
  for (const int r : regions_of(deck)) {
    const auto named = [r](const Body& body) { return body.name == fmt::format("region {}", r); };
    const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(), named);
    const auto shape = body == scene.bodies.end() ? std::nullopt : region_shape(deck, r);
    if (!shape) continue;
    const auto begin = scene.points.volume.begin() + static_cast<std::ptrdiff_t>(body->first);
    const double point = scene.grid.dx * scene.grid.dy / (body->lattice * body->lattice);
    regions.push_back({.number = r,
                       .shape = *shape,
                       .body = &*body,
                       .drawn = drawn_extent(*shape, scene.grid, scene.geometry),
                       .filled = {point * static_cast<double>(body->count),
                                  std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(body->count), 0.0)}});
  }
  return regions;
}

/// Part by which the volume of a region's points may differ from that of its shape before it is warned of. Of the
/// thesis' boxes, columns left aside, all regions but four are within 1 %; one of these is 2.6 % off, the others 5 to
/// 10 %.
constexpr double told_difference = 0.03;

void tell(Severity severity, const Deck& deck, int region, const std::string& message, const std::string& hint,
          Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(severity, "reg.xvi", {1, region}, fmt::format("region {}: {}", region, message), hint));
}

/// Checks how a region is filled. What a region's points hold differs from what is drawn by up to half a lattice
/// spacing at each of its sides. Across a grid of one cell that does no harm: such a column is as wide as its points,
/// and nothing moves across it.
void check_filling(const Deck& deck, const FilledRegion& region, const Scene& scene, Diagnostics& diagnostics) {
  const double ratio = region.filled.volume / region.drawn.volume;
  if (!(std::abs(ratio - 1) > told_difference)) return;
  const BackgroundGrid& grid = scene.grid;
  const bool column = grid.cells_x() == 1 || grid.cells_y() == 1;
  const double density = region.body->density;
  const int lattice = region.body->lattice;
  tell(column ? Severity::remark : Severity::warning, deck, region.number,
       fmt::format("its points hold an area of {:.4g} where {:.4g} is drawn, and so its mass is {:.4g} in place of "
                   "{:.4g}, {:+.1f} %",
                   region.filled.area, region.drawn.area, density * region.filled.volume, density * region.drawn.volume,
                   100 * (ratio - 1)),
       fmt::format("each point is a cell's 1/{}, {:.3g} x {:.3g}: draw sides along lines of these, use a finer grid or "
                   "more points per cell (nprg), or weigh it right by densir = {:.4g}",
                   lattice * lattice, grid.dx / lattice, grid.dy / lattice, density / ratio),
       diagnostics);
}

/// Two regions share space from an area of one point on: what is less holds none, but by chance.
void check_sharing(const Deck& deck, const FilledRegion& one, const FilledRegion& other, const Scene& scene,
                   Diagnostics& diagnostics) {
  const double shared = shared_extent(one.shape, other.shape, scene.grid, scene.geometry).area;
  const int lattice = std::max(one.body->lattice, other.body->lattice);
  if (shared < scene.grid.dx * scene.grid.dy / (lattice * lattice)) return;
  const double smaller = std::min(one.drawn.area, other.drawn.area);
  tell(Severity::warning, deck, other.number,
       fmt::format("it shares an area of {:.4g} with region {}, {:.3g} % of the smaller one: what is there has the "
                   "points and the mass of both",
                   shared, one.number, 100 * shared / smaller),
       "draw them apart, or cut one out of the other by rix, riy", diagnostics);
}

/// Cells by where they are: within a cell of a closed membrane, inside or outside.
class SidesOfMembrane {
 public:
  SidesOfMembrane(const Scene& scene, const Body& membrane)
      : grid_(scene.grid), near_(scene.grid.cells()), inside_(scene.grid.cells()) {
    for (std::size_t p = membrane.first; p < membrane.first + membrane.count; ++p) {
      outline_.x.push_back(scene.points.x[p]), outline_.y.push_back(scene.points.y[p]);
    }
    for (std::size_t k = 0, before = membrane.count - 1; k < membrane.count; before = k++) mark_along(before, k);
    for (int j = 0; j < grid_.cells_y(); ++j) find_inside(j);
  }
  bool near(double x, double y) const { return near_[number(column(x), row(y))]; }
  bool inside(double x, double y) const {
    return near(x, y) ? outline_.contains(x, y) : inside_[number(column(x), row(y))];
  }

 private:
  int column(double x) const { return std::clamp(static_cast<int>((x - grid_.x0) / grid_.dx), 0, grid_.cells_x() - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - grid_.y0) / grid_.dy), 0, grid_.cells_y() - 1); }
  std::size_t number(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.cells_x()) + static_cast<std::size_t>(i);
  }
  /// Cells next to the straight line between two points of the membrane, which may be cells apart.
  void mark_along(std::size_t a, std::size_t b) {
    const double x = outline_.x[b] - outline_.x[a], y = outline_.y[b] - outline_.y[a];
    const int steps = 1 + static_cast<int>(2 * std::max(std::abs(x) / grid_.dx, std::abs(y) / grid_.dy));
    for (int k = 0; k < steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      mark_around(column(outline_.x[a] + s * x), row(outline_.y[a] + s * y));
    }
  }
  void mark_around(int i, int j) {
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, grid_.cells_y() - 1); ++b) {
      for (int a = std::max(i - 1, 0); a <= std::min(i + 1, grid_.cells_x() - 1); ++a) near_[number(a, b)] = true;
    }
  }
  /// Cells of a row that no cell next to the membrane parts are on one side of it.
  void find_inside(int j) {
    for (int i = 0; i < grid_.cells_x(); ++i) {
      if (near_[number(i, j)]) continue;
      const bool goes_on = i > 0 && !near_[number(i - 1, j)];
      inside_[number(i, j)] = goes_on
                                  ? static_cast<bool>(inside_[number(i - 1, j)])
                                  : outline_.contains(grid_.x0 + (i + 0.5) * grid_.dx, grid_.y0 + (j + 0.5) * grid_.dy);
    }
  }

  const BackgroundGrid& grid_;
  std::vector<bool> near_, inside_;
  Polygon outline_;
};

/// A region's gas that is on both sides of a closed membrane, a cell or more from it.
void check_gas_around(const Deck& deck, const FilledRegion& region, const Scene& scene, const Body& membrane,
                      const SidesOfMembrane& sides, Diagnostics& diagnostics) {
  const Body& gas = *region.body;
  const PointSet& P = scene.points;
  double outside = 0;
  bool far_inside = false, far_outside = false;
  for (std::size_t p = gas.first; p < gas.first + gas.count; ++p) {
    const bool inside = sides.inside(P.x[p], P.y[p]), far = !sides.near(P.x[p], P.y[p]);
    far_inside |= far && inside, far_outside |= far && !inside;
    if (!inside) outside += P.volume[p];
  }
  if (!far_inside || !far_outside) return;
  tell(
      Severity::warning, deck, region.number,
      fmt::format("{:.3g} % of its gas lies outside {}, which is closed: nothing holds it there, and it spreads to the "
                  "edges of the grid",
                  100 * outside / region.filled.volume, membrane.name),
      "draw the gas inside the membrane, or give the gas outside a region of its own, as far as walls that hold it",
      diagnostics);
}

}  // namespace

void check_regions(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const auto regions = filled_regions(deck, scene);
  for (std::size_t k = 0; k < regions.size(); ++k) {
    check_filling(deck, regions[k], scene, diagnostics);
    for (std::size_t before = 0; before < k; ++before)
      check_sharing(deck, regions[before], regions[k], scene, diagnostics);
  }
  for (const Body& membrane : scene.bodies) {
    if (!membrane.closed) continue;
    const SidesOfMembrane sides(scene, membrane);
    for (const FilledRegion& region : regions) {
      if (std::holds_alternative<IdealGas>(region.body->material))
        check_gas_around(deck, region, scene, membrane, sides, diagnostics);
    }
  }
}

std::string regions_text(const Deck& deck, const Scene& scene) {
  std::string text;
  for (const FilledRegion& region : filled_regions(deck, scene)) {
    const double density = region.body->density, off = 100 * (region.filled.volume / region.drawn.volume - 1);
    const std::string drawn =
        fmt::format("{:.6g} and {:.6g}: {:+.1f} %", region.drawn.area, density * region.drawn.volume, off);
    text += fmt::format("region {}: its points hold an area of {:.6g} and a mass of {:.6g}, {}\n", region.number,
                        region.filled.area, density * region.filled.volume,
                        std::abs(off) < 0.05 ? "as drawn" : "drawn are " + drawn);
  }
  return text;
}

}  // namespace tether
