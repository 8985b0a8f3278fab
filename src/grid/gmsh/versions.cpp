// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/versions.hpp"

#include <fmt/format.h>

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

namespace {

/// Which set of tags an entity (dimension, tag) has.
using Entities = std::map<std::pair<int, int>, std::size_t>;

/// A point is: tag x y z groups; others: tag, the box's six numbers, groups; both then what does not concern us.
bool read_entity(Words words, int dim, Entities& entities, Content& content) {
  const auto tag = words.whole("the entity's tag", -largest_tag, largest_tag);
  if (!tag) return false;
  for (int k = 0; k < (dim == 0 ? 3 : 6); ++k) {
    if (!words.real("a coordinate")) return false;
  }
  const auto count = words.whole("the number of physical tags", 0, largest_tag);
  if (!count) return false;
  std::vector<int> tags;
  for (long long k = 0; k < *count; ++k) {
    const auto group = words.whole("a physical tag", -largest_tag, largest_tag);
    if (!group) return false;
    tags.push_back(static_cast<int>(std::abs(*group)));
  }
  entities[{dim, static_cast<int>(*tag)}] = content.tag_sets.size();
  content.tag_sets.push_back(std::move(tags));
  return true;
}

void read_entities(Reader reader, Entities& entities, Content& content) {
  auto header = reader.next("the numbers of points, curves, surfaces and volumes");
  if (!header) return;
  for (int dim = 0; dim < 4; ++dim) {
    const auto count = header->whole("a number of entities", 0, largest_number);
    if (!count || !reader.bears_out(*header, *count, "entities")) return;
    for (long long k = 0; k < *count; ++k) {
      auto line = reader.next(fmt::format("entity {} of {} of dimension {}", k + 1, *count, dim));
      if (!line || !read_entity(*line, dim, entities, content)) return;
    }
  }
  reader.expect_end("entities");
}

/// What begins the sections of nodes and of elements, and each of their blocks.
struct Counts {
  long long first = 0, second = 0, third = 0, fourth = 0;
  std::array<std::size_t, 4> place{};  ///< of each in its line
};

std::optional<Counts> counts_of(Words& words, const std::array<const char*, 4>& what) {
  std::array<long long, 4> numbers{};
  std::array<std::size_t, 4> place{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto number = words.whole(what[k], k < 2 ? -largest_tag : 0, k < 2 ? largest_tag : largest_number);
    if (!number) return std::nullopt;
    numbers[k] = *number, place[k] = words.place();
  }
  if (!words.done("Four numbers stand here.")) return std::nullopt;
  return Counts{numbers[0], numbers[1], numbers[2], numbers[3], place};
}

/// The numbers of a block's nodes, a line each, then their places.
bool read_node_block(Reader& reader, Content& content) {
  auto header = reader.next("a block of nodes");
  if (!header) return false;
  const auto block = counts_of(*header, {"the entity's dimension", "the entity's tag", "whether it is parametric",
                                         "the number of nodes in the block"});
  if (!block || !reader.bears_out(*header, block->fourth, "nodes")) return false;
  const std::size_t first = content.nodes.size();
  for (long long k = 0; k < block->fourth; ++k) {
    auto line = reader.next(fmt::format("node {} of the {} of this block", k + 1, block->fourth));
    const auto number = line ? line->whole("the node's number", 1, largest_number) : std::nullopt;
    if (!number || !line->done("A node's number stands alone.")) return false;
    content.nodes.push_back({*number, {}, line->line()});
  }
  for (std::size_t n = first; n < content.nodes.size(); ++n) {
    auto line = reader.next(fmt::format("the place of node {}", content.nodes[n].number));
    if (!line) return false;
    for (double& x : content.nodes[n].x) {
      const auto value = line->real("a coordinate");
      if (!value) return false;
      x = *value;
    }
    for (int k = 0; k < 3 && block->third != 0 && !line->at_end(); ++k) line->real("a parameter");
    if (!line->done("A node's place is: x y z.")) return false;
  }
  return true;
}

bool read_element_line(Words words, const ElementType& type, std::size_t tags, Content& content) {
  const auto number = words.whole("the element's number", 1, largest_number);
  if (!number) return false;
  const Element element{*number, type.number, words.line(), content.element_nodes.size(), tags};
  for (int a = 0; a < type.nodes; ++a) {
    const auto node = words.whole("a node's number", 1, largest_number);
    if (!node) return false;
    content.element_nodes.push_back(*node);
  }
  content.elements.push_back(element);
  return words.done(fmt::format("A {} has {} nodes.", type.name, type.nodes).c_str());
}

/// The set of tags of an entity; an empty one where the file has no entities, thus no groups.
std::optional<std::size_t> tags_of(Words& header, const Counts& block, const Entities& entities) {
  if (entities.empty()) return 0;
  const auto found = entities.find({static_cast<int>(block.first), static_cast<int>(block.second)});
  if (found != entities.end()) return found->second;
  header.blame(block.place[1]);
  header.error(fmt::format("the entity of dimension {} with tag {} is not in $Entities", block.first, block.second));
  return std::nullopt;
}

bool read_element_block(Reader& reader, const Entities& entities, Content& content) {
  auto header = reader.next("a block of elements");
  if (!header) return false;
  const auto block = counts_of(*header, {"the entity's dimension", "the entity's tag", "the elements' type",
                                         "the number of elements in the block"});
  if (!block || !reader.bears_out(*header, block->fourth, "elements")) return false;
  const ElementType* type = block->third <= largest_tag ? find_type(static_cast<int>(block->third)) : nullptr;
  if (type == nullptr) {
    header->blame(block->place[2]);
    header->error(fmt::format("{} elements of an unknown type, {}", block->fourth, block->third),
                  "tether has triangles, quadrangles, tetrahedra and hexahedra.");
  }
  const auto tags = tags_of(*header, *block, entities);
  for (long long k = 0; k < block->fourth; ++k) {
    auto line = reader.next(fmt::format("element {} of the {} of this block", k + 1, block->fourth));
    if (!line) return false;
    if (type != nullptr && tags && !read_element_line(*line, *type, *tags, content)) return false;
  }
  return true;
}

/// Blocks, as many as the section's header says, and of as many things in all.
template <class Thing, class ReadBlock>
void read_blocks(const File& file, Reader reader, const char* what, const std::vector<Thing>& found,
                 ReadBlock read_block) {
  auto header = reader.next(fmt::format("the numbers of {}", what));
  if (!header) return;
  const auto counts =
      counts_of(*header, {"the number of blocks", "the number in all", "the lowest number", "the highest number"});
  if (!counts) return;
  header->blame(counts->place[0]);
  if (!reader.bears_out(*header, counts->first, "blocks")) return;
  header->blame(counts->place[1]);
  if (!reader.bears_out(*header, counts->second, what)) return;
  for (long long k = 0; k < counts->first; ++k) {
    if (!read_block(reader)) return;
  }
  reader.expect_end("blocks");
  if (!file.remarks.has_errors() && static_cast<long long>(found.size()) != counts->second)
    header->error(fmt::format("{} {} are declared, but the blocks have {}", counts->second, what, found.size()),
                  "Is a count wrong?");
}

}  // namespace

void read_version_41(const File& file, Content& content) {
  Entities entities;
  if (auto reader = file.section("Entities")) read_entities(*reader, entities, content);
  if (entities.empty()) content.tag_sets.emplace_back();
  if (auto reader = file.section("Nodes"))
    read_blocks(file, *reader, "nodes", content.nodes,
                [&](Reader& blocks) { return read_node_block(blocks, content); });
  if (auto reader = file.section("Elements"))
    read_blocks(file, *reader, "elements", content.elements,
                [&](Reader& blocks) { return read_element_block(blocks, entities, content); });
}

}  // namespace tether::gmsh
