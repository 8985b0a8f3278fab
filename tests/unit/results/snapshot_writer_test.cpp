// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/grid_writer.hpp"
#include "results/point_writer.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/file.hpp"
#include "base/text.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using SnapshotWriterTest = test::TemporaryFolder;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

TEST_F(SnapshotWriterTest, CreatesNothingBeforeTheFirstSnapshot) {
  PointWriter points(folder, test::provenance());
  GridWriter grid(folder, test::provenance());
  points.close();
  grid.close();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(SnapshotWriterTest, WritesFieldsOfPoints) {
  PointWriter writer(folder, test::provenance());
  writer.append(test::three_points(0.25));
  writer.append(test::three_points(0.5));
  writer.close();
  const test::Reader reader(folder / "particles.nc");
  EXPECT_EQ(reader.format(), NC_FORMAT_NETCDF4);
  EXPECT_TRUE(reader.unlimited("time"));
  EXPECT_EQ(reader.dimensions("pressure"), (Names{"time", "point"}));
  EXPECT_EQ(reader.values("time"), (Values{0.25, 0.5}));
  EXPECT_EQ(reader.values("x"), (Values{0.75, 1.5, 2.5, 1.0, 1.5, 2.5}));
  EXPECT_EQ(reader.values("y"), (Values{-1, 0.1 * 0.25, 1.0 / 3, -1, 0.1 * 0.5, 1.0 / 3}));
  EXPECT_EQ(reader.values("id"), (Values{1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(reader.values("pressure"), (Values{1e5, 200000.25, -3e-300, 1e5, 200000.5, -3e-300}));
  EXPECT_EQ(reader.attribute("units", "pressure"), "Pa");
  EXPECT_EQ(reader.attribute("units", "id"), "1");
  EXPECT_EQ(reader.attribute("units", "time"), "s");
  EXPECT_EQ(reader.attribute("long_name", "x"), "place along x");
}

/// The first n of the points.
Snapshot first_points(double time, std::size_t n) {
  Snapshot snapshot = test::three_points(time);
  for (Field& field : snapshot.fields) field.values.resize(n);
  return snapshot;
}

TEST_F(SnapshotWriterTest, ARecordWithFewerPointsHasNoNumbersAtItsEnd) {
  PointWriter writer(folder, test::provenance(), VtkFiles::automatic, true);
  for (const std::size_t n : {2, 3, 1, 0}) writer.append(first_points(0.5, n));
  writer.close();
  const test::Reader reader(folder / "particles.nc");
  const Values id = reader.values("id");
  ASSERT_EQ(id.size(), 4u * 3u);
  const double gone = std::numeric_limits<double>::quiet_NaN();
  const Values expected{1, 2, gone, 1, 2, 3, 1, gone, gone, gone, gone, gone};
  for (std::size_t k = 0; k < id.size(); ++k)
    EXPECT_TRUE(id[k] == expected[k] || (std::isnan(id[k]) && std::isnan(expected[k]))) << k << ": " << id[k];
  for (const auto& [record, count] : {std::pair{0, 2}, {1, 3}, {2, 1}, {3, 0}}) {
    const std::string vtk = read_file(folder / "vtk" / ("particles-000" + std::to_string(record) + ".vtp"));
    EXPECT_NE(vtk.find("NumberOfPoints=\"" + std::to_string(count) + "\""), std::string::npos) << record;
  }
}

TEST_F(SnapshotWriterTest, WritesFieldsOfNodesWithTheirPlaces) {
  GridWriter writer(folder, test::provenance());
  writer.append(test::small_grid(), test::six_nodes(0.5));
  writer.append(test::small_grid(), test::six_nodes(0.75));
  writer.close();
  const test::Reader reader(folder / "mesh.nc");
  EXPECT_EQ(reader.format(), NC_FORMAT_NETCDF4);
  EXPECT_EQ(reader.dimensions("grid_mass"), (Names{"time", "node_y", "node_x"}));
  EXPECT_EQ(reader.values("node_x"), (Values{-1, -0.5, 0}));
  EXPECT_EQ(reader.values("node_y"), (Values{10, 10.25}));
  EXPECT_EQ(reader.attribute("units", "node_y"), "m");
  EXPECT_EQ(reader.values("time"), (Values{0.5, 0.75}));
  EXPECT_EQ(reader.values("grid_mass"), (Values{0.5, 1, 2, 10, 11, 12, 0.75, 1, 2, 10, 11, 12}));
}

TEST_F(SnapshotWriterTest, CarriesAWholeDeckWithItsParticles) {
  auto provenance = test::provenance();
  provenance.deck_text.assign(400000, 'd');  // beyond the 64 kB of a compact HDF5 attribute
  PointWriter writer(folder, provenance);
  writer.append(test::three_points(0));
  writer.close();
  const test::Reader reader(folder / "particles.nc");
  EXPECT_EQ(reader.attribute("deck"), provenance.deck_text);
  EXPECT_EQ(reader.attribute("Conventions"), "CF-1.10");
  EXPECT_EQ(reader.attribute("history"), provenance.command);
  EXPECT_EQ(reader.attribute("deck_sha256"), provenance.deck_sha256);
}

TEST_F(SnapshotWriterTest, KeepsTheFileAsSmallAsItsNumbers) {
  PointWriter writer(folder, test::provenance());
  for (int k = 0; k < 100; ++k) writer.append(test::three_points(k));
  writer.close();
  EXPECT_LT(std::filesystem::file_size(folder / "particles.nc"), 100000u);  // room is claimed, but not kept
}

TEST_F(SnapshotWriterTest, RefusesSnapshotsThatDoNotFit) {
  PointWriter writer(folder, test::provenance());
  EXPECT_THROW(writer.append(Snapshot{}), std::invalid_argument);
  EXPECT_THROW(writer.append(Snapshot{0, {{{"x", Dimension::length, "x"}, {}}, {{"y", Dimension::length, "y"}, {}}}}),
               std::invalid_argument);
  EXPECT_THROW(writer.append(test::six_nodes(0)), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  writer.append(test::three_points(0));
  auto other = test::three_points(1);
  other.fields[3].quantity.name = "density";
  EXPECT_THROW(writer.append(other), std::invalid_argument);
  auto longer = test::three_points(1);
  longer.fields[1].values.push_back(0);
  EXPECT_THROW(writer.append(longer), std::invalid_argument);
  auto fewer = test::three_points(1);
  fewer.fields.pop_back();
  EXPECT_THROW(writer.append(fewer), std::invalid_argument);
  writer.append(test::three_points(2));
  writer.close();
  EXPECT_EQ(test::Reader(folder / "particles.nc").values("time"), (Values{0, 2}));
}

TEST_F(SnapshotWriterTest, RefusesAGridThatChanges) {
  GridWriter writer(folder, test::provenance());
  writer.append(test::small_grid(), test::six_nodes(0));
  auto moved = test::small_grid();
  moved.x0 += 1;
  EXPECT_THROW(writer.append(moved, test::six_nodes(1)), std::invalid_argument);
  EXPECT_THROW(writer.append(test::small_grid(), test::three_points(1)), std::invalid_argument);
}

TEST_F(SnapshotWriterTest, WritesTheSameBytesTwice) {
  for (const char* run : {"one", "two"}) {
    std::filesystem::create_directory(folder / run);
    PointWriter points(folder / run, test::provenance());
    for (int k = 0; k < 3; ++k) points.append(test::three_points(k));
    points.close();
  }
  EXPECT_EQ(read_file(folder / "one" / "particles.nc"), read_file(folder / "two" / "particles.nc"));
  for (const char* name : {"particles.pvd", "vtk/particles-0002.vtp"})
    EXPECT_EQ(read_file(folder / "one" / name), read_file(folder / "two" / name)) << name;
}

}  // namespace
}  // namespace tether
