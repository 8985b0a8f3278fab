// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/mesh.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace tether::gmsh {
namespace {

/// Indexes all of the file's nodes; numbers that are there twice are reported.
NodeIndex numbered(const Content& content, Remarks& remarks) {
  NodeIndex index;
  for (std::size_t n = 0; n < content.nodes.size(); ++n) {
    const Node& node = content.nodes[n];
    const auto [first, fresh] = index.emplace(node.number, static_cast<int>(n));
    if (fresh) continue;
    remarks.error(node.line, 1,
                  fmt::format("node {} is there twice, first at line {}", node.number,
                              content.nodes[static_cast<std::size_t>(first->second)].line));
  }
  return index;
}

/// The highest dimension of elements there.
int dimension_of(const Content& content) {
  int dim = 0;
  for (const Element& element : content.elements) dim = std::max(dim, find_type(element.type)->dim);
  return dim;
}

/// The one kind of the elements of that dimension; others are reported, each type once.
std::optional<ElementKind> kind_of(const Content& content, int dim, Remarks& remarks) {
  std::map<int, std::pair<int, int>> found;  // count and first line of each type
  for (const Element& element : content.elements) {
    if (find_type(element.type)->dim == dim && found[element.type].first++ == 0)
      found[element.type].second = element.line;
  }
  const ElementType* one = nullptr;
  for (const auto& [number, of_type] : found) {
    const ElementType* type = find_type(number);
    const auto& [count, line] = of_type;
    if (!kind_of(*type)) {
      remarks.error(line, 1, fmt::format("tether has no {}, of which there are {}, the first here", type->name, count),
                    type->instead);
    } else if (one != nullptr) {
      remarks.error(line, 1,
                    fmt::format("elements of two kinds: {} of the type {}, and {} of the type {}, the first here",
                                found[one->number].first, one->name, count, type->name),
                    dim == 2 ? "A mesh is of one kind. In Gmsh 'Recombine Surface{:};' makes quadrangles of "
                               "triangles, and 'Mesh.SubdivisionAlgorithm = 1;' of all of them."
                             : "A mesh is of one kind. Tetrahedra always fit.");
    } else {
      one = type;
    }
  }
  return one ? kind_of(*one) : std::nullopt;
}

/// The nodes of an element as nodes of the mesh, in the file's order; what is wrong with them is reported.
bool nodes_of(const Content& content, const Element& element, const NodeIndex& index, std::vector<int>& nodes,
              Remarks& remarks) {
  const int count = find_type(element.type)->nodes;
  nodes.clear();
  for (int a = 0; a < count; ++a) {
    const long long number = content.element_nodes[element.first + static_cast<std::size_t>(a)];
    const auto found = index.find(number);
    if (found == index.end()) {
      remarks.error(element.line, 1,
                    fmt::format("element {} names node {}, which is not there", element.number, number),
                    "Is the section of nodes whole?");
      return false;
    }
    if (std::find(nodes.begin(), nodes.end(), found->second) != nodes.end()) {
      remarks.error(element.line, 1, fmt::format("element {} names node {} twice", element.number, number),
                    "Each corner has a node of its own.");
      return false;
    }
    nodes.push_back(found->second);
  }
  return true;
}

void add_elements(const Content& content, const NodeIndex& index, NamedMesh& named, Remarks& remarks) {
  const std::vector<int> order = gmsh_order(named.mesh.kind);
  std::vector<int> nodes;
  for (const Element& element : content.elements) {
    if (element.type != row_of(named.mesh.kind).gmsh_type) continue;
    if (!nodes_of(content, element, index, nodes, remarks)) continue;
    for (const int a : order) named.mesh.nodes.push_back(nodes[static_cast<std::size_t>(a)]);
    named.mesh.region.push_back(0);
    named.elements.push_back(&element);
  }
}

/// Places of the nodes; those of a plane mesh stand in one plane z = constant.
void add_places(const Content& content, NamedMesh& named, Remarks& remarks) {
  const int dim = named.mesh.dim();
  double low = 0, high = 0;
  for (std::size_t n = 0; n < content.nodes.size(); ++n) {
    const auto& x = content.nodes[n].x;
    named.nodes.push_back(&content.nodes[n]);
    for (int i = 0; i < dim; ++i) named.mesh.x.push_back(x[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 2; ++i)
      low = n == 0 && i == 0 ? x[0] : std::min(low, x[static_cast<std::size_t>(i)]),
      high = n == 0 && i == 0 ? x[0] : std::max(high, x[static_cast<std::size_t>(i)]);
  }
  if (dim == 3 || content.nodes.empty()) return;
  const Node& first = content.nodes.front();
  const auto off = std::find_if(content.nodes.begin(), content.nodes.end(), [&](const Node& node) {
    return std::abs(node.x[2] - first.x[2]) > 1e-9 * (high - low);
  });
  if (off == content.nodes.end()) return;
  remarks.error(
      off->line, 1,
      fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}) is not in the plane z = {:.6g} of node {}", off->number,
                  off->x[0], off->x[1], off->x[2], first.x[2], first.number),
      "A mesh of triangles or quadrangles is plane; shells are not there. For a body save its volume's mesh.");
}

}  // namespace

std::vector<NamedMesh> split(const NamedMesh& whole, const std::vector<FileRegion>& regions,
                             const std::vector<std::vector<std::size_t>>& regions_of, std::vector<NodeIndex>& indices) {
  const auto per_element = static_cast<std::size_t>(node_count_of(whole.mesh.kind));
  const auto dim = static_cast<std::size_t>(whole.mesh.dim());
  std::vector<NamedMesh> meshes;
  std::vector<int> in_its_mesh;  // the number that each region has there
  for (const FileRegion& region : regions) {
    meshes.resize(std::max(meshes.size(), region.mesh + 1));
    in_its_mesh.push_back(static_cast<int>(meshes[region.mesh].numbers.size()));
    meshes[region.mesh].numbers.push_back(region.number);
  }
  std::vector<std::vector<int>> number(meshes.size(), std::vector<int>(whole.nodes.size(), -1));
  for (std::size_t e = 0; e < whole.elements.size(); ++e) {
    for (const std::size_t r : regions_of[e]) {
      NamedMesh& to = meshes[regions[r].mesh];
      to.elements.push_back(whole.elements[e]), to.mesh.region.push_back(in_its_mesh[r]);
      for (std::size_t a = 0; a < per_element; ++a) {
        to.mesh.nodes.push_back(whole.mesh.element(e)[a]);
        number[regions[r].mesh][static_cast<std::size_t>(to.mesh.nodes.back())] = 0;
      }
    }
  }
  indices.assign(meshes.size(), {});
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    NamedMesh& to = meshes[m];
    to.mesh.kind = whole.mesh.kind;
    for (std::size_t n = 0; n < whole.nodes.size(); ++n) {
      if (number[m][n] < 0) continue;
      number[m][n] = static_cast<int>(to.nodes.size());
      indices[m].emplace(whole.nodes[n]->number, number[m][n]);
      to.nodes.push_back(whole.nodes[n]);
      to.mesh.x.insert(to.mesh.x.end(), &whole.mesh.x[n * dim], &whole.mesh.x[n * dim] + dim);
    }
    for (int& node : to.mesh.nodes) node = number[m][static_cast<std::size_t>(node)];
  }
  return meshes;
}

std::vector<Mesh> meshes_of_content(const Content& content, const std::vector<FileRegion>& regions,
                                    std::vector<MeshFlaw>& flaws, Remarks& remarks) {
  const int dim = dimension_of(content);
  if (dim < 2) {
    remarks.error(content.first_line, 1, "there are no elements of a surface or a volume",
                  "In Gmsh, mesh in 2D or 3D and give physical groups of surfaces or volumes, too.");
    return {};
  }
  const auto kind = kind_of(content, dim, remarks);
  const NodeIndex index = numbered(content, remarks);
  if (!kind || remarks.has_errors()) return {};
  NamedMesh whole;
  whole.mesh.kind = *kind;
  add_places(content, whole, remarks);
  add_elements(content, index, whole, remarks);
  if (remarks.has_errors()) return {};
  const auto regions_of = regions_of_elements(content, regions, whole, flaws, remarks);
  const bool several = std::any_of(regions.begin(), regions.end(), [](const FileRegion& r) { return r.mesh > 0; });
  if (several && (remarks.has_errors() || !flaws.empty())) return {};  // elements would be looked at in a wrong mesh
  std::vector<NodeIndex> indices;
  std::vector<NamedMesh> named = split(whole, regions, regions_of, indices);
  bool once = true;
  for (const NamedMesh& mesh : named) once &= check_once(mesh, remarks);
  if (!once) return {};
  check_used(whole, remarks);
  add_named_sides(content, indices, named, remarks);
  add_node_sets(content, indices, named, remarks);
  std::vector<Mesh> meshes;
  for (NamedMesh& mesh : named) {
    check_shape(mesh, remarks);
    meshes.push_back(std::move(mesh.mesh));
  }
  if (remarks.has_errors() || !flaws.empty()) meshes.clear();
  return meshes;
}

namespace {

constexpr std::size_t most_told = 5;  // of one kind of mistake, the last with the number of those that follow

/// " (and 12 others)" at the last that is reported.
std::string others(std::size_t k, std::size_t count) {
  return k + 1 == most_told && count > most_told ? fmt::format(" (and {} others)", count - most_told) : "";
}

void check_places(const NamedMesh& named, Remarks& remarks) {
  const auto pairs = coinciding_nodes(named.mesh);
  for (std::size_t k = 0; k < std::min(pairs.size(), most_told); ++k) {
    const Node& first = *named.nodes[static_cast<std::size_t>(pairs[k].first)];
    const Node& second = *named.nodes[static_cast<std::size_t>(pairs[k].second)];
    remarks.error(second.line, 1,
                  fmt::format("nodes {} and {} are in one place, {}{}", first.number, second.number,
                              place_text(named.mesh, pairs[k].first), others(k, pairs.size())),
                  "Parts are joined by shared nodes: in Gmsh, 'Coherence' joins geometry, 'Coherence Mesh' nodes.");
  }
}

void check_inverted(const NamedMesh& named, Remarks& remarks) {
  const auto inverted = inverted_elements(named.mesh);
  for (std::size_t k = 0; k < std::min(inverted.size(), most_told); ++k) {
    const std::size_t e = inverted[k];
    const Element& element = *named.elements[e];
    remarks.error(element.line, 1,
                  fmt::format("element {} of region {} at {} is turned inside out or flat{}", element.number,
                              named.numbers[static_cast<std::size_t>(named.mesh.region[e])],
                              place_text(named.mesh, named.mesh.element(e)[0]), others(k, inverted.size())),
                  named.mesh.dim() == 2
                      ? "Plane elements go counter-clockwise, as the outer Curve Loop of their surface does: turn "
                        "that, or write 'ReverseMesh Surface{...};' in the .geo."
                      : "Gmsh's 'Tools, Statistics' shows such elements; a finer mesh may have none.");
  }
}

void check_hanging(const NamedMesh& named, Remarks& remarks) {
  const auto hanging = hanging_node(named.mesh);
  if (!hanging) return;
  const Node& node = *named.nodes[static_cast<std::size_t>(hanging->node)];
  remarks.error(node.line, 1,
                fmt::format("node {} at {} hangs: it lies within a side of an element that does not have it",
                            node.number, place_text(named.mesh, hanging->node)),
                "Parts that touch share their nodes: in Gmsh, 'Coherence' joins their geometry before meshing.");
}

}  // namespace

bool check_once(const NamedMesh& named, Remarks& remarks) {
  const auto per_element = static_cast<std::size_t>(node_count_of(named.mesh.kind));
  std::map<std::vector<int>, const Element*> seen;
  bool all = true;
  for (std::size_t e = 0; e < named.elements.size(); ++e) {
    std::vector<int> nodes(named.mesh.element(e), named.mesh.element(e) + per_element);
    std::sort(nodes.begin(), nodes.end());
    const auto [first, fresh] = seen.emplace(std::move(nodes), named.elements[e]);
    if (fresh) continue;
    all = false;
    remarks.error(
        named.elements[e]->line, 1,
        fmt::format("elements {} and {} have the same nodes", first->second->number, named.elements[e]->number),
        "Does a surface or volume belong to two physical groups? Each element has one region.");
  }
  return all;
}

void check_used(const NamedMesh& whole, Remarks& remarks) {
  std::vector<char> used(whole.nodes.size(), 0);
  for (const int node : whole.mesh.nodes) used[static_cast<std::size_t>(node)] = 1;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  for (std::size_t n = 0, k = 0; n < used.size() && k < most_told; ++n) {
    if (used[n]) continue;
    const Node& node = *whole.nodes[n];
    remarks.error(node.line, 1,
                  fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}) belongs to no element{}", node.number, node.x[0],
                              node.x[1], node.x[2], others(k++, count)),
                  "With physical groups Gmsh saves only their elements and nodes; a centre of an arc is such a node.");
  }
}

void check_shape(const NamedMesh& named, Remarks& remarks) {
  check_places(named, remarks);
  check_inverted(named, remarks);
  if (!remarks.has_errors()) check_hanging(named, remarks);
}

}  // namespace tether::gmsh
