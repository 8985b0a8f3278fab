// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "grid/mesh.hpp"
#include "model/solids.hpp"
#include "physics/solids/elements.hpp"

namespace tether::fem {

/// The elements of the solids' mesh, which must outlive them, as must the team that shares their loops.
std::unique_ptr<Elements> make_elements(const Solids& solids, Team& team);

/// <N_A> over sides of the reference shape [area].
std::vector<double> side_areas(const Mesh& mesh, const Sides& sides);

/// A load's part of each node: areas of its sides, volumes of its region, or 1 at its nodes.
std::vector<double> load_parts(const Load& load, const Mesh& mesh, const Elements& elements);

}  // namespace tether::fem
