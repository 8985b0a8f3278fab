// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tether {

/// The whole file as bytes. Throws FileError with the system's reason; nothing but a regular file is read, so that a
/// read comes to an end, whoever writes into a pipe or never does.
std::string read_file(const std::filesystem::path& path);

/// Throws the FileError of read_file() where the path leads to something else than a regular file.
void refuse_irregular_file(const std::filesystem::path& path);

/// Writes the whole text and checks every step, the close included. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Sets so many bytes aside after the end of an open file, whose length stays: a full disk is met before anything is
/// written. Returns 0, or the system's reason why the file cannot grow by that. File systems that cannot set bytes
/// aside are left alone: the write itself will report it.
int claim_room(int file, std::size_t bytes);

/// Renames a finished file to `path`, in place of one that is there, so that not even a power cut leaves anything but
/// the old file or the whole new one: the disk has the file before the name, and the name before this returns. Throws
/// FileError.
void put_in_place(const std::filesystem::path& fresh, const std::filesystem::path& path);

/// Where a replaced file has got to when the call returns: to the system, which survives the program, or to the disk.
enum class Reach { system, disk };

/// Has `write` make a file under the temporary name that it is given, then puts that into the place of `path` in one
/// go: whoever reads sees the old file or the whole new one. Where something is thrown, the old one stays and no
/// temporary file. Throws FileError, and what `write` throws.
void replace_whole(const std::filesystem::path& path, Reach reach,
                   const std::function<void(const std::filesystem::path&)>& write);

/// Whether those who have a folder keep all others out, or let in those who share it, too.
enum class Sharing { alone, together };

/// Keeps other processes of this program out of a folder while it lives. The kernel holds the lock, so that it ends
/// with its process, however that ends; children made by fork() share it, and while one of them lives the folder is
/// taken.
class FolderLock {
 public:
  static constexpr const char* file_name = "lock";
  /// Makes the folder, and takes it; `work` says for others what is done there, as in "decks/sod.in". Waits some
  /// seconds for a process that is about to end. Throws FileError, which names the holder, where the folder is taken.
  /// A process that was killed holds its locks until its memory is given back: some seconds are waited at least.
  FolderLock(const std::filesystem::path& folder, const std::string& work, Sharing sharing = Sharing::alone,
             std::chrono::milliseconds longest_wait = std::chrono::seconds(2));
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Why the file system keeps nobody out; empty where it does.
  const std::string& weakness() const { return weakness_; }

 private:
  bool take();
  bool is_in_place() const;
  void open_file();
  void tell_of(const std::string& work) const;

  std::filesystem::path path_;
  int kind_;  // of the kernel's lock
  std::string weakness_;
  int file_ = -1;
};

}  // namespace tether
