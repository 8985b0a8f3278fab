// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <system_error>
#include <thread>

#include "base/diagnostics.hpp"
#include "base/process.hpp"

namespace tether {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Handle = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw FileError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

/// Says what stands in the place of a regular file.
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

int claim_room(int file, std::size_t bytes) {
  struct stat status {};
  struct rlimit limit {};
  if (::fstat(file, &status) != 0 || ::getrlimit(RLIMIT_FSIZE, &limit) != 0) return errno;
  if (limit.rlim_cur != RLIM_INFINITY && static_cast<rlim_t>(status.st_size) + bytes > limit.rlim_cur) return EFBIG;
  const int refused = ::fallocate(file, FALLOC_FL_KEEP_SIZE, status.st_size, static_cast<off_t>(bytes));
  return refused == 0 || errno == EOPNOTSUPP ? 0 : errno;
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

namespace {

constexpr std::chrono::milliseconds pause{50};

std::string local_time() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 32> text{};
  const auto length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
  return {text.data(), length};
}

[[noreturn]] void refuse(const std::filesystem::path& lock) {
  std::string holder;
  try {
    holder = read_file(lock);
  } catch (const FileError&) {  // its holder has just ended
  }
  while (holder.ends_with('\n')) holder.pop_back();
  throw FileError(fmt::format("{}: the folder is in use by {}; wait for its end, or give another --out",
                              lock.parent_path().string(), holder.empty() ? "another tether" : holder));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& work, Sharing sharing,
                       std::chrono::milliseconds longest_wait)
    : path_(folder / file_name), kind_(sharing == Sharing::alone ? LOCK_EX : LOCK_SH) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (reason) throw FileError(fmt::format("{}: the folder cannot be made: {}", folder.string(), reason.message()));
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  open_file();
  while (!take()) {
    if (std::chrono::steady_clock::now() > end) {
      ::close(file_);
      refuse(path_);
    }
    std::this_thread::sleep_for(pause);
  }
  tell_of(work);
}

FolderLock::~FolderLock() {
  const bool is_last = ::flock(file_, LOCK_EX | LOCK_NB) == 0;  // nobody shares the folder any more
  if (weakness_.empty() && is_last) ::unlink(path_.c_str());    // before the lock ends, or it could be another's file
  ::close(file_);
}

void FolderLock::open_file() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail(path_, "cannot be opened");
}

/// False where another process has the lock, or took the file away when it ended.
bool FolderLock::take() {
  int result = 0;
  do result = ::flock(file_, kind_ | LOCK_NB);
  while (result != 0 && errno == EINTR);
  if (result != 0 && errno == EWOULDBLOCK) return false;
  if (result != 0) weakness_ = std::strerror(errno);
  if (result != 0 || is_in_place()) return true;
  ::close(file_);
  open_file();
  return false;
}

/// Returns whether the file that is open is the one that stands at the path.
bool FolderLock::is_in_place() const {
  struct stat ours {
  }, there{};
  return ::fstat(file_, &ours) == 0 && ::stat(path_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
         ours.st_dev == there.st_dev;
}

void FolderLock::tell_of(const std::string& work) const {
  const auto text =
      fmt::format("process {} on {}, which runs {} since {}\n", ::getpid(), host_name(), work, local_time());
  const auto size = static_cast<ssize_t>(text.size());
  if (::ftruncate(file_, 0) == 0 && ::pwrite(file_, text.data(), text.size(), 0) == size) return;
  const int reason = errno;
  ::close(file_);
  errno = reason;
  fail(path_, "cannot be written");
}

}  // namespace tether
