// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "grid/block_mesh.hpp"
#include "grid/gmsh/content.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The meshes of an ASCII file of Gmsh (https://gmsh.info, versions 2.2 and 4.1 of its format), as many as the regions
/// name. Meshes may lie on top of each other, and an element or a node may belong to several of them; within a mesh an
/// element has one region, counted from 0 in the order of `regions`. A file without groups of the mesh's dimension is
/// all the first region. Physical groups of one dimension less become sides of all meshes that have them, by name or as
/// 'physical <tag>'.
///
/// Mistakes go into `diagnostics` at their lines: a file that is cut off or does not say what it declares, elements
/// that tether does not have, elements turned inside out, nodes that are unused, twice in one place or hanging. What is
/// wrong with `regions` goes into `flaws`, by their place in the list. Nothing is returned where there is any.
std::vector<Mesh> read_gmsh_meshes(std::string_view text, const std::string& file,
                                   const std::vector<FileRegion>& regions, std::vector<MeshFlaw>& flaws,
                                   Diagnostics& diagnostics);

/// Reads one mesh in the same way, whose regions 1, 2, ... have the groups of these names.
std::optional<Mesh> read_gmsh(std::string_view text, const std::string& file, const std::vector<std::string>& groups,
                              std::vector<MeshFlaw>& flaws, Diagnostics& diagnostics);

}  // namespace tether
