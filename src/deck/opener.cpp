// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/opener.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "deck/table.hpp"

namespace tether {
namespace {

std::size_t skip_blanks(std::string_view line, std::size_t at) {
  while (at < line.size() && is_blank(line[at])) ++at;
  return at;
}

bool is_name_character(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_plain(char c) { return c > ' ' && c <= '~'; }
bool is_control(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool ends_name(std::string_view line, std::size_t at) {
  return at >= line.size() || is_blank(line[at]) || std::string_view(",;/!").find(line[at]) != std::string_view::npos;
}

std::optional<Opener> opener_of(std::string_view line) {
  Opener opener;
  opener.column = skip_blanks(line, 0);
  if (opener.column == line.size() || (line[opener.column] != '$' && line[opener.column] != '&')) return std::nullopt;
  const auto start = skip_blanks(line, opener.column + 1);
  if (start == line.size() || !is_letter(line[start])) return std::nullopt;
  opener.end = start;
  while (opener.end < line.size() && is_name_character(line[opener.end])) ++opener.end;
  if (!ends_name(line, opener.end)) return std::nullopt;
  opener.name = lower(line.substr(start, opener.end - start));
  opener.detached = start > opener.column + 1;
  if (opener.name == "end" || (opener.detached && !is_group(opener.name))) return std::nullopt;
  return opener;
}

std::string_view foreign_comment(std::string_view line) {
  const auto text = trim(line);
  if (text.starts_with("//")) return text.substr(0, 2);
  if (text.starts_with('#') || text.starts_with('*')) return text.substr(0, 1);
  const bool letter = !line.empty() && lower(line.substr(0, 1)) == "c" && (text.size() == 1 || is_blank(line[1]));
  const auto after = letter ? trim(text.substr(1)) : std::string_view("=");
  return after.empty() || (after[0] != '=' && after[0] != '(') ? text.substr(0, 1) : std::string_view();
}

void tell_of_stray_lines(const std::vector<std::string>& lines, std::size_t first, std::size_t end, Remarks& remarks) {
  for (auto k = first; k < end; ++k) {
    const auto content = trim(lines[k]);
    if (content.empty() || content[0] == '!') continue;
    remarks.warn(static_cast<int>(k) + 1, 1, "text between two groups is ignored");
    return;
  }
}

void tell_of_hidden_opener(std::string_view line, int line_number, std::size_t from, Remarks& remarks) {
  line = line.substr(0, line.find('!'));
  for (auto at = line.find_first_of("$&", from); at < line.size(); at = line.find_first_of("$&", at + 1)) {
    const auto opener = opener_of(line.substr(at));
    if (!opener || opener->detached || !is_group(opener->name)) continue;
    remarks.warn(line_number, static_cast<int>(at) + 1, fmt::format("'${}' inside a line opens no group", opener->name),
                 "A group opens at the start of a line.");
    return;
  }
}

}  // namespace tether
