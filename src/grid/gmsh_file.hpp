// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "grid/block_mesh.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The mesh of an ASCII file of Gmsh (https://gmsh.info, versions 2.2 and 4.1 of its format). `regions` says for each
/// region which physical group of the mesh's dimension it is: by name, or where that is empty by tag, the region's
/// number from 1. A file without such groups is all region 1. Physical groups of one dimension less become sides, by
/// name or as 'physical <tag>'.
///
/// Mistakes go into `diagnostics` at their lines: a file that is cut off or does not say what it declares, elements
/// that tether does not have, elements turned inside out, nodes that are unused, twice in one place or hanging. What is
/// wrong with `regions` goes into `flaws`. Nothing is returned where there is any.
std::optional<Mesh> read_gmsh(std::string_view text, const std::string& file, const std::vector<std::string>& regions,
                              std::vector<MeshFlaw>& flaws, Diagnostics& diagnostics);

}  // namespace tether
