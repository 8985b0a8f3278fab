// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a mesh file is told at its line, and no file makes the reader fall.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/file.hpp"
#include "unit/grid/gmsh_support.hpp"

namespace tether::test {
namespace {

/// Of a file of version 2.2 in which `what` is `with`.
Texts errors_of(const std::string& what, const std::string& with) {
  return read_mesh(replaced(two_squares().version_22(), what, with)).errors();
}
Texts errors_41(const std::string& what, const std::string& with) {
  return read_mesh(replaced(two_squares().version_41(), what, with)).errors();
}

TEST(GmshErrors, OfTheFormat) {
  EXPECT_EQ(read_mesh("").errors(), Texts{"0:0: the file is empty"});
  EXPECT_EQ(read_mesh("solid a\nfacet\n").errors(), Texts{"0:0: no section $MeshFormat: this is no mesh file of Gmsh"});
  EXPECT_EQ(errors_of("2.2 0 8", "2.2 1 8"), Texts{"2:5: this is a binary file"});
  EXPECT_EQ(errors_of("2.2 0 8", "4 0 8"), Texts{"2:1: version 4 of the format is not read"});
  EXPECT_EQ(errors_of("2.2 0 8", "2,2 0 8"), Texts{"2:1: the version is no number: '2,2'"});
}

TEST(GmshErrors, OfSections) {
  EXPECT_EQ(errors_of("$EndNodes\n", ""), (Texts{"9:1: the section '$Nodes' that begins here has no '$EndNodes'"}));
  EXPECT_EQ(errors_of("$EndElements\n", ""),
            Texts{"18:1: the section '$Elements' that begins here has no '$EndElements'"});
  EXPECT_EQ(errors_of("$EndMeshFormat\n", "$EndMeshFormat\nlost\n"), Texts{"4:1: 'lost' stands in no section"});
  const std::string text = two_squares().version_22();
  EXPECT_EQ(read_mesh(text.substr(0, text.find("$Elements"))).errors(), Texts{"0:0: there is no section $Elements"});
  EXPECT_EQ(read_mesh(text + "$Nodes\n0\n$EndNodes\n").errors(), Texts{"25:1: a second section '$Nodes'"});
}

TEST(GmshErrors, OfCounts) {
  EXPECT_EQ(errors_of("$Nodes\n6\n", "$Nodes\n7\n"), Texts{"10:1: 7 nodes are declared, but at most 6 lines follow"});
  EXPECT_EQ(errors_of("$Nodes\n6\n", "$Nodes\n5\n"), Texts{"16:1: more lines than the count of nodes says"});
  EXPECT_EQ(errors_of("$Elements\n4\n", "$Elements\n4 4\n"), Texts{"19:3: '4' is one too many"});
  EXPECT_EQ(errors_of("$Elements\n4\n", "$Elements\n-4\n"), Texts{"19:1: the number of elements is -4, out of range"});
  EXPECT_EQ(errors_of("$PhysicalNames\n2\n", "$PhysicalNames\n9000000000000\n"),
            Texts{"5:1: 9000000000000 groups are declared, but at most 2 lines follow"});
  EXPECT_EQ(errors_41("$Nodes\n1 6", "$Nodes\n1 7"), Texts{"17:3: 7 nodes are declared, but the blocks have 6"});
  EXPECT_EQ(errors_41("$Nodes\n1 6", "$Nodes\n1 800000000"),
            Texts{"17:3: 800000000 nodes are declared, but at most 13 lines follow"});
  EXPECT_EQ(errors_41("2 1 0 6", "2 1 0 5"), Texts{"24:2: a coordinate is missing at the end of this line"});
  EXPECT_EQ(errors_41("2 1 0 6", "2 1 0 8000000000000000000"),
            Texts{"18:7: 8000000000000000000 nodes are declared, but at most 12 lines follow"});
  EXPECT_EQ(errors_41("$Elements\n4 4", "$Elements\n4 5"),
            Texts{"33:3: 5 elements are declared, but the blocks have 4"});
}

TEST(GmshErrors, OfNumbersAllAtOnce) {
  EXPECT_EQ(errors_of("2 1 0 0\n3 2 0 0", "2 1x 0 0\n3 2 0"),
            (Texts{"12:3: x is no number: '1x'", "13:6: z is missing at the end of this line"}));
  EXPECT_EQ(errors_of("2 1 0 0\n", "2 1 nan 0\n"), Texts{"12:5: y is no finite number of a size: 'nan'"});
  EXPECT_EQ(errors_of("2 1 0 0\n", "2 1 0 1e400\n"), Texts{"12:7: z is no finite number of a size: '1e400'"});
  EXPECT_EQ(errors_of("2 1 0 0\n", "1 1 0 0\n"), Texts{"12:1: node 1 is there twice, first at line 11"});
}

TEST(GmshErrors, OfElements) {
  EXPECT_EQ(errors_of("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5 44"),
            Texts{"20:1: element 1 names node 44, which is not there"});
  EXPECT_EQ(errors_of("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5"),
            Texts{"20:16: a node's number is missing at the end of this line"});
  EXPECT_EQ(errors_of("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5 4 6"), Texts{"20:19: '6' is one too many"});
  EXPECT_EQ(errors_of("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5 5"), Texts{"20:1: element 1 names node 5 twice"});
  EXPECT_EQ(errors_of("1 3 2 1 1 1 2 5 4", "1 77 2 1 1 1 2 5 4"), Texts{"20:3: element 1 is of an unknown type, 77"});
  EXPECT_EQ(errors_of("2 3 2 1 1 2 3 6 5", "2 3 2 1 1 1 2 5 4"), (Texts{"21:1: elements 1 and 2 have the same nodes"}));
  EXPECT_EQ(errors_41("2 2 3 1", "2 5 3 1"), Texts{"40:3: the entity of dimension 2 with tag 5 is not in $Entities"});
}

/// One kind a mesh: what tether does not have is told with what would be right, mixtures with their numbers.
TEST(GmshErrors, OfKindsOfElements) {
  MadeFile file = two_squares();
  file.elements.push_back({2, 2, 1, {2, 3, 6}});
  EXPECT_EQ(
      read_mesh(file.version_22()).errors(),
      Texts{"20:1: elements of two kinds: 1 of the type 3-node triangle, and 2 of the type 4-node quadrangle, the "
            "first here"});
  for (const auto& [type, nodes, name] : {std::tuple{16, 8, "8-node quadrangle"}, {20, 9, "9-node triangle"}}) {
    MadeFile other;
    for (int n = 0; n < nodes; ++n) other.nodes.push_back({n * 1.0, n * n * 1.0, 0});
    other.elements = {{2, type, 1, {}}};
    for (int n = 1; n <= nodes; ++n) other.elements[0].nodes.push_back(n);
    const auto reading = read_mesh(other.version_22());
    ASSERT_EQ(reading.diagnostics.errors().size(), 1U);
    EXPECT_EQ(reading.diagnostics.errors()[0].message,
              std::string("tether has no ") + name + ", of which there are 1, the first here");
    EXPECT_NE(reading.diagnostics.errors()[0].hint, "");
  }
  MadeFile lines = two_squares();
  lines.elements.erase(lines.elements.begin(), lines.elements.begin() + 2);
  EXPECT_EQ(read_mesh(lines.version_22()).errors(), Texts{"18:1: there are no elements of a surface or a volume"});
}

TEST(GmshErrors, OfNodes) {
  MadeFile file = two_squares();
  file.nodes.push_back({0.5, 0.5, 0});
  EXPECT_EQ(read_mesh(file.version_22()).errors(), Texts{"17:1: node 7 at (0.5, 0.5, 0) belongs to no element"});
  for (int k = 0; k < 9; ++k) file.nodes.push_back({0.1, 0.05 * k, 0});
  const auto many = read_mesh(file.version_22()).errors();
  ASSERT_EQ(many.size(), 5U);
  EXPECT_EQ(many[4], "21:1: node 11 at (0.1, 0.15, 0) belongs to no element (and 5 others)");

  file = two_squares();  // the second square has nodes of its own, of which two stand on the first's
  file.nodes.push_back({1 + 1e-11, 0, 0});
  file.nodes.push_back({1, 1, 0});
  file.elements[1].nodes = {7, 3, 6, 8};
  EXPECT_EQ(read_mesh(file.version_22()).errors(),
            (Texts{"17:1: nodes 2 and 7 are in one place, (1, 0)", "18:1: nodes 5 and 8 are in one place, (1, 1)"}));
  file.nodes[6] = {1, 0.25, 0}, file.nodes[7] = {1, 0.75, 0};
  EXPECT_EQ(read_mesh(file.version_22()).errors(),
            Texts{"17:1: node 7 at (1, 0.25) hangs: it lies within a side of an element that does not have it"});
  file = two_squares();
  file.nodes[4][2] = 0.5;
  EXPECT_EQ(read_mesh(file.version_22()).errors(),
            Texts{"15:1: node 5 at (1, 1, 0.5) is not in the plane z = 0 of node 1"});
}

/// Nodes within rounding of each other are found wherever a lattice's planes lie, others are left alone.
TEST(GmshErrors, OfNodesInOnePlaceWhereverTheyAre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, 1);
  Mesh mesh;
  for (int n = 0; n < 300; ++n) {
    const double x = n == 0 ? 0 : n == 1 ? 1 : anywhere(random), y = n < 2 ? 0 : anywhere(random);
    const double turn = 6.28 * anywhere(random);
    for (const double reach : {0.0, 0.9e-9, 3e-9}) {
      mesh.x.push_back(x + reach * std::cos(turn));
      mesh.x.push_back(y + reach * std::sin(turn));
    }
  }
  const auto pairs = coinciding_nodes(mesh);
  ASSERT_EQ(pairs.size(), 300U);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_EQ(pairs[k], std::pair(static_cast<int>(3 * k), static_cast<int>(3 * k + 1)));
}

TEST(GmshErrors, OfElementsInsideOut) {
  MadeFile file = two_squares();
  file.elements[1].nodes = {5, 6, 3, 2};
  EXPECT_EQ(read_mesh(file.version_22()).errors(),
            Texts{"21:1: element 2 of region 1 at (1, 1) is turned inside out or flat"});
}

TEST(GmshErrors, OfGroups) {
  EXPECT_EQ(errors_of("1 7 \"left\"", "1 7 left"), Texts{"6:5: the name of a group must stand in quotes"});
  EXPECT_EQ(errors_of("1 7 \"left\"", "2 1 \"left\""),
            Texts{"7:5: a group of dimension 2 has this tag already, at line 6"});
  EXPECT_EQ(errors_of("1 7 \"left\"", "1 8 \"left\""), Texts{"6:1: the physical group 'left' has no elements"});
  EXPECT_EQ(errors_of("3 1 2 7 1 4 1", "3 1 2 7 1 4 2"),
            Texts{"22:1: the 2-node line 3 of the physical group 'left' (tag 7) is no side of an element"});
  EXPECT_EQ(errors_of("2 3 2 1 1 2 3 6 5", "2 3 2 4 1 2 3 6 5"),
            Texts{"21:1: element 2 belongs to no region: its physical group is tag 4"});
  EXPECT_EQ(errors_of("2 3 2 1 1 2 3 6 5", "2 3 2 0 1 2 3 6 5"),
            Texts{"21:1: element 2 belongs to no physical group, while others do"});
  const auto flaws = [](const std::vector<std::string>& regions) {
    Texts texts;
    for (const auto& flaw : read_mesh(two_squares().version_22(), regions).flaws)
      texts.push_back(fmt::format("{}: {}", flaw.region, flaw.message));
    return texts;
  };
  EXPECT_EQ(flaws({"plte"}), Texts{"0: the file has no elements in a physical group 'plte' (did you mean 'plate'?); "
                                   "its groups are 'plate' (tag 1)"});
  EXPECT_EQ(flaws({"", ""}),
            Texts{"1: the file has no elements in a physical group of tag 2; its groups are 'plate' (tag 1)"});
  EXPECT_EQ(flaws({"plate", "plate"}), Texts{"1: the physical group 'plate' (tag 1) is region 1 already"});
}

/// Of a file with overlapping groups (version 4.1) each element has the one region that is named.
TEST(GmshErrors, OfOverlappingGroups) {
  MadeFile file = two_squares();
  const std::string text = replaced(file.version_41(), "1 0 0 0 1 1 1 1 1 0", "1 0 0 0 1 1 1 2 1 2 0");
  EXPECT_EQ(read_mesh(text).errors(), Texts{});
  EXPECT_EQ(read_mesh(text, {"", ""}).errors(),
            Texts{"39:1: element 1 belongs to two regions: 'plate' (tag 1), tag 2"});
}

/// Either a mesh or a mistake whose place is in the text.
void expect_an_answer(const std::string& text) {
  const auto reading = read_mesh(text);
  const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
  EXPECT_EQ(reading.mesh.has_value(), reading.errors().empty() && reading.flaws.empty()) << text;
  for (const auto& d : reading.diagnostics.all()) {
    ASSERT_GE(d.place.line, 0);
    ASSERT_LE(d.place.line, lines) << to_text(d);
    ASSERT_LE(d.place.column, static_cast<int>(d.line_text.size()) + 1) << to_text(d);
  }
}

class MutatedMeshes : public testing::TestWithParam<std::string> {
 protected:
  std::string text() const { return read_file(std::string(TETHER_SOURCE_DIR) + "/tests/meshes/" + GetParam()); }
};

TEST_P(MutatedMeshes, CutOff) {
  const auto whole = text();
  for (std::size_t k = 0; k < whole.size(); ++k) expect_an_answer(whole.substr(0, k));
}

TEST_P(MutatedMeshes, WithoutOneByteOrWithAnother) {
  const auto whole = text();
  std::mt19937 random(11);
  const std::string likely = "0123456789 .-$e\n\"\t\r";
  for (std::size_t k = 0; k < whole.size(); ++k) {
    auto mutated = whole;
    expect_an_answer(mutated.erase(k, 1));
    mutated = whole;
    mutated[k] = k % 2 == 0 ? likely[random() % likely.size()] : static_cast<char>(random() % 256);
    expect_an_answer(mutated);
    mutated = whole;
    expect_an_answer(mutated.insert(k, 1, whole[k]));
  }
}

INSTANTIATE_TEST_SUITE_P(Gmsh, MutatedMeshes, testing::Values("box-41.msh", "plate-22.msh"));

}  // namespace
}  // namespace tether::test
