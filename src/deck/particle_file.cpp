// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/particle_file.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

constexpr std::size_t longest_fused_row = 280;  // 7 fields of 40 characters
constexpr std::string_view separators = " \t,;";

/// A right-adjusted Fw.d field. The '.' shows where a field ends: it must be there, once.
std::optional<double> field_number(std::string_view field) {
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  if (std::count(field.begin(), field.end(), '.') != 1) return std::nullopt;
  return parse_real(field);
}

}  // namespace

std::optional<RowNumbers> list_row(std::string_view row) {
  RowNumbers numbers{};
  std::size_t count = 0;
  while (true) {
    const auto start = row.find_first_not_of(separators);
    if (start == std::string_view::npos) break;
    row.remove_prefix(start);
    const auto length = std::min(row.find_first_of(separators), row.size());
    const auto number = parse_real(row.substr(0, length));
    if (!number || count == numbers.size()) return std::nullopt;
    numbers[count++] = *number;
    row.remove_prefix(length);
  }
  return count == numbers.size() ? std::optional(numbers) : std::nullopt;
}

std::optional<RowNumbers> fused_row(std::string_view row, FusedLayout layout) {
  if (2 * layout.w1 + 5 * layout.w2 != row.size()) return std::nullopt;
  RowNumbers numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto width = k < 2 ? layout.w1 : layout.w2;
    const auto number = field_number(row.substr(0, width));
    if (!number) return std::nullopt;
    numbers[k] = *number;
    row.remove_prefix(width);
  }
  return numbers;
}

std::vector<FusedLayout> layouts_of(std::string_view row) {
  std::vector<FusedLayout> layouts;
  for (std::size_t w2 = 2; 5 * w2 + 4 <= row.size() && row.size() <= longest_fused_row; ++w2) {
    const FusedLayout layout{(row.size() - 5 * w2) / 2, w2};
    if (fused_row(row, layout)) layouts.push_back(layout);
  }
  return layouts;
}

bool looks_fused(std::string_view row) {
  return row.size() <= longest_fused_row && row.find('.') != std::string_view::npos &&
         row.find_first_not_of(" 0123456789+-.eEdDqQ") == std::string_view::npos;
}

namespace {

constexpr double most_points = 1e8;

/// Returns what stands on a line before its '!', without blanks after it.
std::string_view content_of(std::string_view line) {
  line = line.substr(0, line.find('!'));
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

std::vector<std::string_view> words_of(std::string_view content) {
  std::vector<std::string_view> words;
  for (auto at = content.find_first_not_of(separators); at != std::string_view::npos;) {
    const auto end = std::min(content.find_first_of(separators, at), content.size());
    words.push_back(content.substr(at, end - at));
    at = content.find_first_not_of(separators, end);
  }
  return words;
}

std::string layout_texts(const std::vector<FusedLayout>& layouts) {
  std::string text;
  for (const auto layout : layouts) {
    text += fmt::format("{}(2F{},5F{})", text.empty() ? "" : " and ", layout.w1, layout.w2);
  }
  return text;
}

class ParticleReader {
 public:
  ParticleReader(ParticleFile& file, Remarks& remarks) : file_(file), remarks_(remarks) {}
  void read();

 private:
  int line_number(std::size_t index) const { return file_.first_line + static_cast<int>(index); }
  void skip_empty_lines();
  std::optional<std::vector<double>> header_line(std::size_t count, const std::string& what);
  bool require(bool holds, const std::string& message);
  bool header();
  bool counts();
  bool whole_number(double number, const char* what, double low, int& result);
  std::vector<std::size_t> possible_rows();
  bool infer_layout(const std::vector<std::size_t>& rows);
  bool no_layout(std::size_t index, const std::vector<FusedLayout>& before);
  bool ambiguous_layout(std::size_t index, const std::vector<FusedLayout>& layouts);
  std::optional<RowNumbers> row_numbers(std::size_t index) const;
  void store_row(std::size_t index, const RowNumbers& numbers);
  void check_count();

  ParticleFile& file_;
  Remarks& remarks_;
  std::size_t at_ = 0;  ///< the next line to read
  std::optional<FusedLayout> layout_;
};

void ParticleReader::read() {
  if (!header()) return;
  const auto rows = possible_rows();
  if (!infer_layout(rows)) return;
  for (const auto index : rows) store_row(index, row_numbers(index).value());
  check_count();
}

void ParticleReader::skip_empty_lines() {
  while (at_ < file_.lines.size() && trim(content_of(file_.lines[at_])).empty()) ++at_;
}

/// The next line's numbers, which must be `count`.
std::optional<std::vector<double>> ParticleReader::header_line(std::size_t count, const std::string& what) {
  skip_empty_lines();
  if (at_ == file_.lines.size()) {
    remarks_.error(0, 0, fmt::format("the particle data end before {}", what),
                   "They begin with: density / 7 constants / 4 numbers ipath / points in the sequence / points in all, "
                   "points per cell.");
    return std::nullopt;
  }
  std::vector<double> numbers;
  const auto words = words_of(content_of(file_.lines[at_]));
  for (const auto word : words) {
    const auto number = parse_real(word);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (words.size() == count && numbers.size() == count) {
    ++at_;
    return numbers;
  }
  remarks_.error(line_number(at_), 1, fmt::format("this line of the particle data must be {}", what),
                 "Remarks stand after '!'.");
  return std::nullopt;
}

/// Speaks of the header line that was read last.
bool ParticleReader::require(bool holds, const std::string& message) {
  if (!holds) remarks_.error(line_number(at_ - 1), 1, message);
  return holds;
}

bool ParticleReader::whole_number(double number, const char* what, double low, int& result) {
  const bool whole = number == std::floor(number) && number >= low && number <= most_points;
  if (whole) result = static_cast<int>(number);
  return require(whole, fmt::format("{} must be a whole number from {:.0f} to 100000000, not {}", what, low, number));
}

bool ParticleReader::header() {
  const auto density = header_line(1, "the density");
  if (!density) return false;
  file_.density = density->front();
  bool good = require(file_.density > 0, fmt::format("the density must be > 0, not {}", file_.density));
  const auto constants = header_line(file_.constants.size(), "7 material constants");
  if (!constants) return false;
  std::copy(constants->begin(), constants->end(), file_.constants.begin());
  file_.constants_line = line_number(at_ - 1);
  const auto ipath = header_line(file_.ipath.size(), "4 integers ipath");
  if (!ipath) return false;
  file_.ipath_line = line_number(at_ - 1);
  for (std::size_t k = 0; k < ipath->size(); ++k) {
    good = whole_number((*ipath)[k], "ipath", -most_points, file_.ipath[k]) && good;
  }
  return counts() && good;
}

bool ParticleReader::counts() {
  const auto sequence = header_line(1, "the number of points in the sequence");
  if (!sequence) return false;
  bool good = whole_number(sequence->front(), "the number of points in the sequence", 0, file_.in_sequence);
  const auto totals = header_line(2, "the number of points in all and the number per cell");
  if (!totals) return false;
  good = whole_number(totals->front(), "the number of points in all", 1, file_.total) && good;
  file_.per_cell = totals->back();
  return require(file_.per_cell > 0, fmt::format("the points per cell must be > 0, not {}", file_.per_cell)) && good;
}

/// Lines that can be rows, `total` of them at most, up to the first that cannot.
std::vector<std::size_t> ParticleReader::possible_rows() {
  std::vector<std::size_t> rows;
  for (skip_empty_lines(); at_ < file_.lines.size(); skip_empty_lines()) {
    const auto content = content_of(file_.lines[at_]);
    const bool possible = list_row(content) || looks_fused(content);
    if (!possible || rows.size() == static_cast<std::size_t>(file_.total)) break;
    rows.push_back(at_++);
  }
  return rows;
}

/// The one layout in which every fused row is seven numbers; nothing is needed where all rows are parted by blanks.
bool ParticleReader::infer_layout(const std::vector<std::size_t>& rows) {
  std::vector<FusedLayout> layouts;
  for (const auto index : rows) {
    const auto content = content_of(file_.lines[index]);
    if (list_row(content)) continue;
    auto fitting = layouts.empty() ? layouts_of(content) : layouts;
    std::erase_if(fitting, [&](FusedLayout layout) { return !fused_row(content, layout); });
    if (fitting.empty()) return no_layout(index, layouts);
    layouts = fitting;
  }
  if (layouts.size() > 1) return ambiguous_layout(rows.front(), layouts);
  if (!layouts.empty()) layout_ = layouts.front();
  return true;
}

bool ParticleReader::no_layout(std::size_t index, const std::vector<FusedLayout>& before) {
  const std::string widths = before.empty() ? "run together, no widths (2Fw1,5Fw2) make 7 numbers of it."
                                            : "the rows before it have the widths " + layout_texts(before) + ".";
  remarks_.error(line_number(index), 1, "this row is not 7 numbers", "Part the numbers by blanks; " + widths);
  return false;
}

bool ParticleReader::ambiguous_layout(std::size_t index, const std::vector<FusedLayout>& layouts) {
  remarks_.error(line_number(index), 1,
                 "the rows are run together and can be read in more than one way: " + layout_texts(layouts),
                 "Part the numbers by blanks.");
  return false;
}

std::optional<RowNumbers> ParticleReader::row_numbers(std::size_t index) const {
  const auto content = content_of(file_.lines[index]);
  const auto numbers = list_row(content);
  return numbers || !layout_ ? numbers : fused_row(content, *layout_);
}

void ParticleReader::store_row(std::size_t index, const RowNumbers& n) {
  if (!std::all_of(n.begin(), n.end(), [](double number) { return std::isfinite(number); })) {
    remarks_.error(line_number(index), 1, "this row has a number that is not finite");
  }
  file_.rows.push_back({n[0], n[1], n[2], n[3], n[4], n[5], n[6], line_number(index)});
}

/// Complete rows right after the declared ones are too many; a note there is none of our business.
void ParticleReader::check_count() {
  auto found = file_.rows.size();
  skip_empty_lines();
  const auto next = at_;
  for (; at_ < file_.lines.size() && row_numbers(at_); skip_empty_lines()) ++found, ++at_;
  if (found == static_cast<std::size_t>(file_.total)) return;
  const bool ended = next == file_.lines.size();
  const bool more = next < at_;
  remarks_.error(ended ? 0 : line_number(next), ended ? 0 : 1,
                 fmt::format("{} rows declared, {} found", file_.total, found),
                 ended || more ? "" : "A row is 7 numbers: x, y, velocity, stress xx, yy, xy. This line is none.");
}

}  // namespace

std::string line_text(const ParticleFile& file, int line) {
  const auto index = static_cast<std::size_t>(line - file.first_line);
  return index < file.lines.size() ? file.lines[index] : "";
}

ParticleFile read_particle_file(std::string_view text, const std::string& file, int first_line,
                                Diagnostics& diagnostics) {
  ParticleFile result;
  result.file = file;
  result.first_line = first_line;
  result.lines = split_lines(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text);
  Remarks remarks(file, result.lines, first_line, diagnostics);
  if (auto [message, hint] = no_text(text); !message.empty()) {
    remarks.error(0, 0, std::move(message), std::move(hint));
    return result;
  }
  ParticleReader(result, remarks).read();
  return result;
}

}  // namespace tether
