// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/errors.hpp"

namespace tether {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Handle = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw FileError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

/// What stands in the place of a regular file.
std::string kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return S_ISCHR(mode) ? "a character device" : "a device";
}

/// A pipe opens without anyone at its other end.
int open_to_read(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) fail(path, "cannot be opened for reading");
  struct stat status {};
  const bool known = ::fstat(file, &status) == 0;
  if (known && (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))) return file;  // a folder fails by being read
  const int reason = errno;
  ::close(file);
  errno = reason;
  if (!known) fail(path, "cannot be read");
  throw FileError(
      fmt::format("{}: cannot be read: it is {}, and only regular files are read; write what comes out of it to a "
                  "file, and name that",
                  path.string(), kind_of(status.st_mode)));
}

/// Hands a file, or a folder's list of names, to the disk.
void sync_to_disk(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) ::close(file);
  errno = reason;
  if (!done) fail(path, "cannot be handed to the disk");
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  const Handle file(fdopen(open_to_read(path), "rb"));
  if (!file) fail(path, "cannot be opened for reading");
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file.get())) text.append(buffer.data(), n);
  if (std::ferror(file.get()) != 0) fail(path, "cannot be read");
  return text;
}

void refuse_irregular_file(const std::filesystem::path& path) { ::close(open_to_read(path)); }

void write_file(const std::filesystem::path& path, std::string_view text) {
  Handle file(std::fopen(path.c_str(), "wb"));
  if (!file) fail(path, "cannot be opened for writing");
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) fail(path, "cannot be written");
  if (std::fclose(file.release()) != 0) fail(path, "cannot be written");
}

void put_in_place(const std::filesystem::path& fresh, const std::filesystem::path& path) {
  sync_to_disk(fresh);
  if (std::rename(fresh.c_str(), path.c_str()) != 0) fail(path, "cannot be replaced");
  sync_to_disk(path.has_parent_path() ? path.parent_path() : ".");
}

void replace_whole(const std::filesystem::path& path, Reach reach,
                   const std::function<void(const std::filesystem::path&)>& write) {
  auto fresh = path;
  fresh += ".new";
  try {
    write(fresh);
    if (reach == Reach::disk)
      put_in_place(fresh, path);
    else if (std::rename(fresh.c_str(), path.c_str()) != 0)
      fail(path, "cannot be replaced");
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(fresh, ignored);
    throw;
  }
}

}  // namespace tether
