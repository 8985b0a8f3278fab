// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "results/text_file.hpp"
#include "unit/results/support.hpp"

namespace tether {
namespace {

using TextTest = test::TemporaryFolder;

TEST_F(TextTest, SummaryHasALineForEachPair) {
  write_summary(folder / "summary.txt", {{"path", "mpm"}, {"error_density", "1.5e-3"}, {"empty", ""}},
                {"tether 0.1.0", "two\nlines"});
  EXPECT_EQ(read_file(folder / "summary.txt"),
            "# tether 0.1.0\n# two\n# lines\npath = mpm\nerror_density = 1.5e-3\nempty = \n");
}

TEST_F(TextTest, SummaryRefusesWhatCouldNotBeReadBack) {
  const auto refused = [this](const char* key, const char* value) {
    EXPECT_THROW(write_summary(folder / "summary.txt", {{key, value}}, {}), std::invalid_argument);
  };
  refused("", "1");
  refused("a=b", "1");
  refused("#steps", "1");
  refused("steps\n", "1");
  refused("steps", "1\nmass = 2");
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.txt"));
}

TEST_F(TextTest, TableHasARowForEachPlace) {
  write_table(folder / "reference.txt", {{"x", "density"}, {{0, 0.1}, {1.0 / 3, -1e-9}}});
  EXPECT_EQ(read_file(folder / "reference.txt"), "# x density\n0 0.3333333333333333\n0.1 -1e-09\n");
}

TEST_F(TextTest, TableMayBeEmpty) {
  write_table(folder / "reference.txt", {{"x", "density"}, {{}, {}}});
  EXPECT_EQ(read_file(folder / "reference.txt"), "# x density\n");
}

TEST_F(TextTest, TableColumnsAreOfOneLength) {
  EXPECT_THROW(write_table(folder / "reference.txt", {{"x", "p"}, {{0, 1}, {2}}}), std::invalid_argument);
  EXPECT_THROW(write_table(folder / "reference.txt", {{"x", "p"}, {{0, 1}}}), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "reference.txt"));
}

TEST_F(TextTest, TextFileIsThereAtOnce) {
  write_file(folder / "messages.txt", "of an earlier run");
  TextFile file(folder / "messages.txt");
  EXPECT_EQ(read_file(folder / "messages.txt"), "");
  file.append("one\n");
  EXPECT_EQ(read_file(folder / "messages.txt"), "one\n");
  file.append("");
  file.append("two\n");
  EXPECT_EQ(read_file(folder / "messages.txt"), "one\ntwo\n");
}

TEST_F(TextTest, TextFileNamesWhatFailed) {
  const auto path = folder / "missing" / "messages.txt";
  try {
    TextFile file(path);
    FAIL() << "the folder is missing";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), path.string() + ": cannot be opened for writing: No such file or directory");
  }
  TextFile full("/dev/full");
  EXPECT_THROW(full.append("text"), FileError);
}

TEST_F(TextTest, ReplacingKeepsTheOldTextWhenItFails) {
  std::filesystem::create_directories(folder / "a.pvd.new");
  write_file(folder / "a.pvd", "old");
  EXPECT_THROW(replace_file(folder / "a.pvd", "new"), FileError);
  EXPECT_EQ(read_file(folder / "a.pvd"), "old");
  std::filesystem::remove(folder / "a.pvd.new");
  replace_file(folder / "a.pvd", "new");
  EXPECT_EQ(read_file(folder / "a.pvd"), "new");
}

}  // namespace
}  // namespace tether
