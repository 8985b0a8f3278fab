// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "grid/gmsh/file.hpp"

namespace tether::test {

using Texts = std::vector<std::string>;

/// What is read of a text, and what is said about it.
struct GmshReading {
  std::optional<Mesh> mesh;
  std::vector<MeshFlaw> flaws;
  Diagnostics diagnostics;

  /// "line:column: message" of each error.
  Texts errors() const {
    Texts texts;
    for (const auto& d : diagnostics.errors())
      texts.push_back(fmt::format("{}:{}: {}", d.place.line, d.place.column, d.message));
    return texts;
  }
};

inline GmshReading read_mesh(const std::string& text, const std::vector<std::string>& regions = {""}) {
  GmshReading reading;
  reading.mesh = read_gmsh(text, "a.msh", regions, reading.flaws, reading.diagnostics);
  return reading;
}

/// An element of a made-up file: its dimension and type as Gmsh counts them, its physical group (0 none), its nodes.
struct MadeElement {
  int dim, type, group;
  std::vector<int> nodes;
};

/// A made-up file: nodes 1, 2, ..., elements 1, 2, ..., groups "dim tag "name"".
struct MadeFile {
  std::vector<std::array<double, 3>> nodes;
  std::vector<MadeElement> elements;
  Texts groups;

  std::string groups_text() const {
    if (groups.empty()) return "";
    std::string text = fmt::format("$PhysicalNames\n{}\n", groups.size());
    for (const auto& group : groups) text += group + "\n";
    return text + "$EndPhysicalNames\n";
  }
  std::string version_22() const {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + groups_text();
    text += fmt::format("$Nodes\n{}\n", nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
      text += fmt::format("{} {} {} {}\n", n + 1, nodes[n][0], nodes[n][1], nodes[n][2]);
    text += fmt::format("$EndNodes\n$Elements\n{}\n", elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
      text += fmt::format("{} {} 2 {} 1", e + 1, elements[e].type, elements[e].group);
      for (const int node : elements[e].nodes) text += fmt::format(" {}", node);
      text += "\n";
    }
    return text + "$EndElements\n";
  }
  /// Each element is an entity of its own.
  std::string version_41() const {
    std::string entities, blocks;
    std::array<int, 4> counts{};
    for (int dim = 0; dim < 4; ++dim) {
      for (std::size_t e = 0; e < elements.size(); ++e) {
        if (elements[e].dim != dim) continue;
        ++counts[static_cast<std::size_t>(dim)];
        entities += fmt::format("{} 0 0 0 {}{}{} 0\n", e + 1, dim > 0 ? "1 1 1 " : "", elements[e].group > 0 ? 1 : 0,
                                elements[e].group > 0 ? fmt::format(" {}", elements[e].group) : "");
        blocks += fmt::format("{} {} {} 1\n{}", dim, e + 1, elements[e].type, e + 1);
        for (const int node : elements[e].nodes) blocks += fmt::format(" {}", node);
        blocks += "\n";
      }
    }
    std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + groups_text();
    text +=
        fmt::format("$Entities\n{} {} {} {}\n{}$EndEntities\n", counts[0], counts[1], counts[2], counts[3], entities);
    text += fmt::format("$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) text += fmt::format("{}\n", n + 1);
    for (const auto& x : nodes) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
    return text + fmt::format("$EndNodes\n$Elements\n{0} {0} 1 {0}\n{1}$EndElements\n", elements.size(), blocks);
  }
};

/// Two squares of unit size side by side, groups "plate" (all), "left" and an unnamed one, 9, at the right.
inline MadeFile two_squares() {
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
          {{2, 3, 1, {1, 2, 5, 4}}, {2, 3, 1, {2, 3, 6, 5}}, {1, 1, 7, {4, 1}}, {1, 1, 9, {6, 3}}},
          {"1 7 \"left\"", "2 1 \"plate\""}};
}

/// The text with `with` in the place of its first `what`, which it must have.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

}  // namespace tether::test
