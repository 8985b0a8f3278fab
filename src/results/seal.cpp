// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/seal.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string_view>

#include "base/errors.hpp"
#include "base/file.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t digits = 64;  // of a SHA-256 in hexadecimal

/// How a 64-bit-offset file begins an attribute `checksum` of 64 characters: name, type NC_CHAR, length.
/// Source: NetCDF classic format specification.
constexpr auto head =
    "\0\0\0\x08"
    "checksum"
    "\0\0\0\x02\0\0\0\x40"sv;

/// Where the digits stand; npos where there are none.
std::size_t place_of_digits(const std::string& bytes) {
  const auto at = bytes.find(head);
  const bool whole = at != std::string::npos && at + head.size() + digits <= bytes.size();
  return whole ? at + head.size() : std::string::npos;
}

}  // namespace

void define_seal(NetcdfFile& file) { file.global_attribute("checksum", std::string(digits, '0')); }

void seal(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(place_of_digits(bytes)));
  file << sha256(bytes) << std::flush;
  if (!file) throw FileError(fmt::format("{}: its checksum cannot be written", path.string()));
}

std::string broken_seal(const std::filesystem::path& path) {
  std::string bytes = read_file(path);
  const auto at = place_of_digits(bytes);
  if (at == std::string::npos) return "it is no checkpoint, or its beginning is damaged";
  const std::string told = bytes.substr(at, digits);
  bytes.replace(at, digits, digits, '0');
  return sha256(bytes) == told ? "" : "it is damaged: its checksum does not fit";
}

}  // namespace tether
