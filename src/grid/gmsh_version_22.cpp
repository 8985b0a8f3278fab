// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "grid/gmsh_versions.hpp"

namespace tether::gmsh {
namespace {

/// The count that a section begins with, where its lines can bear it out.
std::optional<long long> count_of(Reader& reader, const char* what) {
  auto header = reader.next(fmt::format("the number of {}", what));
  if (!header) return std::nullopt;
  const auto count = header->whole(fmt::format("the number of {}", what).c_str(), 0, largest_number);
  if (!count || !header->done("This line is the count alone.")) return std::nullopt;
  return reader.bears_out(*header, *count, what) ? count : std::nullopt;
}

/// number x y z
void read_node(Words words, Content& content) {
  const auto number = words.whole("the node's number", 1, largest_number);
  const auto x = number ? words.real("x") : std::nullopt, y = x ? words.real("y") : std::nullopt,
             z = y ? words.real("z") : std::nullopt;
  if (z && words.done("A node is: number x y z.")) content.nodes.push_back({*number, {*x, *y, *z}, words.line()});
}

/// number type number-of-tags tags nodes; the first tag is the physical group, 0 none.
void read_element(Words words, std::map<int, std::size_t>& sets, Content& content) {
  const auto number = words.whole("the element's number", 1, largest_number);
  const auto type_number = number ? words.whole("the element's type", 1, largest_tag) : std::nullopt;
  if (!type_number) return;
  const ElementType* type = find_type(static_cast<int>(*type_number));
  if (type == nullptr)
    return words.error(fmt::format("element {} is of an unknown type, {}", *number, *type_number),
                       "tether has triangles, quadrangles, tetrahedra and hexahedra.");
  const auto tags = words.whole("the number of tags", 0, largest_tag);
  if (!tags) return;
  int group = 0;
  for (long long k = 0; k < *tags; ++k) {
    const auto tag = words.whole("a tag", -largest_tag, largest_tag);
    if (!tag) return;
    if (k == 0) group = static_cast<int>(std::abs(*tag));
  }
  const auto [set, fresh] = sets.try_emplace(group, content.tag_sets.size());
  if (fresh) content.tag_sets.push_back(group == 0 ? std::vector<int>{} : std::vector{group});
  const Element element{*number, type->number, words.line(), content.element_nodes.size(), set->second};
  for (int a = 0; a < type->nodes; ++a) {
    const auto node = words.whole("a node's number", 1, largest_number);
    if (!node) return content.element_nodes.resize(element.first);
    content.element_nodes.push_back(*node);
  }
  if (!words.done(fmt::format("A {} has {} nodes.", type->name, type->nodes).c_str()))
    return content.element_nodes.resize(element.first);
  content.elements.push_back(element);
}

}  // namespace

void read_version_22(const File& file, Content& content) {
  if (auto nodes = file.section("Nodes")) {
    const auto count = count_of(*nodes, "nodes");
    for (long long k = 0; count && k < *count; ++k) {
      auto line = nodes->next(fmt::format("node {} of {}", k + 1, *count));
      if (!line) break;
      read_node(*line, content);
    }
    if (count) nodes->expect_end("nodes");
  }
  if (auto elements = file.section("Elements")) {
    std::map<int, std::size_t> sets;
    const auto count = count_of(*elements, "elements");
    for (long long k = 0; count && k < *count; ++k) {
      auto line = elements->next(fmt::format("element {} of {}", k + 1, *count));
      if (!line) break;
      read_element(*line, sets, content);
    }
    if (count) elements->expect_end("elements");
  }
}

}  // namespace tether::gmsh
