// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/solids.hpp"
#include "results/results.hpp"

// What all solvers of a mesh write alike. Vectors have dim numbers a node.

namespace tether::fem {

/// Adds name + x, y (and z).
void add_vector(HistoryLayout& layout, const std::string& name, Dimension dimension, const std::string& meaning,
                int dim, Per per = Per::scene);
/// Adds time, dt and the energies that every history has, up to their sum.
void add_energies(HistoryLayout& layout);
/// Adds mass and momenta: in the plane the angular momentum has one component.
void add_momenta(HistoryLayout& layout, int dim);
/// Adds the number of nodes inside another body.
void add_overlap(HistoryLayout& layout);
/// Adds the least volume of an element, and the bodies' volumes.
void add_shape(HistoryLayout& layout);
/// Adds the bodies' and the tracked places' columns, and their names.
void add_bodies_and_nodes(HistoryLayout& layout, const Solids& solids, const std::vector<std::string>& bodies);

/// Adds the numbers of tracked places: by components, where they are, then their velocities.
void append_tracked(const Solids& solids, std::span<const double> q, std::span<const double> v, Record& record);

/// Places, displacements and velocities of all nodes.
Snapshot motion_fields(double time, const Mesh& mesh, std::span<const double> q, std::span<const double> v);

}  // namespace tether::fem
