// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/history_writer.hpp"

#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using HistoryWriterTest = test::TemporaryFolder;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

const Record first{0, 1.0 / 3, 0.1, -0.2, 5e-324, 1e300, 7};
const Record second{0.1, 2.0 / 3, 0.3, -0.4, -0.0, 1e-5, 8};

TEST_F(HistoryWriterTest, WritesAllValuesByScenesBodiesAndPoints) {
  HistoryWriter writer(folder, test::small_layout(), test::provenance());
  writer.append(first);
  writer.append(second);
  writer.close();
  const test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.format(), NC_FORMAT_64BIT_OFFSET);
  EXPECT_TRUE(reader.unlimited("time"));
  EXPECT_EQ(reader.dimensions("energy_total"), (Names{"time"}));
  EXPECT_EQ(reader.dimensions("body_x"), (Names{"time", "body"}));
  EXPECT_EQ(reader.dimensions("point_vy"), (Names{"time", "point"}));
  EXPECT_EQ(reader.values("time"), (Values{0, 0.1}));
  EXPECT_EQ(reader.values("energy_total"), (Values{1.0 / 3, 2.0 / 3}));
  EXPECT_EQ(reader.values("body_x"), (Values{0.1, -0.2, 0.3, -0.4}));
  EXPECT_EQ(reader.values("point_vy"), (Values{5e-324, 1e300, 7, -0.0, 1e-5, 8}));
}

TEST_F(HistoryWriterTest, DescribesVariablesAndNames) {
  HistoryWriter(folder, test::small_layout(), test::provenance()).close();
  const test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.attribute("units", "time"), "s");
  EXPECT_EQ(reader.attribute("units", "energy_total"), "J");
  EXPECT_EQ(reader.attribute("units", "point_vy"), "m s-1");
  EXPECT_EQ(reader.attribute("long_name", "body_x"), "x of a body's centre of mass");
  EXPECT_EQ(reader.dimensions("body_name"), (Names{"body", "name_length"}));
  EXPECT_EQ(reader.text("body_name"), std::string("gas\0\0\0\0\0the bag\0", 16));
  EXPECT_EQ(reader.text("point_name"), std::string("apex\0\0\0\0left endp\0\0\0\0\0\0\0", 24));
}

TEST_F(HistoryWriterTest, CarriesItsProvenance) {
  const auto provenance = test::provenance();
  HistoryWriter(folder, test::small_layout(), provenance).close();
  const test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.attribute("Conventions"), "CF-1.10");
  EXPECT_EQ(reader.attribute("title"), provenance.title);
  EXPECT_EQ(reader.attribute("history"), provenance.command);
  EXPECT_EQ(reader.attribute("program"), "tether " + program_version());
  EXPECT_EQ(reader.attribute("git_hash"), git_hash());
  EXPECT_EQ(reader.attribute("deck"), provenance.deck_text);
  EXPECT_EQ(reader.attribute("deck_sha256"), provenance.deck_sha256);
}

TEST_F(HistoryWriterTest, HasPlainNumbersWhereTheDeckNamesNoUnits) {
  auto provenance = test::provenance();
  provenance.units = Units::none;
  HistoryWriter(folder, test::small_layout(), provenance).close();
  const test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.attribute("units", "time"), "1");
  EXPECT_EQ(reader.attribute("units", "energy_total"), "1");
}

TEST_F(HistoryWriterTest, CanBeReadWhileItGrows) {
  HistoryWriter writer(folder, test::small_layout(), test::provenance());
  test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.length("time"), 0u);
  EXPECT_EQ(reader.text("body_name").substr(0, 3), "gas");
  writer.append(first);
  reader.refresh();
  EXPECT_EQ(reader.values("point_vy"), (Values{5e-324, 1e300, 7}));
  EXPECT_EQ(split_lines(read_file(folder / "history.txt")).size(), 2u);
  writer.append(second);
  reader.refresh();
  EXPECT_EQ(reader.values("energy_total"), (Values{1.0 / 3, 2.0 / 3}));
  EXPECT_EQ(split_lines(read_file(folder / "history.txt")).size(), 3u);
}

TEST_F(HistoryWriterTest, WritesTheSameColumnsAsText) {
  HistoryWriter writer(folder, test::small_layout(), test::provenance());
  writer.append(first);
  writer.append(second);
  EXPECT_EQ(read_file(folder / "history.txt"),
            "# time energy_total body_x_1 body_x_2 point_vy_1 point_vy_2 point_vy_3\n"
            "0 0.3333333333333333 0.1 -0.2 5e-324 1e+300 7\n"
            "0.1 0.6666666666666666 0.3 -0.4 -0 1e-05 8\n");
}

TEST_F(HistoryWriterTest, TextReadsBackToTheSameBits) {
  HistoryWriter writer(folder, test::small_layout(), test::provenance());
  const Record hard{
      0.1 + 0.2,          std::numeric_limits<double>::max(), 1 + 0x1p-52, 123456789.12345679, 2e-308, 1e23,
      -9007199254740993.0};
  writer.append(hard);
  const auto lines = split_lines(read_file(folder / "history.txt"));
  std::istringstream words(lines.at(1));
  std::string word;
  Record back;
  while (words >> word) back.push_back(std::strtod(word.c_str(), nullptr));
  EXPECT_EQ(back, hard);
}

TEST_F(HistoryWriterTest, WritesWhatIsNotANumber) {
  HistoryWriter writer(folder, {{{"time", Dimension::time, "time"}}, {}, {}}, test::provenance());
  writer.append({std::numeric_limits<double>::infinity()});
  writer.append({std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(read_file(folder / "history.txt"), "# time\ninf\nnan\n");
}

TEST_F(HistoryWriterTest, NeedsNeitherBodiesNorPoints) {
  auto layout = test::small_layout();
  layout.body_names.clear();
  layout.point_names.clear();
  HistoryWriter writer(folder, layout, test::provenance());
  writer.append({0.5, 2});
  writer.close();
  const test::Reader reader(folder / "history.nc");
  EXPECT_EQ(reader.values("energy_total"), (Values{2}));
  EXPECT_FALSE(reader.has("body_x"));
  EXPECT_FALSE(reader.has("body_name"));
  EXPECT_FALSE(reader.has("point_vy"));
}

TEST_F(HistoryWriterTest, RefusesWrongRecordsAndLayouts) {
  HistoryWriter writer(folder, test::small_layout(), test::provenance());
  EXPECT_THROW(writer.append({1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(writer.append(Record(8, 0.0)), std::invalid_argument);
  EXPECT_THROW(HistoryWriter(folder, {}, test::provenance()), std::invalid_argument);
  EXPECT_THROW(HistoryWriter(folder, {{{"mass", Dimension::mass, "mass"}}, {}, {}}, test::provenance()),
               std::invalid_argument);
}

TEST_F(HistoryWriterTest, WritesTheSameBytesTwice) {
  for (const char* run : {"one", "two"}) {
    std::filesystem::create_directory(folder / run);
    HistoryWriter writer(folder / run, test::small_layout(), test::provenance());
    for (int k = 0; k < 1000; ++k) writer.append({0.1 * k, 1.0 / (k + 1), 2, 3, 4, 5, 6});
    writer.close();
  }
  EXPECT_EQ(read_file(folder / "one" / "history.nc"), read_file(folder / "two" / "history.nc"));
  EXPECT_EQ(read_file(folder / "one" / "history.txt"), read_file(folder / "two" / "history.txt"));
}

}  // namespace
}  // namespace tether
