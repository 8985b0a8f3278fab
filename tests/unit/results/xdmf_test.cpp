// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/xdmf.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fstream>
#include <sstream>

#include "results/snapshot_file.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using boost::property_tree::ptree;
using Names = std::vector<std::string>;
using Sizes = std::vector<std::size_t>;

/// Throws where the text is not well-formed.
ptree parsed(const std::string& text) {
  std::istringstream stream(text);
  ptree tree;
  boost::property_tree::read_xml(stream, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree;
}

std::vector<ptree> children(const ptree& tree, const std::string& name) {
  std::vector<ptree> found;
  for (const auto& [key, child] : tree) {
    if (key == name) found.push_back(child);
  }
  return found;
}

std::string attribute(const ptree& tree, const std::string& name) { return tree.get<std::string>("<xmlattr>." + name); }

/// The temporal collection of the file.
ptree series(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return parsed(text.str()).get_child("Xdmf.Domain.Grid");
}

Sizes sizes(const std::string& text) {
  std::istringstream stream(text);
  Sizes all;
  for (std::size_t n = 0; stream >> n;) all.push_back(n);
  return all;
}

/// The numbers that a hyperslab item of one record names, read from the file it points to.
std::vector<double> slab(const std::filesystem::path& folder, const ptree& item) {
  const auto parts = children(item, "DataItem");
  const auto target = parts.at(1).data();
  const test::Reader reader(folder / target.substr(0, target.find(":/")));
  const auto variable = target.substr(target.find(":/") + 2);
  Sizes shape;
  for (const auto& d : reader.dimensions(variable)) shape.push_back(reader.length(d));
  EXPECT_EQ(sizes(attribute(parts.at(1), "Dimensions")), shape);
  const auto selection = sizes(parts.at(0).data());
  const auto rank = shape.size();
  Sizes whole{selection.at(0)};
  whole.resize(rank, 0);
  whole.resize(2 * rank, 1);
  whole.push_back(1);
  whole.insert(whole.end(), shape.begin() + 1, shape.end());
  EXPECT_EQ(selection, whole);  // start, stride, count: all of one record
  const auto all = reader.values(variable);
  const auto length = static_cast<std::ptrdiff_t>(all.size() / shape.at(0));
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(selection.at(0)) * length;
  return {begin, begin + length};
}

using XdmfTest = test::TemporaryFolder;

TEST_F(XdmfTest, PlacesThePointsOfEachRecord) {
  PointWriter writer(folder, test::provenance());
  for (const double time : {0.25, 0.5}) writer.append(test::three_points(time));
  writer.close();
  const auto collection = series(folder / "particles.xmf");
  EXPECT_EQ(attribute(collection, "CollectionType"), "Temporal");
  const auto grids = children(collection, "Grid");
  ASSERT_EQ(grids.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const double time = k == 0 ? 0.25 : 0.5;
    const auto expected = test::three_points(time);
    EXPECT_EQ(grids[k].get<double>("Time.<xmlattr>.Value"), time);
    EXPECT_EQ(attribute(grids[k].get_child("Topology"), "TopologyType"), "Polyvertex");
    EXPECT_EQ(attribute(grids[k].get_child("Topology"), "NumberOfElements"), "3");
    EXPECT_EQ(attribute(grids[k].get_child("Geometry"), "GeometryType"), "X_Y");
    const auto places = children(grids[k].get_child("Geometry"), "DataItem");
    EXPECT_EQ(slab(folder, places.at(0)), expected.fields[0].values);
    EXPECT_EQ(slab(folder, places.at(1)), expected.fields[1].values);
    const auto fields = children(grids[k], "Attribute");
    ASSERT_EQ(fields.size(), expected.fields.size());
    for (std::size_t f = 0; f < fields.size(); ++f) {
      EXPECT_EQ(attribute(fields[f], "Name"), expected.fields[f].quantity.name);
      EXPECT_EQ(slab(folder, fields[f].get_child("DataItem")), expected.fields[f].values);
    }
  }
}

TEST_F(XdmfTest, CountsTheGridFromTheSlowestDirection) {
  GridWriter writer(folder, test::provenance());
  for (const double time : {0.5, 0.75, 1.0}) writer.append(test::small_grid(), test::six_nodes(time));
  writer.close();
  const auto grids = children(series(folder / "mesh.xmf"), "Grid");
  ASSERT_EQ(grids.size(), 3u);
  EXPECT_EQ(grids[2].get<double>("Time.<xmlattr>.Value"), 1.0);
  EXPECT_EQ(attribute(grids[2].get_child("Topology"), "TopologyType"), "3DCORECTMesh");
  EXPECT_EQ(attribute(grids[2].get_child("Topology"), "Dimensions"), "1 2 3");
  const auto geometry = grids[2].get_child("Geometry");
  EXPECT_EQ(attribute(geometry, "GeometryType"), "ORIGIN_DXDYDZ");
  const auto items = children(geometry, "DataItem");
  EXPECT_EQ(items.at(0).data(), "0 10 -1");
  EXPECT_EQ(items.at(1).data(), "1 0.25 0.5");
  const auto mass = grids[2].get_child("Attribute");
  EXPECT_EQ(attribute(mass, "Center"), "Node");
  EXPECT_EQ(attribute(mass.get_child("DataItem"), "Dimensions"), "1 2 3");
  EXPECT_EQ(slab(folder, mass.get_child("DataItem")), test::six_nodes(1.0).fields[0].values);
}

TEST_F(XdmfTest, IsWholeAfterEachRecord) {
  PointWriter writer(folder, test::provenance());
  for (std::size_t n = 1; n <= 3; ++n) {
    writer.append(test::three_points(static_cast<double>(n)));
    EXPECT_EQ(children(series(folder / "particles.xmf"), "Grid").size(), n);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "particles.xmf.new"));
}

TEST(Xdmf, IsWellFormedWithoutRecords) {
  EXPECT_EQ(attribute(parsed(xdmf_points({"particles.nc", {"x", "y"}, {}}, {})).get_child("Xdmf"), "Version"), "2.0");
}

TEST(Xdmf, KeepsEveryDigitOfATime) {
  const double time = 0.1 + 0.2;
  const auto tree = parsed(xdmf_points({"particles.nc", {"x", "y"}, {time}}, {5}));
  EXPECT_EQ(tree.get<std::string>("Xdmf.Domain.Grid.Grid.Time.<xmlattr>.Value"), "0.30000000000000004");
}

}  // namespace
}  // namespace tether
