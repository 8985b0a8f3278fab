// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/errors.hpp"
#include "base/file.hpp"

namespace tether {
namespace {

/// 0, or the system's reason why not all of the text could be written.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const auto written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

TextFile::TextFile(std::filesystem::path path) : path_(std::move(path)) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) {
    throw FileError(fmt::format("{}: cannot be opened for writing: {}", path_.string(), std::strerror(errno)));
  }
}

TextFile::~TextFile() { ::close(file_); }  // nothing is pending: every append reached the system

void TextFile::append(std::string_view text) {
  const int reason = write_all(file_, text);
  if (reason == 0) {
    length_ += text.size();
    return;
  }
  const bool whole = ::ftruncate(file_, static_cast<off_t>(length_)) == 0;
  throw FileError(fmt::format("{}: cannot be written: {}{}", path_.string(), std::strerror(reason),
                              whole ? "" : " (its last line is incomplete)"));
}

void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace_whole(path, Reach::system, [text](const std::filesystem::path& fresh) { write_file(fresh, text); });
}

}  // namespace tether
