// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace tether {

/// Keeps other processes of this program out of a folder while it lives. The kernel holds the lock, so that it ends
/// with its process, however that ends; children made by fork() share it, and while one of them lives the folder is
/// taken.
class FolderLock {
 public:
  /// Makes the folder, and takes it; `work` says for others what is done there, as in "decks/sod.in". Waits some
  /// seconds for a process that is about to end. Throws FileError, which names the holder, where the folder is taken.
  FolderLock(const std::filesystem::path& folder, const std::string& work);
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
  std::string weakness_;
  int file_ = -1;
};

}  // namespace tether
