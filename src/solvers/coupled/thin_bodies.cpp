// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/thin_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "model/solids.hpp"

namespace tether::coupled {

ThinBodies thin_bodies(const Placement& placed, const SolidSurface& surface) {
  ThinBodies found;
  const auto& thin = placed.cut.thin;
  found.cells = static_cast<std::size_t>(std::count(thin.begin(), thin.end(), 1));
  if (found.cells == 0) return found;
  std::vector<std::uint8_t> met(thin.size(), 0);
  for (const SurfacePiece& piece : placed.pieces.pieces) {
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
      "fluid "
      "or solid, as by mode='symmetric', so that added mass and buoyancy there are of the order of a cell off; two "
      "cells "
      "across a body, three where it is slanted, are enough",
      thin.cells == 1 ? "1 cell" : fmt::format("{} cells", thin.cells), where, thin.of_cells,
      thin.cells == 1 ? "it counts" : "these cells count");
}

std::string thin_text(const Scene& scene) {
  if (!scene.coupled() || !scene.solids() || scene.coupled()->mode != CouplingMode::cut_cell) return "";
  const SolidSurface surface = surface_of(scene.solids()->mesh);
  const FlowBox box(*scene.coupled());
  const Outside outside(*scene.coupled(), scene.gravity);
  const Placement placed = Placer(*scene.coupled(), surface, box, outside).at(scene.solids()->mesh.x);
  return thin_text(thin_bodies(placed, surface), scene.coupled()->grid.dim);
}

}  // namespace tether::coupled
