// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/solids.hpp"
#include "physics/common_columns.hpp"
#include "physics/solids/elements.hpp"
#include "physics/solids/system.hpp"
#include "results/results.hpp"

namespace tether::fem {

// What all solvers of bodies on a mesh write alike. Vectors have dim numbers a node.

/// What a record of deformable bodies on a mesh is made from.
struct MeshSums : CommonSums {
  double least = 0;             ///< least volume of an element over that at the start
  std::vector<double> volumes;  ///< of each body [volume]
  double nodes_inside = 0;      ///< of bodies inside of bodies
  ContactState contact;
};

/// What the columns of bodies on a mesh depend on.
struct MeshSetting : ColumnSetting {
  bool meets = false;  ///< whether there is contact
};

using MeshGroup = ColumnGroup<ColumnSetting, MeshSums>;

/// The least volume of an element, and the bodies' volumes.
MeshGroup shape_columns();
/// The number of nodes inside another body.
MeshGroup overlap_columns();
/// Lists what contact stores and takes, and how bodies touch.
ColumnGroup<MeshSetting, MeshSums> contact_columns();

/// Names bodies and tracked places.
MeshSetting mesh_setting(const Solids& solids, std::vector<std::string> bodies);
/// The names of the regions.
std::vector<std::string> region_names(const Solids& solids);

/// The tracked places with nodes at q that move by v.
std::vector<TrackedSums> tracked_of(const Solids& solids, std::span<const double> q, std::span<const double> v);
/// A body whose nodes have these parts of a sum, as masses or volumes: the mean places and velocities by them.
BodySums body_of(double mass, std::span<const double> parts, std::span<const double> q, std::span<const double> v,
                 std::size_t dim);

/// Places, displacements and velocities of all nodes.
Snapshot motion_fields(double time, const Mesh& mesh, std::span<const double> q, std::span<const double> v);
/// Returns the same with Cauchy's stress and the energy density and, unless it is null, with contact.
Snapshot shape_fields(double time, const Mesh& mesh, const Elements& elements, std::span<const double> q,
                      std::span<const double> v, const contact::ContactNumbers* contact = nullptr);

/// What a support or a wall does to bodies: the sums over the nodes that it holds.
struct SupportSums {
  Components force{}, torque{};  ///< torque: about the mean place of these nodes at the start
};

/// What a record of elastic bodies is made from.
struct SolidSums : MeshSums {
  double of_loads = 0, of_supports = 0, damped = 0;  ///< so far [energy]
  std::vector<SupportSums> supports;                 ///< those of the deck, then walls
};

/// Names supports and walls, too.
struct SolidSetting : MeshSetting {
  std::vector<std::string> support_names;
};

/// Lists what elastic bodies can write: the history's columns and what a record of them is made from, and fields of the
/// nodes: places, displacements, velocities, Cauchy's stress and the energy density.
const ColumnTable<SolidSetting, SolidSums>& solid_table();
Columns<SolidSums> solid_columns(const Solids& solids);
SolidSums sums_of(const SolidState& state, const SolidSystem& system);
Snapshot node_fields(const SolidState& state, const SolidSystem& system);
/// The element whose volume is the least part of that at the start, and where it is, for a message.
std::string worst_element(const SolidSystem& system, std::span<const double> q);

}  // namespace tether::fem
