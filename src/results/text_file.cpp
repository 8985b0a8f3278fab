// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"

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

namespace {

void check_line(const std::string& key, const std::string& value) {
  const bool readable_key = !key.empty() && key.find_first_of("=#\r\n") == std::string::npos;
  if (!readable_key || value.find_first_of("\r\n") != std::string::npos) {
    throw std::invalid_argument(fmt::format("'{} = {}' is not a line of a summary", key, value));
  }
}

void check_table(const Table& table) {
  if (table.names.size() != table.columns.size()) {
    throw std::invalid_argument(
        fmt::format("a table of {} names for {} columns", table.names.size(), table.columns.size()));
  }
  for (const auto& column : table.columns) {
    if (column.size() != table.columns.front().size()) {
      throw std::invalid_argument(
          fmt::format("a table with columns of {} and {} rows", table.columns.front().size(), column.size()));
    }
  }
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary,
                   const std::vector<std::string>& comments) {
  std::string text;
  for (const auto& comment : comments) {
    for (const auto& line : split_lines(comment)) text += fmt::format("# {}\n", line);
  }
  for (const auto& [key, value] : summary) {
    check_line(key, value);
    text += fmt::format("{} = {}\n", key, value);
  }
  write_file(path, text);
}

void write_table(const std::filesystem::path& path, const Table& table) {
  check_table(table);
  std::string text = fmt::format("# {}\n", fmt::join(table.names, " "));
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().size();
  std::vector<double> row(table.columns.size());
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = table.columns[j][k];
    text += fmt::format("{}\n", fmt::join(row, " "));
  }
  write_file(path, text);
}

}  // namespace tether
