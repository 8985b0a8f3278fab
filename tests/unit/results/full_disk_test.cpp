// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "results/checkpoint.hpp"
#include "results/grid_writer.hpp"
#include "results/history_writer.hpp"
#include "results/point_writer.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

/// A full disk is played by a largest file size, in a process of its own that ends as a program does: with its
/// destructors run, and the libraries' work at exit done.
class FullDiskTest : public test::TemporaryFolder {
 protected:
  static constexpr int told = 4;

  [[noreturn]] static void write_until_full(rlim_t bytes, const std::function<void()>& write) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) std::exit(1);
    try {
      write();
    } catch (const FileError& error) {
      std::cerr << error.what() << "\n";
      std::exit(told);
    }
    std::exit(0);
  }
};

Record record(int k) { return {1.0 * k, 2.0 * k, 3, 4, 5, 6, 7}; }

std::vector<double> first_times(std::size_t n) {
  std::vector<double> times;
  for (std::size_t k = 0; k < n; ++k) times.push_back(static_cast<double>(k));
  return times;
}

TEST_F(FullDiskTest, HistoryKeepsItsRecords) {
  for (const rlim_t limit : {8000, 8191, 20001}) {
    const auto write = [this] {
      HistoryWriter writer(folder, test::small_layout(), test::provenance());
      for (int k = 0; k < 10000; ++k) writer.append(record(k));
    };
    EXPECT_EXIT(write_until_full(limit, write), testing::ExitedWithCode(told), "history.nc.*File too large");
    const test::Reader reader(folder / "history.nc");
    const auto n = reader.length("time");
    EXPECT_GT(n, 100u);
    EXPECT_GT((n + 1) * 7 * sizeof(double) + 2000, limit);  // it ended because the disk was full
    EXPECT_EQ(reader.values("time"), first_times(n));
    EXPECT_EQ(reader.values("point_vy").at(3 * n - 1), 7);
    EXPECT_EQ(split_lines(read_file(folder / "history.txt")).size(), n + 1);
  }
}

TEST_F(FullDiskTest, HistoryTextEndsWithAWholeLine) {
  const auto write = [this] {
    TextFile file(folder / "history.txt");
    for (int k = 0; k < 10000; ++k) file.append("0.3333333333333333 7\n");
  };
  EXPECT_EXIT(write_until_full(5000, write), testing::ExitedWithCode(told), "history.txt.*File too large");
  const auto text = read_file(folder / "history.txt");
  EXPECT_EQ(text.size(), 5000u / 21u * 21u);
  EXPECT_EQ(text.back(), '\n');
}

TEST_F(FullDiskTest, SnapshotsKeepTheirRecords) {
  for (rlim_t limit = 200000; limit < 300000; limit += 6789) {
    const auto write = [this] {
      SnapshotFile file(folder / "particles.nc", {{"point", 3, {}}}, test::three_points(0), test::provenance());
      for (int k = 0; k < 5000; ++k) file.append(test::three_points(k));
    };
    EXPECT_EXIT(write_until_full(limit, write), testing::ExitedWithCode(told), "particles.nc.*File too large");
    const test::Reader reader(folder / "particles.nc");
    const auto n = reader.length("time");
    EXPECT_GT(n, 100u);
    EXPECT_EQ(reader.values("time"), first_times(n));
    const auto x = reader.values("x");
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(x.at(3 * k), 0.5 + static_cast<double>(k));
    EXPECT_EQ(reader.values("pressure").at(3 * n - 1), -3e-300);
  }
}

/// A file of 960 kB, next to one of NetCDF of 740.
TEST_F(FullDiskTest, AVtkFileWithoutRoomLeavesNoneAndNoRecord) {
  const auto write = [this] {
    Snapshot many = test::three_points(0);
    for (Field& field : many.fields) field.values.resize(20000, 1.0);
    PointWriter(folder, test::provenance()).append(many);
  };
  EXPECT_EXIT(write_until_full(850000, write), testing::ExitedWithCode(told), "particles-0000.vtp.*File too large");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "vtk"));
  EXPECT_FALSE(std::filesystem::exists(folder / "particles.pvd"));
  EXPECT_EQ(test::Reader(folder / "particles.nc").length("time"), 0u);
}

TEST_F(FullDiskTest, GridsKeepTheirRecords) {
  const BackgroundGrid grid(100, 50, 0, 99, 0, 49);
  const auto write = [this, grid] {
    GridWriter writer(folder, test::provenance());
    for (int k = 0; k < 1000; ++k) {
      const std::vector<double> values(5000, 0.5 + k);
      writer.append(grid, Snapshot{1.0 * k, {{{"grid_mass", Dimension::mass, "mass of a node"}, values}}});
    }
  };
  EXPECT_EXIT(write_until_full(1000000, write), testing::ExitedWithCode(told), "mesh.nc.*File too large");
  const test::Reader reader(folder / "mesh.nc");
  const auto n = reader.length("time");
  EXPECT_GT(n, 15u);
  EXPECT_EQ(reader.values("time"), first_times(n));
  EXPECT_EQ(reader.values("grid_mass").back(), static_cast<double>(n) - 0.5);
}

TEST_F(FullDiskTest, ACheckpointWithoutRoomLeavesTheOnesBefore) {
  Checkpoint checkpoint;
  checkpoint.records = {{0, 1}};
  checkpoint.state["x"] = std::vector<double>(100, 1.5);
  const auto write = [this, &checkpoint] {
    for (int k = 0; k < 10; ++k) {
      add_checkpoint(folder, checkpoint);
      checkpoint.state["x"].resize(checkpoint.state["x"].size() * 2, 2.5);
    }
  };
  EXPECT_EXIT(write_until_full(20000, write), testing::ExitedWithCode(told), "checkpoint-.*File too large");
  const auto found = checkpoints_in(folder);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& path : found) EXPECT_NO_THROW(read_checkpoint(path));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
}

TEST_F(FullDiskTest, NoRoomForTheFirstSnapshotLeavesNoFile) {
  const auto write = [this] { PointWriter(folder, test::provenance()).append(test::three_points(0)); };
  EXPECT_EXIT(write_until_full(10000, write), testing::ExitedWithCode(told), "particles.nc.*File too large");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace tether
