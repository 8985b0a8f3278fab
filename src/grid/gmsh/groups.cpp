// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "grid/gmsh/mesh.hpp"
#include "grid/mesh.hpp"

namespace tether::gmsh {
namespace {

/// "'core' (tag 7)", or "tag 7" of a group without a name.
std::string group_text(const Content& content, int dim, int tag) {
  for (const Group& group : content.groups) {
    if (group.dim == dim && group.tag == tag) return fmt::format("{} (tag {})", in_quotes(group.name), tag);
  }
  return fmt::format("tag {}", tag);
}

/// Tags of the groups of the mesh's dimension that elements have.
std::set<int> tags_there(const Content& content, const NamedMesh& named) {
  std::set<int> tags;
  for (const Element* element : named.elements) {
    const auto& of = content.tag_sets[element->tags];
    tags.insert(of.begin(), of.end());
  }
  return tags;
}

std::string listed(const Content& content, int dim, const std::set<int>& tags) {
  std::vector<std::string> texts;
  texts.reserve(tags.size());
  for (const int tag : tags) texts.push_back(group_text(content, dim, tag));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The tag that a region's name stands for; nothing where there is none, which is reported.
std::optional<int> tag_of(const Content& content, int dim, const std::set<int>& there,
                          const std::vector<FileRegion>& regions, std::size_t r, std::vector<MeshFlaw>& flaws) {
  const std::string& name = regions[r].group;
  int tag = regions[r].number;
  std::vector<std::string> names;
  bool known = name.empty();
  for (const Group& group : content.groups) {
    if (group.dim != dim) continue;
    names.push_back(group.name);
    if (group.name == name) tag = group.tag, known = true;
  }
  if (known && there.count(tag) > 0) return tag;
  const std::string near = known ? "" : nearest_name(name, names);
  flaws.push_back(
      {r, fmt::format("the file has no elements in a physical group {}{}; its groups are {}",
                      name.empty() ? fmt::format("of tag {}", tag) : in_quotes(name),
                      near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near), listed(content, dim, there))});
  return std::nullopt;
}

/// The region of each tag, by its place in the list.
std::map<int, std::size_t> regions_of_tags(const Content& content, int dim, const std::set<int>& there,
                                           const std::vector<FileRegion>& regions, std::vector<MeshFlaw>& flaws) {
  std::map<int, std::size_t> region;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto tag = tag_of(content, dim, there, regions, r, flaws);
    if (!tag) continue;
    const auto [first, fresh] = region.emplace(*tag, r);
    if (!fresh)
      flaws.push_back({r, fmt::format("the physical group {} is region {} already", group_text(content, dim, *tag),
                                      regions[first->second].number)});
  }
  return region;
}

/// Boundaries and inner sides of the elements, by their nodes in ascending order.
std::map<std::vector<int>, std::vector<int>> sides_by_nodes(const Mesh& mesh) {
  const auto per_side = side_node_count_of(mesh.kind);
  std::map<std::vector<int>, std::vector<int>> sides;
  Sides of_element;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    of_element.clear();
    add_sides(mesh.kind, mesh.element(e), of_element);
    for (auto first = of_element.begin(); first != of_element.end(); first += per_side) {
      std::vector<int> sorted(first, first + per_side);
      std::sort(sorted.begin(), sorted.end());
      sides.emplace(std::move(sorted), std::vector<int>(first, first + per_side));
    }
  }
  return sides;
}

/// Nodes of an element that a mesh has, ascending.
std::vector<int> nodes_of(const Content& content, const Element& element, const NodeIndex& index) {
  std::vector<int> nodes;
  for (int a = 0; a < find_type(element.type)->nodes; ++a) {
    const auto found = index.find(content.element_nodes[element.first + static_cast<std::size_t>(a)]);
    if (found != index.end()) nodes.push_back(found->second);
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// What decks call a group.
std::string group_name(const Content& content, int dim, int tag) {
  for (const Group& group : content.groups) {
    if (group.dim == dim && group.tag == tag && !group.name.empty()) return group.name;
  }
  return fmt::format("physical {}", tag);
}

/// Groups that have a name and no elements.
void check_empty_groups(const Content& content, Remarks& remarks) {
  std::set<std::pair<int, int>> used;
  for (const Element& element : content.elements) {
    for (const int tag : content.tag_sets[element.tags]) used.emplace(find_type(element.type)->dim, tag);
  }
  for (const Group& group : content.groups) {
    if (used.count({group.dim, group.tag}) > 0) continue;
    remarks.error(group.line, 1, fmt::format("the physical group {} has no elements", in_quotes(group.name)),
                  "Is what it names meshed? Else leave the group away.");
  }
}

}  // namespace

std::vector<std::vector<std::size_t>> regions_of_elements(const Content& content,
                                                          const std::vector<FileRegion>& regions,
                                                          const NamedMesh& whole, std::vector<MeshFlaw>& flaws,
                                                          Remarks& remarks) {
  const int dim = whole.mesh.dim();
  const std::set<int> there = tags_there(content, whole);
  if (there.empty()) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (r > 0 || !regions[r].group.empty())
        flaws.push_back({r, fmt::format("the file has no physical groups of its elements, so that all is region {}",
                                        regions[0].number)});
    }
    return std::vector<std::vector<std::size_t>>(whole.elements.size(), {0});
  }
  const std::map<int, std::size_t> region = regions_of_tags(content, dim, there, regions, flaws);
  std::vector<std::vector<std::size_t>> meant(whole.elements.size());
  std::map<std::size_t, int> told;  // sets of tags that are no one region of a mesh, with the first such element's line
  for (std::size_t e = 0; e < whole.elements.size(); ++e) {
    const Element& element = *whole.elements[e];
    const auto& tags = content.tag_sets[element.tags];
    std::set<std::size_t> meshes;
    for (const int tag : tags) {
      if (region.count(tag) == 0) continue;
      meant[e].push_back(region.at(tag)), meshes.insert(regions[meant[e].back()].mesh);
    }
    std::sort(meant[e].begin(), meant[e].end());
    const bool none = meant[e].empty();
    if (!none && meshes.size() == meant[e].size()) continue;
    meant[e].assign(1, none ? 0 : meant[e].front());
    if (flaws.empty() && told.emplace(element.tags, element.line).second) {
      const std::string groups = listed(content, dim, {tags.begin(), tags.end()});
      remarks.error(
          element.line, 1,
          tags.empty() ? fmt::format("element {} belongs to no physical group, while others do", element.number)
          : none ? fmt::format("element {} belongs to no region: its physical group is {}", element.number, groups)
                 : fmt::format("element {} belongs to two regions: {}", element.number, groups),
          "nreg counts the regions; region r is the physical group of tag r, or the one that physical(r) of "
          "$mesh names.");
    }
  }
  return meant;
}

void add_named_sides(const Content& content, const std::vector<NodeIndex>& indices, std::vector<NamedMesh>& meshes,
                     Remarks& remarks) {
  if (meshes.empty()) return;
  const int dim = meshes.front().mesh.dim();
  check_empty_groups(content, remarks);
  std::vector<std::map<std::vector<int>, std::vector<int>>> sides;
  for (const Element& element : content.elements) {
    const ElementType& type = *find_type(element.type);
    const auto& tags = content.tag_sets[element.tags];
    if (type.dim != dim - 1 || tags.empty()) continue;
    for (std::size_t m = sides.size(); m < meshes.size(); ++m) sides.push_back(sides_by_nodes(meshes[m].mesh));
    bool found = false;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const auto side = sides[m].find(nodes_of(content, element, indices[m]));
      if (side == sides[m].end()) continue;
      found = true;
      for (const int tag : tags) {
        Sides& of_name = meshes[m].mesh.sides[group_name(content, dim - 1, tag)];
        of_name.insert(of_name.end(), side->second.begin(), side->second.end());
      }
    }
    if (!found)
      remarks.error(element.line, 1,
                    fmt::format("the {} {} of the physical group {} is no side of an element", type.name,
                                element.number, group_text(content, dim - 1, tags.front())),
                    "A group of one dimension less names sides of the mesh's elements.");
  }
  for (NamedMesh& named : meshes) drop_twins(named.mesh);
}

void add_node_sets(const Content& content, const std::vector<NodeIndex>& indices, std::vector<NamedMesh>& meshes,
                   Remarks& remarks) {
  std::set<std::string> told;
  for (const Element& element : content.elements) {
    const int dim = find_type(element.type)->dim;
    for (const int tag : content.tag_sets[element.tags]) {
      const std::string name = group_name(content, dim, tag);
      for (std::size_t m = 0; m < meshes.size() && dim < meshes[m].mesh.dim() - 1; ++m) {
        Mesh& mesh = meshes[m].mesh;
        const std::vector<int> nodes = nodes_of(content, element, indices[m]);
        if (mesh.sides.count(name) == 0) {
          std::vector<int>& set = mesh.node_sets[name];
          set.insert(set.end(), nodes.begin(), nodes.end());
        } else if (told.insert(name).second) {
          remarks.warn(element.line, 1,
                       fmt::format("the name {} is that of a group of sides, too: a deck cannot name these nodes",
                                   in_quotes(name)),
                       "Give the group another name.");
        }
      }
    }
  }
  for (NamedMesh& named : meshes) {
    for (auto& [name, nodes] : named.mesh.node_sets) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
  }
}

}  // namespace tether::gmsh
