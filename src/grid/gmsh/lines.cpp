// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/lines.hpp"

#include <fmt/format.h>
#include <cmath>

#include "base/numbers.hpp"
#include "base/text.hpp"

namespace tether::gmsh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view Words::next() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  word_ = at_;
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return std::string_view(text_).substr(word_, at_ - word_);
}

bool Words::at_end() { return trim(std::string_view(text_).substr(at_)).empty(); }

void Words::error(std::string message, std::string hint) {
  remarks_.error(line_, static_cast<int>(word_) + 1, std::move(message), std::move(hint));
}

std::optional<long long> Words::whole(const char* what, long long low, long long high) {
  const auto word = next();
  const auto number = parse_integer(word);
  if (number && *number >= low && *number <= high) return number;
  if (word.empty())
    error(fmt::format("{} is missing at the end of this line", what));
  else if (number)
    error(fmt::format("{} is {}, out of range", what, *number), fmt::format("{} to {} can be.", low, high));
  else
    error(fmt::format("{} is no whole number: {}", what, in_quotes(word)));
  return std::nullopt;
}

std::optional<double> Words::real(const char* what) {
  constexpr double largest = 1e100;
  const auto word = next();
  const auto number = parse_real(word);
  if (number && std::abs(*number) <= largest) return number;
  if (word.empty())
    error(fmt::format("{} is missing at the end of this line", what));
  else
    error(number ? fmt::format("{} is no finite number of a size: {}", what, in_quotes(word))
                 : fmt::format("{} is no number: {}", what, in_quotes(word)));
  return std::nullopt;
}

std::optional<std::string> Words::quoted(const char* what) {
  next();
  const auto first = text_.find('"', word_), last = text_.rfind('"');
  if (first != word_ || last <= first) {
    error(fmt::format("{} must stand in quotes", what), "A group is: dimension tag \"name\".");
    return std::nullopt;
  }
  at_ = last + 1;
  return text_.substr(first + 1, last - first - 1);
}

bool Words::done(const char* should_be) {
  if (at_end()) return true;
  const auto word = next();
  error(fmt::format("{} is one too many", in_quotes(word)), should_be);
  return false;
}

std::map<std::string, Section> sections_of(const std::vector<std::string>& lines, Remarks& remarks) {
  std::map<std::string, Section> sections;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto line = trim(lines[k]);
    const int number = static_cast<int>(k) + 1;
    if (line.empty()) continue;
    if (line[0] != '$' || line.starts_with("$End")) {
      remarks.error(number, 1, fmt::format("{} stands in no section", in_quotes(line)),
                    "A section is: $Name, its lines, $EndName.");
      if (line[0] == '$') continue;
      while (k + 1 < lines.size() && !trim(lines[k + 1]).starts_with('$')) ++k;  // reported once
      continue;
    }
    const std::string name(line.substr(1)), end = "$End" + name;
    Section section{k + 1, k + 1, number};
    const auto stops = [&](std::string_view other) {
      return other == end || (other.starts_with('$') && name != "Comments");
    };
    while (section.end < lines.size() && !stops(trim(lines[section.end]))) ++section.end;
    const bool ended = section.end < lines.size() && trim(lines[section.end]) == end;
    if (!ended)
      remarks.error(number, 1,
                    fmt::format("the section {} that begins here has no {}", in_quotes(line), in_quotes(end)),
                    section.end == lines.size() ? "Is the file cut off?" : "Another section begins before.");
    if (!sections.emplace(name, section).second && name != "Comments")
      remarks.error(number, 1, fmt::format("a second section {}", in_quotes(line)), "A file has one of each.");
    k = ended ? section.end : section.end - 1;
  }
  return sections;
}

std::optional<Words> Reader::next() {
  while (at_ < section_.end && trim(lines_[at_]).empty()) ++at_;
  if (at_ >= section_.end) return std::nullopt;
  ++at_;
  return Words(lines_[at_ - 1], static_cast<int>(at_), remarks_);
}

std::optional<Words> Reader::next(const std::string& what) {
  auto words = next();
  if (!words)
    remarks_.error(static_cast<int>(std::min(section_.end, lines_.size() - 1)) + 1, 1,
                   fmt::format("the section ends before {}", what), "Is a count wrong, or the file cut off?");
  return words;
}

bool Reader::bears_out(Words& header, long long count, const char* what) {
  if (count <= left()) return true;
  header.error(fmt::format("{} {} are declared, but at most {} lines follow", count, what, left()),
               "Is the count wrong, or the file cut off?");
  return false;
}

void Reader::expect_end(const char* counted) {
  if (auto words = next()) {
    words->at_end();
    remarks_.error(words->line(), 1, fmt::format("more lines than the count of {} says", counted),
                   "Is the count wrong?");
  }
}

}  // namespace tether::gmsh
