// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>
#include <utility>

#include "base/diagnostics.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;
using FileTest = test::TemporaryFolder;

/// The text of the FileError that `call` must throw.
std::string file_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(FileTest, ReadsBackEveryByteThatWasWritten) {
  std::string bytes;
  for (int k = 0; k < 200000; ++k) bytes += static_cast<char>(k % 256);  // more than the reader's buffer
  write_file(folder / "all", bytes);
  EXPECT_EQ(read_file(folder / "all"), bytes);
  write_file(folder / "all", "");
  EXPECT_EQ(read_file(folder / "all"), "");
}

TEST_F(FileTest, WritingReplacesWhatWasThere) {
  write_file(folder / "f", "a long text");
  write_file(folder / "f", "short");
  EXPECT_EQ(read_file(folder / "f"), "short");
}

TEST_F(FileTest, AMissingFileIsNamedWithTheReason) {
  const fs::path missing = folder / "missing";
  EXPECT_EQ(file_error([&] { read_file(missing); }),
            missing.string() + ": cannot be opened for reading: No such file or directory");
}

TEST_F(FileTest, AFolderIsNoFile) {
  EXPECT_EQ(file_error([&] { read_file(folder); }), folder.string() + ": cannot be read: Is a directory");
  EXPECT_EQ(file_error([&] { write_file(folder, "x"); }),
            folder.string() + ": cannot be opened for writing: Is a directory");
}

TEST_F(FileTest, OnlyRegularFilesAreRead) {
  const fs::path pipe = folder / "pipe", link = folder / "link";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  fs::create_symlink(pipe, link);
  for (const auto& [path, kind] : {std::pair{pipe, "a pipe"}, {link, "a pipe"}, {"/dev/zero", "a character device"}}) {
    const std::string told = path.string() + ": cannot be read: it is " + kind + ", and only regular files are read";
    EXPECT_TRUE(file_error([&, file = path] { read_file(file); }).starts_with(told)) << told;
    EXPECT_TRUE(file_error([&, file = path] { refuse_irregular_file(file); }).starts_with(told)) << told;
  }
  write_file(folder / "f", "x");
  fs::create_symlink("f", folder / "to_f");
  EXPECT_EQ(read_file(folder / "to_f"), "x");
}

TEST_F(FileTest, AFileIsNoFolder) {
  write_file(folder / "f", "x");
  const fs::path below = folder / "f" / "g";
  EXPECT_EQ(file_error([&] { write_file(below, "x"); }),
            below.string() + ": cannot be opened for writing: Not a directory");
}

/// The device of Linux on which every write fails for want of space: a short text fails when it is closed only.
TEST_F(FileTest, AFullDiskIsAnError) {
  const std::string message = "/dev/full: cannot be written: No space left on device";
  EXPECT_EQ(file_error([] { write_file("/dev/full", "short"); }), message);
  EXPECT_EQ(file_error([] { write_file("/dev/full", std::string(1000000, 'x')); }), message);
}

}  // namespace
}  // namespace tether
