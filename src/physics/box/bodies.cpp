// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/bodies.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/numbers.hpp"
#include "model/solids.hpp"

namespace tether::coupled {
namespace {

constexpr double infinity = 1e300;

/// Lowest and highest places of a body's surface.
struct Extent {
  Vec<3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

std::vector<Extent> extents_of(const SolidSurface& surface, std::span<const double> q) {
  std::vector<Extent> extents(at(surface.parts));
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    Extent& of = extents[at(surface.part[s])];
    for (const int node : surface.side(s)) {
      const Vec<3> x = place_of(q, node, surface.dim);
      for (std::size_t i = 0; i < 3; ++i)
        of.low[i] = std::min(of.low[i], x[i]), of.high[i] = std::max(of.high[i], x[i]);
    }
  }
  return extents;
}

const char* hint_of(const Coupled& scene, int side) {
  if (scene.sides[at(side)] == BoxSide::empty || scene.cavities_only)
    return "nothing acts on it there but gravity and what holds it";
  return "there the pressure outside acts on it, but no fluid has to move with it; a tank open to the air has "
         "side='void', and where there is gravity level of $coupled says how high the fluid outside stands";
}

}  // namespace

std::vector<int> sides_left_by(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid) {
  std::vector<int> sides;
  for (const Extent& of : extents_of(surface, q)) {
    int beyond = -1;
    for (int axis = 0; axis < grid.dim; ++axis) {
      if (of.high[at(axis)] < grid.low[at(axis)]) beyond = 2 * axis;
      if (of.low[at(axis)] > grid.high(axis)) beyond = 2 * axis + 1;
    }
    sides.push_back(beyond);
  }
  return sides;
}

std::string leaving_text(const Coupled& scene, const SolidSurface& surface, std::span<const double> q, int body,
                         int side) {
  const Extent of = extents_of(surface, q)[at(body)];
  const auto middle = [&](std::size_t i) { return 0.5 * (of.low[i] + of.high[i]); };
  return fmt::format("body {} has left the box by its {} and is about ({:.6g}, {:.6g}{}): {}", body + 1,
                     box_side_names[at(side)], middle(0), middle(1),
                     surface.dim == 3 ? fmt::format(", {:.6g}", middle(2)) : "", hint_of(scene, side));
}

ThinBodies thin_bodies(const Placement& placed, const SolidSurface& surface) {
  ThinBodies found;
  const auto& thin = placed.thin;
  found.cells = static_cast<std::size_t>(std::count(thin.begin(), thin.end(), 1));
  if (found.cells == 0) return found;
  std::vector<std::uint8_t> met(thin.size(), 0);
  for (const SurfacePiece& piece : placed.pieces) {
    if (!placed.domain.grid.has_cell(piece.cell)) continue;
    const std::size_t cell = placed.domain.grid.cell(piece.cell);
    met[cell] = 1;
    if (thin[cell] == 0 || found.body >= 0) continue;
    found.body = surface.part[at(piece.side)];
    found.place = placed.domain.grid.middle(piece.cell);
  }
  found.of_cells = static_cast<std::size_t>(std::count(met.begin(), met.end(), 1));
  return found;
}

std::string thin_text(const ThinBodies& thin, int dim) {
  if (thin.cells == 0) return "";
  std::string where;
  if (thin.body >= 0) {
    where = fmt::format(", first body {} near ({:.6g}, {:.6g}", thin.body + 1, thin.place[0], thin.place[1]);
    where += dim == 3 ? fmt::format(", {:.6g})", thin.place[2]) : ")";
  }
  return fmt::format(
      "bodies, or gaps between them, are thinner than a cell at {}{} (their surface goes through {}): {} as wholly "
      "fluid or solid, as by mode='symmetric', so that added mass and buoyancy there are of the order of a cell off; "
      "two cells across a body, three where it is slanted or meets a wall, are enough",
      thin.cells == 1 ? "1 cell" : fmt::format("{} cells", thin.cells), where, thin.of_cells,
      thin.cells == 1 ? "it counts" : "these cells count");
}

std::string thin_text(const Scene& scene) {
  if (!scene.coupled() || !scene.solids() || !scene.coupled()->coupling.cuts_faces || scene.coupled()->mesh) return "";
  const SolidSurface surface = surface_of(scene.solids()->mesh);
  const FlowBox box(*scene.coupled());
  const Outside outside(*scene.coupled(), gravity_of(scene));
  Team alone;
  const Placement placed =
      Placer(*scene.coupled(), surface, scene.solids()->mesh.x.size(), box, outside, alone).at(scene.solids()->mesh.x);
  return thin_text(thin_bodies(placed, surface), scene.coupled()->grid.dim);
}

}  // namespace tether::coupled
