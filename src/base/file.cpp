// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

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

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  const Handle file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "cannot be opened for reading");
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), file.get())) text.append(buffer.data(), n);
  if (std::ferror(file.get()) != 0) fail(path, "cannot be read");
  return text;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  Handle file(std::fopen(path.c_str(), "wb"));
  if (!file) fail(path, "cannot be opened for writing");
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) fail(path, "cannot be written");
  if (std::fclose(file.release()) != 0) fail(path, "cannot be written");
}

}  // namespace tether
