// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "read/bodies.hpp"
#include "read/limits.hpp"
#include "read/materials.hpp"
#include "read/points/geometry.hpp"

namespace tether {
namespace {

/// Reads one region's values and reports what is wrong with them at their places.
class RegionReader {
 public:
  RegionReader(const Deck& deck, int r, Diagnostics& diagnostics) : deck_(deck), r_(r), diagnostics_(diagnostics) {}

  double real(AnyVariable name) const { return deck_.real(name, r_); }
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) const {
    diagnostics_.add(deck_.remark(Severity::error, name, at, fmt::format("region {}: {}", r_, message), hint));
  }
  std::optional<RegionShape> shape() const {
    const int vertices = deck_.integer("reg.nvi", r_);
    if (vertices < 3) {
      error("reg.nvi", {r_, 1}, fmt::format("a polygon has at least 3 vertices, not {}", vertices),
            "give nvi, xvi and yvi");
      return std::nullopt;
    }
    RegionShape shape;
    for (int k = 1; k <= vertices; ++k) {
      if (!vertex_given(k)) return std::nullopt;
      shape.polygon.x.push_back(deck_.real("reg.xvi", k, r_));
      shape.polygon.y.push_back(deck_.real("reg.yvi", k, r_));
    }
    if (const auto sides = shape.polygon.crossing()) {
      const auto text = [vertices](std::size_t k) {
        return fmt::format("{}-{}", k + 1, (k + 1) % static_cast<std::size_t>(vertices) + 1);
      };
      error("reg.xvi", {static_cast<int>(sides->second) + 1, r_},
            fmt::format("its outline crosses itself: side {} of its vertices passes through side {}",
                        text(sides->second), text(sides->first)),
            "vertices go round the region in their order");
      return std::nullopt;
    }
    shape.outer = {real("reg.xcenter"), real("reg.ycenter"), real("reg.rex"), real("reg.rey")};
    shape.inner = {real("reg.xcenter"), real("reg.ycenter"), real("reg.rix"), real("reg.riy")};
    return shape;
  }
  /// Points along one side of a cell, or 0 where nprg is no square.
  int lattice() const {
    const int nprg = deck_.integer("reg.nprg", r_);
    const long long side = std::lround(std::sqrt(nprg));
    if (side * side == nprg) return static_cast<int>(side);
    error("reg.nprg", {r_, 1}, fmt::format("nprg = {} is no square", nprg),
          "points per cell: 1, 4, 9, 16, 25, 36, 49, 64 ...");
    return 0;
  }
  double density() const {
    if (deck_.given("reg.densir", r_)) return real("reg.densir");
    error("reg.densir", {r_, 1}, fmt::format("densir({}) is not given", r_), "every region needs its density");
    return 1;
  }
  /// Initial specific internal energy, of a gas only.
  double energy(const Material& material) const {
    if (!std::holds_alternative<IdealGas>(material)) return 0;
    if (!deck_.given("fluid.siep", r_)) {
      error("reg.ipath", {4, r_}, fmt::format("a gas needs siep({}), its initial specific internal energy", r_),
            "give it in $fluid");
    }
    return deck_.real("fluid.siep", r_);
  }

 private:
  bool vertex_given(int k) const {
    for (const AnyVariable name : Variables{"reg.xvi", "reg.yvi"}) {
      if (deck_.given(name, k, r_)) continue;
      error("reg.nvi", {r_, 1}, fmt::format("{}({},{}) is not given", name, k, r_),
            "nvi vertices need an x and a y each");
      return false;
    }
    return true;
  }

  const Deck& deck_;
  int r_;
  Diagnostics& diagnostics_;
};

/// Cells from the one that holds `low` to the one that holds `high`, clipped to the grid; empty where first > last.
struct CellSpan {
  int first, last;
  CellSpan(const std::vector<double>& vertices, double origin, double size, int cells) {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end());
    first = static_cast<int>(std::clamp(std::floor((*low - origin) / size), 0.0, static_cast<double>(cells)));
    last = static_cast<int>(std::clamp(std::floor((*high - origin) / size), -1.0, cells - 1.0));
  }
  double count() const { return std::max(0.0, 1.0 + last - first); }
};

struct Lattice {
  int side;
  double area;  // of a sub-cell [length2]
  double density, vx, vy;
  Geometry geometry;
};

void append(PointSet& points, double x, double y, const Lattice& lattice) {
  const double volume = lattice.area * depth(lattice.geometry, x);
  points.x.push_back(x), points.y.push_back(y);
  points.vx.push_back(lattice.vx), points.vy.push_back(lattice.vy);
  points.sxx.push_back(0), points.syy.push_back(0), points.sxy.push_back(0);
  points.volume.push_back(volume), points.mass.push_back(lattice.density * volume);
}

void fill_cell(int i, int j, const BackgroundGrid& grid, const RegionShape& shape, const Lattice& lattice,
               PointSet& points) {
  for (int b = 0; b < lattice.side; ++b) {
    for (int a = 0; a < lattice.side; ++a) {
      const double x = grid.x0 + (i + (a + 0.5) / lattice.side) * grid.dx;
      const double y = grid.y0 + (j + (b + 0.5) / lattice.side) * grid.dy;
      if (shape.contains(x, y)) append(points, x, y, lattice);
    }
  }
}

/// What a region's values say of it, whatever the grid.
struct RegionValues {
  std::optional<RegionShape> shape;
  std::optional<Material> material;
  int side;  // points along one side of a cell
  double density, energy;
};

/// Nothing where there are mistakes, which are reported.
std::optional<RegionValues> read_region(const RegionReader& reader, const Deck& deck, int r, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.errors().size();
  RegionValues values{.shape = reader.shape(),
                      .material = region_material(deck, r, diagnostics),
                      .side = reader.lattice(),
                      .density = reader.density(),
                      .energy = 0};
  if (values.material) values.energy = reader.energy(*values.material);
  if (diagnostics.errors().size() > errors_before) return std::nullopt;
  return values;
}

}  // namespace

void check_region(const Deck& deck, int r, Diagnostics& diagnostics) {
  read_region(RegionReader(deck, r, diagnostics), deck, r, diagnostics);
}

std::optional<RegionShape> region_shape(const Deck& deck, int r) {
  Diagnostics reported_before;
  return RegionReader(deck, r, reported_before).shape();
}

void add_region(const Deck& deck, int r, Scene& scene, Diagnostics& diagnostics) {
  const RegionReader reader(deck, r, diagnostics);
  const auto values = read_region(reader, deck, r, diagnostics);
  if (!values) return;
  const auto& [shape, material, side, density, energy] = *values;

  const BackgroundGrid& grid = scene.grid;
  const CellSpan columns(shape->polygon.x, grid.x0, grid.dx, grid.cells_x());
  const CellSpan rows(shape->polygon.y, grid.y0, grid.dy, grid.cells_y());
  const double there = static_cast<double>(scene.points.size());
  const std::string too_large = memory_refusal(grid, there + columns.count() * rows.count() * side * side);
  if (!too_large.empty())
    return reader.error("reg.nprg", {r, 1}, too_large, "use fewer points per cell or a coarser grid");

  const double area = grid.dx * grid.dy / (side * side);
  const Lattice lattice{side, area, density, reader.real("reg.vrx"), reader.real("reg.vry"), scene.geometry};
  const std::size_t first = scene.points.size();
  for (int j = rows.first; j <= rows.last; ++j) {
    for (int i = columns.first; i <= columns.last; ++i) fill_cell(i, j, grid, *shape, lattice, scene.points);
  }
  const std::size_t count = scene.points.size() - first;
  if (count == 0) {
    const bool outside = columns.count() * rows.count() == 0;
    return reader.error("reg.xvi", {1, r}, outside ? "it lies wholly outside the grid" : "it holds no point",
                        outside ? fmt::format("the grid spans x {:.6g} to {:.6g}, y {:.6g} to {:.6g}", grid.x0, grid.x1,
                                              grid.y0, grid.y1)
                                : "check its vertices, its ellipses and nprg");
  }
  scene.bodies.push_back({fmt::format("region {}", r), *material, density, energy, first, count, false, side});
}

}  // namespace tether
