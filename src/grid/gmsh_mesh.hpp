// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/remarks.hpp"
#include "grid/gmsh_content.hpp"
#include "grid/mesh_flaws.hpp"

namespace tether::gmsh {

/// A mesh on its way from a file, with what its nodes and elements are called there.
struct NamedMesh {
  Mesh mesh;
  std::vector<const Node*> nodes;        ///< of mesh
  std::vector<const Element*> elements;  ///< of mesh
};

/// Makes the mesh that a file's content describes; arguments and mistakes as of read_gmsh.
std::optional<Mesh> mesh_of_content(const Content& content, const std::vector<std::string>& regions,
                                    std::vector<MeshFlaw>& flaws, Remarks& remarks);

/// The regions of the elements, whose groups `regions` names.
void assign_regions(const Content& content, const std::vector<std::string>& regions, NamedMesh& named,
                    std::vector<MeshFlaw>& flaws, Remarks& remarks);
/// The sides that groups of one dimension less make; `index` says which node of the mesh each number is.
void add_named_sides(const Content& content, const std::map<long long, int>& index, NamedMesh& named, Remarks& remarks);
/// Tells of unused nodes, nodes in one place, elements turned inside out and hanging nodes.
void check_shape(const NamedMesh& named, Remarks& remarks);

}  // namespace tether::gmsh
