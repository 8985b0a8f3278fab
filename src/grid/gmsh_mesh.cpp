// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tether::gmsh {
namespace {

/// Which node of the mesh each of the file's numbers is; numbers that are there twice are told.
std::map<long long, int> numbered(const Content& content, Remarks& remarks) {
  std::map<long long, int> index;
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

/// The one kind of the elements of that dimension; others are told, each type once.
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
    if (!type->kind) {
      remarks.error(line, 1, fmt::format("tether has no {}, of which there are {}, the first here", type->name, count),
                    type->instead);
    } else if (one != nullptr) {
      remarks.error(line, 1,
                    fmt::format("elements of two kinds: {} of the type {}, and {} of the type {}, the first here",
                                found[one->number].first, one->name, count, type->name),
                    dim == 2 ? "A mesh is of one kind. In Gmsh 'Recombine Surface' makes all quadrangles."
                             : "A mesh is of one kind. Tetrahedra always fit.");
    } else {
      one = type;
    }
  }
  return one ? one->kind : std::nullopt;
}

/// The nodes of an element as nodes of the mesh, in the file's order; what is wrong with them is told.
bool nodes_of(const Content& content, const Element& element, const std::map<long long, int>& index,
              std::vector<int>& nodes, Remarks& remarks) {
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

void add_elements(const Content& content, const std::map<long long, int>& index, NamedMesh& named, Remarks& remarks) {
  const std::vector<int> order = gmsh_order(named.mesh.kind);
  std::vector<int> nodes;
  std::map<std::vector<int>, const Element*> seen;
  for (const Element& element : content.elements) {
    if (find_type(element.type)->kind != named.mesh.kind) continue;
    if (!nodes_of(content, element, index, nodes, remarks)) continue;
    for (const int a : order) named.mesh.nodes.push_back(nodes[static_cast<std::size_t>(a)]);
    named.mesh.region.push_back(0);
    named.elements.push_back(&element);
    std::sort(nodes.begin(), nodes.end());
    const auto [first, fresh] = seen.emplace(nodes, &element);
    if (fresh) continue;
    remarks.error(element.line, 1,
                  fmt::format("elements {} and {} have the same nodes", first->second->number, element.number),
                  "Does a surface or volume belong to two physical groups? Each element has one region.");
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

std::optional<Mesh> mesh_of_content(const Content& content, const std::vector<std::string>& regions,
                                    std::vector<MeshFlaw>& flaws, Remarks& remarks) {
  const int dim = dimension_of(content);
  if (dim < 2) {
    remarks.error(content.first_line, 1, "there are no elements of a surface or a volume",
                  "In Gmsh, mesh in 2D or 3D and give physical groups of surfaces or volumes, too.");
    return std::nullopt;
  }
  const auto kind = kind_of(content, dim, remarks);
  const std::map<long long, int> index = numbered(content, remarks);
  if (!kind || remarks.has_errors()) return std::nullopt;
  NamedMesh named;
  named.mesh.kind = *kind;
  add_places(content, named, remarks);
  add_elements(content, index, named, remarks);
  if (remarks.has_errors()) return std::nullopt;
  assign_regions(content, regions, named, flaws, remarks);
  add_named_sides(content, index, named, remarks);
  check_shape(named, remarks);
  if (remarks.has_errors() || !flaws.empty()) return std::nullopt;
  return std::move(named.mesh);
}

}  // namespace tether::gmsh
