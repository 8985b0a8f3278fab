// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/netcdf_file.hpp"

#include <array>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using NetcdfFileTest = test::TemporaryFolder;

/// What a FileError says, or empty where none was thrown.
template <class Action>
std::string complaint(Action action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST_F(NetcdfFileTest, WritesEachFormatAsAsked) {
  for (const auto format : {NetcdfFormat::offset64, NetcdfFormat::netcdf4}) {
    NetcdfFile file(folder / "a.nc", format);
    const int n = file.dimension("n", 3);
    const int v = file.number_variable("v", {n});
    file.attribute(v, "units", "m s-1");
    file.attribute(v, "empty", "");
    file.end_definitions();
    file.put(v, {{0}, {3}}, std::array{1.0, 1.0 / 3, -1e308});
    file.close();
    const test::Reader reader(folder / "a.nc");
    EXPECT_EQ(reader.format(), format == NetcdfFormat::offset64 ? NC_FORMAT_64BIT_OFFSET : NC_FORMAT_NETCDF4);
    EXPECT_EQ(reader.values("v"), (std::vector<double>{1.0, 1.0 / 3, -1e308}));
    EXPECT_EQ(reader.attribute("units", "v"), "m s-1");
    EXPECT_EQ(reader.attribute("empty", "v"), "");
    EXPECT_FALSE(reader.unlimited("n"));
  }
}

TEST_F(NetcdfFileTest, TakesAFolderWithBlanksAndForeignLetters) {
  const auto odd = folder / "a b#1:ü";
  std::filesystem::create_directory(odd);
  NetcdfFile file(odd / "a.nc", NetcdfFormat::netcdf4);
  file.close();
  EXPECT_GT(std::filesystem::file_size(odd / "a.nc"), 0u);
}

TEST_F(NetcdfFileTest, NamesFileActionAndReason) {
  const auto path = folder / "missing" / "a.nc";
  EXPECT_EQ(complaint([&] { NetcdfFile file(path, NetcdfFormat::offset64); }),
            path.string() + ": cannot create the file: No such file or directory");
  NetcdfFile file(folder / "a.nc", NetcdfFormat::offset64);
  file.dimension("n", 3);
  EXPECT_EQ(complaint([&] { file.dimension("n", 4); }),
            (folder / "a.nc").string() + ": cannot define dimension n: NetCDF: String match to name in use");
  EXPECT_NE(complaint([&] { file.number_variable("a/b", {}); }), "");
}

TEST_F(NetcdfFileTest, RefusesPartsOutsideAVariable) {
  NetcdfFile file(folder / "a.nc", NetcdfFormat::offset64);
  const int v = file.number_variable("v", {file.dimension("n", 3)});
  file.end_definitions();
  EXPECT_EQ(complaint([&] {
              file.put(v, {{2}, {2}}, std::array{1.0, 2.0});
            }),
            (folder / "a.nc").string() + ": cannot write v: NetCDF: Start+count exceeds dimension bound");
  EXPECT_THROW(file.put(v, {{0}, {3}}, std::array{1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(file.put_text(v, {{0}, {3}}, "ab"), std::invalid_argument);
}

TEST_F(NetcdfFileTest, ComplainsOfAClosedFile) {
  NetcdfFile file(folder / "a.nc", NetcdfFormat::offset64);
  file.close();
  EXPECT_NE(complaint([&] { file.close(); }), "");
  EXPECT_NE(complaint([&] { file.sync(); }), "");
}

TEST_F(NetcdfFileTest, ReservesRoomWithoutGrowing) {
  NetcdfFile file(folder / "a.nc", NetcdfFormat::offset64);
  file.number_variable("v", {file.dimension("n", 3)});
  file.end_definitions();
  file.sync();
  const auto before = std::filesystem::file_size(folder / "a.nc");
  file.reserve(1 << 20);
  EXPECT_EQ(std::filesystem::file_size(folder / "a.nc"), before);
}

TEST_F(NetcdfFileTest, LeavesNoFileWhereThereIsNoRoomForIt) {
  const auto more_than_any_disk = std::size_t{1} << 62;
  EXPECT_THROW(NetcdfFile(folder / "a.nc", NetcdfFormat::netcdf4, more_than_any_disk), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.nc"));
}

}  // namespace
}  // namespace tether
