// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "plan/plan.hpp"

namespace tether {

/// Cells of a mesh with edges of a size in a volume, or an area in the plane.
double mesh_cells_of(double volume, double size, int dim);

/// Says whether the fluid of a coupled scene with bodies is on a mesh, and where it is not, whether one would pay:
/// where bodies are thinner than two of the grid's cells, or the fluid is in cavities alone.
Term flow_mesh_term(const Scene& scene);

/// Warns of cells in space that are much longer than a body is thick, and so are coarse about its edges; says nothing
/// where there are none.
std::string flow_mesh_warning(const Scene& scene);

}  // namespace tether
