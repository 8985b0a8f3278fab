// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace tether {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    const auto end = std::min(text.find_first_of("\r\n", start), text.size());
    lines.emplace_back(text.substr(start, end - start));
    const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    start = end + (pair ? 2 : 1);
  }
  return lines;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates, std::size_t most) {
  std::string best;
  std::size_t best_distance = most + 1;
  for (const auto& candidate : candidates) {
    const auto distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("libcrypto offers no SHA-256");
  }
  std::string text;
  for (unsigned int k = 0; k < length; ++k) text += fmt::format("{:02x}", digest[k]);
  return text;
}

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = "...";
  if (text.size() <= most || most < gap.size()) return std::string(text);
  const std::size_t kept = most - gap.size(), tail = kept / 2;
  return std::string(text.substr(0, kept - tail)).append(gap).append(text.substr(text.size() - tail));
}

std::string with_short_words(std::string_view text, std::size_t most) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    result += shortened(text.substr(0, end), most);
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

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

std::vector<std::string> split_words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace tether
