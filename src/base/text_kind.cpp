// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text_kind.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"

namespace tether {
namespace {

using namespace std::string_view_literals;

constexpr const char* plain = "Save it as plain text (ASCII or UTF-8).";

/// How files of common kinds begin.
constexpr std::array<std::pair<std::string_view, const char*>, 8> beginnings{
    {{"\xff\xfe"sv, "a text in UTF-16"},
     {"\xfe\xff"sv, "a text in UTF-16"},
     {"CDF"sv, "a NetCDF file"},
     {"\x89HDF"sv, "a NetCDF-4 or HDF5 file"},
     {"\x7f"
      "ELF"sv,
      "a program"},
     {"\x1f\x8b"sv, "a compressed file (gzip)"},
     {"PK\x03\x04"sv, "a compressed file (zip)"},
     {"\x89PNG"sv, "a picture"}}};

/// A text that was damaged in places is still one, with errors at these places.
bool is_binary(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096, one_of = 20, few = 3;
  bytes = bytes.substr(0, looked_at);
  const auto odd = std::count_if(bytes.begin(), bytes.end(), [](char c) {
    return (static_cast<unsigned char>(c) < ' ' && "\t\n\v\f\r\x1a"sv.find(c) == std::string_view::npos) || c == '\x7f';
  });
  return static_cast<std::size_t>(odd) > few && static_cast<std::size_t>(odd) * one_of > bytes.size();
}

/// Every second byte of plain letters is zero.
bool is_utf16(std::string_view bytes) {
  std::size_t even = 0, odd = 0;
  for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) even += bytes[k] == 0, odd += bytes[k + 1] == 0;
  const std::size_t pairs = bytes.size() / 2;
  return pairs > 2 && (2 * even > pairs) != (2 * odd > pairs);
}

}  // namespace

NoText no_text(std::string_view bytes) {
  if (bytes.empty()) return {"the file is empty", ""};
  for (const auto& [beginning, kind] : beginnings) {
    if (bytes.starts_with(beginning)) return {std::string("this is ") + kind + ", no plain text", plain};
  }
  if (is_utf16(bytes)) return {"this is a text in UTF-16, no plain text", plain};
  if (is_binary(bytes)) return {"this is a binary file, no plain text", plain};
  if (trim(bytes).empty()) return {"the file holds nothing but blanks", ""};
  return {};
}

}  // namespace tether
