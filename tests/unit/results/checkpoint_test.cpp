// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/checkpoint.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "results/netcdf_file.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

using CheckpointTest = test::TemporaryFolder;

Checkpoint example() {
  Checkpoint checkpoint;
  checkpoint.provenance = {"a title", "tether x.in", "$in\n$\n", "abc", Units::si};
  checkpoint.deck_effective = "$in\nnx = 3\n$\n";
  checkpoint.time = 0.1 + 0.2;
  checkpoint.state = {{"x", {1, -0.0, 1e-308, std::numeric_limits<double>::denorm_min()}},
                      {"steps", {9007199254740991.0}}};
  checkpoint.records = {{0, 1, 2}, {0.1, 1.1, 2.1}};
  checkpoint.dues = {{0.1, 0.2}, {0, 1e308}};
  checkpoint.point_snapshots = 2;
  checkpoint.messages = {"warning: one", "warning: two"};
  checkpoint.whole = {1.5, 2.5}, checkpoint.setup = {0.1, 1e-9};
  checkpoint.parts = {{"assembly", {0.5, 1.0 / 3}}, {"solve", {0.7, 0.8}}};
  return checkpoint;
}

void damage(const std::filesystem::path& path, std::size_t at) {
  std::string bytes = read_file(path);
  bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
  write_file(path, bytes);
}

std::string refusal(const std::filesystem::path& path) {
  try {
    read_checkpoint(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST_F(CheckpointTest, ReadsBackWhatWasWritten) {
  const Checkpoint written = example();
  write_checkpoint(folder / "c.nc", written);
  const Checkpoint read = read_checkpoint(folder / "c.nc");
  EXPECT_EQ(read.deck_effective, written.deck_effective);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.state, written.state);
  EXPECT_TRUE(std::signbit(read.state.at("x")[1]));
  EXPECT_EQ(read.records, written.records);
  ASSERT_EQ(read.dues.size(), 2U);
  EXPECT_EQ(read.dues[0].next, 0.2);
  EXPECT_EQ(read.dues[1].interval, 0);
  EXPECT_EQ(read.point_snapshots, 2U);
  EXPECT_EQ(read.grid_snapshots, 0U);
  EXPECT_EQ(read.messages, written.messages);
  EXPECT_EQ(read.whole.cpu, 1.5);
  EXPECT_EQ(read.whole.wall, 2.5);
  EXPECT_EQ(read.setup.cpu, 0.1);
  EXPECT_EQ(read.setup.wall, 1e-9);
  ASSERT_EQ(read.parts.size(), 2U);
  EXPECT_EQ(read.parts[0].name, "assembly");
  EXPECT_EQ(read.parts[0].taken.wall, 1.0 / 3);
  EXPECT_EQ(read.parts[1].taken.cpu, 0.7);
}

TEST_F(CheckpointTest, LeavesNoTemporaryFile) {
  write_checkpoint(folder / "c.nc", example());
  write_checkpoint(folder / "c.nc", example());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST_F(CheckpointTest, EveryDamagedByteIsFound) {
  const auto path = folder / "c.nc";
  write_checkpoint(path, example());
  const std::size_t size = std::filesystem::file_size(path);
  for (std::size_t at = 0; at < size; ++at) {
    damage(path, at);
    EXPECT_THROW(read_checkpoint(path), FileError) << "byte " << at;
    damage(path, at);  // back again
  }
  EXPECT_NO_THROW(read_checkpoint(path));
}

TEST_F(CheckpointTest, EveryShorterFileIsFound) {
  const auto path = folder / "c.nc";
  write_checkpoint(path, example());
  const std::string bytes = read_file(path);
  for (std::size_t size = 0; size < bytes.size(); size += 13) {
    write_file(path, std::string_view(bytes).substr(0, size));
    EXPECT_THROW(read_checkpoint(path), FileError) << size << " bytes";
  }
}

TEST_F(CheckpointTest, KeepsTheTwoNewest) {
  Checkpoint checkpoint = example();
  for (int k = 1; k <= 11; ++k) {
    checkpoint.time = k;
    EXPECT_EQ(add_checkpoint(folder, checkpoint), folder / ("checkpoint-" + std::to_string(k) + ".nc"));
  }
  const auto found = checkpoints_in(folder);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], folder / "checkpoint-11.nc");
  EXPECT_EQ(found[1], folder / "checkpoint-10.nc");
  EXPECT_EQ(read_checkpoint(found[1]).time, 10);
}

TEST_F(CheckpointTest, OtherFilesAreNoCheckpoints) {
  for (const char* name : {"checkpoint-.nc", "checkpoint-1a.nc", "checkpoint-2.nc.new", "checkpoint-0.nc",
                           "checkpoint--1.nc", "checkpoint-99999999999999999999.nc", "history.nc"}) {
    write_file(folder / name, "");
  }
  EXPECT_TRUE(checkpoints_in(folder).empty());
  EXPECT_TRUE(checkpoints_in(folder / "nowhere").empty());
}

TEST_F(CheckpointTest, WhatIsNoCheckpointIsRefused) {
  write_file(folder / "x.in", "$in nx=3 $");
  EXPECT_NE(refusal(folder / "x.in").find("it is no checkpoint"), std::string::npos);
  EXPECT_NE(refusal(folder / "nowhere.nc").find("cannot be opened"), std::string::npos);
}

TEST_F(CheckpointTest, TheVariablesDoNotTellWhatARunTook) {
  Checkpoint checkpoint = example();
  write_checkpoint(folder / "a.nc", checkpoint);
  checkpoint.whole.cpu = 77, checkpoint.provenance.command = "otherwise";
  write_checkpoint(folder / "b.nc", checkpoint);
  const NetcdfInput a(folder / "a.nc"), b(folder / "b.nc");
  ASSERT_EQ(a.variables(), b.variables());
  for (const auto& name : a.variables()) EXPECT_EQ(a.numbers(name), b.numbers(name)) << name;
}

TEST_F(CheckpointTest, OfAnotherFormatIsRefused) {
  const auto path = folder / "c.nc";
  write_checkpoint(path, example());
  std::string bytes = read_file(path);
  const std::string head("checkpoint_format\0\0\0\0\0\0\x02\0\0\0\x01", 28);
  bytes.replace(bytes.find(head) + head.size(), 1, "9");
  const std::string seal = "checksum" + std::string("\0\0\0\x02\0\0\0\x40", 8);
  const auto digits = bytes.find(seal) + seal.size();
  bytes.replace(digits, 64, 64, '0');
  bytes.replace(digits, 64, sha256(bytes));
  write_file(path, bytes);
  EXPECT_NE(refusal(path).find("another version of the program wrote it, tether "), std::string::npos) << refusal(path);
}

TEST_F(CheckpointTest, AFolderThatDoesNotTakeItIsTold) {
  EXPECT_THROW(write_checkpoint(folder / "nowhere" / "c.nc", example()), FileError);
}

TEST(SavedState, TellsWhatIsMissingOrOfAnotherLength) {
  const SavedState saved{{"x", {1, 2, 3}}};
  StateRestorer restorer(saved);
  std::vector<double> two(2), three(3), none;
  std::vector<int> grows;
  restorer("x", three);
  restorer.list("x", grows);
  EXPECT_EQ(three, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(grows, (std::vector<int>{1, 2, 3}));
  EXPECT_THROW(restorer("x", two), FileError);
  EXPECT_THROW(restorer("x", none), FileError);
  EXPECT_THROW(restorer("y", three), FileError);
}

}  // namespace
}  // namespace tether
