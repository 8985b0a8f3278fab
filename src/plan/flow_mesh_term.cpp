// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/flow_mesh_term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/numbers.hpp"
#include "grid/solid_surface.hpp"
#include "model/coupled.hpp"

namespace tether {
namespace {

/// The thinnest body.
struct Thinnest {
  double thickness = std::numeric_limits<double>::infinity();  // as a sheet of its volume and surface [length]
  double side = 0;                                             // of a square as large as its largest two [length]
};

Thinnest thinnest_of(const SolidSurface& surface, const std::vector<double>& x) {
  std::vector<double> area(at(surface.parts), 0.0), volume(area), largest(area);
  const std::vector<double> of_sheet = enclosed_volumes(surface, x);
  std::vector<int> part_of_sheet(at(surface.sheets), 0);
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    const Vec<3> side = area_of_side(surface, s, x);
    const double of_side = std::sqrt(dot(side, side));
    const std::size_t part = at(surface.part[s]);
    area[part] += of_side, largest[part] = std::max(largest[part], of_side);
    part_of_sheet[at(surface.sheet[s])] = surface.part[s];
  }
  for (std::size_t k = 0; k < of_sheet.size(); ++k) volume[at(part_of_sheet[k])] += of_sheet[k];
  Thinnest thinnest;
  for (std::size_t p = 0; p < area.size(); ++p) {
    const double thickness = 2 * volume[p] / area[p];
    if (thickness < thinnest.thickness) thinnest = {thickness, std::sqrt(2 * largest[p])};
  }
  return thinnest;
}

/// Of the cavities [volume].
double cavity_volume(const std::vector<double>& of_sheet) {
  double volume = 0;
  for (const double of : of_sheet) volume -= std::min(of, 0.0);
  return volume;
}

}  // namespace

double mesh_cells_of(double volume, double size, int dim) {
  return dim == 2 ? volume / (std::sqrt(0.1875) * size * size) : 11 * volume / (size * size * size);
}

Term flow_mesh_term(const Scene& scene) {
  const Coupled& c = *scene.coupled();
  const Mesh& bodies = scene.solids()->mesh;
  const SolidSurface surface = surface_of(bodies);
  const std::vector<double>& x = bodies.x;
  const int dim = c.grid.dim;
  const double cell = *std::min_element(c.grid.d.begin(), c.grid.d.begin() + dim);
  const char* shape = dim == 2 ? "triangles" : "tetrahedra";
  const auto off = [](std::string why) { return Term{"mesh of the fluid", false, std::move(why)}; };
  if (c.mesh)
    return {"mesh of the fluid", true,
            fmt::format("{} of {:.4g}, of {:.4g} at most at bodies, whose sides are faces", shape, c.mesh->size,
                        c.mesh->near)};
  if (c.liquid || !c.voids.empty()) return off("liquids and voids need the grid");
  if (c.cavities_only)
    return off(fmt::format("flow='mesh' would have {} in the cavities alone, about {:.0f} in place of {} cells", shape,
                           mesh_cells_of(cavity_volume(enclosed_volumes(surface, x)), cell, dim), c.grid.cell_count()));
  const double across = thinnest_of(surface, x).thickness / cell;
  if (across < 2) return off(fmt::format("a body is {:.2g} cells thick: flow='mesh' would fit it", across));
  return off(fmt::format("bodies are at least {:.2g} cells thick: a step on the grid costs less", across));
}

/// A plate of 0.4 by 0.4 by 0.04 (0.033 as a sheet), of one element, in a fluid of ten times its density begins to move
/// along itself: it keeps 0.22, 0.41, 0.50, 0.50 of its speed with cells of 0.25, 0.12, 0.08, 0.04 at it; 0.49 with
/// sides of 0.1.
std::string flow_mesh_warning(const Scene& scene) {
  const Coupled& c = *scene.coupled();
  if (!c.mesh || c.grid.dim < 3 || !scene.solids()) return "";
  constexpr double longest = 3, good = 2;  // of a cell at a body, over the body's thickness
  const Mesh& bodies = scene.solids()->mesh;
  const Thinnest thinnest = thinnest_of(surface_of(bodies), bodies.x);
  const double cell = std::min(c.mesh->near, thinnest.side);
  if (cell <= longest * thinnest.thickness) return "";
  return fmt::format(
      "a body is about {:.2g} thick, and the fluid's cells at it are up to {:.3g} long: they are too coarse for the "
      "flow around its edges, so that it takes too much fluid along where it moves along itself; size_near = {:.2g} "
      "or less mends that",
      thinnest.thickness, cell, good * thinnest.thickness);
}

}  // namespace tether
