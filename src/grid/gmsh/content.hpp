// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// A region of a deck that a file's physical group is.
struct FileRegion {
  int number = 1;        ///< in the deck, from 1
  std::string group;     ///< name of the group; where that is empty it is the one whose tag is the region's number
  std::size_t mesh = 0;  ///< which of the meshes it belongs to, from 0
};

}  // namespace tether

namespace tether::gmsh {

/// A physical group that the file names.
struct Group {
  int dim = 0, tag = 0;
  std::string name;
  int line = 0;
};

struct Node {
  long long number = 0;
  Vec<3> x{};  // [length]
  int line = 0;
};

struct Element {
  long long number = 0;
  int type = 0;  ///< Gmsh's number of it
  int line = 0;
  std::size_t first = 0;  ///< of its nodes in element_nodes
  std::size_t tags = 0;   ///< of its physical groups in tag_sets
};

/// What a file says, each with its line, whether it makes sense or not.
struct Content {
  std::vector<Group> groups;
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<long long> element_nodes;    ///< by their numbers
  std::vector<std::vector<int>> tag_sets;  ///< tags of physical groups that elements have
  int first_line = 0;                      ///< of the elements' section
};

/// An element as Gmsh counts them.
struct ElementType {
  int number;
  const char* name;
  int dim, nodes;
  const char* instead;  ///< what would be right where none of ours is it
};

/// The type of that number, or null. Gmsh knows more, of higher orders.
const ElementType* find_type(int number);

/// Ours of that type, where there is one.
std::optional<ElementKind> kind_of(const ElementType& type);

/// Numbers of Gmsh's nodes of an element, in the order of ours.
std::vector<int> gmsh_order(ElementKind kind);

}  // namespace tether::gmsh
