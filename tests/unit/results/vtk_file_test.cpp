// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a VTK file, read back apart from the code that wrote them.
#include "results/vtk_file.hpp"

#include <gtest/gtest.h>
#include <cstring>
#include <map>

#include "base/file.hpp"
#include "results/vtk_series.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using VtkFileTest = test::TemporaryFolder;
using Numbers = std::vector<double>;

/// The array of that name, by its offset.
template <class Number>
std::vector<Number> array_of(const std::string& bytes, const std::string& name) {
  const auto at = bytes.find("Name=\"" + name + "\"");
  const std::string key = "offset=\"";
  const auto offset = std::stoull(bytes.substr(bytes.find(key, at) + key.size()));
  const std::string begin = "<AppendedData encoding=\"raw\">\n_";
  const char* data = bytes.data() + bytes.find(begin) + begin.size() + offset;
  std::uint64_t length = 0;
  std::memcpy(&length, data, sizeof(length));
  std::vector<Number> numbers(length / sizeof(Number));
  std::memcpy(numbers.data(), data + sizeof(length), length);
  return numbers;
}

TEST(VtkParts, AreVectorsWhereNamesSaySo) {
  const auto parts = vtk_parts({"x", "y", "vx", "vy", "vz", "sxx", "sxy", "force_x", "force_y", "p", "max", "nx"});
  const std::vector<std::string> arrays{"", "", "v", "v", "v", "sxx", "sxy", "force", "force", "p", "max", "nx"};
  for (std::size_t k = 0; k < parts.size(); ++k) EXPECT_EQ(parts[k].array, arrays[k]);
  EXPECT_TRUE(parts[0].of_vector);
  EXPECT_EQ(parts[4].component, 2);
  EXPECT_EQ(parts[8].component, 1);
  for (const std::size_t k : {5, 6, 9, 10, 11}) EXPECT_FALSE(parts[k].of_vector) << k;
}

TEST_F(VtkFileTest, HasPlacesVectorsAndNumbers) {
  VtkFile file(folder / "a.vtp", vtk_of_points(2), {"y", "vx", "x", "p", "vy"}, 2);
  const std::vector<Numbers> fields{{10, 11}, {-1, -2}, {0.5, 1.0 / 3}, {7, 8e300}, {3, 4}};
  for (std::size_t k = 0; k < fields.size(); ++k) file.put(k, fields[k]);
  file.close();
  const std::string bytes = read_file(folder / "a.vtp");
  EXPECT_EQ(array_of<double>(bytes, "points"), (Numbers{0.5, 10, 0, 1.0 / 3, 11, 0}));
  EXPECT_EQ(array_of<double>(bytes, "v"), (Numbers{-1, 3, 0, -2, 4, 0}));
  EXPECT_EQ(array_of<double>(bytes, "p"), (Numbers{7, 8e300}));
  EXPECT_EQ(array_of<std::int32_t>(bytes, "connectivity"), (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(array_of<std::int32_t>(bytes, "offsets"), (std::vector<std::int32_t>{1, 2}));
  EXPECT_TRUE(bytes.ends_with("</AppendedData>\n</VTKFile>\n"));
}

TEST_F(VtkFileTest, HasCellsOfABoxAsAnImage) {
  StaggeredGrid grid{3, {2, 1, 3}, {1, 2, 3}, {0.5, 1, 2}};
  VtkFile(folder / "a.vti", vtk_of_cells(grid), {"p"}, 6).put(0, Numbers{1, 2, 3, 4, 5, 6});
  const std::string bytes = read_file(folder / "a.vti");
  EXPECT_NE(bytes.find("WholeExtent=\"0 2 0 1 0 3\" Origin=\"1 2 3\" Spacing=\"0.5 1 2\""), std::string::npos) << bytes;
  EXPECT_LT(bytes.find("<CellData>"), bytes.find("Name=\"p\""));
  EXPECT_EQ(array_of<double>(bytes, "p"), (Numbers{1, 2, 3, 4, 5, 6}));
}

TEST_F(VtkFileTest, IsLeftOutWhereItIsLargeOrNotWanted) {
  EXPECT_TRUE(writes_vtk(VtkFiles::automatic, most_in_vtk));
  EXPECT_FALSE(writes_vtk(VtkFiles::automatic, most_in_vtk + 1));
  EXPECT_TRUE(writes_vtk(VtkFiles::yes, most_in_vtk + 1));
  EXPECT_FALSE(writes_vtk(VtkFiles::no, 1));
}

}  // namespace
}  // namespace tether
