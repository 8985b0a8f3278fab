// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_index.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/file.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

/// A study's folder with two runs that ended well.
class Index : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    study.quantities = {"steps", "max_body_x_1"};
    study.criterion.key = exit_code_key;
    for (const std::string& key : {first, second}) {
      std::filesystem::create_directories(run_folder(folder, key));
      write_file(run_folder(folder, key) / "summary.txt", "steps = 3\n");
      write_file(run_folder(folder, key) / "history.txt", "# time\n");
    }
  }
  FinishedRun run_of(const std::string& key, double steps) const {
    return {{},
            {key, {exit_done, "warning: of\tsomething"}, 0.1, 1. / 3},
            false,
            {{"steps", steps}, {"max_body_x_1", NAN}}};
  }
  void write_both() const {
    RunIndex index(study, folder);
    index.add(run_of(first, 3));
    index.add(run_of(second, 1e-300));
    index.write();
  }
  std::optional<FinishedRun> found(const std::string& key) const { return RunIndex(study, folder).find({}, key); }

  Study study;
  std::string first = std::string(64, 'a'), second = std::string(64, 'b');
};

TEST_F(Index, GivesBackWhatItWasGiven) {
  EXPECT_FALSE(found(first));
  write_both();
  const auto run = found(second);
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->reused);
  EXPECT_EQ(run->record.key, second);
  EXPECT_EQ(run->record.cpu_seconds, 0.1);
  EXPECT_EQ(run->record.wall_seconds, 1. / 3);
  EXPECT_EQ(run->record.ending.message, "warning: of something");
  EXPECT_EQ(run->value("steps"), 1e-300);
  EXPECT_TRUE(std::isnan(run->value("max_body_x_1")));
  EXPECT_EQ(run->values.size(), 2u);
}

TEST_F(Index, KnowsNothingOfARunWhoseFilesHaveChanged) {
  write_both();
  write_file(run_folder(folder, first) / "history.txt", "# time\n0\n");
  EXPECT_FALSE(found(first));
  std::filesystem::remove(run_folder(folder, second) / "summary.txt");
  EXPECT_FALSE(found(second));
}

TEST_F(Index, IsNotOneOfOtherValuesNorADamagedOne) {
  write_both();
  study.quantities = {"steps", "energy_lost"};
  EXPECT_FALSE(found(first));
  study.quantities = {"steps", "max_body_x_1"};
  const auto path = folder / "runs/index.txt";
  const std::string whole = read_file(path);
  write_file(path, whole.substr(0, whole.size() - 40));  // in the middle of the second run's line
  EXPECT_TRUE(found(first));
  EXPECT_FALSE(found(second));
  for (const auto& text : {std::string(), std::string("# key\n"), std::string(100, '\0')}) {
    write_file(path, text);
    EXPECT_FALSE(found(first));
  }
}

TEST_F(Index, KnowsALineInWhichAByteIsLost) {
  write_both();
  const auto path = folder / "runs/index.txt";
  const std::string whole = read_file(path);
  const std::size_t line = whole.find('\n') + 1;
  for (std::size_t at = line; at < whole.find('\n', line); at += 7) {
    std::string damaged = whole;
    write_file(path, damaged.erase(at, 1));
    EXPECT_FALSE(found(first)) << at;
    EXPECT_TRUE(found(second)) << at;
  }
}

TEST_F(Index, HasNoRunThatFailedOrLacksAValue) {
  RunIndex index(study, folder);
  FinishedRun failed = run_of(first, 3), lacks = run_of(second, 3);
  failed.record.ending.exit_code = exit_run;
  lacks.values.erase("steps");
  index.add(failed);
  index.add(lacks);
  EXPECT_FALSE(index.find({}, first));
  EXPECT_FALSE(index.find({}, second));
}

}  // namespace
}  // namespace tether
