// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/file.hpp"
#include "grid/shapes.hpp"
#include "unit/grid/gmsh_support.hpp"
#include "unit/grid/mesh_support.hpp"

namespace tether::test {
namespace {

Mesh mesh_of(const std::string& text, const std::vector<std::string>& regions = {""}) {
  const GmshReading reading = read_mesh(text, regions);
  EXPECT_EQ(reading.errors(), Texts{});
  for (const auto& flaw : reading.flaws) ADD_FAILURE() << flaw.message;
  return reading.mesh.value_or(Mesh{});
}

/// A box element's nodes stand as on a lattice, along x first: the box from 0 to `size`.
void expect_lattice(const Mesh& mesh, std::array<double, 3> size) {
  const int p = order_of(mesh.kind), dim = mesh.dim();
  ASSERT_GT(mesh.element_count(), 0U);
  for (int a = 0; a < node_count_of(mesh.kind); ++a) {
    const int index[] = {a % (p + 1), a / (p + 1) % (p + 1), a / (p + 1) / (p + 1)};
    const auto node = static_cast<std::size_t>(mesh.element(0)[a]);
    for (int i = 0; i < dim; ++i) {
      EXPECT_NEAR(mesh.x[node * static_cast<std::size_t>(dim) + static_cast<std::size_t>(i)],
                  size[static_cast<std::size_t>(i)] * index[i] / p, 1e-9)
          << "node " << a << " axis " << i;
    }
  }
}

/// One element of each kind with one side that is a group, by the drawings of Gmsh's manual.
struct Kind {
  ElementKind kind;
  MadeFile file;
  double volume;
};

std::vector<std::array<double, 3>> corners_of_box() {
  return {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}};
}

/// Means of the nodes of these numbers (from 0), one behind the other.
void add_means(std::vector<std::array<double, 3>>& nodes, const std::vector<std::vector<int>>& of) {
  for (const auto& numbers : of) {
    std::array<double, 3> mean{};
    for (const int n : numbers) {
      for (std::size_t i = 0; i < 3; ++i)
        mean[i] += nodes[static_cast<std::size_t>(n)][i] / static_cast<double>(numbers.size());
    }
    nodes.push_back(mean);
  }
}

std::vector<int> up_to(int count) {
  std::vector<int> numbers;
  for (int n = 1; n <= count; ++n) numbers.push_back(n);
  return numbers;
}

std::vector<Kind> all_kinds() {
  std::vector<std::array<double, 3>> quad9{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, quad4 = quad9;
  add_means(quad9, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}});
  auto hex27 = corners_of_box();
  add_means(hex27, {{0, 1},
                    {0, 3},
                    {0, 4},
                    {1, 2},
                    {1, 5},
                    {2, 3},
                    {2, 6},
                    {3, 7},
                    {4, 5},
                    {4, 7},
                    {5, 6},
                    {6, 7},
                    {0, 3, 2, 1},
                    {0, 1, 5, 4},
                    {0, 4, 7, 3},
                    {1, 2, 6, 5},
                    {2, 3, 7, 6},
                    {4, 5, 6, 7},
                    {0, 6}});
  std::vector<std::array<double, 3>> tri6{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, tet10 = tri6;
  tet10.push_back({0, 0, 3});
  add_means(tri6, {{0, 1}, {1, 2}, {2, 0}});
  add_means(tet10, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}});
  return {{ElementKind::tri6, {tri6, {{2, 9, 1, up_to(6)}, {1, 8, 7, {1, 3, 6}}}, {}}, 1},
          {ElementKind::tet10, {tet10, {{3, 11, 1, up_to(10)}, {2, 9, 7, {1, 3, 4, 7, 9, 8}}}, {}}, 1},
          {ElementKind::tri3, {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{2, 2, 1, {1, 2, 3}}, {1, 1, 7, {1, 3}}}, {}}, 1},
          {ElementKind::quad4, {quad4, {{2, 3, 1, up_to(4)}, {1, 1, 7, {1, 4}}}, {}}, 2},
          {ElementKind::quad9, {quad9, {{2, 10, 1, up_to(9)}, {1, 8, 7, {1, 4, 8}}}, {}}, 2},
          {ElementKind::tet4,
           {{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}}, {{3, 4, 1, up_to(4)}, {2, 2, 7, {1, 3, 4}}}, {}},
           1},
          {ElementKind::hex8, {corners_of_box(), {{3, 5, 1, up_to(8)}, {2, 3, 7, {1, 5, 8, 4}}}, {}}, 6},
          {ElementKind::hex27, {hex27, {{3, 12, 1, up_to(27)}, {2, 10, 7, {1, 5, 8, 4, 11, 18, 16, 10, 23}}}, {}}, 6}};
}

TEST(GmshFile, HasEachKindOfElementInBothVersions) {
  for (const Kind& kind : all_kinds()) {
    for (const auto& text : {kind.file.version_22(), kind.file.version_41()}) {
      SCOPED_TRACE(text);
      const Mesh mesh = mesh_of(text);
      EXPECT_EQ(mesh.kind, kind.kind);
      EXPECT_NEAR(volume(mesh), kind.volume, 1e-12);
      if (!is_simplex(kind.kind)) expect_lattice(mesh, {2, 1, 3});
      // The group is the side at x = 0, in the order of the mesh's own boundary.
      ASSERT_EQ(mesh.sides.count("physical 7"), 1U);
      const Sides& side = mesh.sides.at("physical 7");
      ASSERT_EQ(side.size(), static_cast<std::size_t>(side_node_count_of(kind.kind)));
      const Sides boundary = boundary_of(mesh);
      EXPECT_NE(std::search(boundary.begin(), boundary.end(), side.begin(), side.end()), boundary.end());
      for (const int node : side)
        EXPECT_EQ(mesh.x[static_cast<std::size_t>(node) * static_cast<std::size_t>(mesh.dim())], 0);
    }
  }
}

/// Files that Gmsh 4.8.4 wrote.
TEST(GmshFile, ReadsWhatGmshWrites) {
  const std::string folder = std::string(TETHER_SOURCE_DIR) + "/tests/meshes/";
  const Mesh box = mesh_of(read_file(folder + "box-41.msh"), {"box"});
  EXPECT_EQ(box.kind, ElementKind::hex27);
  EXPECT_NEAR(volume(box), 2, 1e-9);
  expect_lattice(box, {2, 1, 1});
  ASSERT_EQ(box.sides.size(), 1U);
  ASSERT_EQ(box.sides.at("top").size(), 9U);
  for (const int node : box.sides.at("top")) EXPECT_NEAR(box.x[static_cast<std::size_t>(node) * 3 + 2], 1, 1e-12);
  const Mesh plate = mesh_of(read_file(folder + "plate-22.msh"));
  EXPECT_EQ(plate.kind, ElementKind::quad9);
  EXPECT_EQ(plate.element_count(), 2U);
  EXPECT_NEAR(volume(plate), 2, 1e-9);
  ASSERT_EQ(plate.sides.size(), 2U);
  EXPECT_EQ(plate.sides.at("left").size(), 3U);
  for (const int node : plate.sides.at("physical 8")) EXPECT_NEAR(plate.x[static_cast<std::size_t>(node) * 2], 2, 1e-9);
}

TEST(GmshFile, RegionsAreGroupsByTagOrName) {
  MadeFile file = two_squares();
  file.elements[1].group = 2;
  file.groups.push_back("2 2 \"core\"");
  for (const auto& text : {file.version_22(), file.version_41()}) {
    EXPECT_EQ(mesh_of(text, {"", ""}).region, (std::vector<int>{0, 1}));
    EXPECT_EQ(mesh_of(text, {"core", "plate"}).region, (std::vector<int>{1, 0}));
    const Mesh mesh = mesh_of(text, {"", "core"});
    EXPECT_EQ(mesh.sides.size(), 2U);
    EXPECT_EQ(mesh.sides.count("left"), 1U);
    EXPECT_EQ(mesh.sides.count("physical 9"), 1U);
  }
}

/// Gmsh numbers groups of each dimension from 1, and their names may stand in any order.
TEST(GmshFile, GroupsOfOtherDimensionsMayHaveTheSameTag) {
  MadeFile file = two_squares();
  file.elements[2].group = 1;
  file.groups = {"2 1 \"plate\"", "1 1 \"left\""};
  for (const auto& text : {file.version_22(), file.version_41()}) EXPECT_EQ(mesh_of(text).sides.count("left"), 1U);
}

/// Groups of points, and of curves in space, are sets of nodes; one that has the name of sides cannot be named.
TEST(GmshFile, GroupsOfFewerDimensionsAreSetsOfNodes) {
  MadeFile file = two_squares();
  file.elements.insert(file.elements.end(), {{0, 15, 5, {4}}, {0, 15, 5, {1}}, {0, 15, 6, {2}}});
  file.groups.push_back("0 5 \"ends\"");
  for (const auto& text : {file.version_22(), file.version_41()}) {
    const Mesh mesh = mesh_of(text);
    ASSERT_EQ(mesh.node_sets.size(), 2U);
    EXPECT_EQ(mesh.node_sets.at("ends"), (std::vector<int>{0, 3}));
    EXPECT_EQ(mesh.node_sets.at("physical 6"), (std::vector<int>{1}));
  }
  file.groups.back() = "0 5 \"left\"";
  const auto reading = read_mesh(file.version_22());
  ASSERT_TRUE(reading.mesh);
  EXPECT_EQ(reading.mesh->node_sets.count("left"), 0U);
  ASSERT_EQ(reading.diagnostics.warnings().size(), 1U);
  EXPECT_EQ(reading.diagnostics.warnings()[0].message,
            "the name 'left' is that of a group of sides, too: a deck cannot name these nodes");
}

TEST(GmshFile, WithoutGroupsIsRegionOne) {
  MadeFile file = two_squares();
  for (auto& element : file.elements) element.group = 0;
  file.groups.clear();
  for (const auto& text : {file.version_22(), file.version_41()}) {
    const Mesh mesh = mesh_of(text);
    EXPECT_EQ(mesh.region, (std::vector<int>{0, 0}));
    EXPECT_TRUE(mesh.sides.empty());
    const auto reading = read_mesh(text, {"", "plate"});
    ASSERT_EQ(reading.flaws.size(), 1U);
    EXPECT_EQ(reading.flaws[0].region, 1U);
    EXPECT_FALSE(reading.mesh);
  }
}

TEST(GmshFile, TakesOtherLineEndsCommentsAndSections) {
  const MadeFile file = two_squares();
  for (const auto& text : {file.version_22(), file.version_41()}) {
    const Mesh mesh = mesh_of(text);
    std::string windows;
    for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(mesh_of(windows).nodes, mesh.nodes);
    const std::string comments = "$Comments\nanything $Nodes\n$Elements\n$EndComments\n";
    EXPECT_EQ(mesh_of(comments + text).nodes, mesh.nodes);
    EXPECT_EQ(mesh_of(text + comments + "$Periodic\n0\n$EndPeriodic\n\n").nodes, mesh.nodes);
    EXPECT_EQ(mesh_of(replaced(text, "$Nodes\n", "$Nodes\n\n")).nodes, mesh.nodes);
    EXPECT_EQ(mesh_of(text.substr(0, text.size() - 1)).nodes, mesh.nodes);
  }
}

/// Numbers of nodes with gaps, in any order; the plane may be any z.
TEST(GmshFile, TakesSparseNumbersAndAnotherPlane) {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n900000000007 0 1 5\n4 0 0 5\n77 1 0 5\n$EndNodes\n"
      "$Elements\n1\n12 2 0 4 77 900000000007\n$EndElements\n";
  const Mesh mesh = mesh_of(text);
  EXPECT_EQ(mesh.nodes, (std::vector<int>{1, 2, 0}));
  EXPECT_DOUBLE_EQ(volume(mesh), 0.5);
}

/// Parametric nodes of version 4.1 have up to three numbers more.
TEST(GmshFile, PassesOverParameters) {
  const std::string text = replaced(two_squares().version_41(), "2 1 0 6", "2 1 1 6");
  EXPECT_NEAR(volume(mesh_of(replaced(text, "1 0 0\n2 0 0\n", "1 0 0 .5\n2 0 0 .1 .2\n"))), 2, 1e-12);
}

/// One surface in two groups, as both versions write it: an element twice, or with two tags.
TEST(GmshFile, MeshesMayShareElements) {
  MadeFile file = two_squares();
  file.elements.push_back({2, 3, 2, {2, 3, 6, 5}});
  file.groups.push_back("2 2 \"flag\"");
  const std::string both = replaced(two_squares().version_41(), "2 0 0 0 1 1 1 1 1 0\n", "2 0 0 0 1 1 1 2 1 2 0\n");
  const std::string named = replaced(both, "2 1 \"plate\"", "2 1 \"plate\"\n2 2 \"flag\"");
  for (const auto& text : {file.version_22(), replaced(named, "$PhysicalNames\n2\n", "$PhysicalNames\n3\n")}) {
    std::vector<MeshFlaw> flaws;
    Diagnostics diagnostics;
    const auto meshes = read_gmsh_meshes(text, "a.msh", {{4, "flag", 1}, {9, "plate", 0}}, flaws, diagnostics);
    for (const auto& d : diagnostics.errors()) ADD_FAILURE() << d.message;
    ASSERT_EQ(meshes.size(), 2u);
    EXPECT_EQ(meshes[0].element_count(), 2u);
    EXPECT_EQ(meshes[0].node_count(), 6u);
    EXPECT_EQ(meshes[1].element_count(), 1u);
    EXPECT_EQ(meshes[1].x, (std::vector<double>{1, 0, 2, 0, 1, 1, 2, 1}));
    EXPECT_EQ(meshes[1].region, (std::vector<int>{0}));
    EXPECT_EQ(meshes[1].sides.count("left"), 0u);
    ASSERT_EQ(meshes[1].sides.count("physical 9"), 1u);
    EXPECT_EQ(meshes[1].sides.at("physical 9"), (Sides{1, 3}));
    EXPECT_EQ(meshes[0].sides.at("physical 9"), (Sides{2, 5}));
  }
}

}  // namespace
}  // namespace tether::test
