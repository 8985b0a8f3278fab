// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/mesh_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/file.hpp"
#include "grid/block_mesh.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

Mesh unit_box(ElementKind kind) {
  Block block;
  block.edges = {straight({0, 0}, {1, 0}), straight({1, 0}, {1, 1}), straight({1, 1}, {0, 1}),
                 straight({0, 1}, {0, 0})};
  block.z_high = 1;
  std::vector<MeshFlaw> flaws;
  return mesh_of_blocks({block}, kind, flaws);
}

/// Places of the one element's nodes in VTK's order.
std::vector<Vec<3>> places(ElementKind kind) {
  const Mesh mesh = unit_box(kind);
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::vector<Vec<3>> places;
  for (const int a : vtk_order(kind)) {
    Vec<3> place{};
    for (std::size_t i = 0; i < dim; ++i) place[i] = mesh.x[static_cast<std::size_t>(mesh.element(0)[a]) * dim + i];
    places.push_back(place);
  }
  return places;
}

/// Mean of the nodes of those numbers.
Vec<3> mean(const std::vector<Vec<3>>& of, std::initializer_list<std::size_t> numbers) {
  Vec<3> sum{};
  for (const std::size_t n : numbers) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += of[n][i] / static_cast<double>(numbers.size());
  }
  return sum;
}

TEST(MeshWriter, CountsCornersAroundAndThenMiddles) {
  const std::vector<Vec<3>> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(places(ElementKind::quad4), square);
  const auto nine = places(ElementKind::quad9);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(nine[k], square[k]);
    EXPECT_EQ(nine[4 + k], mean(nine, {k, (k + 1) % 4}));
  }
  EXPECT_EQ(nine[8], mean(nine, {0, 1, 2, 3}));
  const auto box = places(ElementKind::hex27);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(box[k], square[k]);
    EXPECT_EQ(box[4 + k], (Vec<3>{square[k][0], square[k][1], 1}));
    EXPECT_EQ(box[8 + k], mean(box, {k, (k + 1) % 4}));
    EXPECT_EQ(box[12 + k], mean(box, {4 + k, 4 + (k + 1) % 4}));
    EXPECT_EQ(box[16 + k], mean(box, {k, 4 + k}));
  }
  EXPECT_EQ(box[20], mean(box, {0, 3, 4, 7}));
  EXPECT_EQ(box[21], mean(box, {1, 2, 5, 6}));
  EXPECT_EQ(box[22], mean(box, {0, 1, 4, 5}));
  EXPECT_EQ(box[23], mean(box, {2, 3, 6, 7}));
  EXPECT_EQ(box[24], mean(box, {0, 1, 2, 3}));
  EXPECT_EQ(box[25], mean(box, {4, 5, 6, 7}));
  EXPECT_EQ(box[26], mean(box, {0, 6}));
  const auto eight = places(ElementKind::hex8);
  EXPECT_TRUE(std::equal(eight.begin(), eight.end(), box.begin()));
}

using MeshWriterTest = test::TemporaryFolder;
using Values = std::vector<double>;

TEST_F(MeshWriterTest, WritesElementsAndFieldsOfEachRecord) {
  const Mesh mesh = unit_box(ElementKind::quad4);
  MeshWriter writer(folder, "mesh", test::provenance());
  for (const double time : {0.0, 0.5}) {
    Snapshot snapshot{time, {}};
    snapshot.fields.push_back({{"x", Dimension::length, "place"}, {0 + time, 1 + time, 0 + time, 1 + time}});
    snapshot.fields.push_back({{"y", Dimension::length, "place"}, {0, 0, 1, 1}});
    writer.append(mesh, snapshot);
  }
  writer.close();
  const test::Reader reader(folder / "mesh.nc");
  EXPECT_EQ(reader.values("element_nodes"), (Values{0, 1, 3, 2}));
  EXPECT_EQ(reader.values("x"), (Values{0, 1, 0, 1, 0.5, 1.5, 0.5, 1.5}));
  EXPECT_EQ(reader.attribute("cf_role", "mesh"), "mesh_topology");
  EXPECT_EQ(reader.attribute("location", "x"), "node");
  EXPECT_EQ(reader.attribute("Conventions"), "CF-1.10 UGRID-1.0");
  EXPECT_EQ(reader.whole_attribute("topology_dimension", "mesh"), 2);
  EXPECT_EQ(reader.whole_attribute("start_index", "element_nodes"), 0);
  EXPECT_EQ(reader.attribute("node_coordinates", "mesh"), "node_x node_y");
  EXPECT_EQ(reader.values("node_x"), (Values{0, 1, 0, 1}));
  EXPECT_EQ(reader.values("node_y"), (Values{0, 0, 1, 1}));
  EXPECT_EQ(reader.dimensions("node_x"), std::vector<std::string>{"node"});
  EXPECT_EQ(reader.dimensions("element_region"), std::vector<std::string>{"element"});
  const std::string series = read_file(folder / "mesh.pvd");
  EXPECT_NE(series.find("timestep=\"0.5\" part=\"0\" file=\"vtk/mesh-0001.vtu\""), std::string::npos) << series;
  EXPECT_TRUE(std::filesystem::exists(folder / "vtk" / "mesh-0001.vtu"));
}

/// UGRID has no middles of edges: a face of 9 nodes would be read as a 9-gon.
TEST_F(MeshWriterTest, GivesReadersOfUgridTheCornersAlone) {
  const Mesh mesh = unit_box(ElementKind::quad9);
  MeshWriter writer(folder, "mesh", test::provenance());
  Snapshot snapshot{0, {}};
  snapshot.fields.push_back({{"x", Dimension::length, "place"}, Values(mesh.node_count(), 0.0)});
  writer.append(mesh, snapshot);
  writer.close();
  const test::Reader reader(folder / "mesh.nc");
  EXPECT_EQ(reader.attribute("face_node_connectivity", "mesh"), "element_corners");
  EXPECT_EQ(reader.dimensions("element_corners"), (std::vector<std::string>{"element", "corner"}));
  Values corners = reader.values("element_nodes");
  ASSERT_EQ(corners.size(), 9u);
  corners.resize(4);
  EXPECT_EQ(reader.values("element_corners"), corners);
}

}  // namespace
}  // namespace tether
