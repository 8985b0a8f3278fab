// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/result_folder.hpp"

#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "results/seal.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using ResultFolderTest = test::TemporaryFolder;

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

std::vector<double> replayed_times(const std::filesystem::path& file, std::size_t count, std::string& lost,
                                   const std::string& run = "run 1") {
  std::vector<double> times;
  const Snapshot like = test::three_points(0);
  lost = replay_snapshots(file, {like, count, run}, [&times](const Snapshot& snapshot) {
    const Snapshot same = test::three_points(snapshot.time);
    for (std::size_t k = 0; k < same.fields.size(); ++k) EXPECT_EQ(snapshot.fields[k].values, same.fields[k].values);
    times.push_back(snapshot.time);
  });
  return times;
}

void write_points(const std::filesystem::path& folder, EarlierSnapshots earlier, const std::vector<double>& times) {
  ResultFolder results(folder, test::small_layout(), test::provenance(), {.earlier = earlier});
  for (const double time : times) results.points(test::three_points(time));
}

TEST_F(ResultFolderTest, SetsEarlierSnapshotsAsideUntilTheyAreTakenOver) {
  write_points(folder, EarlierSnapshots::removed, {0, 1, 2});
  write_points(folder, EarlierSnapshots::set_aside, {0});  // as if killed before all were taken over
  write_points(folder, EarlierSnapshots::set_aside, {0, 1});
  const auto earlier = ResultFolder::earlier_snapshots(folder, "particles.nc");
  std::string lost;
  EXPECT_EQ(replayed_times(earlier, 3, lost), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(lost, "");
  ResultFolder(folder, test::small_layout(), test::provenance(), {.earlier = EarlierSnapshots::set_aside})
      .remove_what_was_set_aside("particles.nc");
  EXPECT_FALSE(std::filesystem::exists(earlier));
  EXPECT_EQ(ResultFolder::earlier_snapshots(folder, "particles.nc"), folder / "particles.nc");
}

TEST_F(ResultFolderTest, ANewRunRemovesWhatWasSetAside) {
  write_points(folder, EarlierSnapshots::removed, {0, 1, 2});
  write_points(folder, EarlierSnapshots::set_aside, {0});
  write_points(folder, EarlierSnapshots::removed, {5});
  std::string lost;
  EXPECT_EQ(replayed_times(ResultFolder::earlier_snapshots(folder, "particles.nc"), 1, lost), std::vector<double>{5});
}

TEST_F(ResultFolderTest, SnapshotsOfAnotherRunOrShapeAreNotTakenOver) {
  write_points(folder, EarlierSnapshots::removed, {0, 1});
  std::string lost;
  EXPECT_TRUE(replayed_times(folder / "particles.nc", 2, lost, "run 2").empty());
  EXPECT_EQ(lost, "2 of 2 earlier snapshots are lost: " + (folder / "particles.nc").string() + ": is of another run");
  Snapshot other = test::three_points(0);
  for (auto& field : other.fields) field.values.push_back(0);
  lost = replay_snapshots(folder / "particles.nc", {other, 2, "run 1"}, [](const Snapshot&) { FAIL(); });
  EXPECT_TRUE(lost.ends_with("is of another run")) << lost;
}

TEST_F(ResultFolderTest, WhatIsNotTakenOverStaysUnused) {
  write_points(folder, EarlierSnapshots::removed, {0, 1});
  ResultFolder again(folder, test::small_layout(), test::provenance(), {.earlier = EarlierSnapshots::set_aside});
  EXPECT_EQ(again.keep_what_was_set_aside("particles.nc"), folder / "particles.nc.unused");
  EXPECT_EQ(again.keep_what_was_set_aside("mesh.nc"), std::filesystem::path());
  std::string lost;
  EXPECT_EQ(replayed_times(folder / "particles.nc.unused", 2, lost), (std::vector<double>{0, 1}));
}

TEST_F(ResultFolderTest, AFailedWriteIsNoLostSnapshot) {
  write_points(folder, EarlierSnapshots::removed, {0, 1});
  const Snapshot like = test::three_points(0);
  const auto full = [](const Snapshot&) { throw FileError("no space"); };
  EXPECT_THROW(replay_snapshots(folder / "particles.nc", {like, 2, "run 1"}, full), FileError);
}

TEST_F(ResultFolderTest, TellsWhichEarlierSnapshotsAreLost) {
  write_points(folder, EarlierSnapshots::removed, {0, 1});
  std::string lost;
  EXPECT_EQ(replayed_times(folder / "particles.nc", 1, lost), std::vector<double>{0});  // of two, the first
  EXPECT_EQ(replayed_times(folder / "particles.nc", 5, lost), (std::vector<double>{0, 1}));
  EXPECT_TRUE(lost.starts_with("3 of 5 earlier snapshots are lost: ")) << lost;
  EXPECT_TRUE(replayed_times(folder / "nowhere.nc", 2, lost).empty());
  EXPECT_TRUE(lost.starts_with("2 of 2 earlier snapshots are lost: ")) << lost;
}

TEST_F(ResultFolderTest, HoldsTheFilesOfTheContract) {
  const auto deep = folder / "a" / "b";
  ResultFolder results(deep, test::small_layout(), test::provenance());
  EXPECT_EQ(results.path(), deep);
  results.deck_effective("$in $end\n");
  results.append(Record(7, 1.5));
  results.points(test::three_points(0));
  results.grid(test::small_grid(), test::six_nodes(0));
  results.reference({{"x"}, {{1}}});
  results.finish({{"steps", "1"}});
  EXPECT_EQ(names_in(deep),
            (std::set<std::string>{"deck.effective", "history.nc", "history.txt", "mesh.nc", "mesh.pvd", "messages.txt",
                                   "particles.nc", "particles.pvd", "reference.txt", "summary.txt", "vtk"}));
  EXPECT_EQ(read_file(deep / "deck.effective"), "$in $end\n");
  EXPECT_EQ(read_file(deep / "reference.txt"), "# x\n1\n");
  EXPECT_EQ(read_file(deep / "summary.txt"),
            "# tether " + program_version() + " " + git_hash() + "\n# tether decks/sod.in\nsteps = 1\n");
  EXPECT_EQ(test::Reader(deep / "history.nc").values("time"), std::vector<double>{1.5});
  EXPECT_EQ(test::Reader(deep / "particles.nc").values("id"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(test::Reader(deep / "mesh.nc").values("node_y"), (std::vector<double>{10, 10.25}));
}

TEST_F(ResultFolderTest, WritesOnlyWhatItIsGiven) {
  ResultFolder(folder, test::small_layout(), test::provenance()).finish({});
  EXPECT_EQ(names_in(folder), (std::set<std::string>{"history.nc", "history.txt", "messages.txt", "summary.txt"}));
}

TEST_F(ResultFolderTest, RemovesItsOwnFilesOfAnEarlierRunOnly) {
  for (const char* name :
       {"history.nc", "history.txt", "particles.nc", "particles.pvd", "mesh.nc", "mesh.pvd", "summary.txt",
        "messages.txt", "deck.effective", "reference.txt", "checkpoint-1.nc", "notes.md"}) {
    write_file(folder / name, "stale");
  }
  std::filesystem::create_directory(folder / "vtk");
  for (const char* name : {"particles-0000.vtp", "mesh-0017.vti", "mesh-0003.vtu", "solids-0000.vtu", "own.vtu"})
    write_file(folder / "vtk" / name, "stale");
  const ResultFolder results(folder, test::small_layout(), test::provenance());
  EXPECT_EQ(names_in(folder / "vtk"), std::set<std::string>{"own.vtu"});
  EXPECT_EQ(names_in(folder),
            (std::set<std::string>{"history.nc", "history.txt", "messages.txt", "checkpoint-1.nc", "notes.md", "vtk"}));
  EXPECT_EQ(read_file(folder / "messages.txt"), "");
  EXPECT_EQ(read_file(folder / "checkpoint-1.nc"), "stale");
  EXPECT_EQ(test::Reader(folder / "history.nc").length("time"), 0u);
}

TEST_F(ResultFolderTest, MessagesAreThereAtOnce) {
  ResultFolder results(folder, test::small_layout(), test::provenance());
  results.message("warning: tstep is above the limit");
  results.message("a.in:3:1: warning: odd\n  line\n");
  EXPECT_EQ(read_file(folder / "messages.txt"), "warning: tstep is above the limit\na.in:3:1: warning: odd\n  line\n");
}

/// The process ends at once: no destructor runs, no buffer of any library is emptied.
[[noreturn]] void write_and_crash(const std::filesystem::path& folder) {
  ResultFolder results(folder, test::small_layout(), test::provenance());
  results.append(Record(7, 1.5));
  results.points(test::three_points(0.5));
  results.grid(test::small_grid(), test::six_nodes(0.5));
  results.message("warning");
  ::_exit(9);
}

TEST_F(ResultFolderTest, KeepsEverythingInACrash) {
  EXPECT_EXIT(write_and_crash(folder), testing::ExitedWithCode(9), "");
  EXPECT_EQ(test::Reader(folder / "history.nc").values("point_vy"), (std::vector<double>{1.5, 1.5, 1.5}));
  EXPECT_EQ(test::Reader(folder / "particles.nc").values("id"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(test::Reader(folder / "mesh.nc").values("grid_mass"), (std::vector<double>{0.5, 1, 2, 10, 11, 12}));
  EXPECT_EQ(read_file(folder / "messages.txt"), "warning\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.txt"));
}

TEST_F(ResultFolderTest, IsRefusedBelowAFile) {
  write_file(folder / "file", "");
  EXPECT_THROW(ResultFolder(folder / "file", test::small_layout(), test::provenance()), FileError);
  try {
    const ResultFolder results(folder / "file" / "out", test::small_layout(), test::provenance());
    FAIL() << "a file has no folders";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), (folder / "file" / "out").string() + ": the folder cannot be made: Not a directory");
  }
}

TEST_F(ResultFolderTest, IsRefusedWhereAnOldOutputCannotBeRemoved) {
  std::filesystem::create_directories(folder / "mesh.nc" / "inside");
  EXPECT_THROW(ResultFolder(folder, test::small_layout(), test::provenance()), FileError);
}

}  // namespace
}  // namespace tether
