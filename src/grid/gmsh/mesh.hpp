// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "grid/gmsh/content.hpp"
#include "grid/mesh_flaws.hpp"

namespace tether::gmsh {

/// A mesh on its way from a file, with what its nodes and elements are called there.
struct NamedMesh {
  Mesh mesh;
  std::vector<const Node*> nodes;        ///< of mesh
  std::vector<const Element*> elements;  ///< of mesh
  std::vector<int> numbers;              ///< of its regions in the deck
};

/// Which node of a mesh each of the file's numbers is.
using NodeIndex = std::map<long long, int>;

/// Makes the meshes that a file's content describes; arguments and mistakes as of read_gmsh_meshes.
std::vector<Mesh> meshes_of_content(const Content& content, const std::vector<FileRegion>& regions,
                                    std::vector<MeshFlaw>& flaws, Remarks& remarks);

/// Returns for each element of `whole`, which are all of the file, the places in `regions` that its groups mean,
/// ascending.
std::vector<std::vector<std::size_t>> regions_of_elements(const Content& content,
                                                          const std::vector<FileRegion>& regions,
                                                          const NamedMesh& whole, std::vector<MeshFlaw>& flaws,
                                                          Remarks& remarks);
/// The meshes of the regions, their nodes in the order of the file, and what the numbers of their nodes are.
std::vector<NamedMesh> split(const NamedMesh& whole, const std::vector<FileRegion>& regions,
                             const std::vector<std::vector<std::size_t>>& regions_of, std::vector<NodeIndex>& indices);
/// The sides that groups of one dimension less make.
void add_named_sides(const Content& content, const std::vector<NodeIndex>& indices, std::vector<NamedMesh>& meshes,
                     Remarks& remarks);
/// The sets of nodes that groups of still fewer dimensions make: of points, in space of curves, too.
void add_node_sets(const Content& content, const std::vector<NodeIndex>& indices, std::vector<NamedMesh>& meshes,
                   Remarks& remarks);
/// Reports nodes of no element.
void check_used(const NamedMesh& whole, Remarks& remarks);
/// Reports elements with the same nodes, and returns whether there are none.
bool check_once(const NamedMesh& named, Remarks& remarks);
/// Reports nodes in one place, elements turned inside out and hanging nodes.
void check_shape(const NamedMesh& named, Remarks& remarks);

}  // namespace tether::gmsh
